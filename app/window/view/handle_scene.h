#pragma once

#include <QObject>

#include "viscera/scene/handle_event.h"
#include "viscera/scene/organ_view.h"
#include "window/pose_editor.h"
#include "window/view/view_model.h"
#include "window/workspace.h"

namespace viscera::app {

/// Keeps the handle widget as the document and the selection have them, and turns what the mouse does with it
/// into commands: at rest it edits the rest shape, else the pose, where locked volumes are kept. One drag is
/// one undo step.
class HandleScene final : public QObject {
  Q_OBJECT

public:
  HandleScene(Workspace& workspace, PoseEditor& poses, const ViewModel& model, scene::OrganView& view,
              QObject* parent = nullptr);
  ~HandleScene() override;

  /// Whether there are handles to be seen, by the mode or always.
  bool shown() const { return seen_.handles || alwaysShown_; }
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
  void syncView();
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
  const ViewModel& model_;
  scene::OrganView& view_;
  presentation::Shown seen_; ///< As the view had it last: a drag ends as it began.
  bool alwaysShown_ = false;
  std::function<bool(const Vec3&)> shownWhere_;
  bool fromWidget_ = false; ///< The widget already shows what is being changed.
  bool dragFailed_ = false; ///< This drag has met an error and said so.
  std::vector<unsigned long> observers_;
  std::vector<Subscription> subscriptions_;
};

} // namespace viscera::app
