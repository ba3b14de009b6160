#include "play_fixture.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QStandardItemModel>

#include <chrono>
#include <thread>
#include <utility>
#include <vector>

#include "build_paths.h"
#include "viscera/document/organ_commands.h"
#include "window/movie/movie_plan.h"
#include "window/play/play_page.h"
#include "window_probe.h"

namespace viscera::tests {
namespace {

/// Packets in an Ogg file, over all of its pages; -1 when it is none.
int oggPackets(const QByteArray& bytes) {
  int packets = 0;
  for (int at = 0; at < bytes.size();) {
    if (bytes.mid(at, 4) != "OggS" || at + 27 > bytes.size())
      return -1;
    const int segments = static_cast<unsigned char>(bytes[at + 26]);
    int length = 27 + segments;
    for (int i = 0; i < segments; ++i) {
      const int segment = static_cast<unsigned char>(bytes[at + 27 + i]);
      length += segment;
      packets += segment < 255;
    }
    at += length;
  }
  return packets;
}

constexpr presentation::HeartSigns kNoSigns{false, false, false, false, false};

class Recordings : public PlayMode {
protected:
  void describe(const QString& kind, const QString& file, int framesPerSecond, int cycles) {
    auto& format = find<QComboBox>("recordFormat");
    const int row = format.findText(kind, Qt::MatchContains);
    ASSERT_GE(row, 0);
    format.setCurrentIndex(row);
    Q_EMIT format.activated(row);
    auto& name = find<QLineEdit>("recordFile");
    name.setFocus();
    name.selectAll();
    QTest::keyClicks(&name, file);
    auto& size = find<QComboBox>("recordSize");
    size.setCurrentIndex(size.findText(QStringLiteral("640 x 480")));
    find<QSpinBox>("recordRate").setValue(framesPerSecond);
    find<QSpinBox>("recordCycles").setValue(cycles);
  }
  void press() { QTest::mouseClick(&find<QAbstractButton>("recordButton"), Qt::LeftButton); }
  bool recorded() {
    return QTest::qWaitFor([this] { return !parts().recorder().running(); }, 60000 * VISCERA_TEST_PATIENCE);
  }
  /// The first frames of the motion that is played, 640 x 480, five of them a second.
  std::vector<QImage> frames(const char* folder) {
    app::MoviePlan plan;
    plan.format = app::MovieFormat::pictures;
    plan.file = path(QLatin1String(folder));
    plan.size = {640, 480};
    plan.framesPerSecond = 5;
    plan.caption = false;
    std::vector<QImage> frames;
    if (!parts().record(plan) || !recorded())
      return frames;
    for (const QString& name : QDir(plan.file).entryList(QDir::Files, QDir::Name))
      frames.emplace_back(plan.file + QLatin1Char('/') + name);
    return frames;
  }
  /// How many pixels of two pictures differ in the lowest `part` of them.
  static int differing(const QImage& a, const QImage& b, double part) {
    int count = 0;
    for (int y = static_cast<int>((1 - part) * a.height()); y < a.height(); ++y)
      for (int x = 0; x < a.width(); ++x)
        count += a.pixel(x, y) != b.pixel(x, y);
    return count;
  }
  QByteArray contents(const QString& file) {
    QFile stream(file);
    EXPECT_TRUE(stream.open(QIODevice::ReadOnly)) << file.toStdString();
    return stream.readAll();
  }
};

TEST_F(Recordings, AnOggMovieOfOneBeatHasAllItsFramesAndATableBesideIt) {
  const QString file = path(QStringLiteral("beat.ogv"));
  describe(QStringLiteral("Ogg"), file, 10, 1);
  find<QCheckBox>("recordTable").setChecked(true);
  press();
  EXPECT_TRUE(parts().recorder().running());
  key(Qt::Key_1); // The window is free for other things.
  EXPECT_EQ(window().mode(), "explore");
  ASSERT_TRUE(recorded());
  // A beat of 0.8 s at ten frames a second, behind three headers.
  EXPECT_EQ(oggPackets(contents(file)), 3 + 8);
  const QList<QByteArray> rows = contents(path(QStringLiteral("beat.csv"))).trimmed().split('\n');
  ASSERT_EQ(rows.size(), 1 + 8);
  EXPECT_TRUE(rows[0].startsWith("time_s,Heart_ml,LV_ml,RV_ml,LA_ml,RA_ml")) << rows[0].toStdString();
  EXPECT_NEAR(rows[3].split(',')[0].toDouble(), 0.2, 1e-9);
  EXPECT_TRUE(message().contains(QStringLiteral("beat.ogv"))) << message().toStdString();
}

TEST_F(Recordings, KeepALockedVolumeAsTheWindowDoes) {
  ASSERT_TRUE(window().workspace().perform(document::setVolumeLocked(document().organs().front()->id, true)));
  settle();
  const QString file = path(QStringLiteral("locked.csv"));
  describe(QStringLiteral("Table"), file, 10, 1);
  press();
  ASSERT_TRUE(recorded());
  const QList<QByteArray> rows = contents(file).trimmed().split('\n');
  ASSERT_EQ(rows.size(), 1 + 8);
  for (int row = 1; row < rows.size(); ++row) {
    window().playback().seek((row - 1) / 8.0);
    EXPECT_NEAR(rows[row].split(',')[1].toDouble(), volumeOf("Heart"), 1e-5) << row;
    EXPECT_NEAR(rows[row].split(',')[2].toDouble(), volumeOf("LV"), 1e-5) << row;
    EXPECT_NEAR(rows[row].split(',')[1].toDouble(), rows[1].split(',')[1].toDouble(), 1e-5) << row;
  }
}

TEST_F(Recordings, OfTheStressModeShowTheMapAsTheWindowDoes) {
  setViewSize(window(), 640, 480);
  key(Qt::Key_4);
  ASSERT_EQ(window().mode(), "stress");
  ASSERT_TRUE(waitUntil([this] { return atPeace(window()); }));
  window().playback().seek(0.5);
  ASSERT_TRUE(waitUntil([this] { return atPeace(window()); }));
  app::MoviePlan plan;
  plan.format = app::MovieFormat::pictures;
  plan.file = path(QStringLiteral("map"));
  plan.size = {640, 480};
  plan.framesPerSecond = 10;
  plan.caption = false;
  window().viewModel().change([](presentation::ViewState& state) { state.heartSigns = kNoSigns; });
  ASSERT_TRUE(parts().record(plan));
  ASSERT_TRUE(recorded());
  const QStringList frames = QDir(plan.file).entryList(QDir::Files, QDir::Name);
  ASSERT_EQ(frames.size(), 8);
  const auto frame = scene::readPng((plan.file + QLatin1Char('/') + frames[4]).toStdString());
  EXPECT_LE(scene::comparePictures(grab(window()), frame, 8).differing, 0.005) << "half a beat";
}

/// A strip of 77 pixels: the scale of type is that of the movie's height.
TEST_F(Recordings, OfATextbookBeatHaveItsSignsBelowAtEachInstantUnlessTheyAreSwitchedOff) {
  constexpr double kStripPart = 0.14;
  const std::vector<QImage> with = frames("with");
  window().viewModel().change([](presentation::ViewState& state) { state.heartSigns = kNoSigns; });
  const std::vector<QImage> without = frames("without");
  ASSERT_EQ(with.size(), 4u);
  ASSERT_EQ(without.size(), 4u);
  EXPECT_EQ(with[0].size(), without[0].size());
  const int pixels = static_cast<int>(kStripPart * 640 * 480);
  EXPECT_GT(differing(with[1], without[1], kStripPart), pixels / 20) << "bars, a trace and names";
  const int moved = differing(with[1], with[2], kStripPart);
  EXPECT_GT(moved, 60) << "the line of the instant, and lamps";
  EXPECT_LT(moved, pixels / 20) << "the rest of the strip stays";
}

TEST_F(Recordings, OfACirculationHaveItsChartsBelowWithTheInstant) {
  find<QAbstractButton>("scenario.rest").click();
  ASSERT_TRUE(waitUntil([this] {
    return parts().circulation().settled() && parts().circulation().isPlayed();
  })) << message().toStdString();
  const std::vector<QImage> with = frames("charts");
  window().viewModel().change([](presentation::ViewState& state) {
    state.heartSigns = kNoSigns;
    state.heartSigns.loops = true;
  });
  const std::vector<QImage> loops = frames("loops");
  ASSERT_GE(with.size(), 3u);
  ASSERT_GE(loops.size(), 3u);
  constexpr double kCharts = 0.25; // Below the names of the colours.
  const int pixels = static_cast<int>(kCharts * 640 * 480);
  EXPECT_GT(differing(with[0], loops[0], kCharts), pixels / 50) << "another choice";
  for (const auto& [former, later] : {std::pair(&with[0], &with[2]), std::pair(&loops[0], &loops[2])}) {
    const int moved = differing(*former, *later, kCharts);
    EXPECT_GT(moved, 15) << "a ring on each loop";
    EXPECT_LT(moved, pixels / 20) << "the curves stay";
  }
}

TEST_F(Recordings, GoesOnWhileTheWindowIsBusyWithOtherThings) {
  const QString file = path(QStringLiteral("beat.ogv"));
  describe(QStringLiteral("Ogg"), file, 10, 1);
  press();
  // No event of the window is handled in here.
  const auto giveUp = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!QFile::exists(file) && std::chrono::steady_clock::now() < giveUp)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_EQ(oggPackets(contents(file)), 3 + 8);
  EXPECT_TRUE(parts().recorder().running()) << "the window has not heard of it yet";
  EXPECT_TRUE(recorded());
}

TEST_F(Recordings, WritesTextWhileTheWindowWritesItsOwn) {
  key(Qt::Key_N);
  describe(QStringLiteral("PNG"), path(QStringLiteral("frames")), 25, 1);
  press();
  key(Qt::Key_Space); // Labels and chart are drawn anew with every frame of the window.
  ASSERT_TRUE(recorded());
  EXPECT_EQ(QDir(path(QStringLiteral("frames"))).entryList(QDir::Files).size(), 20);
}

TEST_F(Recordings, CancelLeavesNothing) {
  const QString folder = path(QStringLiteral("movies"));
  QDir().mkpath(folder);
  describe(QStringLiteral("Ogg"), folder + QStringLiteral("/long.ogv"), 60, 100);
  press();
  ASSERT_TRUE(waitUntil([this] {
    const auto jobs = parts().recorder().jobs().jobs();
    return !jobs.empty() && jobs.front().fraction > 0;
  }));
  auto* cross = window().findChild<QAbstractButton*>(QStringLiteral("cancelJob"));
  ASSERT_NE(cross, nullptr);
  // The status bar hears of the progress a moment after the job has made it.
  ASSERT_TRUE(waitUntil([cross] { return cross->isVisible(); })) << "progress is in the status bar";
  QTest::mouseClick(cross, Qt::LeftButton);
  ASSERT_TRUE(recorded());
  EXPECT_TRUE(QDir(folder).isEmpty());
  EXPECT_EQ(find<QAbstractButton>("recordButton").text(), QStringLiteral("Record"));
}

TEST_F(Recordings, TwoViewsAreRecordedSideBySide) {
  key(Qt::Key_2, Qt::ControlModifier);
  ASSERT_TRUE(waitUntil([this] { return !parts().comparison().workspace().live().busy(); }));
  const QString folder = path(QStringLiteral("both"));
  describe(QStringLiteral("PNG"), folder, 5, 1);
  press();
  ASSERT_TRUE(recorded());
  EXPECT_EQ(QDir(folder).entryList(QDir::Files).size(), 4);
  const QImage picture(folder + QStringLiteral("/frame_00001.png"));
  ASSERT_EQ(picture.size(), QSize(640, 480));
  const QImage left = picture.copy(0, 60, 320, 420);
  const QImage right = picture.copy(320, 60, 320, 420);
  EXPECT_NE(left, right) << "two rates are in other phases";
  EXPECT_GT(left.pixelColor(160, 200).red(), left.pixelColor(5, 200).red() + 20) << "there is a heart";
  EXPECT_GT(right.pixelColor(160, 200).red(), right.pixelColor(5, 200).red() + 20);
}

TEST_F(Recordings, ATableNeedsNoPicturesAndWhatCannotBeDoneIsSaid) {
  const QString file = path(QStringLiteral("volumes.csv"));
  describe(QStringLiteral("Table"), file, 25, 2);
  EXPECT_FALSE(find<QComboBox>("recordSize").isEnabled());
  press();
  ASSERT_TRUE(recorded());
  const QList<QByteArray> rows = contents(file).trimmed().split('\n');
  ASSERT_EQ(rows.size(), 1 + 40);
  EXPECT_EQ(rows[1].split(',')[2].left(5), rows[21].split(',')[2].left(5))
      << "the second beat is like the first";

  describe(QStringLiteral("Ogg"), QStringLiteral("/nowhere/at/all.ogv"), 10, 1);
  press();
  ASSERT_TRUE(recorded());
  EXPECT_TRUE(waitUntil([this] { return message().contains(QStringLiteral("/nowhere/at/all.ogv")); }))
      << message().toStdString();

  const QByteArray search = qgetenv("PATH");
  qputenv("PATH", path(QStringLiteral("empty")).toLocal8Bit());
  find<app::MovieBox>("recordBox").refresh();
  auto& format = find<QComboBox>("recordFormat");
  const auto* items = qobject_cast<QStandardItemModel*>(format.model());
  const int mp4 = format.findText(QStringLiteral("MP4"), Qt::MatchContains);
  EXPECT_FALSE(items->item(mp4)->isEnabled());
  bool said = false;
  for (const QLabel* label : find<app::MovieBox>("recordBox").findChildren<QLabel*>())
    said = said || (label->isVisibleTo(&find<app::MovieBox>("recordBox")) &&
                    label->text().contains(QStringLiteral("ffmpeg")));
  EXPECT_TRUE(said);
  qputenv("PATH", search);
}

TEST_F(Recordings, AFileThatWasChosenStaysWhenTheSequencePlaysOn) {
  const QString file = path(QStringLiteral("mine.ogv"));
  describe(QStringLiteral("Ogg"), file, 10, 1);
  const double rate = window().playback().player().ratePerMinute();
  window().playback().setRate(rate + 5);
  key(Qt::Key_Space);
  settle();
  EXPECT_EQ(find<QLineEdit>("recordFile").text(), file);
}

TEST_F(Recordings, AProposedFileLeavesTheTableOfAnotherAlone) {
  const QString folder = path(QString());
  QFile table(path(QStringLiteral("beat.csv")));
  ASSERT_TRUE(table.open(QIODevice::WriteOnly));
  table.close();
  EXPECT_EQ(
      QFileInfo(app::freeMovieFile(folder, QStringLiteral("beat"), app::MovieFormat::ogg, true)).fileName(),
      QStringLiteral("beat_2.ogv"));
  EXPECT_EQ(
      QFileInfo(app::freeMovieFile(folder, QStringLiteral("beat"), app::MovieFormat::ogg, false)).fileName(),
      QStringLiteral("beat.ogv"));
}

} // namespace
} // namespace viscera::tests
