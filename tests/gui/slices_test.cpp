#include "window_test.h"

#include <QAction>
#include <QTest>
#include <QWheelEvent>

#include "phantom_scan.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/scan_item.h"
#include "window/slices/scan_actions.h"
#include "window/slices/slice_panes.h"
#include "window/view/picture.h"

namespace viscera::tests {
namespace {

/// A ball of 60 mm radius with its handles, and a scan in which that ball is brighter than what is around it.
class SlicesTest : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile());
    window().workspace().perform(document::openScan(document::scanItem(
        phantomScan({66, 66, 66}, Vec3(3, 3, 3), Vec3(-97.5, -97.5, -97.5), ballValue(Vec3::Zero(), 60)),
        {})));
    window().scans().opened();
    settle();
  }

  app::SliceWidget& slice(int direction) { return window().slices().widget(direction); }
  const presentation::ScanLook& look() { return window().viewModel().state().scan; }
  Vec3 focus() { return presentation::focusOf(window().workspace().state(), look()); }
  const geometry::PlaneCut& contour(int direction) {
    return *window().slices().presenter().cut(direction, document().organs().front()->id);
  }
  QPoint placeIn(int direction, const Vec3& point) {
    return slice(direction).placeOf(window().slices().presenter().frame(direction).pixelOf(point)).toPoint();
  }
  void dragIn(int direction, Qt::MouseButton button, const QPoint& from, const QPoint& to,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    constexpr int kSteps = 6;
    const auto send = [&](QEvent::Type type, const QPoint& at, Qt::MouseButton which, Qt::MouseButtons down) {
      QMouseEvent event(type, at, slice(direction).mapToGlobal(at), which, down, modifiers);
      QCoreApplication::sendEvent(&slice(direction), &event);
    };
    send(QEvent::MouseButtonPress, from, button, button);
    for (int step = 1; step <= kSteps; ++step)
      send(QEvent::MouseMove, from + (to - from) * step / kSteps, Qt::NoButton, button);
    send(QEvent::MouseButtonRelease, to, button, Qt::NoButton);
    settle();
  }
  void turnWheel(int direction, int steps, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    const QPoint at = slice(direction).rect().center();
    QWheelEvent event(at, slice(direction).mapToGlobal(at), {}, QPoint(0, 120 * steps), Qt::NoButton,
                      modifiers, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(&slice(direction), &event);
    settle();
  }
};

TEST_F(SlicesTest, AScanThatIsOpenedComesInFourViewsAndKeysChooseAnother) {
  EXPECT_EQ(look().layout, "four");
  for (int direction = 0; direction < 3; ++direction)
    EXPECT_TRUE(slice(direction).isVisible());
  EXPECT_TRUE(view().isVisible());
  key(Qt::Key_F8);
  EXPECT_TRUE(slice(1).isVisible());
  EXPECT_FALSE(slice(0).isVisible() || slice(2).isVisible() || view().isVisible());
  EXPECT_GT(slice(1).height(), 0.9 * window().viewArea().height()) << "one slice alone has all the room";
  key(Qt::Key_F6, Qt::ShiftModifier);
  EXPECT_TRUE(view().isVisible());
  EXPECT_FALSE(slice(0).isVisible() || slice(1).isVisible() || slice(2).isVisible());
}

TEST_F(SlicesTest, TheWheelTurnsTheSlicesTowardsHeadAndFront) {
  const Vec3 before = focus();
  turnWheel(0, 2);
  EXPECT_LT((focus() - before - Vec3(0, 0, 6)).norm(), 1e-9);
  turnWheel(1, 1);
  EXPECT_LT((focus() - before - Vec3(0, -3, 6)).norm(), 1e-9);
  EXPECT_LT(contour(0).points.rowwise().norm().maxCoeff(), 61);
  EXPECT_NEAR(contour(0).points.col(2).minCoeff(), 6, 1e-9) << "the contour is the new slice's";
}

TEST_F(SlicesTest, ACrosshairIsOnePlaceInAllSlices) {
  const QPoint at = placeIn(0, Vec3(30, -24, 0)); // Far from the lines of the crosshair.
  QTest::mouseClick(&slice(0), Qt::LeftButton, Qt::NoModifier, at);
  settle();
  const double pixel = window().slices().presenter().frame(0).right.norm();
  EXPECT_LT((focus() - Vec3(30, -24, 0)).norm(), 2 * pixel);
  EXPECT_NEAR(window().slices().presenter().frame(2).corner.x(), focus().x(), 1e-9);
  EXPECT_NEAR(window().slices().presenter().frame(1).corner.y(), focus().y(), 1e-9);
  // A drag that begins on it takes it along.
  dragIn(2, Qt::LeftButton, placeIn(2, focus()), placeIn(2, focus() + Vec3(0, 9, 21)));
  EXPECT_LT((focus() - Vec3(30, -15, 21)).norm(), 5 * pixel);
}

