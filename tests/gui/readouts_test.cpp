// What is read in the window is of the frame that is drawn, and means what is drawn.
#include "play_fixture.h"

#include <QAbstractButton>
#include <QCoreApplication>
#include <QLabel>
#include <QSpinBox>
#include <QTreeWidget>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <vtkCamera.h>
#include <vtkRenderer.h>

#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "window/circulation/circulation_panel.h"
#include "window/compare/compared_system.h"
#include "window/compare/side_header.h"
#include "window/session/session_files.h"
#include "window/style/language.h"
#include "window/timeline/chart_cursor.h"
#include "window/timeline/timeline_bar.h"
#include "window/timeline/volume_panel.h"
#include "window/widgets/elided_label.h"

namespace viscera::tests {
namespace {

constexpr int kColumnOfVolume = 2; ///< The column.

class Readouts : public PlayMode {
protected:
  app::Workspace& workspaceOf(const app::VolumeMonitor::Line& line) {
    return line.side == 0 ? window().workspace() : parts().comparison().workspace();
  }
  QString shownMl(const app::VolumeMonitor::Line& line) {
    return app::formatMilliliters(workspaceOf(line).live().volume(line.organ).nowMl);
  }
  QTreeWidgetItem* row(document::OrganId organ) {
    for (QTreeWidgetItemIterator item(&find<QTreeWidget>("organList")); *item; ++item)
      if ((*item)->data(1, Qt::UserRole).toLongLong() == organ.value)
        return *item;
    throw std::runtime_error("no row");
  }
  app::VolumePanel& chart() { return *window().findChild<app::VolumePanel*>(); }

  /// Tiles, list, status bar and headers against what the view draws.
  void expectNumbersOfTheFrame() {
    const auto& lines = window().volumes().lines();
    const auto tiles = window().findChildren<QLabel*>(QStringLiteral("tileValue"));
    ASSERT_EQ(tiles.size(), static_cast<int>(lines.size()));
    const auto headers = window().findChildren<app::SideHeader*>();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const QString volume = shownMl(lines[i]);
      EXPECT_EQ(tiles[static_cast<int>(i)]->text(), volume) << "the tile of " << lines[i].label;
      if (lines[i].side == 0) {
        EXPECT_EQ(row(lines[i].organ)->text(kColumnOfVolume), volume) << "the list's " << lines[i].label;
      }
      if (!headers.empty()) {
        const QString said = QStringLiteral("%1 %2").arg(lines[i].name, volume);
        EXPECT_TRUE(headers[lines[i].side]->volumes().contains(said))
            << headers[lines[i].side]->volumes().toStdString() << " for " << said.toStdString();
      }
    }
    const auto current = window().workspace().currentOrgan();
    const double now = window().workspace().live().volume(current->id).nowMl;
    EXPECT_TRUE(find<QLabel>("statusVolume").text().contains(app::formatMilliliters(now)))
        << find<QLabel>("statusVolume").text().toStdString();
    EXPECT_EQ(find<QLabel>("playPhase").text(), app::inWords(window().playback().player().phase()));
  }

