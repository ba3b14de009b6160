#pragma once

#include <QObject>

#include "viscera/scene/layout_hulls.h"
#include "viscera/scene/organ_view.h"
#include "window/group_layout.h"
#include "window/view/view_model.h"

namespace viscera::app {

/// What is drawn of a layout over handles at rest, in the colours of the groups, and with the regions also
/// the cage where `withCage`.
std::vector<scene::RegionHull> regionHulls(const document::Rig& rig, const coordinates::SpaceLayout& layout,
                                           const scene::LayoutParts& shown, bool withCage);

/// Shows the regions, zones and super-regions of the groups, and the cage of coordinates that need one, where
/// the view has them.
class RegionScene final : public QObject {
  Q_OBJECT

public:
  RegionScene(Workspace& workspace, GroupLayout& layout, const ViewModel& model, scene::OrganView& view,
              QObject* parent = nullptr);
  ~RegionScene() override;

Q_SIGNALS:
  void changed();

private:
  void sync();

  Workspace& workspace_;
  GroupLayout& layout_;
  const ViewModel& model_;
  scene::OrganView& view_;
  Subscription subscription_;
};

} // namespace viscera::app
