#include "window_test.h"

#include <QAction>
#include <QCheckBox>
#include <QSpinBox>
#include <QTableWidget>
#include <QTest>

#include <cstdlib>

#include "build_paths.h"
#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/rig_commands.h"
#include "window/play/play_mode.h"
#include "window/session/session_files.h"
#include "window/timeline/phase_scrubber.h"
#include "window/view/view_area.h"
#include "window/widgets/message_bar.h"
#include "window_probe.h"

namespace viscera::tests {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPhases = 25;

/// The right ventricle of one person in 25 phases, in the window.
class RealSeries : public WindowTest {
protected:
  void SetUp() override {
    if (!fs::exists(kCine))
      GTEST_SKIP() << "shared/organs/cine is absent";
    WindowTest::SetUp();
    window().resize(1600, 1000);
    window().samples().load(QStringLiteral("heart"), false);
    waitUntil([this] { return window().playback().sequence() && atPeace(window()); });
    findMotion();
  }
  void findMotion() {
    app::MotionDialog& dialog = window().play().chooseSeries();
    dialog.look({QString::fromStdString(kCine.string())});
    settle();
    find<QDoubleSpinBox>("seriesPeriod").setValue(829);
    dialog.start();
    ASSERT_TRUE(waitUntil([&] { return measured().present() != nullptr; })) << dialog.said().toStdString();
    window().playback().pause();
    window().activateWindow(); // No window manager gives the keys back when the dialog goes.
    settle();
  }
  app::MeasuredMotion& measured() { return window().play().measured(); }
  double shownMl() { return window().workspace().live().volume(document().organs().front()->id).nowMl; }
  double measuredMl(std::size_t phase) { return measured().present()->series->volumesMl[phase].front(); }
  void expectMeasuredVolumes() {
    for (std::size_t phase = 0; phase < kPhases; phase += 4) {
      measured().showPhase(phase);
      settle();
      EXPECT_NEAR(shownMl() / measuredMl(phase), 1, 1e-4) << "phase " << phase;
    }
  }
  /// Into docs/pictures, where VISCERA_UPDATE_PICTURES asks for it; else into the build folder.
  void keep(const char* name, QWidget& what) {
    window().viewArea().messages()->dismiss();
    settle();
    waitUntil([this] { return atPeace(window()); });
    const fs::path folder = std::getenv("VISCERA_UPDATE_PICTURES")
                                ? fs::path(VISCERA_SOURCE_DIR) / "docs/pictures"
                                : fs::path(VISCERA_BINARY_DIR) / "pictures";
    fs::create_directories(folder);
    EXPECT_TRUE(window()
                    .grab(QRect(what.mapTo(&window(), QPoint()), what.size()))
                    .save(QString::fromStdString((folder / name).string())));
  }
  void checkBox(const char* name, bool on) { find<QCheckBox>(name).setChecked(on); }

  const fs::path kCine = fs::path(VISCERA_SHARED_ORGANS) / "cine";
};

/// The pictures of docs/patient_motion.md.
TEST_F(RealSeries, TakesThePlaceOfTheSampleAndShowsWhatWasMeasured) {
  ASSERT_EQ(document().organs().size(), 1U);
  EXPECT_EQ(document().keySequence().keys.size(), kPhases);
  EXPECT_EQ(document().rig().handles.size(), 60U);
  auto& table = find<QTableWidget>("residuals");
  EXPECT_EQ(table.rowCount(), int(kPhases));
  double mean = 0;
  for (const live::TrackedPhase& phase : measured().present()->motion->phases)
    mean += phase.quality.meanMm / kPhases;
  EXPECT_LT(mean, 0.7);
  const auto indices = window().volumes().indices(0);
  ASSERT_TRUE(indices);
  EXPECT_NEAR(indices->ejectionFraction, 0.549, 0.001);
  expectMeasuredVolumes();

  const QStringList keys = window().findChild<app::PhaseScrubber*>()->namesShown();
  ASSERT_GT(keys.size(), 5);
  const auto numberOf = [&](int place) { return keys[place].section(' ', -1).toInt(); };
  for (int i = 1; i < keys.size(); ++i)
    EXPECT_EQ(numberOf(i) - numberOf(i - 1), numberOf(1) - numberOf(0)) << keys[i].toStdString();

  checkBox("measuredGhost", true);
  measured().showPhase(10);
  keep("measured_rv.png", window());
  measured().showPhase(0);
  keep("measured_rv_1.png", view());
  measured().showPhase(4);
  keep("measured_rv_5.png", view());
  checkBox("measuredGhost", false);
  checkBox("measuredDistances", true);
  measured().showPhase(10);
  keep("measured_rv_distances.png", view());
}

/// In orders that nobody plans: each step is one that a user may take next.
TEST_F(RealSeries, HoldsThroughUndoComparisonEditsAndSessions) {
  QAction* undo = window().actions()["edit.undo"];
  QAction* redo = window().actions()["edit.redo"];
  window().playback().play();
  undo->trigger();
  settle();
  EXPECT_EQ(document().organs().size(), 5U) << "the sample heart is back";
  EXPECT_EQ(measured().present(), nullptr);
  redo->trigger();
  settle();
  ASSERT_NE(measured().present(), nullptr) << "with its table";
  expectMeasuredVolumes();

  key(Qt::Key_4);
  waitUntil([this] { return atPeace(window()); });
  key(Qt::Key_5);
  settle();
  expectMeasuredVolumes();

  window().actions()["play.compareTextbook"]->trigger();
  app::Comparison& comparison = window().play().comparison();
  ASSERT_TRUE(waitUntil([&] { return comparison.on() && comparison.playback().sequence(); }));
  undo->trigger();
  settle();
  redo->trigger();
  settle();
  window().actions()["play.single"]->trigger();
  settle();
  EXPECT_FALSE(comparison.on());
  expectMeasuredVolumes();

  const QString file = path(QStringLiteral("rv.viscera"));
  bool saved = false;
  window().sessions().saveTo(file, false, [&] { saved = true; });
  ASSERT_TRUE(waitUntil([&] { return saved; })) << message().toStdString();
  window().playback().play();
  window().actions()["file.new"]->trigger();
  settle();
  EXPECT_TRUE(document().organs().empty());
  EXPECT_EQ(measured().present(), nullptr);
  EXPECT_FALSE(window().playback().player().playing());
  open(file);
  ASSERT_EQ(document().organs().size(), 1U);
  EXPECT_EQ(find<QTableWidget>("residuals").rowCount(), int(kPhases));
  EXPECT_EQ(message().indexOf(QStringLiteral("rror")), -1) << message().toStdString();
}

} // namespace
} // namespace viscera::tests
