#pragma once

#include <QObject>

#include "viscera/scene/handle_event.h"
#include "viscera/scene/organ_view.h"
#include "window/mode.h"
#include "window/pose_editor.h"
#include "window/workspace.h"

namespace viscera::app {

/// Keeps the handle widget as the document and the selection have them, and turns what the mouse does with it
/// into commands: in Handles mode it edits the rest shape, in Deform mode the pose, where locked volumes are
/// kept. One drag is one undo step.
class HandleScene final : public QObject {
  Q_OBJECT

public:
  HandleScene(Workspace& workspace, PoseEditor& poses, scene::OrganView& view, QObject* parent = nullptr);
  ~HandleScene() override;

  void setMode(Mode mode);
  /// Shows the handles also where they cannot be moved (Explore, Play).
  void setAlwaysShown(bool shown);
  bool alwaysShown() const { return alwaysShown_; }
  /// Whether the mouse is on a handle or holds one: a click there is not one on the organ.
  bool handleUnderMouse() const;
  bool dragging() const;

Q_SIGNALS:
  void changed();
  void dragStarted();
  void dragEnded();

private:
  bool editable() const { return mode_ == Mode::handles || mode_ == Mode::deform; }
  void syncRig();
  void syncPositions();
  void syncSelection();
  void syncShown();
  void onGrabbed(const scene::HandleEvent& event);
  void beginPoseDrag(const QString& name, const scene::HandleEvent& event);
  void onMoved(const scene::HandleEvent& event);
  void onReleased();
  void onCancelled();
  void onSelected(const scene::HandleEvent& event);
  session::Command moveCommand(const std::vector<int>& rows) const;

  Workspace& workspace_;
  PoseEditor& poses_;
  scene::OrganView& view_;
  Mode mode_ = Mode::explore;
  bool alwaysShown_ = false;
  bool fromWidget_ = false; ///< The widget already shows what is being changed.
  bool dragFailed_ = false; ///< This drag has met an error and said so.
  std::vector<unsigned long> observers_;
  std::vector<session::Subscription> subscriptions_;
};

} // namespace viscera::app
