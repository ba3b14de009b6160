#include "window_test.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "cine_phantom.h"
#include "viscera/document/study_item.h"
#include "viscera/medical_io/cine_writer.h"
#include "viscera/medical_io/surface_file.h"
#include "window/import/file_actions.h"
#include "window/play/play_mode.h"
#include "window/session/session_files.h"
#include "window/slices/slice_panes.h"
#include "window/track/cine_page.h"

namespace viscera::tests {
namespace {

namespace fs = std::filesystem;

/// The phantom as a cine study in a folder, open in the window, and its surfaces in single phases.
class CineTrack : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    window().files().open({study()});
    ASSERT_TRUE(waitUntil([this] { return document().state().study != nullptr; })) << message().toStdString();
    settle();
  }
  QString study() const {
    const fs::path folder = path(QStringLiteral("heart")).toStdString();
    fs::create_directory(folder);
    int number = 0;
    for (const tracking::CinePlane& plane : CinePhantom::planes()) {
      medical_io::CineSeries series;
      series.patientName = "Phantom^Moving";
      series.patientId = "P1";
      series.studyUid = "1.2.3";
      series.frameOfReferenceUid = "1.2.3.77";
      series.number = ++number;
      series.seriesUid = "1.2.3." + std::to_string(100 + number);
      series.description = plane.name;
      series.geometry.origin = plane.origin;
      series.geometry.row = plane.alongRow;
      series.geometry.column = plane.alongColumn;
      series.geometry.betweenColumns = plane.spacing[0];
      series.geometry.betweenRows = plane.spacing[1];
      series.geometry.thickness = 6;
      series.geometry.columns = static_cast<int>(plane.images[0].cols());
      series.geometry.rows = static_cast<int>(plane.images[0].rows());
      series.phases = static_cast<int>(CinePhantom::kPhases);
      for (int phase = 0; phase < series.phases; ++phase) {
        const tracking::CineImage& image = plane.images[static_cast<std::size_t>(phase)];
        std::vector<std::uint16_t> pixels;
        for (Eigen::Index i = 0; i < image.rows(); ++i)
          for (Eigen::Index j = 0; j < image.cols(); ++j)
            pixels.push_back(static_cast<std::uint16_t>(std::lround(std::max(0.0F, image(i, j)))));
        medical_io::writeCinePicture(folder / (std::to_string(number) + "_" + std::to_string(phase) + ".dcm"),
                                     series, phase, pixels);
      }
    }
    return QString::fromStdString(folder.string());
  }
  /// Both surfaces of a phase in a folder of that name.
  QString labels(const char* name, std::size_t phase) const {
    const fs::path folder = path(QLatin1String(name)).toStdString();
    fs::create_directories(folder);
    for (std::size_t which = 0; which < 2; ++which)
      medical_io::writeSurface(folder / (which == 0 ? "EPI.obj" : "LV.obj"),
                               CinePhantom::surface(which, phase), {});
    return QString::fromStdString(folder.string());
  }
  /// The dialog with the open study's images and these labels.
  app::MotionDialog& ask(const QStringList& labelled) {
    app::MotionDialog& dialog = window().play().chooseSeries();
    EXPECT_TRUE(waitUntil([&] { return dialog.images().draft().cycle().has_value(); }))
        << dialog.said().toStdString();
    dialog.images().addLabels(labelled);
    find<QSpinBox>("seriesHandles").setValue(60);
    auto& start = *dialog.findChild<QPushButton*>(QStringLiteral("primary"));
    EXPECT_TRUE(waitUntil([&] { return start.isEnabled(); })) << start.toolTip().toStdString();
    return dialog;
  }
  app::MeasuredMotion& measured() { return window().play().measured(); }
  QString cell(const char* table, int row, const QString& head) {
    auto& cells = find<QTableWidget>(table);
    for (int column = 0; column < cells.columnCount(); ++column)
      if (cells.horizontalHeaderItem(column)->text() == head)
        return cells.item(row, column)->text();
    return QStringLiteral("no column %1").arg(head);
  }
  QString verdictAt(std::size_t phase) {
    measured().showPhase(phase);
    settle();
    return window().slices().widget(0).verdict();
  }
  double contourMm() {
    double length = 0;
    for (const auto& contour : window().slices().cine().presenter().contours(0))
      length += contour.lengthMm;
    return length;
  }
};

