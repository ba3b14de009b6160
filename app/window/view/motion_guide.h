#pragma once

#include <QObject>

#include "viscera/scene/organ_view.h"
#include "window/pose_editor.h"
#include "window/view/view_model.h"
#include "window/workspace.h"

namespace viscera::app {

/// What is drawn to help with motions in Deform mode: the plane in which a dragged handle may go and the
/// volume's gradient while the volume is locked, and the plane that drags are mirrored at.
class MotionGuide final : public QObject {
  Q_OBJECT

public:
  MotionGuide(Workspace& workspace, PoseEditor& poses, const ViewModel& model, scene::OrganView& view,
              QObject* parent = nullptr);

Q_SIGNALS:
  void changed();

private:
  void syncConstraint();
  void syncMirror();

  Workspace& workspace_;
  PoseEditor& poses_;
  const ViewModel& model_;
  scene::OrganView& view_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
