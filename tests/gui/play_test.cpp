#include "play_fixture.h"

#include <algorithm>

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QTest>
#include <QTreeWidget>

#include <nlohmann/json.hpp>
#include <vtkCamera.h>
#include <vtkRenderer.h>

#include "build_paths.h"
#include "run_process.h"
#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/session_file.h"
#include "viscera/heart/beating_heart.h"
#include "viscera/heart/cardiac_times.h"
#include "viscera/presentation/view_state.h"
#include "viscera/sample_organs/sample_organ.h"
#include "window/play/curve_box.h"
#include "window/session/session_files.h"
#include "window/timeline/phase_scrubber.h"
#include "window/timeline/volume_panel.h"

namespace viscera::tests {
namespace {

TEST_F(PlayMode, SpacePlaysAndTheVolumesFollowTheBeat) {
  key(Qt::Key_Space);
  ASSERT_TRUE(window().playback().player().playing());
  double smallest = 1e9;
  double largest = 0;
  for (int i = 0; i < 30; ++i) {
    playFor(1.0 / 30);
    smallest = std::min(smallest, volumeOf("LV"));
    largest = std::max(largest, volumeOf("LV"));
  }
  EXPECT_NEAR(largest, 130.5, 1);
  EXPECT_NEAR(smallest, 55, 2);
  key(Qt::Key_Space);
  EXPECT_FALSE(window().playback().player().playing());
  EXPECT_EQ(window().workspace().undo().names().size(), 0u) << "playing leaves no undo steps";
}

/// Of the textbook's beat at its own rate, as a part of the cycle.
double endOfSystole() {
  const heart::CardiacTimes times = heart::cardiacTimes(75);
  return heart::leftClock(times).outletShuts / times.cycle;
}

/// Rows of a table of numbers, without its heading.
std::vector<std::vector<double>> tableIn(const QString& file) {
  QFile stream(file);
  EXPECT_TRUE(stream.open(QIODevice::ReadOnly)) << file.toStdString();
  std::vector<std::vector<double>> rows;
  for (const QByteArray& line : stream.readAll().trimmed().split('\n').mid(1)) {
    rows.emplace_back();
    for (const QByteArray& cell : line.split(','))
      rows.back().push_back(cell.toDouble());
  }
  return rows;
}

/// The sample heart as fine as users see it.
class PlayedFineHeart : public PlayMode {
protected:
  bool coarseSamples() const override { return false; }
};

TEST_F(PlayedFineHeart, TheWholeCycleIsExactBeforeAFrameOfItWasPlayed) {
  const auto& monitor = window().volumes();
  ASSERT_EQ(monitor.lines().at(1).name, QStringLiteral("LV cavity"));
  ASSERT_TRUE(waitUntil([&] { return monitor.indices(1).has_value(); }));
  EXPECT_EQ(window().playback().player().playedSeconds(), 0);
  EXPECT_NEAR(monitor.indices(1)->ejectionFraction, 0.579, 5e-4);
  const QString file = path(QStringLiteral("beat.csv"));
  const auto result =
      test::runProcess({VISCERA_PROGRAM, "play", "heartbeat", "--fps", "120", "--csv", file.toStdString()});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const auto rows = tableIn(file);
  ASSERT_EQ(rows.size(), 96u);
  for (std::size_t line = 0; line < 3; ++line) {
    const app::VolumeMonitor::Curve curve = monitor.cycle(line);
    std::size_t found = 0;
    for (const auto& row : rows)
      for (std::size_t i = 0; i < curve.fractions.size(); ++i)
        if (std::abs(curve.fractions[i] * 0.8 - row[0]) < 1e-9) {
          EXPECT_NEAR(curve.milliliters[i], row[1 + line], 1e-9 * row[1 + line]) << row[0];
          ++found;
        }
    EXPECT_EQ(found, rows.size());
  }
  // Both isovolumic phases are flat in the curve.
  const app::VolumeMonitor::Curve left = monitor.cycle(1);
  for (const auto& phase : window().playback().sequence()->phases(75)) {
    if (phase.name.english().find("isovolumic") == std::string::npos)
      continue;
    double low = 1e9, high = 0;
    for (std::size_t i = 0; i < left.fractions.size(); ++i)
      if (left.fractions[i] >= phase.begin && left.fractions[i] <= phase.end) {
        low = std::min(low, left.milliliters[i]);
        high = std::max(high, left.milliliters[i]);
      }
    EXPECT_LT(high - low, 0.5) << phase.name;
  }
}

/// Qt measures all rows of a list at each of its signals, which took a third of an undo of 95 organs.
TEST_F(PlayMode, VolumesAreWrittenIntoTheListWithoutASignalForEach) {
  auto& list = find<QTreeWidget>("organList");
  window().playback().seek(0.1);
  settle();
  const auto volume = [&] { return list.topLevelItem(0)->child(0)->text(2); };
  const QString before = volume();
  int signalsOfTheList = 0;
  QObject::connect(list.model(), &QAbstractItemModel::dataChanged, &list, [&] { ++signalsOfTheList; });
  window().playback().seek(0.3);
  settle();
  EXPECT_NE(volume(), before);
  EXPECT_LT(signalsOfTheList, 5) << "fewer than organs";
}

TEST_F(PlayMode, TheTimelineLooksAtOneInstant) {
  auto* scrubber = window().findChild<app::PhaseScrubber*>();
  ASSERT_NE(scrubber, nullptr);
  const double systoleEnds = endOfSystole();
  QTest::mouseClick(scrubber, Qt::LeftButton, Qt::NoModifier,
                    QPoint(8 + qRound((scrubber->width() - 16) * systoleEnds), scrubber->height() / 2));
  settle();
  EXPECT_NEAR(window().playback().player().fraction(), systoleEnds, 0.02);
  EXPECT_LT(volumeOf("LV"), 62);
  EXPECT_FALSE(scrubber->phaseName().isEmpty());
}

TEST_F(PlayMode, OneFrameForwardAndBackIsTheSameInstant) {
  window().playback().seek(0.2);
  const double before = volumeOf("LV");
  key(Qt::Key_Period);
  EXPECT_NE(volumeOf("LV"), before);
  key(Qt::Key_Comma);
  EXPECT_NEAR(volumeOf("LV"), before, 1e-6);
}

TEST_F(PlayMode, EditingTheHandlesEndsTheMotionAndOffersItsOwnHandlesAgain) {
  key(Qt::Key_Space);
  playFor(0.1);
  key(Qt::Key_H); // What is not seen is not removed by a key.
  key(Qt::Key_A, Qt::ControlModifier);
  key(Qt::Key_Delete);
  EXPECT_FALSE(window().playback().player().playing());
  key(Qt::Key_Space);
  EXPECT_FALSE(window().playback().player().playing());
  auto* offer = window().findChild<QAbstractButton*>(QStringLiteral("offer"));
  ASSERT_NE(offer, nullptr) << message().toStdString();
  offer->click();
  settle();
  EXPECT_TRUE(window().playback().player().playing());
}

TEST_F(PlayMode, OpeningAFileTakesThePlaceOfTheSampleAndUndoBringsItBackWithItsMotion) {
  key(Qt::Key_Space);
  const auto farAway = [this] { return view().view().renderer()->GetActiveCamera()->GetDistance(); };
  const double before = farAway();
  open(sphereFile(QStringLiteral("large.stl"), 160));
  EXPECT_EQ(document().organs().size(), 1u);
  EXPECT_EQ(window().playback().sequence(), nullptr);
  EXPECT_FALSE(window().playback().player().playing());
  EXPECT_GT(farAway(), 1.5 * before);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(waitUntil([&] { return farAway() < 1.2 * before; })) << "the heart is small";
  EXPECT_EQ(document().organs().size(), 5u);
  EXPECT_NE(window().playback().sequence(), nullptr);
}

TEST_F(PlayMode, UndoOfOpeningAFileIsHeardByEveryPanelThoughTheSelectionGoesWithIt) {
  key(Qt::Key_2);
  ASSERT_EQ(window().mode(), "handles");
  document::Selection& selection = window().workspace().selection();
  const document::OrganId heart = selection.organ();
  ASSERT_TRUE(heart);
  open(sphereFile());
  ASSERT_TRUE(selection.organ());
  ASSERT_NE(selection.organ(), heart);
  selection.setHandles({document().rig().handles.front().id});
  settle();
  window().workspace().undo().undo();
  EXPECT_EQ(document().organs().size(), 5u);
  EXPECT_EQ(selection.organ(), heart) << "which was selected before";
  EXPECT_TRUE(selection.handles().empty());
  selection.setHandles({document().rig().handles.front().id});
  settle();
  window().workspace().undo().redo();
  EXPECT_EQ(document().organs().size(), 1u);
}

TEST_F(PlayMode, SlowMotionLetsTimePassMoreSlowlyAndEndsInRealTimeAgain) {
  key(Qt::Key_S);
  EXPECT_EQ(window().playback().player().speed(), 0.5);
  key(Qt::Key_Space);
  const double before = window().playback().player().fraction();
  playFor(0.2);
  EXPECT_NEAR(window().playback().player().fraction() - before, 0.5 * 0.2 / 0.8, 0.03);
  auto* speed = window().findChild<QComboBox*>(QStringLiteral("speed"));
  ASSERT_NE(speed, nullptr);
  EXPECT_EQ(speed->currentData().toDouble(), 0.5) << "the timeline says so";
  for (int i = 0; i < 3; ++i)
    key(Qt::Key_S);
  EXPECT_EQ(window().playback().player().speed(), 1);
}

TEST_F(PlayMode, OneKeyLooksThroughTheWallAndUndoClosesItAgain) {
  const auto wall = [this] { return document().organs().front()->look.opacity; };
  const double sample = wall();
  ASSERT_LT(sample, 1) << "the sample heart comes with a translucent wall";
  key(Qt::Key_X);
  EXPECT_EQ(wall(), 1);
  key(Qt::Key_X);
  EXPECT_LT(wall(), 0.5);
  for (const auto& organ : document().organs())
    EXPECT_TRUE(!organ->parent || organ->look.opacity == 1) << "cavities are seen plainly";
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(wall(), 1);
  EXPECT_FALSE(window().actions()["view.seeThrough"]->isChecked());
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(wall(), sample);
}

/// The sample's, the usual one and one that the user has chosen.
TEST_F(PlayMode, AWallThatWasMadeOpaqueGetsTheOpacityBackThatItHad) {
  const document::OrganId wall = document().organs().front()->id;
  const auto opacity = [&] { return document().organ(wall)->look.opacity; };
  const double sample = opacity();
  key(Qt::Key_X);
  key(Qt::Key_X);
  EXPECT_EQ(opacity(), sample);
  for (const double chosen : {0.17, 0.62}) {
    document::OrganLook look = document().organ(wall)->look;
    look.opacity = chosen;
    ASSERT_TRUE(window().workspace().perform(document::setOrganLook(wall, look)));
    key(Qt::Key_X);
    EXPECT_EQ(opacity(), 1);
    key(Qt::Key_X);
    EXPECT_EQ(opacity(), chosen);
  }
}

TEST_F(PlayMode, LabelsNameTheOrgansBesideThem) {
  const auto labels = [this] { return window().picture().presenter().labels().drawn(); };
  EXPECT_TRUE(labels().empty());
  key(Qt::Key_N);
  ASSERT_EQ(labels().size(), 5u);
  EXPECT_EQ(labels()[1].text, "LV cavity");
  for (const auto& organ : document().organs()) {
    if (!organ->parent)
      continue;
    // Each line ends where its cavity is seen.
    const Bounds box = boundsOf(window().workspace().live().points(organ->id));
    const QPoint middle = onScreen(box.center());
    const double radius = 0.5 * (onScreen(box.high) - onScreen(box.low)).manhattanLength();
    const auto drawn = labels();
    const auto found = std::find_if(drawn.begin(), drawn.end(),
                                    [&](const auto& one) { return one.text == organ->name + " cavity"; });
    ASSERT_NE(found, drawn.end()) << organ->name;
    const auto label = *found;
    const QPoint end(qRound(label.targetX / view().devicePixelRatioF()),
                     view().height() - qRound(label.targetY / view().devicePixelRatioF()));
    EXPECT_LT((end - middle).manhattanLength(), radius) << organ->name;
  }
  key(Qt::Key_N);
  EXPECT_TRUE(labels().empty());
}

TEST_F(PlayMode, PhasesNormalRangesAndIndicesOfTheBeatAreShown) {
  auto* scrubber = window().findChild<app::PhaseScrubber*>();
  ASSERT_NE(scrubber, nullptr);
  const QStringList names = scrubber->namesShown();
  EXPECT_TRUE(names.contains(QStringLiteral("rapid ejection")));
  EXPECT_TRUE(names.contains(QStringLiteral("diastasis")));
  scrubber->resize(2000, scrubber->height());
  EXPECT_EQ(scrubber->namesShown().size(), 8) << "diastasis at both ends of the beat";
  const QStringList groups = scrubber->groupsShown();
  ASSERT_EQ(groups.size(), 2);
  EXPECT_TRUE(groups[0].startsWith(QStringLiteral("systole 32"))) << groups[0].toStdString();
  EXPECT_TRUE(groups[1].startsWith(QStringLiteral("diastole 47"))) << groups[1].toStdString();
  scrubber->resize(90, scrubber->height());
  EXPECT_LT(scrubber->namesShown().size(), 8) << "what has no room is left out";

  auto* chart = window().findChild<app::VolumePanel*>();
  ASSERT_NE(chart, nullptr);
  EXPECT_TRUE(chart->normalsText().contains(QStringLiteral("82\u2013166 ml")))
      << "of one sex: " << chart->normalsText().toStdString();
  EXPECT_TRUE(chart->normalsText().contains(QStringLiteral("doi")));
  auto* whose = chart->findChild<QComboBox*>(QStringLiteral("rangesOf"));
  auto* surface = chart->findChild<QDoubleSpinBox*>(QStringLiteral("rangesForBodySurface"));
  ASSERT_TRUE(whose && surface);
  whose->setCurrentIndex(2);
  EXPECT_TRUE(chart->normalsText().contains(QStringLiteral("102\u2013230 ml")))
      << "men: " << chart->normalsText().toStdString();
  whose->setCurrentIndex(0);
  EXPECT_TRUE(chart->normalsText().contains(QStringLiteral("82\u2013230 ml")))
      << "both: " << chart->normalsText().toStdString();
  whose->setCurrentIndex(1);
  surface->setValue(1.5);
  EXPECT_TRUE(chart->normalsText().contains(QStringLiteral("75\u2013147 ml")))
      << "women of 1.5 m2: " << chart->normalsText().toStdString();
  EXPECT_TRUE(chart->normalsText().contains(QStringLiteral("women, mean +- 2")));
  EXPECT_EQ(window().viewModel().state().person, (anatomy::Person{anatomy::Sex::women, 1.5}));
  whose->setCurrentIndex(0);
  surface->setValue(surface->minimum());
  const auto tiles = window().findChildren<QAbstractButton*>(QStringLiteral("tileName"));
  ASSERT_EQ(tiles.size(), 5);
  QTest::mouseClick(tiles[2], Qt::LeftButton);
  EXPECT_TRUE(chart->normalsText().contains(QStringLiteral("RV"))) << chart->normalsText().toStdString();

  key(Qt::Key_Space);
  playFor(1.0);
  ASSERT_TRUE(waitUntil([this] {
    const auto* label = window().findChild<QLabel*>(QStringLiteral("cardiacOutput"));
    return label && label->text().contains(QStringLiteral("l/min"));
  }));
  const double output = window()
                            .findChild<QLabel*>(QStringLiteral("cardiacOutput"))
                            ->text()
                            .section(QLatin1Char(' '), 0, 0)
                            .toDouble();
  EXPECT_NEAR(output, (130.5 - 55) * 75 / 1000, 0.15);
}

TEST_F(PlayMode, WavesTravelDownTheStomachAndUndoBringsBackTheHeartWithItsMotion) {
  const auto first = window().playback().sequence();
  loadSample(QStringLiteral("stomach"));
  auto* scrubber = window().findChild<app::PhaseScrubber*>();
  ASSERT_NE(scrubber, nullptr);
  EXPECT_EQ(scrubber->namesShown(), (QStringList{QStringLiteral("fundus"), QStringLiteral("body"),
                                                 QStringLiteral("antrum"), QStringLiteral("pylorus")}));
  window().playback().seek(0.2);
  ASSERT_GE(scrubber->marks().size(), 3u);
  ASSERT_LE(scrubber->marks().size(), 4u);
  const auto places = [scrubber] {
    std::vector<double> all;
    for (const auto& mark : scrubber->marks())
      all.push_back(mark.place);
    return all;
  };
  const std::vector<double> before = places();
  const double youngest = *std::min_element(before.begin(), before.end());
  window().playback().seek(0.3);
  const std::vector<double> after = places();
  EXPECT_TRUE(std::any_of(after.begin(), after.end(), [youngest](double place) {
    return place > youngest && place < youngest + 0.1;
  })) << "the youngest wave has gone on";
  auto* chart = window().findChild<app::VolumePanel*>();
  EXPECT_TRUE(chart->normalsText().contains(QStringLiteral("after a meal")));

  EXPECT_NE(window().playback().sequence(), first);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(window().playback().sequence(), first);
  key(Qt::Key_Space);
  EXPECT_TRUE(window().playback().player().playing());
}

TEST_F(PlayMode, TheConductionSystemIsSwitchedInTheViewMenuAndLitByTheBeat) {
  auto& action = find<QAction>("view.conduction");
  const auto& glyphs = window().picture().presenter().conduction();
  settle();
  EXPECT_FALSE(action.isChecked());
  EXPECT_TRUE(glyphs.lines().empty());
  action.trigger();
  const auto brightest = [&](double fraction) {
    window().playback().seek(fraction);
    settle();
    double most = 0;
    for (const auto& line : glyphs.lines())
      most = std::max(most, line.lit.maxCoeff());
    return most;
  };
  EXPECT_TRUE(window().viewModel().state().conduction);
  const auto beat = window().playback().sequence()->heart()->textbookBeat(75);
  EXPECT_GT(brightest(beat->left().inletShuts / beat->times().cycle), 0.3) << "the ventricles contract";
  EXPECT_GT(glyphs.lines().size(), 20u);
  EXPECT_LT(brightest(0.75), 0.05) << "all is at rest in diastole";
  action.trigger();
  settle();
  EXPECT_TRUE(glyphs.lines().empty());
}

TEST_F(PlayMode, ValvesAreOfferedOnlyWhereTheyAreDrawnAndTheWishForThemStays) {
  const auto& valves = find<QAction>("play.valves");
  const auto expectOffered = [&](bool offered, const char* where) {
    settle();
    EXPECT_EQ(valves.isEnabled(), offered) << where;
    EXPECT_EQ(valves.isChecked(), offered) << where;
    EXPECT_TRUE(window().viewModel().state().valves) << where;
  };
  expectOffered(true, "the heart with its beat");
  const QString tip = valves.toolTip();
  loadSample(QStringLiteral("stomach"));
  expectOffered(false, "a stomach");
  EXPECT_TRUE(valves.toolTip().contains(QStringLiteral("sample heart"))) << valves.toolTip().toStdString();
  window().workspace().undo().undo();
  expectOffered(true, "the heart is back");
  for (const double seconds : {0.0, 0.8}) {
    Points pose = document().pose();
    pose.row(0) += Vec3(4, 0, 0).transpose();
    ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
    ASSERT_TRUE(window().workspace().perform(document::recordKey(seconds)));
  }
  window().playback().choose(parts().keySequence().sequence());
  expectOffered(false, "keys by hand");
  EXPECT_TRUE(valves.toolTip().contains(QStringLiteral("choose the heartbeat")))
      << valves.toolTip().toStdString();
  for (const auto& motion : window().playback().motions())
    if (motion.sequence->id() == "heartbeat") {
      window().playback().choose(motion.sequence.get());
      break;
    }
  expectOffered(true, "its beat again");
  EXPECT_EQ(valves.toolTip(), tip);
  key(Qt::Key_V);
  EXPECT_FALSE(window().viewModel().state().valves);
}

TEST_F(PlayMode, UndoAndRedoOfAChangeOfSequenceStopWhatPlaysOrIsPausedInEveryMode) {
  const auto* heart = window().playback().sequence();
  loadSample(QStringLiteral("stomach"));
  const auto* stomach = window().playback().sequence();
  const auto expectStopped = [this](const sequences::Sequence* sequence) {
    settle();
    EXPECT_EQ(window().playback().sequence(), sequence);
    EXPECT_FALSE(window().playback().player().playing());
    EXPECT_FALSE(window().playback().showing());
    EXPECT_EQ(window().playback().player().fraction(), 0);
    EXPECT_EQ(find<QLabel>("phase").text(), QStringLiteral("at rest"));
    const Points wanted = window().mode() == "handles" ? document().rig().restPositions() : document().pose();
    EXPECT_EQ(window().workspace().live().shownPose(), wanted);
    EXPECT_FALSE(message().contains(QStringLiteral("range"))) << message().toStdString();
  };
  bool playing = false;
  for (const Qt::Key mode : {Qt::Key_5, Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_4, Qt::Key_5}) {
    key(Qt::Key_5);
    window().playback().seek(0.3);
    playing = !playing;
    if (playing) {
      key(Qt::Key_Space);
      playFor(0.1);
    }
    key(mode);
    window().workspace().undo().undo();
    expectStopped(heart);
    window().playback().seek(0.4);
    window().workspace().undo().redo();
    expectStopped(stomach);
  }
}

TEST_F(PlayMode, AnUndoThatLeavesTheHandlesLeavesTheInstantAndItsPose) {
  const document::OrganId organ = document().organs().front()->id;
  ASSERT_TRUE(window().workspace().perform(document::setVolumeLocked(organ, true)));
  window().playback().seek(0.5);
  const double locked = volumeOf("Heart");
  window().workspace().undo().undo();
  settle();
  EXPECT_TRUE(window().playback().showing());
  EXPECT_EQ(window().playback().player().fraction(), 0.5);
  EXPECT_LT(volumeOf("Heart"), locked - 20) << "the pose is the one without the lock";
}

TEST_F(PlayMode, AVolumeCurveIsFollowedUntilItIsTakenBack) {
  QFile file(path(QStringLiteral("lv.csv")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  const double systoleEnds = endOfSystole();
  file.write(QStringLiteral("fraction,ml\n0,130\n%1,75\n").arg(systoleEnds).toUtf8());
  file.close();
  auto* box = window().findChild<app::CurveBox*>();
  auto* organ = window().findChild<QComboBox*>(QStringLiteral("curveOrgan"));
  auto* remove = window().findChild<QAbstractButton*>(QStringLiteral("removeCurve"));
  ASSERT_TRUE(box && organ && remove);
  organ->setCurrentIndex(organ->findText(QStringLiteral("LV cavity")));
  window().playback().seek(systoleEnds);
  const double own = volumeOf("LV");
  EXPECT_LT(own, 62);
  box->load(file.fileName());
  settle();
  EXPECT_NEAR(volumeOf("LV"), 75, 1e-6) << message().toStdString();
  EXPECT_LT(volumeOf("RV"), 80) << "its neighbour beats on";
  remove->click();
  settle();
  EXPECT_EQ(volumeOf("LV"), own);
  box->load(path(QStringLiteral("none.csv")));
  EXPECT_TRUE(message().contains(QStringLiteral("none.csv"))) << message().toStdString();
}

TEST_F(PlayMode, ASessionKeepsThePrescribedVolume) {
  const QString curve = prescribeLeftVentricle();
  bool done = false;
  window().sessions().saveTo(path(QStringLiteral("lv.viscera")), false, [&] { done = true; });
  ASSERT_TRUE(waitUntil([&] { return done; }));
  QFile::remove(curve);
  reopenWindow();
  open(path(QStringLiteral("lv.viscera")));
  ASSERT_TRUE(waitUntil([&] { return window().playback().player().runner().prescribed().has_value(); }))
      << message().toStdString();
  settle();
  EXPECT_NEAR(volumeOf("LV"), 75, 1e-6) << "at the instant that was shown";
  window().playback().seek(0);
  EXPECT_NEAR(volumeOf("LV"), 130, 1e-6);
  const auto labels = window().findChild<app::CurveBox*>()->findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
    return label->text().contains(QStringLiteral("lv.csv"));
  }));
}

/// Its beat began with the contraction of the atria.
TEST_F(PlayMode, ASessionOfBeforeOpensAtTheInstantItWasPausedAt) {
  window().playback().pause();
  window().playback().seek(0.4);
  const double volume = volumeOf("LV");
  const double rate = window().playback().player().ratePerMinute();
  document::SessionContents contents = window().sessions().contents();
  nlohmann::ordered_json& view = contents.view;
  view["format"] = 2;
  view["playing"]["fraction"] = 0.4 - heart::kBeforeAtria * rate / 60;
  const QString name = path(QStringLiteral("before.viscera"));
  Progress quiet;
  document::writeSession(name.toStdString(), contents, quiet);
  reopenWindow();
  open(name);
  EXPECT_TRUE(waitUntil([&] { return std::abs(window().playback().player().fraction() - 0.4) < 1e-9; }))
      << message().toStdString();
  EXPECT_TRUE(waitUntil([&] { return std::abs(volumeOf("LV") - volume) < 1e-3; })) << volumeOf("LV");
  EXPECT_FALSE(message().contains(QStringLiteral("differently"))) << message().toStdString();
}

TEST_F(PlayMode, APrescribedVolumeOfASessionThatIsNoneIsTold) {
  document::SessionContents contents = window().sessions().contents();
  presentation::ViewState view = presentation::viewFromJson(contents.view);
  ASSERT_TRUE(view.playing);
  view.playing->prescribed =
      presentation::Prescribed{document().organs().front()->id, "odd.csv", {{0.5, -1}}};
  contents.view = presentation::toJson(view);
  const QString name = path(QStringLiteral("odd.viscera"));
  Progress quiet;
  document::writeSession(name.toStdString(), contents, quiet);
  reopenWindow();
  open(name);
  ASSERT_TRUE(waitUntil([&] { return message().contains(QStringLiteral("not positive")); }))
      << message().toStdString();
  EXPECT_FALSE(window().playback().player().runner().prescribed());
  EXPECT_NE(window().playback().sequence(), nullptr) << "it plays without";
}

TEST_F(PlayMode, ALockedVolumeStaysWhileTheSequencePlays) {
  window().playback().seek(0.5);
  const double lost = volumeOf("Heart") - document().organs().front()->restVolumeMm3 / kMm3PerMl;
  EXPECT_LT(lost, -20) << "the heart is smallest at the end of systole";
  window().playback().stop();
  ASSERT_TRUE(window().workspace().perform(document::setVolumeLocked(document().organs().front()->id, true)));
  settle();
  const double before = volumeOf("Heart");
  const double ventricle = volumeOf("LV");
  for (const double fraction : {0.1, 0.3, 0.5, 0.8}) {
    window().playback().seek(fraction);
    EXPECT_NEAR(volumeOf("Heart") / before, 1, 1e-9) << fraction << ' ' << message().toStdString();
  }
  window().playback().seek(0.5);
  EXPECT_LT(volumeOf("LV"), 0.7 * ventricle) << "its cavity is not locked";
}

/// Undo, or a number that is typed, changes the pose while the organs show the sequence's.
TEST_F(PlayMode, APoseThatIsChangedBehindTheSequenceIsNoDragOfItsVolumes) {
  playFor(0.3);
  const std::size_t rows = window().volumes().drags().rows();
  Points pose = document().pose();
  pose.row(0) *= 1.15;
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  settle();
  EXPECT_EQ(window().volumes().drags().rows(), rows);
  key(Qt::Key_3);
  settle();
  pose.row(0) *= 1.01;
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  settle();
  const sequences::VolumeRecord& drags = window().volumes().drags();
  ASSERT_EQ(drags.rows(), rows + 2);
  EXPECT_NEAR(drags.milliliters(drags.rows() - 1, 0), volumeOf(document().organs().front()->name.c_str()),
              1e-9);
}

} // namespace
} // namespace viscera::tests
