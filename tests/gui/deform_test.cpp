#include "window_test.h"

#include <QAction>
#include <QLabel>
#include <QTest>
#include <QTreeWidget>

#include "viscera/document/rig_commands.h"
#include "viscera/geometry/volume.h"
#include "window/style/language.h"

namespace viscera::tests {
namespace {

constexpr int kListVolume = 2; ///< The column.

class DeformMode : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile());
    key(Qt::Key_3);
    ASSERT_EQ(window().mode(), "deform");
    organ_ = document().organs().front()->id;
    handle_ = reachableHandle();
    ASSERT_GE(handle_, 0);
  }

  const Points& points() { return window().workspace().live().points(organ_); }
  QString status() { return window().findChild<QLabel*>(QStringLiteral("statusVolume"))->text(); }

  document::OrganId organ_;
  int handle_ = -1;
};

TEST_F(DeformMode, DraggingAHandleMovesTheOrganAndItsVolume) {
  const Points before = points();
  const QString statusBefore = status();
  const QPoint from = onScreen(handleInView(handle_));
  drag(from, from + QPoint(80, 0));
  EXPECT_GT((points() - before).rowwise().norm().maxCoeff(), 1);
  const live::OrganVolume volume = window().workspace().live().volume(organ_);
  const geometry::TriangleMesh& mesh = *document().organs().front()->mesh;
  EXPECT_NEAR(volume.nowMl, geometry::volume(points(), mesh.triangles) / kMm3PerMl, 1e-6);
  EXPECT_GT(std::abs(volume.relativeChange()), 1e-4);
  EXPECT_NE(status(), statusBefore);
  // What is drawn is what was computed.
  EXPECT_EQ(&view().view().organs().front()->points(), &points());
}

TEST_F(DeformMode, NumbersAreOfTheFrameThatIsDrawnDuringADrag) {
  const QPoint from = onScreen(handleInView(handle_));
  QTest::mouseMove(&view(), from);
  QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, from);
  QString before;
  for (int step = 1; step <= 8; ++step) {
    QTest::mouseMove(&view(), from + QPoint(10 * step, 0));
    handleEvents();
    const live::OrganVolume volume = window().workspace().live().volume(organ_);
    const QString now = app::formatMilliliters(volume.nowMl);
    // The numbers follow as soon as the frame is drawn, which a busy machine does later.
    ASSERT_TRUE(waitUntil([this, &now] { return status().contains(now); }))
        << status().toStdString() << " for " << now.toStdString();
    const auto tiles = window().findChildren<QLabel*>(QStringLiteral("tileValue"));
    ASSERT_EQ(tiles.size(), 1);
    EXPECT_EQ(tiles.front()->text(), now);
    EXPECT_EQ(find<QTreeWidget>("organList").topLevelItem(0)->text(kListVolume), now);
    before = now;
  }
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, from + QPoint(80, 0));
  settle();
  EXPECT_NE(before, app::formatMilliliters(window().workspace().live().volume(organ_).restMl));
}

TEST_F(DeformMode, TheHandleStaysUnderTheCursor) {
  const QPoint from = onScreen(handleInView(handle_));
  const QPoint to = from + QPoint(50, -40);
  drag(from, to);
  const QPoint there = onScreen(handleInView(handle_));
  EXPECT_LE((there - to).manhattanLength(), 3)
      << there.x() << ' ' << there.y() << " not " << to.x() << ' ' << to.y();
}

TEST_F(DeformMode, UndoTakesTheDragBackToTheLastBitAndRedoDoesItAgain) {
  const Points organBefore = points();
  const Points poseBefore = document().pose();
  const QPoint from = onScreen(handleInView(handle_));
  drag(from, from + QPoint(60, 30));
  const Points poseAfter = document().pose();
  ASSERT_NE(poseAfter, poseBefore);
  EXPECT_EQ(window().workspace().undo().names().size(), 2u) << "one drag is one step";
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().pose(), poseBefore);
  EXPECT_EQ(points(), organBefore);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document().pose(), poseAfter);
}