  /// One beat at 75 a minute, in frames that follow each other faster than pictures are drawn. List, tiles,
  /// chart and status bar read what was measured once.
  void expectNumbersOverABeat() {
    constexpr int kFrames = 24;
    const live::LiveBinding& live = window().workspace().live();
    const std::uint64_t first = live.measurings();
    for (int frame = 0; frame < kFrames; ++frame) {
      const std::uint64_t measured = live.measurings();
      now_ += 0.8 / kFrames;
      window().playback().advance();
      QCoreApplication::processEvents();
      expectNumbersOfTheFrame();
      EXPECT_LE(live.measurings(), measured + 1) << "frame " << frame;
      if (HasFailure())
        return;
    }
    EXPECT_GT(live.measurings(), first + kFrames / 2) << "the heart rests for a few frames only";
  }
};

TEST_F(Readouts, AreOfTheFrameThatIsDrawnOverAWholeBeat) {
  window().playback().toStart();
  key(Qt::Key_Space);
  const double before = volumeOf("LV");
  expectNumbersOverABeat();
  EXPECT_NEAR(volumeOf("LV"), before, 20) << "a beat went by";
}

TEST_F(Readouts, OfTwoViewsAreOfTheFrameThatIsDrawn) {
  key(Qt::Key_2, Qt::ControlModifier);
  app::Workspace& second = parts().comparison().workspace();
  ASSERT_TRUE(waitUntil([&] { return !second.live().busy() && second.jobs().idle(); }));
  window().playback().toStart();
  key(Qt::Key_Space);
  expectNumbersOverABeat();
}

TEST_F(Readouts, OfALectureAreOfTheFrameThatIsDrawn) {
  key(Qt::Key_F5);
  window().playback().toStart();
  window().playback().play();
  for (int frame = 0; frame < 8; ++frame) {
    now_ += 0.05;
    window().playback().advance();
    QCoreApplication::processEvents();
    const QString numbers = find<QLabel>("lectureNumbers").text().replace(QChar::Nbsp, QLatin1Char(' '));
    const QString left = app::formatNumber(volumeOf("LV"), 1);
    EXPECT_TRUE(numbers.contains(left)) << numbers.toStdString() << " for " << left.toStdString();
    EXPECT_TRUE(numbers.startsWith(app::inWords(window().playback().player().phase())));
  }
}

TEST_F(Readouts, OfALectureWithTwoViewsSayOfWhichViewTheyAre) {
  key(Qt::Key_2, Qt::ControlModifier);
  app::Workspace& second = parts().comparison().workspace();
  ASSERT_TRUE(waitUntil([&] { return !second.live().busy() && second.jobs().idle(); }));
  key(Qt::Key_F5);
  window().playback().seek(0.4);
  settle();
  const QStringList rows =
      find<QLabel>("lectureNumbers").text().replace(QChar::Nbsp, QLatin1Char(' ')).split(QLatin1Char('\n'));
  ASSERT_EQ(rows.size(), 2) << rows.join(QLatin1Char('|')).toStdString();
  const double volumes[] = {volumeOf("LV"), volumeIn(second, "LV")};
  ASSERT_GT(std::abs(volumes[0] - volumes[1]), 1) << "the second beats twice as fast";
  for (int side = 0; side < 2; ++side) {
    EXPECT_TRUE(rows[side].startsWith(QStringLiteral("%1: ").arg(side + 1))) << rows[side].toStdString();
    EXPECT_TRUE(rows[side].contains(app::formatNumber(volumes[side], 1))) << rows[side].toStdString();
  }
}

TEST_F(Readouts, TheChartsCursorIsAtTheInstantInEveryFrame) {
  auto* cursor = chart().findChild<app::ChartCursor*>();
  ASSERT_NE(cursor, nullptr);
  const auto at = [&](double fraction) {
    window().playback().seek(fraction);
    EXPECT_EQ(cursor->marks().lines.size(), 1u);
    return cursor->marks().lines.empty() ? -1 : cursor->marks().lines.front().x;
  };
  window().playback().seek(0.1);
  ASSERT_TRUE(waitUntil([&] { return !cursor->marks().lines.empty(); }));
  settle();
  QTest::qWait(100); // The chart has its place.
  const double left = at(0), right = at(0.8);
  ASSERT_GT(right, left + 0.2);
  window().playback().toStart();
  key(Qt::Key_Space);
  for (int frame = 0; frame < 12; ++frame) {
    now_ += 0.06;
    window().playback().advance();
    const double fraction = window().playback().player().fraction();
    ASSERT_EQ(cursor->marks().lines.size(), 1u);
    EXPECT_NEAR(cursor->marks().lines.front().x, left + (right - left) * fraction / 0.8, 1e-3);
  }
  key(Qt::Key_O);
  EXPECT_TRUE(cursor->marks().lines.empty()) << "the curves end at the instant themselves";
  key(Qt::Key_O);
  key(Qt::Key_3);
  EXPECT_TRUE(waitUntil([&] { return cursor->marks().lines.empty(); })) << "no instant is shown";
}

TEST_F(Readouts, TheCirculationsCursorAndRingsAreAtTheInstantInEveryFrame) {
  find<QAbstractButton>("scenario.rest").click();
  auto* panel = window().findChild<app::CirculationPanel*>();
  ASSERT_TRUE(waitUntil([&] {
    return parts().circulation().settled() && parts().circulation().present() && panel->isVisible();
  })) << message().toStdString();
  settle();
  const auto* cursor = panel->findChild<app::ChartCursor*>();
  ASSERT_NE(cursor, nullptr);
  window().playback().seek(0);
  const app::ChartCursor::Marks begin = cursor->marks();
  const double before = volumeOf("LV");
  ASSERT_EQ(begin.lines.size(), 5u) << "the strips of Wiggers's diagram";
  ASSERT_EQ(begin.rings.size(), 2u) << "the loops";
  window().playback().seek(0.4);
  const app::ChartCursor::Marks later = cursor->marks();
  for (std::size_t i = 0; i < begin.lines.size(); ++i)
    EXPECT_GT(later.lines[i].x, begin.lines[i].x + 0.05);
  EXPECT_GT(std::abs(volumeOf("LV") - before), 5);
  EXPECT_EQ(later.rings[0].x > begin.rings[0].x, volumeOf("LV") > before);
}

TEST_F(Readouts, NormalRangesOfABeatAreShownOfABeatOnly) {
  const auto* source = chart().findChild<app::ElidedLabel*>(QStringLiteral("chartSource"));
  ASSERT_NE(source, nullptr);
  EXPECT_FALSE(chart().normalsText().isEmpty());
  EXPECT_FALSE(source->fullText().isEmpty());
  EXPECT_TRUE(waitUntil([&] { return !find<QLabel>("normalRanges").isHidden(); }));
  for (const double seconds : {0.0, 0.8}) {
    Points pose = document().pose();
    pose.row(0) += Vec3(4, 0, 0).transpose();
    ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
    ASSERT_TRUE(window().workspace().perform(document::recordKey(seconds)));
  }
  settle();
  window().playback().choose(parts().keySequence().sequence());
  ASSERT_EQ(window().playback().sequence()->id(), "keyframes");
  EXPECT_EQ(chart().normalsText(), QString()) << "keys by hand are no beat";
  EXPECT_TRUE(waitUntil([&] { return source->fullText().isEmpty(); }));
  EXPECT_TRUE(waitUntil([&] { return find<QLabel>("normalRanges").isHidden(); }));
  for (const auto& motion : window().playback().motions())
    if (motion.sequence->id() == "heartbeat") {
      window().playback().choose(motion.sequence.get());
      break;
    }
  EXPECT_TRUE(waitUntil([&] { return !source->fullText().isEmpty(); }));
  EXPECT_TRUE(waitUntil([&] { return !find<QLabel>("normalRanges").isHidden(); }));
}

TEST_F(Readouts, NoRateIsShownWhereThereIsNoMotion) {
  const auto& rate = find<QSpinBox>("rate");
  window().playback().setRate(150);
  ASSERT_EQ(rate.text(), QStringLiteral("150 / min"));
  key(Qt::Key_N, Qt::ControlModifier);
  ASSERT_EQ(window().playback().sequence(), nullptr);
  EXPECT_EQ(rate.text(), QStringLiteral("-"));
  EXPECT_FALSE(rate.toolTip().contains(QStringLiteral("Heartbeat"))) << rate.toolTip().toStdString();
  EXPECT_EQ(find<QLabel>("phase").toolTip(), QString()) << "nothing is at an instant of a cycle";
  loadSample(QStringLiteral("liver"));
  EXPECT_EQ(rate.text(),
            QStringLiteral("%1 / min").arg(std::lround(window().playback().player().ratePerMinute())));
}

TEST_F(Readouts, APoseByHandIsNotCalledRest) {
  const auto& phase = find<QLabel>("phase");
  window().playback().stop();
  settle();
  EXPECT_EQ(phase.text(), QStringLiteral("at rest"));
  Points pose = document().pose();
  pose.row(0) += Vec3(4, 0, 0).transpose();
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  settle();
  EXPECT_EQ(phase.text(), QStringLiteral("posed by hand"));
  window().workspace().undo().undo();
  settle();
  EXPECT_EQ(phase.text(), QStringLiteral("at rest"));
}

/// A motion that can be played at one rate only, as the beat of a circulation.
class OneRate final : public sequences::Sequence {
public:
  explicit OneRate(double perMinute) : rate_(perMinute) {}

