#include "window_test.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QTest>
#include <QTreeWidget>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include "shapes.h"
#include "viscera/document/rig_commands.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/scene/vtkVisceraGizmoRepresentation.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "window/import/import_controller.h"

namespace viscera::tests {
namespace {

constexpr double kAllowedError = 1e-9;
constexpr int kVolumeColumn = 2;
constexpr int kLockColumn = 3;

class LockedDeform : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile());
    key(Qt::Key_3);
    organ_ = document().organs().front()->id;
    handle_ = reachableHandle();
    ASSERT_GE(handle_, 0);
  }

  const document::Organ& organ() { return *document().organ(organ_); }
  double relativeChange() { return window().workspace().live().volume(organ_).relativeChange(); }
  QString status() { return window().findChild<QLabel*>(QStringLiteral("statusVolume"))->text(); }
  QTreeWidget* list() { return window().findChild<QTreeWidget*>(QStringLiteral("organList")); }
  std::size_t steps() { return window().workspace().undo().names().size(); }

  void clickPadlock(int row = 0) {
    const QModelIndex index = list()->model()->index(row, kLockColumn);
    QTest::mouseClick(list()->viewport(), Qt::LeftButton, Qt::NoModifier, list()->visualRect(index).center());
    settle();
  }

  void pressButton(const char* name) {
    auto* button = window().findChild<QPushButton*>(QLatin1String(name));
    ASSERT_TRUE(button && button->isEnabled()) << name;
    button->click();
    settle();
  }

  void pressOffer() {
    auto* offer = window().viewArea().messages()->findChild<QPushButton*>(QStringLiteral("offer"));
    ASSERT_TRUE(offer);
    QTest::mouseClick(offer, Qt::LeftButton);
    settle();
  }

  Points displacement() { return document().pose() - document().rig().restPositions(); }

  void selectRows(const std::vector<int>& rows) {
    std::vector<document::HandleId> ids;
    for (const int row : rows)
      ids.push_back(document().rig().handles[static_cast<std::size_t>(row)].id);
    window().workspace().selection().setHandles(ids);
    settle();
  }

  document::OrganId organ_;
  int handle_ = -1;
};

TEST_F(LockedDeform, AClickOnThePadlockLocksAndUndoUnlocks) {
  clickPadlock();
  EXPECT_TRUE(organ().volumeLocked);
  EXPECT_TRUE(status().contains(QStringLiteral("locked"))) << status().toStdString();
  EXPECT_TRUE(window().actions()["volume.lock"]->isChecked());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(organ().volumeLocked);
  EXPECT_FALSE(status().contains(QStringLiteral("locked")));
  key(Qt::Key_K);
  EXPECT_TRUE(organ().volumeLocked) << "the key does the same";
}

TEST_F(LockedDeform, ADragKeepsTheVolumeShownAndDrawsThePlaneMeanwhile) {
  key(Qt::Key_K);
  const QString volumeBefore = list()->topLevelItem(0)->text(kVolumeColumn);
  const Points before = document().pose();
  const QPoint from = onScreen(handleInView(handle_)), to = from + QPoint(70, -30);
  QTest::mouseMove(&view(), from);
  QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, from);
  for (int step = 1; step <= 6; ++step) {
    QTest::mouseMove(&view(), from + (to - from) * step / 6);
    QTest::qWait(10);
    EXPECT_LE(std::abs(relativeChange()), kAllowedError) << step;
  }
  EXPECT_TRUE(view().view().constraint().visible());
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, to);
  settle();
  EXPECT_FALSE(view().view().constraint().visible());
  EXPECT_GT((document().pose() - before).rowwise().norm()[handle_], 0.01);
  EXPECT_LE(std::abs(relativeChange()), kAllowedError);
  EXPECT_EQ(list()->topLevelItem(0)->text(kVolumeColumn), volumeBefore);
  EXPECT_TRUE(status().contains(QStringLiteral("+0.0 %"))) << status().toStdString();
  EXPECT_EQ((displacement().rowwise().norm().array() > 0).count(), 1) << "nobody else moves";
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().pose(), before);
  EXPECT_TRUE(organ().volumeLocked) << "the drag alone is taken back";
}

