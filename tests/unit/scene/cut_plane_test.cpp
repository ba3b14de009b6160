#include <cmath>

#include <gtest/gtest.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>

#include "viscera/scene/vtkVisceraCutPlaneRepresentation.h"
#include "viscera/scene/vtkVisceraCutPlaneWidget.h"

#include "shapes.h"
#include "view_fixture.h"

namespace viscera::scene {
namespace {

class CutPlaneWidget : public testing::Test {
protected:
  CutPlaneWidget() : window(400, 300), mouse(window.surface.interactor()) {
    window.addOrgan(tests::sphere(3, 40));
    window.view.lookFrom(StandardView::anterior);
    plane->SetBall(Vec3::Zero(), 40);
    plane->SetPlane({Vec3::Zero(), Vec3(0.3, 1, -0.2).normalized()});
    plane->SetRenderer(window.view.renderer());
    widget->SetRepresentation(plane);
    widget->SetInteractor(window.surface.interactor());
    widget->SetDefaultRenderer(window.view.renderer());
    widget->SetCurrentRenderer(window.view.renderer());
    widget->SetEnabled(1);
    window.render();
  }
  ~CutPlaneWidget() override { widget->SetEnabled(0); }

  vtkNew<vtkVisceraCutPlaneRepresentation> plane;
  vtkNew<vtkVisceraCutPlaneWidget> widget;
  tests::ViewInWindow window;
  tests::Mouse mouse;
};

TEST_F(CutPlaneWidget, TheArrowPushesThePlaneAlongItsNormal) {
  const CutPlane before = plane->GetPlane();
  const auto from = window.display(plane->GetArrowTip());
  const auto to = window.display(plane->GetArrowTip() - 12 * before.normal);
  mouse.drag(from[0], from[1], to[0], to[1]);
  const CutPlane after = plane->GetPlane();
  EXPECT_NEAR((after.normal - before.normal).norm(), 0, 1e-12);
  EXPECT_NEAR((after.origin - before.origin).dot(before.normal), -12, 1.5);
}

TEST_F(CutPlaneWidget, TheRimTiltsThePlaneAboutItsMiddle) {
  const CutPlane before = plane->GetPlane();
  const Vec3 middle = plane->GetMiddle();
  const auto from = window.display(plane->GetRimPoint(0.4));
  mouse.drag(from[0], from[1], from[0] + 6, from[1] + 25);
  EXPECT_LT(plane->GetPlane().normal.dot(before.normal), 0.999);
  EXPECT_NEAR(plane->GetPlane().normal.norm(), 1, 1e-12);
  EXPECT_NEAR((plane->GetMiddle() - middle).norm(), 0, 1e-9);
}

TEST_F(CutPlaneWidget, ElsewhereTheCameraTurnsAndThePlaneStays) {
  const CutPlane before = plane->GetPlane();
  const Vec3 eye(window.view.renderer()->GetActiveCamera()->GetPosition());
  mouse.drag(20, 20, 80, 40);
  EXPECT_EQ(plane->GetPlane(), before);
  EXPECT_GT((Vec3(window.view.renderer()->GetActiveCamera()->GetPosition()) - eye).norm(), 1);
  EXPECT_FALSE(widget->IsUnderCursor());
}

TEST_F(CutPlaneWidget, ACancelledDragPutsThePlaneBack) {
  const CutPlane before = plane->GetPlane();
  const auto from = window.display(plane->GetArrowTip());
  mouse.move(from[0], from[1]);
  mouse.press();
  EXPECT_TRUE(widget->IsDragging());
  mouse.move(from[0] + 20, from[1] - 30);
  EXPECT_FALSE(plane->GetPlane() == before);
  widget->CancelDrag();
  EXPECT_EQ(plane->GetPlane(), before);
  mouse.release();
}

TEST_F(CutPlaneWidget, ThePlaneNeverLeavesWhatItCuts) {
  const auto from = window.display(plane->GetArrowTip());
  const auto to = window.display(plane->GetArrowTip() - 300 * plane->GetPlane().normal);
  mouse.drag(from[0], from[1], to[0], to[1]);
  EXPECT_LE(plane->GetMiddle().norm(), 40 + 1e-9);
}

} // namespace
} // namespace viscera::scene
