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
  /// Whether there are handles to be seen, by the mode or always.
  bool shown() const { return editable() || alwaysShown_; }
  /// In Stress mode handles can be moved only while the document's pose is shown, not a sequence's.
  void setPlayed(bool played);
  /// Shows only handles at places of which `wanted` says so; null: all again. Asked when it is set and when
  /// the handles change.
  void setShownWhere(std::function<bool(const Vec3&)> wanted);
  /// Whether the mouse is on a handle or holds one: a click there is not one on the organ.
  bool handleUnderMouse() const;
  bool dragging() const;

Q_SIGNALS:
  void changed();
  void dragStarted();
  void dragEnded();

private:
  bool editable() const {
    return mode_ == Mode::handles || mode_ == Mode::deform || (mode_ == Mode::stress && !played_);
  }
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
  document::Command moveCommand(const std::vector<int>& rows) const;

  Workspace& workspace_;
  PoseEditor& poses_;
  scene::OrganView& view_;
  Mode mode_ = Mode::explore;
  bool alwaysShown_ = false;
  std::function<bool(const Vec3&)> shownWhere_;
  bool played_ = false;                           ///< What is shown is a sequence's pose.
  bool fromWidget_ = false;                       ///< The widget already shows what is being changed.
  std::optional<document::UndoStack::Step> drag_; ///< Of handles at rest.
  bool dragFailed_ = false;                       ///< This drag has met an error and said so.
  std::vector<unsigned long> observers_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