// A mouse of 15 mm became 27.8 mm of handle, 19 of them towards the viewer.
TEST_F(LockedDeform, ADragStaysInTheViewsPlaneAndNeverGoesFartherThanTheMouse) {
  key(Qt::Key_K);
  Vec3 sight;
  view().view().renderer()->GetActiveCamera()->GetDirectionOfProjection(sight.data());
  double farthest = 0;
  for (const QPoint by : {QPoint(70, -30), QPoint(-20, 60), QPoint(-50, -10), QPoint(15, 55)}) {
    const Vec3 before = document().pose().row(handle_).transpose();
    const QPoint from = onScreen(handleInView(handle_));
    drag(from, from + by);
    const Vec3 moved = document().pose().row(handle_).transpose() - before;
    EXPECT_LE(std::abs(moved.dot(sight)), 1e-9);
    const QPoint seen = onScreen(handleInView(handle_)) - from;
    EXPECT_LE(std::hypot(seen.x(), seen.y()), std::hypot(by.x(), by.y()) + 2);
    EXPECT_LE(std::abs(relativeChange()), kAllowedError);
    farthest = std::max(farthest, moved.norm());
    key(Qt::Key_Z, Qt::ControlModifier);
  }
  EXPECT_GT(farthest, 2) << "it moves along a line of the view";
}

TEST_F(LockedDeform, AMoveThatTheLockCutsShortSaysSoAndOffersTheWholeOfIt) {
  key(Qt::Key_K);
  selectRows({handle_});
  const auto fields =
      window().findChild<QWidget*>(QStringLiteral("displacementBox"))->findChildren<QDoubleSpinBox*>();
  fields[0]->setValue(9);
  fields[1]->setValue(-9);
  fields[2]->setValue(6);
  pressButton("applyDisplacement");
  const Eigen::RowVector3d asked(9, -9, 6);
  ASSERT_GT((displacement().row(handle_) - asked).norm(), 0.5);
  EXPECT_TRUE(message().contains(QStringLiteral("of 14.07 mm"))) << message().toStdString();
  pressOffer();
  EXPECT_LE((displacement().row(handle_) - asked).norm(), 1e-12);
  EXPECT_LE(std::abs(relativeChange()), kAllowedError);
  EXPECT_GT((displacement().rowwise().norm().array() > 1e-6).count(), 1) << "others compensate";
  EXPECT_TRUE(message().isEmpty()) << message().toStdString();
}

TEST_F(LockedDeform, MovedExactlyAHandleFollowsTheCursorInTheViewsPlane) {
  key(Qt::Key_K);
  window().actions()["handles.exactly"]->trigger();
  settle();
  Vec3 sight;
  view().view().renderer()->GetActiveCamera()->GetDirectionOfProjection(sight.data());
  const QPoint from = onScreen(handleInView(handle_)), to = from + QPoint(30, -20);
  drag(from, to);
  EXPECT_LE((onScreen(handleInView(handle_)) - to).manhattanLength(), 3);
  EXPECT_LE(std::abs(displacement().row(handle_).dot(sight.transpose())), 1e-9);
  EXPECT_LE(std::abs(relativeChange()), kAllowedError);
  EXPECT_TRUE(message().isEmpty()) << message().toStdString();
  const Points before = document().pose();
  EXPECT_FALSE(window().poses().moveExactly({document().rig().handles[std::size_t(handle_)].id}, {4e9, 0, 0}))
      << "rounding alone is more than the lock allows";
  settle();
  EXPECT_EQ(document().pose(), before);
  EXPECT_TRUE(message().contains(QStringLiteral("exactly"))) << message().toStdString();
}

TEST_F(LockedDeform, TheLockKeyDuringADragEndsItAndKeepsTheVolumeOfThatMoment) {
  const Points before = document().pose();
  const std::size_t stepsBefore = steps();
  const QPoint from = onScreen(handleInView(handle_)), to = from + QPoint(70, -30);
  QTest::mouseMove(&view(), from);
  QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, from);
  QTest::mouseMove(&view(), from + QPoint(35, -15));
  QTest::qWait(10);
  key(Qt::Key_K);
  ASSERT_TRUE(organ().volumeLocked);
  const double locked = relativeChange();
  QTest::mouseMove(&view(), to);
  QTest::qWait(10);
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, to);
  settle();
  EXPECT_NEAR(relativeChange(), locked, kAllowedError) << "what is locked is the volume at that moment";
  EXPECT_NE(document().pose(), before);
  for (std::size_t step = steps(); step > stepsBefore; --step)
    key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().pose(), before);
  EXPECT_FALSE(organ().volumeLocked);
  EXPECT_EQ(relativeChange(), 0);
}

