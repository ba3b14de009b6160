#include "window_test.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableWidget>
#include <QTest>

#include "beating_labels.h"
#include "cut_texts.h"
#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/geometry/winding_number.h"
#include "viscera/scene/legend.h"
#include "window/play/play_mode.h"
#include "window/session/session_files.h"

namespace viscera::tests {
namespace {

/// A ball that a user has open, and six phases of a small heart in one file.
class Track : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile());
  }
  QString series(int phases = 6, int units = 16) {
    std::vector<LabelImage> images;
    for (int phase = 0; phase < phases; ++phase)
      images.push_back(beatingLabels(phase / double(phases), Vec3(4, 4, 8)));
    QFile file(path(QStringLiteral("cine.nii")));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    const std::string bytes = nifti4d(images, 900.0 / phases, units);
    file.write(bytes.data(), static_cast<qint64>(bytes.size()));
    return file.fileName();
  }
  app::MotionDialog& ask(const QString& file) {
    app::MotionDialog& dialog = window().play().chooseSeries();
    dialog.look({file});
    settle();
    return dialog;
  }
  app::MeasuredMotion& measured() { return window().play().measured(); }
  QTableWidget& residuals() { return find<QTableWidget>("residuals"); }
  double volumeOf(std::size_t organ) {
    return window().workspace().live().volume(document().organs().at(organ)->id).nowMl;
  }
  /// Goes on until the motion is in the document.
  void findMotion() {
    app::MotionDialog& dialog = ask(series());
    find<QSpinBox>("seriesHandles").setValue(60);
    dialog.start();
    ASSERT_TRUE(waitUntil([&] { return measured().present() != nullptr; })) << dialog.said().toStdString();
    window().playback().pause();
    window().activateWindow(); // No window manager gives the keys back when the dialog goes.
    settle();
  }
};

