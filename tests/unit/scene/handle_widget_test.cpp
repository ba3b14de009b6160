#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include "viscera/scene/picture.h"

#include "shapes.h"
#include "view_fixture.h"

namespace viscera::scene {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using tests::Mouse;
using tests::ViewInWindow;

constexpr double kRadius = 50;

/// A ball of 50 mm, seen from the front (from -y), with the handles that a test puts around it.
class HandleWidget : public testing::Test {
protected:
  HandleWidget() : organ(window.addOrgan(tests::sphere(4, kRadius))), handles(window.view.handles()) {
    window.view.lookFrom(StandardView::anterior, {Vec3::Constant(-100), Vec3::Constant(100)});
    window.render();
    const std::vector<std::pair<unsigned long, std::string>> events = {
        {vtkVisceraHandleSetWidget::HandleHoveredEvent, "hovered"},
        {vtkVisceraHandleSetWidget::HandleGrabbedEvent, "grabbed"},
        {vtkVisceraHandleSetWidget::HandleMovedEvent, "moved"},
        {vtkVisceraHandleSetWidget::HandleReleasedEvent, "released"},
        {vtkVisceraHandleSetWidget::HandleCancelledEvent, "cancelled"},
        {vtkVisceraHandleSetWidget::SelectionChangedEvent, "selected"}};
    for (const auto& [event, name] : events)
      observe(window.view.handleWidget(), event, [this, text = name](const HandleEvent& payload) {
        log.push_back(text + " " + std::to_string(payload.handle));
        last = payload;
        if (onEvent)
          onEvent(text);
      });
  }

  void place(const std::vector<Vec3>& positions) {
    Points points(Eigen::Index(positions.size()), 3);
    for (std::size_t i = 0; i < positions.size(); ++i)
      points.row(Eigen::Index(i)) = positions[i].transpose();
    handles->SetPositions(points);
  }
  int pick(const Vec3& point) {
    const auto at = window.display(point);
    return handles->PickHandle(static_cast<int>(at[0] + 0.5), static_cast<int>(at[1] + 0.5));
  }
  /// Presses on a handle; returns where.
  std::array<double, 3> grab(int handle) {
    const auto at = window.display(handles->GetPosition(handle));
    mouse.move(at[0], at[1]);
    mouse.press();
    return at;
  }
  Vec3 eye() { return Vec3(window.view.renderer()->GetActiveCamera()->GetPosition()); }