  std::string id() const override { return "one-rate"; }
  Text name() const override { return "One rate"; }
  const Points& restHandles() const override { return rest_; }
  double standardRatePerMinute() const override { return rate_; }
  double lowestRatePerMinute() const override { return rate_; }
  double highestRatePerMinute() const override { return rate_; }
  void poseAt(double, double, Points& pose) const override { pose = rest_; }
  std::vector<sequences::Phase> phases(double) const override { return {{"all", 0, 1}}; }

private:
  Points rest_;
  double rate_;
};

TEST(RateOfTheTimeline, IsTheOnlyOneThereIsAlsoWhereThatHasAFraction) {
  QSpinBox box;
  for (const double rate : {60 / (60 / 110.0), 85.7}) {
    app::showRate(box, OneRate(rate), rate);
    EXPECT_EQ(box.value(), std::lround(rate));
    EXPECT_EQ(box.minimum(), box.maximum());
    EXPECT_FALSE(box.isEnabled()) << "there is nothing to choose";
  }
}

TEST_F(Readouts, TheTwoViewsHaveNumbersWhereLettersAreSides) {
  key(Qt::Key_2, Qt::ControlModifier);
  QStringList badges;
  for (const QLabel* badge : window().findChildren<QLabel*>(QStringLiteral("sideNumber")))
    badges << badge->text();
  badges.sort();
  EXPECT_EQ(badges, (QStringList{QStringLiteral("1"), QStringLiteral("2")}));
  const auto& lines = window().volumes().lines();
  EXPECT_TRUE(window().volumes().nameOf(lines.front()).startsWith(QLatin1String("1: ")));
  EXPECT_TRUE(window().volumes().nameOf(lines.back()).startsWith(QLatin1String("2: ")));
}

/// A posed ball beside which something is shown.
class SecondViewOfASession : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    open(sphereFile());
    pose(7.5);
  }
  void pose(double mm) {
    Points pose = document().pose();
    pose(0, 0) += mm;
    ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
    settle();
  }
  app::Comparison& comparison() { return window().play().comparison(); }
  void saveAndOpen() {
    bool done = false;
    const QString file = path(QStringLiteral("beside.viscera"));
    window().sessions().saveTo(file, false, [&] { done = true; });
    ASSERT_TRUE(waitUntil([&] { return done; })) << message().toStdString();
    reopenWindow();
    open(file);
  }
  void waitForSecond() {
    ASSERT_TRUE(comparison().on());
    app::Workspace& second = comparison().workspace();
    ASSERT_TRUE(waitUntil([&] {
      return !second.document().organs().empty() && second.jobs().idle() && !second.live().busy();
    }));
    settle();
  }
};