TEST_F(LockedDeform, EscapeDuringALockedDragPutsEverythingBack) {
  key(Qt::Key_K);
  const Points before = document().pose();
  const QPoint from = onScreen(handleInView(handle_));
  QTest::mouseMove(&view(), from);
  QTest::mousePress(&view(), Qt::LeftButton, Qt::NoModifier, from);
  QTest::mouseMove(&view(), from + QPoint(40, 20));
  QTest::qWait(10);
  ASSERT_NE(document().pose(), before);
  key(Qt::Key_Escape);
  QTest::mouseRelease(&view(), Qt::LeftButton, Qt::NoModifier, from + QPoint(40, 20));
  settle();
  EXPECT_EQ(document().pose(), before);
  EXPECT_FALSE(view().view().constraint().visible());
}

TEST_F(LockedDeform, AnOpenSurfaceIsRefusedAndTheOfferClosesItInOneStep) {
  geometry::TriangleMesh cup = sphere(4, 60);
  cup.triangles.conservativeResize(cup.triangles.rows() - 40, 3);
  const QString file = path(QStringLiteral("cup.stl"));
  medical_io::writeSurface(file.toStdString(), cup);
  open(file);
  window().imports().accept(); // As it is, open.
  settle();
  const document::OrganId opened = document().organs().back()->id;
  const int edges = document().organ(opened)->boundaryEdges;
  ASSERT_GT(edges, 0);
  const std::size_t stepsBefore = steps();
  clickPadlock(static_cast<int>(document().organs().size()) - 1);
  EXPECT_FALSE(document().organ(opened)->volumeLocked);
  EXPECT_TRUE(message().contains(QString::number(edges))) << message().toStdString();
  QPushButton* offer = window().viewArea().messages()->findChild<QPushButton*>(QStringLiteral("offer"));
  ASSERT_TRUE(offer);
  QTest::mouseClick(offer, Qt::LeftButton);
  settle();
  EXPECT_TRUE(document().organ(opened)->closed());
  EXPECT_TRUE(document().organ(opened)->volumeLocked);
  EXPECT_EQ(steps(), stepsBefore + 1);
  EXPECT_NE(list()->topLevelItem(list()->topLevelItemCount() - 1)->text(kVolumeColumn),
            QStringLiteral("open"));
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().organ(opened)->boundaryEdges, edges);
}

TEST_F(LockedDeform, TheGizmoTurnsTheSelectionInOneStepAndTheOthersKeepTheVolume) {
  key(Qt::Key_K);
  auto* gizmo = view().view().gizmo();
  key(Qt::Key_T);
  EXPECT_FALSE(gizmo->GetVisibility()) << "nothing to turn";
  selectRows({8, 9, 12, 15});
  ASSERT_TRUE(gizmo->GetVisibility());
  const std::size_t stepsBefore = steps();
  const Points before = document().pose();
  const QPoint middle = onScreen(gizmo->GetCenter());
  const QPoint from = onScreen(gizmo->GetGrabPoint(vtkVisceraGizmoRepresentation::RingY));
  drag(from, middle + QPoint(-(from - middle).y(), (from - middle).x()) * 0.4 + (from - middle) * 0.8);
  EXPECT_EQ(steps(), stepsBefore + 1);
  EXPECT_GT((document().pose() - before).rowwise().norm()[8], 2);
  EXPECT_LE(std::abs(relativeChange()), kAllowedError);
  // Without anybody compensating, distances within the selection stay: it was a rotation.
  const Points now = document().pose();
  EXPECT_NEAR((now.row(8) - now.row(15)).norm(), (before.row(8) - before.row(15)).norm(), 1e-9);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().pose(), before);
  key(Qt::Key_1);
  EXPECT_FALSE(gizmo->GetVisibility()) << "only in Deform mode";
}

