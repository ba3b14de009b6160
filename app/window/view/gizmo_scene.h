#pragma once

#include <QObject>

#include "viscera/scene/gizmo_event.h"
#include "viscera/scene/organ_view.h"
#include "window/pose_editor.h"
#include "window/view/view_model.h"
#include "window/workspace.h"

namespace viscera::app {

/// Shows the gizmo that turns and scales the selected handles, where there are tools, while it is wanted and
/// two handles at least are selected; and does to the pose what the mouse does with it.
class GizmoScene final : public QObject {
  Q_OBJECT

public:
  GizmoScene(Workspace& workspace, PoseEditor& poses, const ViewModel& model, scene::OrganView& view,
             QObject* parent = nullptr);
  ~GizmoScene() override;

  bool shown() const;
  bool dragging() const;
  /// Whether the mouse is on the gizmo or holds it.
  bool underMouse() const;

Q_SIGNALS:
  void changed();

private:
  /// The selected handles that can be moved.
  std::vector<document::HandleId> movable() const;
  bool wanted() const { return model_.state().gizmo && model_.state().shown.tools; }
  void sync();
  void onGrabbed(const scene::GizmoEvent& event);
  void onMoved(const scene::GizmoEvent& event);

  Workspace& workspace_;
  PoseEditor& poses_;
  const ViewModel& model_;
  scene::OrganView& view_;
  std::vector<unsigned long> observers_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