TEST_F(SlicesTest, ADragChangesLevelAndWidthAndAPresetSetsThem) {
  const QPoint away = placeIn(0, Vec3(40, 40, 0));
  dragIn(0, Qt::LeftButton, away, away + QPoint(60, 0));
  EXPECT_GT(look().width, 410);
  EXPECT_NEAR(look().level, 40, 1e-9);
  dragIn(0, Qt::LeftButton, away, away + QPoint(0, -60));
  EXPECT_GT(look().level, 60);
  window().actions()["scan.lung"]->trigger();
  EXPECT_EQ(look().level, -600);
  EXPECT_EQ(look().width, 1500);
  EXPECT_TRUE(window().actions()["scan.lung"]->isChecked());
  window().actions()["scan.automatic"]->trigger();
  EXPECT_EQ(look().width, 0);
}

TEST_F(SlicesTest, PanAndZoomKeepWhatIsUnderTheMouse) {
  const Vec3 grabbed(20, 30, 0);
  const QPoint from = placeIn(0, grabbed), to = from + QPoint(36, -24);
  dragIn(0, Qt::MiddleButton, from, to);
  EXPECT_LT((placeIn(0, grabbed) - to).manhattanLength(), 10) << "but for the way before a drag is one";
  const QPoint middle = slice(0).rect().center();
  const double before = window().slices().presenter().frame(0).right.norm();
  const Vec3 there =
      window().slices().presenter().frame(0).at(slice(0).pixelAt(middle).x(), slice(0).pixelAt(middle).y());
  turnWheel(0, 3, Qt::ControlModifier);
  EXPECT_LT(window().slices().presenter().frame(0).right.norm(), 0.8 * before);
  EXPECT_LT((placeIn(0, there) - middle).manhattanLength(), 3);
}

TEST_F(SlicesTest, SaysWhatIsUnderTheCursor) {
  const Vec3 inside(12, -30, 0), outside(80, 80, 0);
  const auto hover = [&](const Vec3& place) {
    QMouseEvent event(QEvent::MouseMove, placeIn(0, place), slice(0).mapToGlobal(placeIn(0, place)),
                      Qt::NoButton, Qt::NoButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&slice(0), &event);
    return slice(0).reading();
  };
  const QString in = hover(inside), out = hover(outside);
  EXPECT_TRUE(in.contains(QStringLiteral("100 HU"))) << in.toStdString();
  EXPECT_TRUE(in.contains(QStringLiteral("ball"))) << in.toStdString();
  EXPECT_TRUE(in.contains(QStringLiteral("A 30")) || in.contains(QStringLiteral("A 29"))) << in.toStdString();
  EXPECT_TRUE(out.contains(QStringLiteral("-50 HU"))) << out.toStdString();
  EXPECT_FALSE(out.contains(QStringLiteral("ball"))) << out.toStdString();
}

TEST_F(SlicesTest, ContoursFollowAHandleWhileItIsDragged) {
  key(Qt::Key_3); // Deform
  const double before = contour(1).points.col(2).maxCoeff();
  EXPECT_NEAR(before, 60, 0.5);
  Points higher = document().rig().restPositions();
  higher.col(2).array() += 40;
  std::vector<document::HandleId> all;
  for (const document::Handle& handle : document().rig().handles)
    all.push_back(handle.id);
  document::UndoStack::Step step(window().workspace().undo(), "Drag");
  window().workspace().perform(document::moveHandles(all, higher));
  QTest::qWait(50); // The drag goes on.
  EXPECT_NEAR(contour(1).points.col(2).maxCoeff(), before + 40, 0.1);
  step.finish();
  window().actions()["edit.undo"]->trigger();
  settle();
  EXPECT_NEAR(contour(1).points.col(2).maxCoeff(), before, 1e-6);
}

TEST_F(SlicesTest, AScanIsOneStepThatCanBeUndone) {
  ASSERT_TRUE(document().state().scan);
  window().actions()["scan.close"]->trigger();
  EXPECT_FALSE(document().state().scan);
  window().actions()["edit.undo"]->trigger();
  EXPECT_TRUE(document().state().scan);
  window().actions()["edit.undo"]->trigger();
  EXPECT_FALSE(document().state().scan);
  EXPECT_EQ(document().organs().size(), 1u);
}

TEST_F(SlicesTest, MovingASliceDrawsNo3DViewUnlessSlicesStandInIt) {
  int pictures = 0;
  const auto counting =
      QObject::connect(&window().picture(), &app::Picture::changed, [&pictures] { ++pictures; });
  turnWheel(0, 1);
  EXPECT_EQ(pictures, 0);
  window().actions()["scan.standing"]->trigger();
  settle();
  EXPECT_EQ(pictures, 1);
  turnWheel(0, 1);
  EXPECT_EQ(pictures, 2);
  QObject::disconnect(counting);
}

} // namespace
} // namespace viscera::tests
