#pragma once

#include <QObject>

#include <vector>

#include "window/view/view_model.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// Tells when a change of the document shows other organs in the place of all that were seen, an undo above
/// all: they may lie where the camera does not look. A stress map is of one organ, so that there organs that
/// stay may be others than those that were seen.
class Framing final : public QObject {
  Q_OBJECT

public:
  /// Both have to live longer.
  Framing(Workspace& workspace, ViewModel& view, QObject* parent = nullptr);

Q_SIGNALS:
  /// What is seen has to be brought into the picture.
  void wanted();

private:
  bool showsOneAlone() const;
  std::vector<document::OrganId> seen() const;
  void onOrgans();

  Workspace& workspace_;
  ViewModel& view_;
  bool alone_;                          ///< The current organ, as in a stress map without the others.
  std::vector<document::OrganId> seen_; ///< Before the next change.
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