TEST_F(SecondViewOfASession, HasTheCoordinatesThatItHad) {
  comparison().showOtherCoordinates();
  comparison().comparedSystem()->choose("mean-value");
  waitForSecond();
  const Vec3 eye(view().view().renderer()->GetActiveCamera()->GetPosition());
  saveAndOpen();
  waitForSecond();
  ASSERT_NE(comparison().comparedSystem(), nullptr);
  EXPECT_EQ(comparison().comparedSystem()->system(), "mean-value");
  EXPECT_EQ(comparison().workspace().document().pose(), document().pose());
  EXPECT_LT((Vec3(view().view().renderer()->GetActiveCamera()->GetPosition()) - eye).norm(), 1e-9)
      << "the camera is the session's";
  EXPECT_FALSE(window().isWindowModified());
}

TEST_F(SecondViewOfASession, HasThePoseThatWasKept) {
  comparison().showKeptPose();
  const Points kept = document().pose();
  pose(5);
  saveAndOpen();
  waitForSecond();
  EXPECT_EQ(comparison().workspace().document().pose(), kept);
  EXPECT_NE(document().pose(), kept);
}

TEST_F(SecondViewOfASession, HasItsSampleAndNoFiles) {
  comparison().showSample(QStringLiteral("kidney_left"));
  waitForSecond();
  const std::string name = comparison().workspace().document().organs().front()->name;
  saveAndOpen();
  waitForSecond();
  EXPECT_EQ(comparison().workspace().document().organs().front()->name, name);
  comparison().showFiles({sphereFile(QStringLiteral("other.stl"), 40)});
  EXPECT_FALSE(comparison().compared());
}