TEST_F(CineTrack, TwoLabelledPhasesAndTheImagesMoveTheHeart) {
  const QStringList labelled = {labels("ed", 0), labels("es", CinePhantom::kSystole)};
  app::MotionDialog& dialog = ask(labelled);
  EXPECT_EQ(find<QComboBox>("motionSource").currentIndex(), 1) << "a study is open";
  EXPECT_NEAR(find<QDoubleSpinBox>("seriesPeriod").value(), 800, 0.5);
  auto& table = find<QTableWidget>("cineLabels");
  ASSERT_EQ(table.rowCount(), 2);
  EXPECT_EQ(qobject_cast<QSpinBox*>(table.cellWidget(0, 1))->value(), 1);
  auto* systole = qobject_cast<QSpinBox*>(table.cellWidget(1, 1));
  EXPECT_NEAR(systole->value(), int(CinePhantom::kSystole) + 1, 1) << "guessed from the images";
  systole->setValue(int(CinePhantom::kSystole) + 1);
  dialog.start();
  EXPECT_TRUE(find<QPushButton>("motionCancel").isVisible());
  find<QPushButton>("motionCancel").click();
  ASSERT_TRUE(waitUntil([&] { return dialog.said().contains(QStringLiteral("cancelled")); }));
  EXPECT_TRUE(document().organs().empty());

  dialog.start();
  ASSERT_TRUE(waitUntil([&] { return measured().present() != nullptr; })) << dialog.said().toStdString();
  window().playback().pause();
  settle();
  ASSERT_EQ(document().organs().size(), 2U);
  EXPECT_EQ(document().keySequence().keys.size(), CinePhantom::kPhases);
  EXPECT_TRUE(measured().isOfStudy()) << "it is the study that was open";
  EXPECT_FALSE(measured().isEstimate());
  const QString phaseHead = find<QTableWidget>("residuals").horizontalHeaderItem(0)->text();
  EXPECT_TRUE(cell("residuals", 0, phaseHead).startsWith(QStringLiteral("1 ED")));
  EXPECT_TRUE(cell("residuals", int(CinePhantom::kSystole), phaseHead).startsWith(QStringLiteral("5 ES")));
  EXPECT_EQ(cell("residuals", 0, QStringLiteral("from")), QStringLiteral("labels"));
  EXPECT_EQ(cell("residuals", 1, QStringLiteral("from")), QStringLiteral("images"));
  EXPECT_GT(cell("residuals", 1, QStringLiteral("wall ml")).toDouble(), 0);

  ASSERT_TRUE(window().slices().widget(0).isVisible()) << "contours are to be seen on the images";
  EXPECT_EQ(verdictAt(0), QStringLiteral("Labelled"));
  const double full = contourMm();
  const QString between = verdictAt(2);
  EXPECT_TRUE(between.contains(QStringLiteral("eight"))) << between.toStdString();
  verdictAt(CinePhantom::kSystole);
  EXPECT_LT(contourMm(), 0.97 * full) << "they move with the heart";
  auto& surfaces = find<QComboBox>("residualSurface");
  surfaces.setCurrentIndex(surfaces.findText(QStringLiteral("Planes of the images")));
  EXPECT_EQ(find<QTableWidget>("cinePlanes").rowCount(), 7);

  const std::string places = toJson(*measured().record())["images"].dump();
  const QString file = path(QStringLiteral("beat.viscera"));
  window().sessions().saveTo(file, false);
  ASSERT_TRUE(waitUntil([&] { return QFile::exists(file); })) << message().toStdString();
  window().actions()["edit.undo"]->trigger();
  settle();
  EXPECT_TRUE(document().organs().empty());
  EXPECT_NE(document().state().study, nullptr) << "it was open before";
  EXPECT_EQ(measured().images(), nullptr);
  EXPECT_EQ(window().slices().widget(0).verdict(), QString());
  reopenWindow();
  window().sessions().open(file);
  ASSERT_TRUE(waitUntil([&] { return measured().images() && document().state().study; }))
      << message().toStdString();
  settle();
  EXPECT_EQ(toJson(*measured().record())["images"].dump(), places);
  EXPECT_TRUE(measured().isOfStudy());
  EXPECT_EQ(measured().present()->images->request.labels.size(), 2U) << "a correction can find it again";
  EXPECT_EQ(verdictAt(2), between);
}

TEST_F(CineTrack, OneLabelledPhaseIsAnEstimateAtEveryNumber) {
  app::MotionDialog& dialog = ask({labels("ed", 0)});
  EXPECT_TRUE(find<QLabel>("cineRemark").text().contains(QStringLiteral("estimates")));
  dialog.start();
  ASSERT_TRUE(waitUntil([&] { return measured().present() != nullptr; })) << dialog.said().toStdString();
  window().playback().pause();
  settle();
  EXPECT_TRUE(message().contains(QStringLiteral("estimate"))) << message().toStdString();
  EXPECT_TRUE(measured().isEstimate());
  EXPECT_FALSE(document().organs().front()->warnings.empty()) << "reports list it";
  auto& surfaces = find<QComboBox>("residualSurface");
  surfaces.setCurrentIndex(surfaces.findText(QStringLiteral("LV")));
  EXPECT_GT(cell("residuals", 0, QStringLiteral("fitted ml")).toDouble(), 0) << "it was measured";
  EXPECT_TRUE(cell("residuals", 3, QStringLiteral("fitted ml")).startsWith(QString::fromUtf8("\u2248")));
  ASSERT_TRUE(waitUntil([&] { return find<QTableWidget>("heartNumbers").rowCount() > 0; }));
  EXPECT_TRUE(find<QTableWidget>("heartNumbers").item(0, 0)->text().contains(QStringLiteral("estimate")));
  EXPECT_TRUE(find<QLabel>("heartNumbersAbout").text().contains(QStringLiteral("Estimates")));
  EXPECT_TRUE(verdictAt(2).contains(QStringLiteral("Estimate")));
}

} // namespace
} // namespace viscera::tests
