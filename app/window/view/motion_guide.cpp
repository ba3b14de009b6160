#include "window/view/motion_guide.h"

#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"

namespace viscera::app {
namespace {
/// Half a side of the mirror plane, as a part of the organ's diagonal.
constexpr double kHalfSide = 0.42;
} // namespace

MotionGuide::MotionGuide(Workspace& workspace, PoseEditor& poses, const ViewModel& model,
                         scene::OrganView& view, QObject* parent)
    : QObject(parent), workspace_(workspace), poses_(poses), model_(model), view_(view) {
  connect(&poses, &PoseEditor::gestureChanged, this, &MotionGuide::syncConstraint);
  connect(&model, &ViewModel::changed, this, &MotionGuide::syncMirror);
  subscriptions_.push_back(workspace.onChange([this](const document::Change& change) {
    if (change.organs())
      syncMirror();
  }));
  subscriptions_.push_back(workspace.selection().onChange([this] { syncMirror(); }));
}

void MotionGuide::syncConstraint() {
  const live::LockedMotion* motion = poses_.motion();
  const int held = view_.handles()->GetActiveHandle();
  const Vec3 normal = motion ? motion->planeNormal() : Vec3(Vec3::Zero());
  if (held >= 0 && normal.norm() > 0 && held < motion->pose().rows())
    view_.constraint().show(motion->pose().row(held).transpose(), normal);
  else
    view_.constraint().hide();
  Q_EMIT changed();
}

void MotionGuide::syncMirror() {
  const auto plane = poses_.mirrorPlane();
  const auto organ = workspace_.currentOrgan();
  if (plane && organ && model_.state().shown.tools)
    view_.mirrorPlane().show(plane->point, plane->normal,
                             kHalfSide * boundsOf(organ->mesh->points).diagonal());
  else
    view_.mirrorPlane().hide();
  Q_EMIT changed();
}

} // namespace viscera::app