TEST_F(Track, ALabelSeriesBecomesARecordedSequenceWithWhatWasMeasured) {
  app::MotionDialog& dialog = ask(series());
  auto& items = find<QTableWidget>("seriesItems");
  ASSERT_EQ(items.rowCount(), 3);
  EXPECT_EQ(qobject_cast<QComboBox*>(items.cellWidget(0, 1))->currentText(), QStringLiteral("Cavity"));
  EXPECT_TRUE(qobject_cast<QComboBox*>(items.cellWidget(2, 1))->currentText().startsWith("Tissue"));
  EXPECT_NEAR(find<QDoubleSpinBox>("seriesPeriod").value(), 900, 0.01) << "as the file says";
  items.item(0, 0)->setText(QStringLiteral("LV"));
  items.item(1, 0)->setText(QStringLiteral("RV"));
  find<QSpinBox>("seriesHandles").setValue(60);
  dialog.start();
  ASSERT_TRUE(waitUntil([&] { return measured().present() != nullptr; })) << dialog.said().toStdString();
  settle();
  EXPECT_FALSE(dialog.isVisible());
  EXPECT_EQ(window().mode(), "play") << message().toStdString();
  ASSERT_EQ(document().organs().size(), 3U);
  EXPECT_EQ(document().organs()[0]->name, "Heart");
  EXPECT_EQ(document().organs()[1]->name, "LV");
  EXPECT_EQ(document().organs()[1]->parent, document().organs()[0]->id);
  for (const auto& organ : document().organs())
    EXPECT_EQ(organ->file.filename(), "cine.nii") << "it was not made in the program";
  EXPECT_EQ(document().keySequence().keys.size(), 6U);
  EXPECT_EQ(document().rig().handles.size(), 60U);
  ASSERT_NE(window().playback().sequence(), nullptr);

  ASSERT_TRUE(residuals().isVisible());
  EXPECT_TRUE(find<QWidget>("chartTabs").isVisible()) << "the chart is in the other tab";
  EXPECT_EQ(residuals().rowCount(), 6);
  Q_EMIT residuals().cellClicked(3, 0);
  settle();
  EXPECT_FALSE(window().playback().player().playing());
  EXPECT_EQ(measured().phaseNow(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(volumeOf(i) / measured().present()->series->volumesMl[3][i], 1, 1e-4);
  EXPECT_TRUE(window().volumes().beats(1)) << "measured, and so no keys by hand";
  EXPECT_FALSE(window().volumes().normals(1, {}).empty());
  const auto indices = window().volumes().indices(1);
  ASSERT_TRUE(indices);
  EXPECT_NEAR(indices->ejectionFraction, measured().present()->motion->indices.at("LV").ejectionFraction,
              5e-3);
}

TEST_F(Track, TheTableOfTheFitCutsNothingInANarrowWindow) {
  window().resize(1280, 800);
  findMotion();
  CutTexts cut;
  collectCutHeads(*residuals().parentWidget(), "fit", cut);
  collectCutEntries(residuals(), "fit", cut);
  EXPECT_EQ(cut, CutTexts());
}

TEST_F(Track, TheMeasuredSurfaceAndTheDistancesStandInTheViewWhileItIsShown) {
  findMotion();
  measured().showPhase(2);
  const auto ghosts = [&] { return measured().ghostCount(); };
  ASSERT_TRUE(waitUntil([&] { return ghosts() == 3; }));
  find<QCheckBox>("measuredGhost").setChecked(false);
  settle();
  EXPECT_EQ(ghosts(), 0U);
  EXPECT_FALSE(view().view().legend().visible());
  find<QCheckBox>("measuredDistances").setChecked(true);
  settle();
  EXPECT_TRUE(view().view().legend().visible());
  key(Qt::Key_3);
  settle();
  EXPECT_FALSE(view().view().legend().visible()) << "they leave with the sequence's pose";
}

TEST_F(Track, ASecondSeriesIsComparedWithTheOneBefore) {
  findMotion();
  app::MotionDialog& dialog = ask(series());
  find<QLineEdit>("seriesLeaveOut").setText(QStringLiteral("4"));
  const auto* first = measured().present()->motion.get();
  dialog.start();
  ASSERT_TRUE(waitUntil([&] { return measured().present() && measured().present()->motion.get() != first; }))
      << dialog.said().toStdString();
  settle();
  ASSERT_NE(measured().before(), nullptr);
  EXPECT_EQ(measured().before()->motion.get(), first);
  auto& surfaces = find<QComboBox>("residualSurface");
  surfaces.setCurrentIndex(surfaces.count() - 1);
  auto& differences = find<QTableWidget>("seriesDifferences");
  ASSERT_TRUE(differences.isVisible());
  ASSERT_EQ(differences.rowCount(), 10) << "five numbers of two cavities";
  const auto number = [&](int column) { return differences.item(1, column)->text().toDouble(); };
  EXPECT_GT(number(2), number(1)) << "without its end of systole the cavity is larger at its smallest";
  EXPECT_NEAR(number(3), number(2) - number(1), 0.11);
}

TEST_F(Track, IsOneStepThatUndoTakesBackWithItsTable) {
  const auto ball = document().organs().front()->mesh;
  findMotion();
  ASSERT_TRUE(message().contains(QStringLiteral("6 phases"))) << message().toStdString();
  key(Qt::Key_Z, Qt::ControlModifier);
  settle();
  ASSERT_EQ(document().organs().size(), 1U);
  EXPECT_EQ(message(), QString()) << "it is of organs that are gone, and so is what it may offer";
  EXPECT_EQ(document().organs().front()->mesh, ball);
  EXPECT_TRUE(document().keySequence().keys.empty());
  EXPECT_EQ(measured().present(), nullptr);
  EXPECT_FALSE(residuals().isVisible() || find<QWidget>("chartTabs").isVisible());
  key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  settle();
  EXPECT_NE(measured().present(), nullptr);
  ASSERT_NE(window().playback().sequence(), nullptr);
  window().playback().play();
  settle();
  EXPECT_TRUE(residuals().isVisible());
}

TEST_F(Track, IsSavedAndEditedLikeAnyRecordedSequence) {
  findMotion();
  const document::KeySequence found = document().keySequence();
  const QString file = path(QStringLiteral("beat.sequence.json"));
  window().play().keySequence().save(file);
  ASSERT_TRUE(QFile::exists(file));
  // One handle in one key changes that key only.
  ASSERT_TRUE(window().play().keySequence().takePose(found.keys[2].id));
  const auto handle = document().rig().handles[20].id;
  Points pose = document().pose();
  pose.row(20) += Vec3(1, 2, 3).transpose();
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  ASSERT_TRUE(window().workspace().perform(document::replaceKey(found.keys[2].id)));
  for (std::size_t key = 0; key < 6; ++key) {
    const auto& now = document().keySequence().keys[key].displacements;
    EXPECT_EQ(now == found.keys[key].displacements, key != 2) << "key " << key;
  }
  EXPECT_NEAR((document().keySequence().keys[2].displacements.at(handle) -
               found.keys[2].displacements.at(handle) - Vec3(1, 2, 3))
                  .norm(),
              0, 1e-9);
}

TEST_F(Track, ASessionKeepsTheDotsAndTheTable) {
  findMotion();
  measured().showPhase(2);
  const auto before = *measured().present();
  const auto cells = [&] {
    QStringList all;
    for (int row = 0; row < residuals().rowCount(); ++row)
      for (int column = 0; column < residuals().columnCount(); ++column)
        all.push_back(residuals().item(row, column)->text() + residuals().item(row, column)->toolTip());
    return all;
  };
  settle();
  const QStringList table = cells();
  const QString file = path(QStringLiteral("beat.viscera"));
  window().sessions().saveTo(file, false);
  ASSERT_TRUE(waitUntil([&] { return QFile::exists(file); })) << message().toStdString();
  reopenWindow();
  window().sessions().open(file);
  settle();
  ASSERT_TRUE(waitUntil([&] { return measured().present() && residuals().isVisible(); }))
      << message().toStdString();
  EXPECT_EQ(cells(), table);
  EXPECT_EQ(measured().phaseNow(), 2U);
  EXPECT_EQ(measured().present()->series->volumesMl, before.series->volumesMl) << "dots of the chart";
  EXPECT_EQ(measured().present()->motion->tissueMl, before.motion->tissueMl);
  EXPECT_FALSE(find<QCheckBox>("measuredGhost").isEnabled()) << "surfaces are in no session";
  EXPECT_EQ(measured().ghostCount(), 0U);
  key(Qt::Key_N, Qt::ControlModifier);
  settle();
  EXPECT_EQ(measured().present(), nullptr);
}

TEST_F(Track, StressIsThatOfTheMuscleAloneAndSaysWhatItDoesNotTell) {
  findMotion();
  key(Qt::Key_4);
  measured().showPhase(3);
  auto& live = window().workspace().stress();
  ASSERT_TRUE(waitUntil([&] { return live.mesh() != nullptr; }));
  settle();
  const auto& organs = document().organs();
  for (const std::size_t cavity : {1, 2}) {
    const Bounds box = boundsOf(organs[cavity]->mesh->points);
    const geometry::WindingNumber winding(*organs[cavity]->mesh);
    for (Eigen::Index point = 0; point < live.mesh()->witnesses; ++point) {
      const Vec3 at = live.mesh()->points.row(point).transpose();
      if ((at - box.center()).norm() < box.diagonal() / 2) {
        ASSERT_FALSE(winding.inside(at)) << "blood is not distorted";
      }
    }
  }
  EXPECT_TRUE(find<QLabel>("stressCaution").isVisible());
  EXPECT_TRUE(find<QLabel>("stressCaution").text().contains(QStringLiteral("how points move along a wall")));
  window().playback().stop();
  settle();
  EXPECT_FALSE(find<QLabel>("stressCaution").isVisible()) << "your own pose is known everywhere";
}

TEST_F(Track, BeatsBesideTheTextbooksHeartUnderOneTimeline) {
  findMotion();
  window().actions()["play.compareTextbook"]->trigger();
  app::Comparison& comparison = window().play().comparison();
  ASSERT_TRUE(QTest::qWaitFor([&] { return comparison.on() && comparison.playback().sequence(); }, 120000));
  ASSERT_TRUE(waitUntil([&] { return !comparison.workspace().live().busy(); }));
  settle();
  EXPECT_EQ(document().organs().size(), 3U) << "the patient's heart stays";
  EXPECT_GT(comparison.workspace().document().organs().size(), 2U);
  const double own = window().playback().player().ratePerMinute();
  EXPECT_NEAR(own, 60 / 0.9, 1e-3);
  EXPECT_NEAR(comparison.playback().player().ratePerMinute(), own, 1e-6) << "at the patient's rate";
  window().playback().toStart();
  window().playback().seek(0.4);
  settle();
  EXPECT_NEAR(comparison.playback().player().fraction(), 0.4, 1e-6) << "one timeline";
  EXPECT_GT(window().volumes().lines().size(), 4U) << "curves of both";
  window().actions()["play.single"]->trigger();
  settle();
  EXPECT_FALSE(comparison.on());
  EXPECT_NE(measured().present(), nullptr);
}

TEST_F(Track, RefusalsStandInTheDialogAndChangeNothing) {
  const auto before = document().state();
  app::MotionDialog& dialog = ask(series(3));
  dialog.start();
  ASSERT_TRUE(waitUntil([&] { return !dialog.said().isEmpty(); }));
  EXPECT_TRUE(dialog.isVisible());
  EXPECT_TRUE(dialog.said().contains(QStringLiteral("It has 3 phases; a motion needs four at least")))
      << dialog.said().toStdString();
  EXPECT_TRUE(dialog.said().contains(QStringLiteral("Name all phases of the cycle")));
  ask(series(6, 0));
  EXPECT_EQ(document().organs().size(), 1U);
  find<QDoubleSpinBox>("seriesPeriod").setValue(0);
  EXPECT_FALSE(dialog.findChild<QPushButton*>(QStringLiteral("primary"))->isEnabled())
      << "nobody has said how long a cycle lasts";
  find<QDoubleSpinBox>("seriesPeriod").setValue(900);
  find<QLineEdit>("seriesLeaveOut").setText(QStringLiteral("two"));
  dialog.start();
  EXPECT_TRUE(dialog.said().contains(QStringLiteral("Two is not a phase"), Qt::CaseInsensitive));
  find<QLineEdit>("seriesLeaveOut").clear();
  dialog.look({path(QStringLiteral("nowhere"))});
  settle();
  EXPECT_TRUE(dialog.said().contains(QStringLiteral("no such file or folder")))
      << dialog.said().toStdString();
  EXPECT_EQ(document().state().organs, before.organs);
  EXPECT_EQ(document().state().rig, before.rig);
}

TEST_F(Track, TheGreyButtonSaysWhatIsMissing) {
  app::MotionDialog& dialog = window().play().chooseSeries();
  const auto& button = *dialog.findChild<QPushButton*>(QStringLiteral("primary"));
  const auto& missing = *dialog.findChild<QLabel*>(QStringLiteral("motionMissing"));
  EXPECT_FALSE(button.isEnabled());
  EXPECT_TRUE(button.toolTip().contains(QStringLiteral("series"))) << button.toolTip().toStdString();
  ask(series(6, 0));
  auto& period = find<QDoubleSpinBox>("seriesPeriod");
  period.setValue(0);
  EXPECT_FALSE(button.isEnabled());
  EXPECT_TRUE(missing.isVisible()) << "also for whom the mouse is elsewhere";
  EXPECT_TRUE(missing.text().contains(QStringLiteral("duration of one cycle")))
      << missing.text().toStdString();
  EXPECT_EQ(button.toolTip(), missing.text());
  period.setValue(900);
  EXPECT_TRUE(button.isEnabled());
  EXPECT_TRUE(missing.isHidden());
  EXPECT_EQ(button.toolTip(), QString());
}

TEST_F(Track, CanBeCancelled) {
  app::MotionDialog& dialog = ask(series());
  dialog.start();
  measured().cancel();
  ASSERT_TRUE(waitUntil([&] { return dialog.said().contains(QStringLiteral("cancelled")); }));
  settle();
  EXPECT_EQ(document().organs().size(), 1U);
  EXPECT_EQ(measured().present(), nullptr);
  EXPECT_TRUE(dialog.isVisible());
}

} // namespace
} // namespace viscera::tests
