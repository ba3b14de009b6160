#pragma once

#include <QObject>

#include "viscera/scene/layout_hulls.h"
#include "viscera/scene/organ_view.h"
#include "window/group_layout.h"
#include "window/mode.h"

namespace viscera::app {

/// What is drawn of a layout over handles at rest, in the colours of the groups, and with the regions also
/// the cage where `withCage`.
std::vector<scene::RegionHull> regionHulls(const document::Rig& rig, const coordinates::SpaceLayout& layout,
                                           const scene::LayoutParts& shown, bool withCage);

/// Shows the regions, zones and super-regions of the groups, and the cage of coordinates that need one, while
/// the handles are edited at rest.
class RegionScene final : public QObject {
  Q_OBJECT

public:
  RegionScene(Workspace& workspace, GroupLayout& layout, scene::OrganView& view, QObject* parent = nullptr);
  ~RegionScene() override;

  void setMode(Mode mode);
  void setShown(const scene::LayoutParts& shown);
  const scene::LayoutParts& shown() const { return shown_; }

Q_SIGNALS:
  void changed();

private:
  void sync();

  Workspace& workspace_;
  GroupLayout& layout_;
  scene::OrganView& view_;
  scene::LayoutParts shown_;
  Mode mode_ = Mode::explore;
  Subscription subscription_;
};

} // namespace viscera::app
