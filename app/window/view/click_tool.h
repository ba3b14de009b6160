#pragma once

#include <QObject>

#include "window/mode.h"
#include "window/view/gizmo_scene.h"
#include "window/view/handle_scene.h"
#include "window/view/organ_scene.h"
#include "window/view/view_widget.h"

namespace viscera::app {

/// What a click on the view does: selects an organ, or in Handles mode adds a handle a little off the
/// surface.
class ClickTool final : public QObject {
  Q_OBJECT

public:
  ClickTool(Workspace& workspace, ViewWidget& view, OrganScene& organs, HandleScene& handles,
            GizmoScene& gizmo, QObject* parent = nullptr);

  void setMode(Mode mode) { mode_ = mode; }
  /// While clicks are meant for somebody else.
  void setPaused(bool paused) { paused_ = paused; }

private:
  void onClick(const QPointF& place, Qt::KeyboardModifiers modifiers);
  void addHandle(const scene::SurfacePick& pick);

  Workspace& workspace_;
  ViewWidget& view_;
  OrganScene& organs_;
  HandleScene& handles_;
  GizmoScene& gizmo_;
  Mode mode_ = Mode::explore;
  bool paused_ = false;
};

} // namespace viscera::app
