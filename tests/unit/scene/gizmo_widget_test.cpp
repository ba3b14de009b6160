#include "viscera/scene/vtkVisceraGizmoWidget.h"

#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <vtkCamera.h>

#include "view_fixture.h"
#include "viscera/scene/helper_glyphs.h"
#include "viscera/scene/vtkVisceraGizmoRepresentation.h"

namespace viscera::scene {
namespace {

using Gizmo = vtkVisceraGizmoRepresentation;
using Widget = vtkVisceraGizmoWidget;

class GizmoWidget : public testing::Test {
protected:
  void SetUp() override {
    window.view.lookFrom(StandardView::anterior, {Vec3::Constant(-100), Vec3::Constant(100)});
    gizmo->SetCenter(Vec3(5, 0, -8));
    gizmo->SetVisibility(true);
    const auto listen = [this](unsigned long event, const char* name) {
      observe(window.view.gizmoWidget(), event, [this, name](const GizmoEvent& payload) {
        events.emplace_back(name);
        last = payload;
      });
    };
    listen(Widget::GrabbedEvent, "grabbed");
    listen(Widget::MovedEvent, "moved");
    listen(Widget::ReleasedEvent, "released");
    listen(Widget::CancelledEvent, "cancelled");
    window.render();
  }

  std::array<double, 3> grab(int part) {
    const auto at = window.display(gizmo->GetGrabPoint(part));
    mouse.move(at[0], at[1]);
    mouse.press();
    return at;
  }

  tests::ViewInWindow window;
  tests::Mouse mouse{window.surface.interactor()};
  Gizmo* gizmo = window.view.gizmo();
  std::vector<std::string> events;
  GizmoEvent last;
};

TEST_F(GizmoWidget, ARingThatFacesTheReaderTurnsByTheAngleOfTheCursor) {
  const auto middle = window.display(gizmo->GetCenter());
  const auto at = grab(Gizmo::RingY);
  ASSERT_EQ(gizmo->GetActivePart(), Gizmo::RingY);
  // A quarter of a turn around the middle, against the clock for the reader, in two steps.
  const double x = at[0] - middle[0], y = at[1] - middle[1];
  mouse.move(middle[0] + (x - y) * std::numbers::sqrt2 / 2, middle[1] + (x + y) * std::numbers::sqrt2 / 2);
  mouse.move(middle[0] - y, middle[1] + x);
  EXPECT_TRUE(last.rotates);
  // The reader looks along +y: what is against the clock for them turns about -y.
  EXPECT_NEAR(last.angle, -std::numbers::pi / 2, 0.05);
  EXPECT_EQ(last.axis, Vec3(Vec3::UnitY()));
  EXPECT_EQ(last.center, Vec3(5, 0, -8));
  mouse.release();
  EXPECT_EQ(events.front(), "grabbed");
  EXPECT_EQ(events.back(), "released");
}

TEST_F(GizmoWidget, TurningOnBeyondHalfATurnDoesNotJumpBack) {
  const auto middle = window.display(gizmo->GetCenter());
  const auto at = grab(Gizmo::RingY);
  const double x = at[0] - middle[0], y = at[1] - middle[1];
  double before = 0;
  for (int step = 1; step <= 20; ++step) {
    const double angle = 1.5 * 2 * std::numbers::pi * step / 20;
    mouse.move(middle[0] + x * std::cos(angle) - y * std::sin(angle),
               middle[1] + x * std::sin(angle) + y * std::cos(angle));
    EXPECT_NEAR(last.angle - before, -1.5 * 2 * std::numbers::pi / 20, 0.08) << step;
    before = last.angle;
  }
}

TEST_F(GizmoWidget, ARingSeenFromItsSideTurnsByTheMotionAlongIt) {
  const auto at = grab(Gizmo::RingX);
  ASSERT_EQ(gizmo->GetActivePart(), Gizmo::RingX);
  mouse.move(at[0], at[1] + 20);
  const double up = last.angle;
  EXPECT_GT(std::abs(up), 0.05);
  mouse.move(at[0], at[1] - 20);
  EXPECT_NEAR(last.angle, -up, 0.02);
  EXPECT_EQ(last.axis, Vec3(Vec3::UnitX()));
}

TEST_F(GizmoWidget, ACubeScalesAlongItsAxisAndTheMiddleEvenly) {
  const auto middle = window.display(gizmo->GetCenter());
  auto at = grab(Gizmo::CubeZ);
  ASSERT_EQ(gizmo->GetActivePart(), Gizmo::CubeZ);
  mouse.move(at[0], at[1] + 0.5 * (at[1] - middle[1]));
  EXPECT_FALSE(last.rotates);
  EXPECT_NEAR(last.factors.z(), 1.5, 0.03);
  EXPECT_EQ(last.factors.x(), 1);
  mouse.release();
  at = grab(Gizmo::Middle);
  ASSERT_EQ(gizmo->GetActivePart(), Gizmo::Middle);
  mouse.move(at[0] - 30, at[1]);
  EXPECT_LT(last.factors.x(), 1);
  EXPECT_EQ(last.factors, Vec3(Vec3::Constant(last.factors.x())));
  mouse.move(at[0] - 4000, at[1]);
  EXPECT_GT(last.factors.x(), 0) << "nothing is turned inside out";
}

TEST_F(GizmoWidget, EscapeCancelsAndTheCameraIsLeftAlone) {
  const Vec3 before(window.view.renderer()->GetActiveCamera()->GetPosition());
  const auto at = grab(Gizmo::RingY);
  mouse.move(at[0] + 20, at[1] + 20);
  mouse.key("Escape");
  EXPECT_EQ(events.back(), "cancelled");
  const auto count = events.size();
  mouse.release();
  EXPECT_EQ(events.size(), count);
  EXPECT_EQ(Vec3(window.view.renderer()->GetActiveCamera()->GetPosition()), before);
}

TEST_F(GizmoWidget, HiddenItLetsTheMouseThrough) {
  const Vec3 ring = gizmo->GetGrabPoint(Gizmo::RingY);
  gizmo->SetVisibility(false);
  const auto at = window.display(ring);
  mouse.drag(at[0], at[1], at[0] + 30, at[1]);
  EXPECT_TRUE(events.empty());
}

TEST_F(GizmoWidget, KeepsItsSizeOnTheScreen) {
  const auto size = [this] {
    window.render();
    const auto a = window.display(gizmo->GetCenter()), b = window.display(gizmo->GetGrabPoint(Gizmo::CubeX));
    return std::hypot(a[0] - b[0], a[1] - b[1]);
  };
  const double before = size();
  window.view.renderer()->GetActiveCamera()->Dolly(1.7);
  EXPECT_NEAR(size(), before, 1);
}

TEST_F(GizmoWidget, TheMirrorPlaneIsShownAndHidden) {
  EXPECT_FALSE(window.view.mirrorPlane().visible());
  window.view.mirrorPlane().show({0, 0, 0}, Vec3::UnitX(), 50);
  EXPECT_TRUE(window.view.mirrorPlane().visible());
  window.render();
  window.view.mirrorPlane().hide();
  EXPECT_FALSE(window.view.mirrorPlane().visible());
}

} // namespace
} // namespace viscera::scene
