// One event of the mouse during a drag brings each view up to date once, renders it once and stores one pose.
#include "stress_fixture.h"

#include <QCoreApplication>
#include <QMouseEvent>

#include <vector>

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include "phantom_scan.h"
#include "viscera/document/scan_item.h"
#include "viscera/medical_io/slice_frame.h"
#include "viscera/scene/vtkVisceraHandleSetWidget.h"
#include "window/compare/comparison.h"
#include "window/play/play_mode.h"
#include "window/slices/scan_actions.h"
#include "window/slices/slice_panes.h"
#include "window/view/picture.h"

namespace viscera::tests {
namespace {

constexpr int kMoves = 5;

/// Counts the frames of a render window while it lives.
class FrameCounter {
public:
  explicit FrameCounter(vtkRenderWindow* window) : window_(window) {
    counting_->SetClientData(&count_);
    counting_->SetCallback(
        [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
    tag_ = window->AddObserver(vtkCommand::EndEvent, counting_);
  }
  ~FrameCounter() { window_->RemoveObserver(tag_); }
  FrameCounter(const FrameCounter&) = delete;
  FrameCounter& operator=(const FrameCounter&) = delete;
  int count() const { return count_; }

private:
  vtkRenderWindow* window_;
  vtkNew<vtkCallbackCommand> counting_;
  unsigned long tag_ = 0;
  int count_ = 0;
};

class OneUpdate : public StressModeTest {
protected:
  void send(QWidget& to, QEvent::Type type, const QPoint& at) {
    const bool moves = type == QEvent::MouseMove;
    QMouseEvent event(type, at, to.mapToGlobal(at), moves ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease || !held_ ? Qt::NoButton : Qt::LeftButton,
                      Qt::NoModifier);
    QCoreApplication::sendEvent(&to, &event);
  }

  /// Presses there and moves the mouse step by step; every step has to cost one update and one frame.
  void expectOneOfEach(QWidget& widget, app::ViewWidget& drawn, const app::Picture& picture,
                       const QPoint& from) {
    send(widget, QEvent::MouseMove, from);
    held_ = true;
    send(widget, QEvent::MouseButtonPress, from);
    settle();
    ASSERT_TRUE(view().view().handleWidget()->IsDragging());
    const document::DocumentState before = document().state();
    for (int step = 1; step <= kMoves; ++step) {
      int updates = 0, updatesOfSlices = 0;
      const auto counting = QObject::connect(&picture, &app::Picture::changed, [&updates] { ++updates; });
      const auto countingSlices = QObject::connect(&window().slices(), &app::SlicePanes::changed,
                                                   [&updatesOfSlices] { ++updatesOfSlices; });
      const FrameCounter frames(drawn.renderWindow());
      send(widget, QEvent::MouseMove, from + QPoint(9 * step, -4 * step));
      EXPECT_EQ(updates, 0) << "within the event";
      handleEvents();
      QObject::disconnect(counting);
      QObject::disconnect(countingSlices);
      EXPECT_EQ(updates, 1) << "step " << step;
      EXPECT_EQ(updatesOfSlices, window().slices().widget(0).isVisible() ? 1 : 0) << "step " << step;
      EXPECT_EQ(frames.count(), 1) << "step " << step;
    }
    EXPECT_FALSE(document().state() == before);
    held_ = false;
    send(widget, QEvent::MouseButtonRelease, from + QPoint(9 * kMoves, -4 * kMoves));
    settle();
  }
  void expectOneOfEach() { expectOneOfEach(view(), view(), window().picture(), freeHandle()); }

private:
  bool held_ = false;
};

TEST_F(OneUpdate, IsMadeForEachMoveOfAHandleInThePose) {
  key(Qt::Key_3);
  expectOneOfEach();
}

TEST_F(OneUpdate, IsMadeForEachMoveOfAHandleAtRest) {
  key(Qt::Key_2);
  expectOneOfEach();
}

TEST_F(OneUpdate, IsMadeForEachMoveUnderALockedVolume) {
  key(Qt::Key_3);
  key(Qt::Key_K);
  ASSERT_TRUE(document().organs().front()->volumeLocked);
  expectOneOfEach();
}

TEST_F(OneUpdate, IsMadeForEachMoveUnderAStressMap) {
  enter();
  expectOneOfEach();
}

TEST_F(OneUpdate, IsMadeOfTheSecondViewToo) {
  key(Qt::Key_3);
  app::Comparison& comparison = window().play().comparison();
  comparison.showSameOrgan();
  ASSERT_TRUE(waitUntil([&] { return !comparison.workspace().live().busy(); }));
  settle();
  expectOneOfEach();
  expectOneOfEach(view(), comparison.view(), comparison.picture(), freeHandle());
}

TEST_F(OneUpdate, IsMadeOfTheSlicesWhereverTheMouseDrags) {
  key(Qt::Key_3);
  window().workspace().perform(document::openScan(document::scanItem(
      phantomScan({30, 30, 30}, Vec3::Constant(6), Vec3::Constant(-87), ballValue(Vec3::Zero(), 60)), {})));
  window().scans().opened();
  settle();
  const Vec3 handle = document().pose().row(0).transpose();
  window().viewModel().change([&](presentation::ViewState& state) { state.scan.focus = handle; });
  settle();
  app::SliceWidget& slice = window().slices().widget(0);
  ASSERT_TRUE(slice.isVisible() && view().isVisible());
  expectOneOfEach(slice, view(), window().picture(),
                  slice.placeOf(window().slices().presenter().frame(0).pixelOf(handle)).toPoint());
  expectOneOfEach();
}

TEST_F(OneUpdate, LeavesNoReaderWithAnOldPicture) {
  key(Qt::Key_3);
  const auto* handles = view().view().handles();
  document::UndoStack::Step drag(window().workspace().undo(), "Drag");
  Points pose = document().pose();
  pose.array() += 3;
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  EXPECT_NE(handles->GetPositions(), pose);
  EXPECT_EQ(view().view().handles()->GetPositions(), pose) << "though no frame was drawn yet";
  pose.array() += 3;
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  EXPECT_EQ(window().picture().presenter().view().handles()->GetPositions(), pose);
  pose.array() += 3;
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  send(view(), QEvent::MouseMove, QPoint(5, 5));
  EXPECT_EQ(handles->GetPositions(), pose) << "before the mouse picks";
}

TEST_F(OneUpdate, OfThePictureFollowsTheDocumentWhileTheViewIsHidden) {
  key(Qt::Key_3);
  int updates = 0;
  const auto counting =
      QObject::connect(&window().picture(), &app::Picture::changed, [&updates] { ++updates; });
  view().hide();
  Points pose = document().pose();
  pose.array() += 3;
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  handleEvents();
  QObject::disconnect(counting);
  EXPECT_EQ(updates, 1) << "for the texts that belong to it";
}

TEST_F(OneUpdate, StoresOnePoseForDocumentOrgansAndDrag) {
  key(Qt::Key_3);
  const QPoint from = freeHandle();
  QTest::mouseMove(&view(), from);
  QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, from);
  QTest::mouseMove(&view(), from + QPoint(40, 0));
  const live::LockedMotion* motion = window().poses().motion();
  ASSERT_NE(motion, nullptr);
  const Points* pose = &document().pose();
  EXPECT_NE(*pose, document().rig().restPositions());
  EXPECT_EQ(&motion->pose(), pose);
  EXPECT_EQ(&window().workspace().live().shownPose(), pose);
  EXPECT_EQ(&window().workspace().live().deformer(document().organs().front()->id)->pose(), pose);
  key(Qt::Key_Escape);
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, from);
}

} // namespace
} // namespace viscera::tests
