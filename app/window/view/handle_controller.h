#pragma once

#include <QObject>

#include <optional>
#include <vector>

#include "viscera/scene/widget_events.h"
#include "window/view/picture.h"
#include "window/view/pose_editor.h"
#include "window/work/workspace.h"

namespace viscera::app {

/// Turns mouse gestures on handles and on the gizmo of a view into commands: it edits the handles at rest, or
/// their pose, in which locked volumes are kept. One drag is one undo step. It draws only the plane in which
/// a drag may move; `Picture` draws the handles.
class HandleController final : public QObject {
  Q_OBJECT

public:
  /// All have to live longer.
  HandleController(Workspace& workspace, PoseEditor& poses, const ViewModel& model, Picture& picture,
                   QObject* parent = nullptr);
  ~HandleController() override;

  /// Whether the mouse is on a handle or the gizmo, or drags one. A click there is not a click on the organ.
  bool underMouse() const;
  bool dragging() const;
  /// Cancels the present drag; false when there is none.
  bool cancelDrag();

private:
  const presentation::Shown& shown() const { return model_.state().shown; }
  void listenToHandles();
  void listenToGizmo();
  void onGrabbed(const scene::HandleEvent& event);
  void onMoved(const scene::HandleEvent& event);
  void onReleased();
  void onCancelled();
  void onSelected(const scene::HandleEvent& event);
  std::optional<Vec3> planeOfView() const;
  void moveAtRest(const std::vector<int>& rows);
  void onGizmoGrabbed(const scene::GizmoEvent& event);
  void onGizmoMoved(const scene::GizmoEvent& event);
  void showConstraint();
  std::vector<document::HandleId> idsOf(const std::vector<int>& rows) const;

  Workspace& workspace_;
  PoseEditor& poses_;
  const ViewModel& model_;
  Picture& picture_;
  scene::OrganView& view_; ///< In which the mouse may have put handles where `picture_` will not leave them.
  presentation::Shown grabbed_;                   ///< What the view showed when the drag began.
  std::optional<document::UndoStack::Step> step_; ///< Undo step of a drag at rest.
  bool dragFailed_ = false;                       ///< An error of this drag was reported.
  std::vector<unsigned long> handleObservers_;
  std::vector<unsigned long> gizmoObservers_;
};

} // namespace viscera::app