TEST_F(LockedDeform, AMirroredDragMovesThePartnerAndKeepsTheVolume) {
  key(Qt::Key_K);
  key(Qt::Key_M); // Sagittal.
  EXPECT_EQ(window().findChild<QComboBox*>(QStringLiteral("mirror"))->currentIndex(), 1);
  EXPECT_TRUE(view().view().mirrorPlane().visible());
  // A corner of the enclosing box surely has a partner.
  window().workspace().selection().setHandles({document().rig().handles[0].id});
  settle();
  const auto partners = window().poses().partnersOfSelection();
  ASSERT_EQ(partners.size(), 1u);
  auto* box = window().findChild<QWidget*>(QStringLiteral("displacementBox"));
  const auto fields = box->findChildren<QDoubleSpinBox*>();
  ASSERT_EQ(fields.size(), 3);
  fields[0]->setValue(4);
  fields[2]->setValue(-3);
  pressButton("applyDisplacement");
  const Points moved = displacement();
  const int partner = document().rig().indexOf(partners.front());
  EXPECT_GT(moved.row(0).norm(), 0.1);
  EXPECT_NEAR(moved(0, 0), -moved(partner, 0), 1e-12);
  EXPECT_NEAR(moved(0, 2), moved(partner, 2), 1e-12);
  EXPECT_LE(std::abs(relativeChange()), kAllowedError);
}

TEST_F(LockedDeform, ATypedDisplacementMovesTheSelectionOnceAsOneStep) {
  selectRows({handle_, (handle_ + 1) % 20});
  const auto fields =
      window().findChild<QWidget*>(QStringLiteral("displacementBox"))->findChildren<QDoubleSpinBox*>();
  fields[0]->setValue(5);
  fields[1]->setValue(-2.5);
  const std::size_t stepsBefore = steps();
  pressButton("applyDisplacement");
  EXPECT_EQ(steps(), stepsBefore + 1);
  EXPECT_LE((displacement().row(handle_) - Eigen::RowVector3d(5, -2.5, 0)).norm(), 1e-12);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(document::atRest(document().state()));
}

TEST_F(LockedDeform, ATargetVolumeIsReachedOrRefusedInWords) {
  auto* field = window().findChild<QWidget*>(QStringLiteral("volumeBox"))->findChild<QDoubleSpinBox*>();
  const double rest = organ().restVolumeMm3 / kMm3PerMl;
  field->setValue(0.95 * rest);
  const double wanted = field->value();
  pressButton("applyVolume");
  EXPECT_NEAR(window().workspace().live().volume(organ_).nowMl, wanted, kAllowedError * rest);
  const Points before = document().pose();
  field->setValue(60 * rest);
  pressButton("applyVolume");
  EXPECT_FALSE(message().isEmpty());
  EXPECT_EQ(document().pose(), before) << "the last valid pose stays";
  window().actions()["volume.restore"]->trigger();
  settle();
  EXPECT_LE(std::abs(relativeChange()), kAllowedError);
}

TEST_F(LockedDeform, MarkedHandlesCompensateWhileTheDraggedOneFollowsTheCursor) {
  key(Qt::Key_K);
  selectRows({0, 3, 5, 6});
  window().actions()["handles.compensate"]->trigger();
  settle();
  EXPECT_TRUE(document().rig().handles[3].compensates);
  const QPoint from = onScreen(handleInView(handle_)), to = from + QPoint(30, -20);
  drag(from, to);
  EXPECT_LE((onScreen(handleInView(handle_)) - to).manhattanLength(), 3);
  EXPECT_GT(displacement().row(3).norm(), 1e-6);
  EXPECT_LE(std::abs(relativeChange()), kAllowedError);
}

TEST_F(LockedDeform, TheChartHasTheVolumesOfTheLastDrags) {
  const QPoint from = onScreen(handleInView(handle_));
  drag(from, from + QPoint(60, 20));
  const sequences::VolumeRecord& drags = window().volumes().drags();
  ASSERT_GE(drags.rows(), 2u);
  EXPECT_NE(drags.milliliters(0, 0), drags.milliliters(drags.rows() - 1, 0));
  EXPECT_NEAR(drags.milliliters(drags.rows() - 1, 0), window().workspace().live().volume(organ_).nowMl, 1e-9);
}

} // namespace
} // namespace viscera::tests
