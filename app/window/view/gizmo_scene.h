#pragma once

#include <QObject>

#include "viscera/scene/gizmo_event.h"
#include "viscera/scene/organ_view.h"
#include "window/mode.h"
#include "window/pose_editor.h"
#include "window/workspace.h"

namespace viscera::app {

/// Shows the gizmo that turns and scales the selected handles, in Deform mode, while it is wanted and two
/// handles at least are selected; and does to the pose what the mouse does with it.
class GizmoScene final : public QObject {
  Q_OBJECT

public:
  GizmoScene(Workspace& workspace, PoseEditor& poses, scene::OrganView& view, QObject* parent = nullptr);
  ~GizmoScene() override;

  void setMode(Mode mode);
  void setWanted(bool wanted);
  bool wanted() const { return wanted_; }
  bool shown() const;
  bool dragging() const;
  /// Whether the mouse is on the gizmo or holds it.
  bool underMouse() const;

Q_SIGNALS:
  void changed();

private:
  /// The selected handles that can be moved.
  std::vector<document::HandleId> movable() const;
  void sync();
  void onGrabbed(const scene::GizmoEvent& event);
  void onMoved(const scene::GizmoEvent& event);

  Workspace& workspace_;
  PoseEditor& poses_;
  scene::OrganView& view_;
  Mode mode_ = Mode::explore;
  bool wanted_ = false;
  std::vector<unsigned long> observers_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