  ViewInWindow window;
  Mouse mouse{window.surface.interactor()};
  std::shared_ptr<OrganActor> organ;
  vtkVisceraHandleSetRepresentation* handles;
  std::vector<std::string> log;
  HandleEvent last;
  std::function<void(const std::string&)> onEvent;
};

TEST_F(HandleWidget, OfOverlappingHandlesTheOneNearestToTheEyeIsPickedWhateverTheOrder) {
  const Vec3 sight = Vec3(30, -70, 20) - eye();
  const Vec3 near = eye() + 0.9 * sight, far = eye() + sight;
  place({far, near});
  EXPECT_EQ(pick(far), 1);
  place({near, far});
  EXPECT_EQ(pick(far), 0);
}

TEST_F(HandleWidget, TheBallUnderTheCursorIsPreferredToANearerOneThatIsOnlyClose) {
  handles->SetPickRadius(24);
  const double pixel = handles->GetHandleRadius();
  place({{0, -60, 60}});
  const double mmPerPixel = handles->GetWorldRadius(0) / pixel;
  // 22 pixels to the right of the first, and nearer to the eye.
  place({{0, -60, 60}, {22 * mmPerPixel, -62, 60}});
  EXPECT_EQ(pick({0, -60, 60}), 0);
}

TEST_F(HandleWidget, HandleBehindTheOpaqueOrganCannotBePickedOrGrabbed) {
  place({{0, 70, 0}, {80, 0, 0}});
  EXPECT_EQ(pick({0, 70, 0}), -1);
  EXPECT_FALSE(handles->IsHandleVisible(0));
  EXPECT_TRUE(handles->IsHandleVisible(1));
  const Vec3 before = eye();
  const auto at = window.display(handles->GetPosition(0));
  mouse.drag(at[0], at[1], at[0] + 40, at[1] + 20);
  EXPECT_THAT(log, IsEmpty());
  EXPECT_EQ(handles->GetPosition(0), Vec3(0, 70, 0));
  EXPECT_GT((eye() - before).norm(), 1.0) << "the drag has to go to the camera";
}

TEST_F(HandleWidget, InvisibleOrTranslucentOrCutAwayOrgansDoNotHideHandles) {
  place({{0, 70, 0}});
  organ->setVisible(false);
  EXPECT_EQ(pick({0, 70, 0}), 0);
  organ->setVisible(true);
  organ->setOpacity(0.5);
  EXPECT_EQ(pick({0, 70, 0}), 0);
  organ->setOpacity(1);
  EXPECT_EQ(pick({0, 70, 0}), -1);
  organ->setClipPlane({30, 0, 0}, Vec3::UnitX());
  EXPECT_EQ(pick({0, 70, 0}), 0);
}

TEST_F(HandleWidget, OrganHidesHandlesAsItIsPosedNow) {
  place({{0, 70, 0}});
  auto moved = std::make_shared<Points>(organ->mesh().points);
  moved->col(0).array() += 120;
  organ->setPoints(moved);
  EXPECT_EQ(pick({0, 70, 0}), 0);
  moved->col(0).array() -= 120;
  organ->pointsChanged();
  EXPECT_EQ(pick({0, 70, 0}), -1);
}

TEST_F(HandleWidget, DragMovesExactlyOneHandleUnderTheCursorAndTellsInOrder) {
  place({{0, -60, 0}, {70, 0, 0}, {-70, 0, 10}});
  const Points before = handles->GetPositions();
  const Vec3 eyeBefore = eye();
  const auto at = grab(1);
  mouse.move(at[0] + 10, at[1] + 5);
  mouse.move(at[0] + 25, at[1] + 15);
  mouse.release();
  EXPECT_THAT(log, ElementsAre("hovered 1", "selected 1", "grabbed 1", "moved 1", "moved 1", "released 1"));
  EXPECT_EQ(handles->GetPositions().row(0), before.row(0));
  EXPECT_EQ(handles->GetPositions().row(2), before.row(2));
  const auto now = window.display(handles->GetPosition(1));
  EXPECT_NEAR(now[0] - at[0], 25, 1e-3);
  EXPECT_NEAR(now[1] - at[1], 15, 1e-3);
  EXPECT_NEAR(now[2], at[2], 1e-9) << "without a plane a handle moves parallel to the screen";
  EXPECT_EQ(eye(), eyeBefore);
  EXPECT_EQ(last.position, handles->GetPosition(1));
  EXPECT_EQ(last.start, Vec3(before.row(1).transpose()));
  EXPECT_THAT(last.moving, ElementsAre(1));
}

TEST_F(HandleWidget, GrabbingBesideTheCentreDoesNotMakeTheHandleJump) {
  place({{70, 0, 0}});
  const auto at = window.display(handles->GetPosition(0));
  mouse.move(at[0] + 6, at[1] - 4);
  mouse.press();
  mouse.move(mouse.x() + 1, mouse.y());
  const auto now = window.display(handles->GetPosition(0));
  EXPECT_NEAR(now[0] - at[0], 1, 1e-3);
  EXPECT_NEAR(now[1] - at[1], 0, 1e-3);
}

TEST_F(HandleWidget, DraggingOneOfASelectionMovesAllOfItByTheSameVector) {
  place({{-70, 0, 0}, {70, 0, 0}, {0, -60, 0}});
  handles->SetSelection({0, 2});
  const Points before = handles->GetPositions();
  const auto at = grab(0);
  mouse.move(at[0] + 20, at[1] + 10);
  mouse.release();
  const Vec3 delta = last.delta();
  EXPECT_GT(delta.norm(), 1.0);
  EXPECT_THAT(last.moving, ElementsAre(0, 2));
  EXPECT_EQ(handles->GetPositions().row(1), before.row(1));
  for (const int i : {0, 2})
    EXPECT_LT((handles->GetPositions().row(i) - before.row(i) - delta.transpose()).norm(), 1e-12);
  EXPECT_THAT(handles->GetSelection(), ElementsAre(0, 2));
}

TEST_F(HandleWidget, ClickSelectsAloneAndShiftOrControlTogglesIt) {
  place({{-70, 0, 0}, {70, 0, 0}});
  const auto a = window.display(handles->GetPosition(0)), b = window.display(handles->GetPosition(1));
  mouse.click(a[0], a[1]);
  EXPECT_THAT(handles->GetSelection(), ElementsAre(0));
  mouse.click(b[0], b[1], /*shift=*/true);
  EXPECT_THAT(handles->GetSelection(), ElementsAre(0, 1));
  mouse.click(a[0], a[1], false, /*control=*/true);
  EXPECT_THAT(handles->GetSelection(), ElementsAre(1));
  mouse.click(a[0], a[1], true);
  mouse.click(a[0], a[1]);
  EXPECT_THAT(handles->GetSelection(), ElementsAre(0))
      << "a click without motion leaves the selection to one";
  mouse.click(5, 5);
  EXPECT_THAT(handles->GetSelection(), ElementsAre(0)) << "a click beside all handles belongs to the camera";
}

TEST_F(HandleWidget, EscapePutsEverythingBackAndEndsTheDrag) {
  place({{-70, 0, 0}, {70, 0, 0}});
  handles->SetSelection({0, 1});
  const Points before = handles->GetPositions();
  const auto at = grab(0);
  mouse.move(at[0] + 30, at[1] + 12);
  ASSERT_NE(handles->GetPositions(), before);
  log.clear();
  mouse.key("Escape");
  EXPECT_EQ(handles->GetPositions(), before);
  EXPECT_THAT(log, ElementsAre("moved 0", "cancelled 0"));
  mouse.move(at[0] + 60, at[1]);
  mouse.release();
  EXPECT_EQ(handles->GetPositions(), before);
  EXPECT_FALSE(window.view.handleWidget()->IsDragging());
}

TEST_F(HandleWidget, OtherKeysDoNotCancelADrag) {
  place({{70, 0, 0}});
  const auto at = grab(0);
  mouse.move(at[0] + 30, at[1]);
  mouse.key("a");
  mouse.key(nullptr);
  EXPECT_TRUE(window.view.handleWidget()->IsDragging());
}

TEST_F(HandleWidget, DisablingTheWidgetCancelsTheDrag) {
  place({{70, 0, 0}});
  const auto at = grab(0);
  mouse.move(at[0] + 30, at[1]);
  window.view.handleWidget()->SetEnabled(0);
  EXPECT_EQ(handles->GetPosition(0), Vec3(70, 0, 0));
  EXPECT_EQ(log.back(), "cancelled 0");
}

/// As a window does whose picture no longer shows what was grabbed.
TEST_F(HandleWidget, EndsADragOnceThatIsCancelledAgainAtItsEnd) {
  place({{70, 0, 0}});
  const Vec3 before = handles->GetPosition(0);
  onEvent = [this](const std::string& event) {
    ASSERT_LT(log.size(), 100u) << "no end";
    if (event != "hovered" && event != "grabbed" && event != "selected")
      window.view.handleWidget()->CancelDrag();
  };
  const auto at = grab(0);
  log.clear();
  mouse.move(at[0] + 30, at[1]);
  EXPECT_THAT(log, ElementsAre("moved 0", "moved 0", "cancelled 0")) << "the last move is the way back";
  EXPECT_EQ(handles->GetPosition(0), before);
  EXPECT_FALSE(window.view.handleWidget()->IsDragging());
  mouse.release();

  grab(0);
  log.clear();
  mouse.release();
  EXPECT_THAT(log, ElementsAre("released 0")) << "a drag that was released is not cancelled";
}

TEST_F(HandleWidget, ReplacingTheHandlesDuringADragEndsIt) {
  place({{70, 0, 0}, {-70, 0, 0}});
  const auto at = grab(0);
  place({{0, -70, 0}});
  mouse.move(at[0] + 30, at[1]);
  EXPECT_FALSE(window.view.handleWidget()->IsDragging());
  EXPECT_EQ(handles->GetPosition(0), Vec3(0, -70, 0));
}

TEST_F(HandleWidget, DragFollowsTheCursorWithAParallelCameraToo) {
  window.view.renderer()->GetActiveCamera()->ParallelProjectionOn();
  place({{70, 0, 0}});
  const auto at = grab(0);
  mouse.move(at[0] + 25, at[1] - 15);
  const auto now = window.display(handles->GetPosition(0));
  EXPECT_NEAR(now[0] - at[0], 25, 1e-3);
  EXPECT_NEAR(now[1] - at[1], -15, 1e-3);
}

TEST_F(HandleWidget, LockedHandlesAreSelectedButNotDragged) {
  place({{70, 0, 0}, {-70, 0, 0}});
  handles->SetHandleLocked(0, true);
  const auto at = grab(0);
  mouse.move(at[0] + 30, at[1]);
  mouse.release();
  EXPECT_EQ(handles->GetPosition(0), Vec3(70, 0, 0));
  EXPECT_THAT(handles->GetSelection(), ElementsAre(0));
  handles->SetSelection({0, 1});
  const auto other = grab(1);
  mouse.move(other[0] + 10, other[1]);
  EXPECT_THAT(last.moving, ElementsAre(1)) << "a locked handle stays when the selection is dragged";
}

TEST_F(HandleWidget, HandlesThatAreNotShownAreNotPicked) {
  place({{70, 0, 0}});
  handles->SetHandleShown(0, false);
  EXPECT_EQ(pick({70, 0, 0}), -1);
  EXPECT_EQ(handles->GetWorldRadius(0), 0);
}

TEST_F(HandleWidget, HandlesBehindTheCameraAreNeitherPickedNorDrawn) {
  organ->setVisible(false);
  place({eye() + 2 * (eye() - Vec3(0, 0, 0))});
  EXPECT_EQ(handles->GetWorldRadius(0), 0);
  for (int x = 0; x < 400; x += 10)
    for (int y = 0; y < 300; y += 10)
      ASSERT_EQ(handles->PickHandle(x, y), -1);
}

TEST_F(HandleWidget, NoHandlesAtAllIsAnOrdinaryState) {
  place({});
  EXPECT_EQ(handles->PickHandle(200, 150), -1);
  mouse.drag(200, 150, 220, 160);
  window.render();
  EXPECT_THAT(log, IsEmpty());
}

TEST_F(HandleWidget, HandlesKeepTheirSizeOnTheScreenAtAnyZoom) {
  place({{20, -60, 10}});
  auto* camera = window.view.renderer()->GetActiveCamera();
  for (const double zoom : {1.0, 3.0, 0.25}) {
    camera->Dolly(zoom);
    window.view.renderer()->ResetCameraClippingRange();
    const Vec3 center = handles->GetPosition(0);
    const auto a = window.display(center),
               b = window.display(center + handles->GetWorldRadius(0) * Vec3::UnitZ());
    EXPECT_NEAR(b[1] - a[1], handles->GetHandleRadius(), 0.05) << zoom;
    camera->Dolly(1 / zoom);
  }
}

TEST_F(HandleWidget, FarHandlesAreSmallerUnlessSomebodyWorksWithThem) {
  std::vector<Vec3> row;
  for (int i = 0; i < 12; ++i)
    row.emplace_back(-60, -60 + 10 * i, 5 * i - 30);
  place(row);
  const auto pixels = [this](int handle) {
    const Vec3 center = handles->GetPosition(handle);
    const auto a = window.display(center),
               b = window.display(center + handles->GetWorldRadius(handle) * Vec3::UnitZ());
    return b[1] - a[1];
  };
  const double whole = handles->GetHandleRadius();
  EXPECT_NEAR(pixels(0), whole, 0.05);
  EXPECT_NEAR(pixels(2), whole, 0.05) << "near ones are alike";
  EXPECT_LT(pixels(8), 0.9 * whole);
  EXPECT_LT(pixels(11), pixels(8));
  EXPECT_GT(pixels(11), 0.5 * whole) << "it can still be seen";
  handles->SetSelection({11});
  EXPECT_NEAR(pixels(11), whole, 0.05) << "selected";
  EXPECT_LT(pixels(10), 0.9 * whole);
  handles->SetActiveHandle(10);
  EXPECT_GT(pixels(10), whole) << "under the mouse";
}

TEST_F(HandleWidget, GhostsOfFarHandlesHideLessOfTheOrgan) {
  std::vector<Vec3> row; // All but one behind the organ, one behind the other.
  for (int i = 0; i < 12; ++i)
    row.emplace_back(i == 0 ? 0 : 30 * (i % 2 ? 1 : -1), -90 + 16 * i, 0);
  const auto ghostAt = [&](int handle) {
    place(row);
    const auto at = window.display(handles->GetPosition(handle));
    const auto x = static_cast<int>(at[0]), y = static_cast<int>(at[1]);
    const auto brightness = [&] {
      window.render();
      const auto picture = grabPicture(window.surface.window());
      const auto* p = static_cast<const unsigned char*>(picture->GetScalarPointer(x, y, 0));
      return Vec3(p[0], p[1], p[2]);
    };
    const Vec3 with = brightness();
    for (int i = 0; i < 12; ++i)
      handles->SetHandleShown(i, false);
    return (with - brightness()).norm();
  };
  organ->setColor({0.2, 0.2, 0.6});
  const double near = ghostAt(4), far = ghostAt(11);
  EXPECT_GT(near, 8);
  EXPECT_LT(far, 0.5 * near);
}

TEST_F(HandleWidget, HandlesAreLargerOnADenseScreenAndUnderTheCursor) {
  place({{70, 0, 0}});
  const double plain = handles->GetWorldRadius(0);
  window.surface.window()->SetDPI(144);
  EXPECT_NEAR(handles->GetWorldRadius(0), 2 * plain, 1e-9 * plain);
  window.surface.window()->SetDPI(72);
  const auto at = window.display(handles->GetPosition(0));
  mouse.move(at[0], at[1]);
  EXPECT_GT(handles->GetWorldRadius(0), plain);
  mouse.leave();
  EXPECT_EQ(handles->GetWorldRadius(0), plain);
  EXPECT_THAT(log, ElementsAre("hovered 0", "hovered -1"));
}

TEST_F(HandleWidget, MovesThatChangeNothingDoNotRender) {
  place({{70, 0, 0}});
  int renders = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&renders);
  count->SetCallback([](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  window.view.renderer()->AddObserver(vtkCommand::EndEvent, count);
  for (int i = 0; i < 10; ++i)
    mouse.move(10 + i, 10);
  EXPECT_EQ(renders, 0);
  const auto at = window.display(handles->GetPosition(0));
  mouse.move(at[0], at[1]);
  mouse.move(at[0] + 1, at[1]);
  EXPECT_EQ(renders, 1);
  mouse.press();
  renders = 0;
  mouse.move(at[0] + 5, at[1]);
  EXPECT_EQ(renders, 1);
}

TEST_F(HandleWidget, CameraDragsDoNotHoverOverHandles) {
  place({{70, 0, 0}});
  const auto at = window.display(handles->GetPosition(0));
  mouse.move(20, 20);
  mouse.press();
  mouse.move(at[0], at[1]);
  EXPECT_THAT(log, IsEmpty());
  mouse.release();
}

TEST_F(HandleWidget, ListenerMayPutTheHandleSomewhereElseWhileItIsDragged) {
  place({{70, 0, 0}});
  onEvent = [&](const std::string& event) {
    if (event == "moved")
      handles->SetPosition(0, {70, 0, 33});
  };
  const auto at = grab(0);
  mouse.move(at[0] + 12, at[1]);
  mouse.release();
  EXPECT_EQ(handles->GetPosition(0), Vec3(70, 0, 33));
}

TEST_F(HandleWidget, SelectionDropsRepetitionsAndHandlesThatDoNotExist) {
  place({{70, 0, 0}, {-70, 0, 0}});
  handles->SetSelection({1, 7, 1, -2, 0});
  EXPECT_THAT(handles->GetSelection(), ElementsAre(0, 1));
  place({{70, 0, 0}});
  EXPECT_THAT(handles->GetSelection(), IsEmpty());
}

} // namespace
} // namespace viscera::scene
