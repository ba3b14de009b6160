#include "window_test.h"

#include <QAction>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>

#include <fstream>
#include <string>

#include "label_files.h"
#include "viscera/document/measurement_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/scan_item.h"
#include "viscera/medical_io/image_file.h"
#include "window/import/import_controller.h"
#include "window/session/session_files.h"
#include "window/slices/scan_actions.h"
#include "window/slices/slice_panes.h"
#include "window/slices/warp_export.h"
#include "window/view/picture.h"

namespace viscera::tests {
namespace {

/// A ball of 40 mm as a label map and as a scan, in one folder.
class PatientTest : public WindowTest {
protected:
  static LabelImage grid() {
    LabelImage image = emptyLabels({52, 52, 52});
    image.indexToLps.linear() *= 3;
    image.indexToLps.translation().setConstant(-76.5);
    return image;
  }
  QString labelFileName() const { return path(QStringLiteral("ball_seg.nrrd")); }
  QString scanFileName() const { return path(QStringLiteral("ball_ct.nii")); }
  QString labelFile() {
    LabelImage image = grid();
    addBall(image, Vec3::Constant(25.5), 40.0 / 3, 1);
    return write(QStringLiteral("ball_seg.nrrd"),
                 nrrdFile(image, "left-posterior-superior",
                          "Segment0_ID:=s\nSegment0_Name:=phantom\nSegment0_LabelValue:=1\n"));
  }
  /// With noise, so that nobody takes it for labels.
  QString scanFile() {
    LabelImage image = grid();
    for (std::size_t i = 0; i < image.voxels.size(); ++i)
      image.voxels[i] = std::int16_t((i * 2654435761u >> 16) % 7) - 53;
    LabelImage ball = grid();
    addBall(ball, Vec3::Constant(25.5), 40.0 / 3, 150);
    for (std::size_t i = 0; i < image.voxels.size(); ++i)
      image.voxels[i] = std::int16_t(image.voxels[i] + ball.voxels[i]);
    return write(QStringLiteral("ball_ct.nii"), niftiFile(image));
  }
  QString write(const QString& name, const std::string& bytes) {
    QFile file(path(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    return path(name);
  }

  void openBoth() {
    const QString labels = labelFile(), scan = scanFile();
    open(labels);
    window().scans().open(scan);
    settle();
    ASSERT_TRUE(document().state().scan);
    ASSERT_EQ(document().organs().size(), 1u);
  }
  std::vector<document::HandleId> allHandles() {
    std::vector<document::HandleId> all;
    for (const document::Handle& handle : document().rig().handles)
      all.push_back(handle.id);
    return all;
  }
  void shift(const Vec3& by) {
    Points moved = document().rig().restPositions();
    moved.rowwise() += by.transpose();
    window().workspace().perform(document::moveHandles(allHandles(), moved));
  }
  double valueAt(int direction, const Vec3& place) {
    const presentation::SlicePresenter& slices = window().slices().presenter();
    return slices.read(direction, slices.frame(direction).pixelOf(place)).value.value_or(-9999);
  }
  QPushButton* offer() {
    for (QPushButton* button : window().findChildren<QPushButton*>(QStringLiteral("offer")))
      if (button->isVisible())
        return button;
    return nullptr;
  }
  /// How much of the view the organ takes; all of it has to be seen.
  double fraction() {
    const QPoint top = onScreen(Vec3(0, 0, 40)), bottom = onScreen(Vec3(0, 0, -40));
    EXPECT_TRUE(view().rect().contains(top) && view().rect().contains(bottom));
    return std::abs(top.y() - bottom.y()) / double(std::min(view().height(), view().width()));
  }
  bool bent() {
    return waitUntil([this] { return window().workspace().warp().map() != nullptr; });
  }
};

TEST_F(PatientTest, TheScanBendsAlongAndComesBackWithThePose) {
  openBoth();
  key(Qt::Key_3); // Deform
  window().actions()["scan.bent"]->trigger();
  settle();
  EXPECT_LT(valueAt(1, Vec3(0, 0, 55)), 0);
  shift(Vec3(0, 0, 30));
  ASSERT_TRUE(bent());
  settle();
  EXPECT_GT(valueAt(1, Vec3(0, 0, 55)), 60) << "the ball's tissue went there";
  EXPECT_LT(valueAt(1, Vec3(0, 0, -25)), 0) << "and is gone from here";
  EXPECT_TRUE(QString::fromStdString(window().slices().presenter().picture(1).note)
                  .contains(QStringLiteral("Warped")));
  const geometry::PlaneCut* contour = window().slices().presenter().cut(1, document().organs().front()->id);
  ASSERT_TRUE(contour);
  EXPECT_NEAR(contour->points.col(2).maxCoeff(), 70, 2) << "as its contour says";
  window().actions()["edit.undo"]->trigger();
  settle();
  EXPECT_LT(valueAt(1, Vec3(0, 0, 55)), 0);
}

TEST_F(PatientTest, WhatIsMeasuredOnSlicesGoesWithTheWarpedScan) {
  openBoth();
  const auto fixedAt = [](const Vec3& place) {
    document::MeasuredPoint point;
    point.rest = place;
    return point;
  };
  window().workspace().perform(document::addMeasurement({fixedAt(Vec3(0, 0, -30)), fixedAt(Vec3(0, 0, 30))}));
  auto* list = window().findChild<QTreeWidget*>(QStringLiteral("measureList"));
  const auto now = [&] { return list->topLevelItem(0)->text(1); };
  window().actions()["scan.bent"]->trigger();
  settle();
  EXPECT_EQ(now(), QStringLiteral("60.0 mm"));
  Points longer = document().rig().restPositions();
  longer.col(2) *= 1.5;
  window().workspace().perform(document::moveHandles(allHandles(), longer));
  ASSERT_TRUE(bent());
  settle();
  EXPECT_NEAR(now().section(QLatin1Char(' '), 0, 0).toDouble(), 90, 0.3) << now().toStdString();
  window().actions()["scan.bent"]->trigger();
  settle();
  EXPECT_EQ(now(), QStringLiteral("60.0 mm")) << "the scan as it was recorded";
  window().actions()["scan.bent"]->trigger();
  window().actions()["edit.undo"]->trigger();
  settle();
  EXPECT_EQ(now(), QStringLiteral("60.0 mm"));
}

TEST_F(PatientTest, FoldedTissueIsCountedInTheStatus) {
  openBoth();
  key(Qt::Key_3);
  window().actions()["scan.bent"]->trigger();
  const auto status = [this] { return window().findChild<QLabel*>(QStringLiteral("statusBinding"))->text(); };
  EXPECT_FALSE(status().contains(QStringLiteral("folded"))) << status().toStdString();
  // The handles in front change places with those behind: the patient is turned inside out.
  Points mirrored = document().rig().restPositions();
  mirrored.col(1) *= -0.8;
  window().workspace().perform(document::moveHandles(allHandles(), mirrored));
  ASSERT_TRUE(bent());
  settle();
  EXPECT_TRUE(status().contains(QStringLiteral("folded"))) << status().toStdString();
  EXPECT_TRUE(QString::fromStdString(window().slices().presenter().picture(0).note)
                  .contains(QStringLiteral("folded")));
}

TEST_F(PatientTest, TheBentScanIsExportedWithItsLabels) {
  openBoth();
  key(Qt::Key_3);
  shift(Vec3(0, 0, 30));
  settle();
  const QString file = path(QStringLiteral("bent.nrrd"));
  window().findChild<app::WarpExport*>()->exportScan(file);
  settle();
  EXPECT_TRUE(message().contains(QStringLiteral("bent.seg.nrrd"))) << message().toStdString();
  Progress progress;
  const medical_io::Scan scan = medical_io::readScan(file.toStdString(), {}, progress);
  EXPECT_EQ(scan.size, document().state().scan->scan->size);
  EXPECT_GT(scan.at(Vec3(0, 0, 55)).value_or(-9999), 60);
  EXPECT_LT(scan.at(Vec3(0, 0, -25)).value_or(9999), 0);
  const medical_io::LabelMap labels =
      medical_io::readLabelMap(path(QStringLiteral("bent.seg.nrrd")).toStdString(), progress);
  ASSERT_EQ(labels.segments.size(), 1u);
  EXPECT_EQ(labels.segments.front().name, "phantom");
  EXPECT_NEAR(labels.indexToLps.translation().z() + 3 * labels.segments.front().high[2], 68, 4);
}

TEST_F(PatientTest, AnExportThatIsCancelledLeavesNothing) {
  openBoth();
  shift(Vec3(0, 0, 30));
  const QString file = path(QStringLiteral("bent.nii.gz"));
  window().findChild<app::WarpExport*>()->exportScan(file);
  window().workspace().jobs().cancelAll();
  settle();
  EXPECT_FALSE(QFileInfo::exists(file));
}

TEST_F(PatientTest, ALabelMapOffersTheScanBesideItAndTheScanItsOrgans) {
  const QString labels = labelFile(), scan = scanFile();
  open(labels);
  EXPECT_TRUE(message().contains(QStringLiteral("The scan ball_ct.nii has the same voxels")))
      << message().toStdString();
  ASSERT_TRUE(offer());
  offer()->click();
  settle();
  ASSERT_TRUE(document().state().scan);
  reopenWindow();
  window().scans().open(scan);
  settle();
  EXPECT_TRUE(message().contains(QStringLiteral("The label map ball_seg.nrrd has the same voxels")))
      << message().toStdString();
  ASSERT_TRUE(offer());
  offer()->click();
  settle();
  ASSERT_EQ(document().organs().size(), 1u);
  EXPECT_EQ(document().organs().front()->name, "phantom");
}

TEST_F(PatientTest, ALabelMapAndItsScanAreOneChangeEach) {
  int changes = 0;
  const Subscription subscription =
      window().workspace().onChange([&changes](const document::Change&) { ++changes; });
  window().files().open({labelFile(), scanFile()});
  ASSERT_TRUE(waitUntil([this] { return document().state().scan && !document().organs().empty(); }))
      << message().toStdString();
  settle();
  EXPECT_EQ(changes, 2);
  EXPECT_EQ(window().workspace().undo().names().size(), 2u) << "a step each";
}

TEST_F(PatientTest, AScanOpensBesideAFileThatIsNotThereWhichIsNamedWithTheOffer) {
  const QString scan = scanFile(), missing = labelFile() + QStringLiteral("/liver");
  window().files().open({scan, missing});
  ASSERT_TRUE(waitUntil([this] { return document().state().scan != nullptr; })) << message().toStdString();
  settle();
  EXPECT_TRUE(message().contains(missing)) << message().toStdString();
  EXPECT_TRUE(message().contains(QStringLiteral("The label map ball_seg.nrrd"))) << message().toStdString();
}

TEST_F(PatientTest, AScanOpensBesideDamagedFilesWhichAreAllNamedWithTheOffer) {
  const QString scan = scanFile();
  labelFile(); // Beside it.
  QStringList files = {scan};
  for (const char* name : {"liver.stl", "kidney.vtp"}) {
    files << path(QLatin1String(name));
    std::ofstream(files.back().toStdString()) << "nothing that a surface begins with";
  }
  window().files().open(files);
  ASSERT_TRUE(waitUntil([this] { return document().state().scan != nullptr; })) << message().toStdString();
  settle();
  for (const char* said : {"liver.stl", "kidney.vtp", "The label map ball_seg.nrrd"})
    EXPECT_TRUE(message().contains(QLatin1String(said))) << said << " in " << message().toStdString();
}

TEST_F(PatientTest, AnOrganOpensBesideADamagedScanWhichIsNamed) {
  const QString organ = sphereFile(), slice = path(QStringLiteral("slice.dcm"));
  std::ofstream(slice.toStdString(), std::ios::binary)
      << std::string(128, '\0') << "DICM" << std::string(60, 'x');
  window().files().open({slice, organ});
  ASSERT_TRUE(waitUntil([this] { return !document().organs().empty(); })) << message().toStdString();
  settle();
  EXPECT_TRUE(message().contains(QStringLiteral("slice.dcm"))) << message().toStdString();
}

TEST_F(PatientTest, NothingIsOfferedOfWhatIsBeingImported) {
  const QString labels = labelFile(), scan = scanFile();
  window().files().open({labels, scan}, true); // With check.
  settle();
  ASSERT_TRUE(window().imports().isOpen());
  EXPECT_TRUE(document().state().scan);
  EXPECT_FALSE(offer()) << message().toStdString();
}

TEST_F(PatientTest, TheCameraShowsAllOfTheOrgansWhateverTheLayout) {
  openBoth();
  const double four = fraction();
  EXPECT_GT(four, 0.4);
  key(Qt::Key_F6, Qt::ShiftModifier);
  settle();
  EXPECT_NEAR(fraction(), four, 0.25 * four);
  key(Qt::Key_F6);
  settle();
  EXPECT_NEAR(fraction(), four, 0.05 * four);
}

TEST_F(PatientTest, TheOrgansFillTheViewAfterUndoAndRedoOfTheScan) {
  openBoth();
  const double four = fraction();
  ASSERT_TRUE(document().state().scan);
  key(Qt::Key_Z, Qt::ControlModifier);
  ASSERT_FALSE(document().state().scan);
  EXPECT_NEAR(fraction(), four, 0.25 * four);
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(document().state().scan);
  EXPECT_NEAR(fraction(), four, 0.05 * four);
}

TEST_F(PatientTest, ASessionHasScanAndOrgansInsideAndIsFramedWhenItHasNoCamera) {
  openBoth();
  const auto scan = document().state().scan->scan;
  const QString session = path(QStringLiteral("patient.viscera"));
  window().sessions().saveTo(session, true);
  settle();
  EXPECT_TRUE(QFile::remove(labelFileName()) && QFile::remove(scanFileName()));
  QFile file(session);
  ASSERT_TRUE(file.open(QIODevice::ReadOnly));
  QJsonObject root = QJsonDocument::fromJson(file.readAll()).object();
  file.close();
  QJsonObject look = root[QLatin1String("view")].toObject();
  ASSERT_TRUE(look.contains(QLatin1String("camera")));
  look.remove(QLatin1String("camera"));
  root[QLatin1String("view")] = look;
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(QJsonDocument(root).toJson());
  file.close();
  reopenWindow();
  open(session);
  ASSERT_EQ(document().organs().size(), 1u);
  ASSERT_TRUE(document().state().scan);
  EXPECT_EQ(document().state().scan->scan->samples, scan->samples);
  EXPECT_TRUE(view().isVisible() && window().slices().widget(0).isVisible());
  EXPECT_GT(fraction(), 0.4);
}

} // namespace
} // namespace viscera::tests
