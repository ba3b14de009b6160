#include "window/view/click_tool.h"

#include "viscera/deformation/place_handles.h"
#include "viscera/document/rig_commands.h"

namespace viscera::app {

ClickTool::ClickTool(Workspace& workspace, ViewWidget& view, OrganScene& organs, HandleScene& handles,
                     GizmoScene& gizmo, QObject* parent)
    : QObject(parent), workspace_(workspace), view_(view), organs_(organs), handles_(handles), gizmo_(gizmo) {
  connect(&view, &ViewWidget::clicked, this, &ClickTool::onClick);
}

void ClickTool::onClick(const QPointF& place, Qt::KeyboardModifiers modifiers) {
  if (paused_ || mode_ == Mode::stress) // There a click asks for values.
    return;
  if (handles_.handleUnderMouse() || gizmo_.underMouse() ||
      (modifiers & (Qt::ShiftModifier | Qt::ControlModifier)))
    return;
  const auto pick = view_.pickNear(place);
  if (!pick) {
    workspace_.selection().clear();
    return;
  }
  if (mode_ == Mode::handles)
    addHandle(*pick);
  else
    workspace_.selection().setOrgan(organs_.organOf(pick->organ));
}

void ClickTool::addHandle(const scene::SurfacePick& pick) {
  const auto organ = workspace_.document().organ(organs_.organOf(pick.organ));
  if (!organ)
    return;
  const double offset = deformation::Placement().offsetFraction * boundsOf(organ->mesh->points).diagonal();
  document::NewHandle handle;
  handle.rest = pick.position + offset * pick.normal;
  if (!workspace_.perform(document::addHandles({handle}, workspace_.selection().group())))
    return;
  workspace_.selection().setHandles({workspace_.document().rig().handles.back().id});
}

} // namespace viscera::app