TEST_F(DeformMode, EscapeDuringADragPutsEverythingBack) {
  const Points before = points();
  const QPoint from = onScreen(handleInView(handle_));
  QTest::mouseMove(&view(), from);
  QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, from);
  QTest::mouseMove(&view(), from + QPoint(40, 0));
  QTest::mouseMove(&view(), from + QPoint(60, 0));
  ASSERT_NE(points(), before);
  key(Qt::Key_Escape);
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, from + QPoint(60, 0));
  settle();
  EXPECT_EQ(points(), before);
  EXPECT_EQ(window().workspace().undo().names().size(), 1u);
}

TEST_F(DeformMode, ResetPoseGoesBackToRestExactly) {
  const QPoint from = onScreen(handleInView(handle_));
  drag(from, from + QPoint(60, 30));
  key(Qt::Key_R, Qt::ControlModifier);
  EXPECT_TRUE(document::atRest(document().state()));
  EXPECT_EQ(points(), document().organs().front()->mesh->points);
}

TEST_F(DeformMode, TheElasticOrganIsAGhostAndColoursTheDistance) {
  QAction& beside = *window().actions()["pose.elasticity"];
  const auto& reason = find<QLabel>("elasticReason");
  beside.trigger();
  EXPECT_TRUE(window().viewModel().state().besideElasticity);
  EXPECT_TRUE(reason.text().contains(QStringLiteral("Move a handle"))) << reason.text().toStdString();
  EXPECT_FALSE(find<QLabel>("elasticLargest").isVisibleTo(reason.parentWidget()));
  Points pose = document().pose();
  pose(handle_, 0) += 5;
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  ASSERT_TRUE(waitUntil([&] { return reason.text().isEmpty(); })) << reason.text().toStdString();
  EXPECT_TRUE(find<QLabel>("elasticLargest").text().endsWith(QStringLiteral("mm")));
  EXPECT_TRUE(window().picture().hasMoreThanMovies()) << "the ghost and the colours";
  pose(handle_, 0) += 5;
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  EXPECT_FALSE(window().picture().hasMoreThanMovies()) << "they belong to another pose";
  EXPECT_FALSE(reason.text().isEmpty());
  beside.trigger();
  settle();
  EXPECT_TRUE(reason.text().isEmpty());
  EXPECT_FALSE(window().picture().hasMoreThanMovies());
}

TEST_F(DeformMode, ADragBesideTheHandlesTurnsTheCameraAndChangesNothing) {
  const document::DocumentState before = document().state();
  const Vec3 handleBefore = handleInView(handle_);
  const QPoint place = onScreen(handleBefore);
  drag(QPoint(8, view().height() - 60), QPoint(120, view().height() - 120));
  EXPECT_TRUE(document().state() == before);
  EXPECT_NE(onScreen(handleBefore), place);
}

TEST_F(DeformMode, TheDeformedPoseIsKeptWhileTheHandlesAreLookedAt) {
  const QPoint from = onScreen(handleInView(handle_));
  drag(from, from + QPoint(60, 30));
  const Points posed = points();
  key(Qt::Key_2);
  EXPECT_EQ(points(), document().organs().front()->mesh->points) << "Handles mode shows the rest shape";
  key(Qt::Key_3);
  EXPECT_LT((points() - posed).cwiseAbs().maxCoeff(), 1e-9);
}

TEST_F(DeformMode, LockingAVolumeHasItsFormMadeByAWorkerAndUnlockingDoesNot) {
  int begun = 0;
  std::int64_t last = 0;
  const Subscription subscription = window().workspace().jobs().onChange([&] {
    for (const JobInfo& job : window().workspace().jobs().jobs())
      if (job.slot.starts_with("lock/") && job.id != last) {
        last = job.id;
        ++begun;
      }
  });
  window().poses().setLocked({organ_}, true);
  EXPECT_TRUE(waitUntil([&] { return begun == 1 && window().workspace().jobs().idle(); }));
  window().poses().setLocked({organ_}, false);
  settle();
  QTest::qWait(400);
  EXPECT_EQ(begun, 1);
}

} // namespace
} // namespace viscera::tests