TEST_F(SecondViewOfASession, HasItsSampleAlsoBesideNoOrgan) {
  comparison().showSample(QStringLiteral("kidney_left"));
  waitForSecond();
  const std::string name = comparison().workspace().document().organs().front()->name;
  ASSERT_TRUE(window().workspace().perform(document::removeAllOrgans()));
  saveAndOpen();
  waitForSecond();
  EXPECT_TRUE(document().organs().empty());
  EXPECT_EQ(comparison().workspace().document().organs().front()->name, name);
  scene::OrganView& second = comparison().view().view();
  const Vec3 focus(second.renderer()->GetActiveCamera()->GetFocalPoint());
  EXPECT_LT((focus - second.bounds().center()).norm(), 0.1 * second.bounds().diagonal()) << "in the middle";
}

TEST_F(SecondViewOfASession, WithCoordinatesThatAreNotThereSaysSo) {
  presentation::Compared wanted;
  wanted.what = presentation::Compared::What::coordinates;
  wanted.name = "nobodys";
  comparison().restore(wanted);
  EXPECT_FALSE(comparison().on());
  EXPECT_TRUE(message().contains(QStringLiteral("nobodys"))) << message().toStdString();
}

/// A mode that learns of other organs may show the chart before the chart itself learns of them.
TEST_F(Readouts, OfAChartThatIsShownBeforeItKnowsOfOtherOrgansFollow) {
  app::VolumeMonitor monitor(window().workspace(), window().playback());
  app::VolumePanel* shown = nullptr;
  QObject earlier;
  QObject::connect(&monitor, &app::VolumeMonitor::linesChanged, &earlier, [&] {
    if (shown) {
      shown->hide();
      shown->show();
    }
  });
  app::VolumePanel panel(monitor, window().playback(), window().viewModel());
  const auto tiles = [&] {
    return static_cast<std::size_t>(panel.findChildren<QLabel*>(QStringLiteral("tileValue")).size());
  };
  shown = &panel;
  panel.show();
  std::vector<document::OrganId> others;
  for (std::size_t organ = 1; organ < document().organs().size(); ++organ)
    others.push_back(document().organs()[organ]->id);
  ASSERT_GT(others.size(), 1);
  ASSERT_TRUE(window().workspace().perform(document::removeOrgans(others)));
  EXPECT_EQ(tiles(), monitor.lines().size());
  panel.setNormalsOf(monitor.lines().size());
  window().workspace().undo().undo();
  EXPECT_EQ(tiles(), monitor.lines().size());
  EXPECT_GT(tiles(), 1);
}

} // namespace
} // namespace viscera::tests
