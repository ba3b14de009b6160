// What the parts of the window show belongs to one state, whatever came before it.
#include "play_fixture.h"

#include <QAction>
#include <QApplication>
#include <QSpinBox>

#include <ostream>
#include <random>

#include "shapes.h"
#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/system_commands.h"
#include "viscera/medical_io/surface_file.h"
#include "window/compare/side_header.h"
#include "window/import/import_controller.h"
#include "window/session/session_files.h"
#include "window_probe.h"

namespace viscera::tests {
namespace {

constexpr std::size_t kHeartHandles = 222, kLiverHandles = 38;

class OneState : public PlayMode {
protected:
  /// Small views: what is asserted is not how they look.
  static constexpr int kWidth = 240, kHeight = 160;

  void SetUp() override {
    PlayMode::SetUp();
    setViewSize(window(), kWidth, kHeight);
  }
  void waitForPeace() {
    int quiet = 0;
    EXPECT_TRUE(waitUntil([&] { return (quiet = atPeace(window()) ? quiet + 1 : 0) > 8; }));
  }
  /// The sample liver comes in place of the heart, as from the gallery in Play.
  void chooseBreathing() {
    parts().chooseSequence(QStringLiteral("breathing"));
    ASSERT_TRUE(QTest::qWaitFor(
        [this] {
          return window().playback().sequence() && window().playback().sequence()->id() == "breathing";
        },
        120000))
        << message().toStdString();
    waitForPeace();
  }
  void expectAllIsOne(const char* when) {
    waitForPeace();
    EXPECT_EQ(message().toStdString(), "") << when;
    EXPECT_EQ(disagreement(window()), "") << when;
    EXPECT_EQ(offTheTimeline(window().workspace(), window().playback()), "") << when;
  }
  void undo() { window().actions()["edit.undo"]->trigger(); }
  void redo() { window().actions()["edit.redo"]->trigger(); }
  /// Whether the middle of the organ is in the picture.
  bool organInPicture() {
    const Points& points = window().workspace().live().points(document().organs().front()->id);
    return view().rect().contains(onScreen(boundsOf(points).center()));
  }
  app::Workspace& second() { return parts().comparison().workspace(); }
  /// Plays for a while and pauses between two frames, as a user does.
  void playAndPause(double seconds) {
    key(Qt::Key_Space);
    playFor(seconds);
    now_ += 0.013;
    key(Qt::Key_Space);
  }
  app::Playback& secondPlayback() { return parts().comparison().playback(); }
  void waitForSecond() {
    parts().comparison().view().setFixedSize(kWidth, kHeight);
    ASSERT_TRUE(waitUntil([this] { return !second().live().busy() && second().jobs().idle(); }));
    settle();
  }
};

// The window's monkey took a locked volume's pose for a wrong one (seed 7003).
TEST_F(OneState, AnInstantIsShownWithTheVolumesThatAreLocked) {
  const document::OrganId heart = document().organs().front()->id;
  ASSERT_TRUE(window().workspace().perform(document::setVolumeLocked(heart, true)));
  for (const double instant : {0.0, 0.4}) {
    window().playback().seek(instant);
    expectAllIsOne("under the lock");
    Points free;
    const auto& player = window().playback().player();
    player.sequence()->poseAt(player.secondsInCycle(), player.ratePerMinute(), free);
    EXPECT_GT((window().workspace().live().shownPose() - free).cwiseAbs().maxCoeff(), 0.1) << instant;
  }
}

// Reset pose changes the volume that the lock keeps (the window's monkey, seed 30).
TEST_F(OneState, AnInstantUnderALockStaysOneWhenTheOwnPoseChanges) {
  const document::OrganId heart = document().organs().front()->id;
  window().playback().seek(0.4);
  window().setMode("deform");
  waitForPeace();
  ASSERT_TRUE(window().workspace().perform(document::setVolumeLocked(heart, true)));
  Points pose = document().rig().restPositions();
  pose.row(7) += Eigen::RowVector3d(9, -4, 3);
  for (const char* views : {"in one view", "in two views"}) {
    SCOPED_TRACE(views);
    window().setMode("deform");
    ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
    waitForPeace();
    window().setMode("explore");
    expectAllIsOne("in Explore");
    ASSERT_TRUE(window().workspace().perform(document::resetPose()));
    expectAllIsOne("after the pose is reset");
    window().play().comparison().showOtherCoordinates();
  }
}

// While an organ is being bound its volume cannot be kept (the window's monkey, seed 1524).
TEST_F(OneState, AnInstantUnderALockIsShownAgainOnceItsOrganIsBound) {
  const document::OrganId heart = document().organs().front()->id;
  ASSERT_TRUE(window().workspace().perform(document::setVolumeLocked(heart, true)));
  window().playback().seek(0.4);
  waitForPeace();
  ASSERT_TRUE(window().workspace().perform(document::setSystem({"t-celestial", {}})));
  expectAllIsOne("with other coordinates");

  undo();
  window().playback().seek(0.6); // As a rule while the organ is being bound, which takes longer than a frame.
  expectAllIsOne("after a step to another instant");
}

/// How the window is when the change of sequence is undone.
struct Moment {
  const char* name;
  const char* mode;
  bool playing;
};
void PrintTo(const Moment& moment, std::ostream* stream) {
  *stream << moment.name;
}

class UndoOfAChangeOfSequence : public OneState, public testing::WithParamInterface<Moment> {};

TEST_P(UndoOfAChangeOfSequence, ShowsTheHeartAgainAndRedoTheLiverWithoutAWord) {
  chooseBreathing();
  if (HasFatalFailure())
    return;
  if (!GetParam().playing)
    window().playback().pause();
  window().setMode(GetParam().mode);
  waitForPeace();
  for (int round = 0; round < 2; ++round) {
    undo();
    expectAllIsOne("after undo");
    ASSERT_EQ(document().rig().handles.size(), kHeartHandles);
    EXPECT_EQ(shownHandleCount(window()), int(kHeartHandles));
    EXPECT_EQ(document().organs().size(), 5u);
    ASSERT_NE(window().playback().sequence(), nullptr);
    EXPECT_EQ(window().playback().sequence()->id(), "heartbeat");
    EXPECT_FALSE(window().playback().player().playing()) << "another motion begins when it is asked to";
    EXPECT_TRUE(organInPicture());
    redo();
    expectAllIsOne("after redo");
    EXPECT_EQ(document().rig().handles.size(), kLiverHandles);
    EXPECT_EQ(shownHandleCount(window()), int(kLiverHandles));
    EXPECT_EQ(document().organs().size(), 1u);
    EXPECT_TRUE(organInPicture());
  }
  undo();
  window().setMode("play");
  key(Qt::Key_Space);
  playFor(0.2);
  EXPECT_TRUE(window().playback().showing());
  expectAllIsOne("playing the heart again");
}

constexpr Moment kMoments[] = {
    {"PlayingInPlay", "play", true}, {"PausedInPlay", "play", false}, {"InExplore", "explore", true},
    {"InHandles", "handles", false}, {"InDeform", "deform", false},   {"InStress", "stress", false},
};
INSTANTIATE_TEST_SUITE_P(From, UndoOfAChangeOfSequence, testing::ValuesIn(kMoments),
                         [](const auto& of) { return std::string(of.param.name); });

TEST_F(OneState, StaysOneOnAWalkAmongTheThreeSampleSequences) {
  std::mt19937 random(7);
  const auto number = [&random](int end) { return std::uniform_int_distribution<int>(0, end - 1)(random); };
  chooseBreathing();
  parts().chooseSequence(QStringLiteral("peristalsis"));
  ASSERT_TRUE(QTest::qWaitFor(
      [this] {
        return window().playback().sequence() && window().playback().sequence()->id() == "peristalsis";
      },
      120000));
  waitForPeace();
  document::UndoStack& stack = window().workspace().undo();
  ASSERT_EQ(stack.names().size(), 2u) << "the heart was there at the start";
  std::string walked;
  for (int step = 0; step < 60; ++step) {
    const int kind = number(6);
    if (kind < 3) {
      const auto to = static_cast<std::size_t>(number(3));
      walked += " step " + std::to_string(to);
      window().workspace().guarded([&] { stack.goTo(to); });
    } else if (kind == 3) {
      walked += " seek";
      window().playback().seek(0.1 * number(10));
    } else if (kind == 4) {
      walked += " play or pause";
      window().playback().toggle();
      now_ += 0.05;
      window().playback().advance();
    } else {
      const char* const modes[] = {"explore", "handles", "deform", "play"};
      const int to = number(4);
      walked += " mode " + std::to_string(to);
      window().setMode(modes[to]);
    }
    ASSERT_EQ(disagreement(window()), "") << walked;
    ASSERT_EQ(message().toStdString(), "") << walked;
    if (step % 10 == 9)
      waitForPeace();
  }
}

/// A ball in Stress mode with its map.
class AfterStress : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    setViewSize(window(), 600, 400);
  }
  void stress(const QString& file) {
    open(file);
    app::StressLook look = window().stress().model().look();
    look.witnesses = live::WitnessOptions::kFewest;
    window().stress().model().setLook(look);
    key(Qt::Key_4);
    ASSERT_TRUE(waitUntil([this] { return window().stress().model().shown().ready() && atPeace(window()); }));
    settle();
  }
  vtkSmartPointer<vtkImageData> fromFront() {
    settle();
    viewOf(window()).lookFrom(scene::StandardView::anterior);
    return grab(window());
  }
  void expectSame(vtkImageData* a, vtkImageData* b) {
    EXPECT_LE(scene::comparePictures(a, b, kSameColor).differing, kMostDiffering);
  }
};

TEST_F(AfterStress, ANewSessionHasNothingOfTheMapInItsView) {
  const auto empty = grab(window());
  stress(sphereFile());
  window().sessions().begin();
  settle();
  EXPECT_EQ(actorCount(window()), 0);
  EXPECT_FALSE(viewOf(window()).legend().visible());
  EXPECT_FALSE(window().stress().cut().planeWidget()->GetEnabled());
  expectSame(grab(window()), empty);
}

TEST_F(AfterStress, TheNextOrganOfANewSessionStandsAlone) {
  const QString small = sphereFile(QStringLiteral("small.stl"), 30);
  open(small);
  key(Qt::Key_1);
  const auto alone = fromFront();
  window().sessions().begin();
  stress(sphereFile());
  window().sessions().begin();
  settle();
  open(small);
  key(Qt::Key_1);
  expectSame(fromFront(), alone);
}

/// The map is of one organ, and the others are not seen.
TEST_F(AfterStress, AnImportThatIsUndoneAndRedoneLeavesTheOrganOfTheMapInThePicture) {
  stress(sphereFile());
  const QString file = path(QStringLiteral("far.stl"));
  medical_io::writeSurface(file.toStdString(), sphere(3, 20, Vec3(300, 0, 0)));
  window().files().open({file});
  ASSERT_TRUE(waitUntil([this] { return document().organs().size() == 2 || window().imports().isOpen(); }));
  window().imports().accept(); // Nothing happens where nothing is asked.
  settle();
  ASSERT_EQ(document().organs().size(), 2u) << message().toStdString();
  const auto inPicture = [this] {
    const auto organ = window().workspace().currentOrgan();
    const Points& points = window().workspace().live().points(organ->id);
    return view().rect().contains(onScreen(boundsOf(points).center()));
  };
  EXPECT_EQ(window().workspace().currentOrgan()->id, document().organs().back()->id);
  EXPECT_TRUE(inPicture()) << "what was opened";
  window().actions()["edit.undo"]->trigger();
  settle();
  EXPECT_EQ(document().organs().size(), 1u);
  EXPECT_TRUE(inPicture()) << "the one that is left";
  window().actions()["edit.redo"]->trigger();
  settle();
  EXPECT_EQ(document().organs().size(), 2u);
  EXPECT_TRUE(inPicture()) << "the one that is chosen after redo";
}

/// How far the map has come when the mode is left.
struct Stage {
  const char* name;
  bool (*reached)(app::MainWindow&);
};
void PrintTo(const Stage& stage, std::ostream* stream) {
  *stream << stage.name;
}

class LeavingStress : public OneState, public testing::WithParamInterface<Stage> {
protected:
  /// Work that is interrupted has to last.
  bool coarseSamples() const override { return false; }
};

TEST_P(LeavingStress, ForPlayLeavesNoColoursOfTheMapThatWasUnderWay) {
  app::StressLook look = window().stress().model().look();
  look.witnesses = 1500;
  window().stress().model().setLook(look);
  window().playback().seek(0.3);
  window().playback().pause();
  waitForPeace();
  const auto before = grab(window());
  window().setMode("stress");
  while (!GetParam().reached(window()))
    QApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
  window().setMode("play");
  waitForPeace();
  for (const auto& organ : document().organs())
    EXPECT_FALSE(shownOrgan(window(), *organ).colouredByNumbers) << organ->name;
  EXPECT_FALSE(viewOf(window()).legend().visible());
  EXPECT_LE(scene::comparePictures(grab(window()), before, kSameColor).differing, kMostDiffering)
      << "Play looks as it did before";
  expectAllIsOne("in Play again");
}

using StressState = live::StressStatus::State;
constexpr Stage kStages[] = {
    {"AtOnce", [](app::MainWindow&) { return true; }},
    {"WhileThePointsAreMade",
     [](app::MainWindow& window) {
       return window.workspace().stress().status().state == StressState::sampling;
     }},
    {"WhileTheyAreBound",
     [](app::MainWindow& window) { return window.workspace().stress().mesh() != nullptr; }},
    {"WhileTheSurfaceIsColoured",
     [](app::MainWindow& window) {
       return window.workspace().stress().status().state == StressState::ready;
     }},
    {"WhenAllIsThere",
     [](app::MainWindow& window) { return window.stress().model().shown().ready() && atPeace(window); }},
};
INSTANTIATE_TEST_SUITE_P(Stages, LeavingStress, testing::ValuesIn(kStages),
                         [](const auto& of) { return std::string(of.param.name); });

TEST_F(OneState, APausedComparisonShowsTheInstantThatItsHeadersName) {
  key(Qt::Key_2, Qt::ControlModifier);
  ASSERT_TRUE(parts().comparison().on());
  waitForSecond();
  for (const double seconds : {0.07, 0.31, 0.5}) {
    playAndPause(seconds);
    EXPECT_EQ(offTheTimeline(window().workspace(), window().playback()), "") << seconds;
    EXPECT_EQ(offTheTimeline(second(), secondPlayback()), "") << seconds;
    EXPECT_NEAR(
        secondPlayback().player().secondsInCycle(),
        std::fmod(window().playback().player().secondsInCycle(), secondPlayback().player().periodSeconds()),
        1e-9);
    const auto headers = window().findChildren<app::SideHeader*>();
    ASSERT_EQ(headers.size(), 2);
    const auto expectRead = [&](const app::SideHeader& header, app::Workspace& workspace) {
      EXPECT_TRUE(header.volumes().contains(app::formatMilliliters(volumeIn(workspace, "LV"))))
          << header.volumes().toStdString() << " for " << volumeIn(workspace, "LV");
    };
    expectRead(*headers[0], window().workspace());
    expectRead(*headers[1], second());
  }
}

TEST_F(OneState, APausedComparisonComesBackAtItsInstant) {
  key(Qt::Key_2, Qt::ControlModifier);
  waitForSecond();
  find<QSpinBox>("secondRate").setValue(110);
  playAndPause(0.3);
  const double volume = volumeOf("LV"), beside = volumeIn(second(), "LV");
  const double fraction = window().playback().player().fraction();
  bool done = false;
  window().sessions().saveTo(path(QStringLiteral("two.viscera")), false, [&] { done = true; });
  ASSERT_TRUE(waitUntil([&] { return done; }));
  reopenWindow();
  open(path(QStringLiteral("two.viscera")));
  ASSERT_TRUE(waitUntil([this] { return window().playback().showing(); }));
  waitForPeace();
  EXPECT_NEAR(volumeOf("LV"), volume, 1e-6);
  EXPECT_NEAR(window().playback().player().fraction(), fraction, 1e-12);
  EXPECT_EQ(offTheTimeline(window().workspace(), window().playback()), "");
  ASSERT_TRUE(parts().comparison().on()) << "the second view belongs to the session";
  waitForSecond();
  EXPECT_EQ(secondPlayback().player().ratePerMinute(), 110);
  EXPECT_EQ(offTheTimeline(second(), secondPlayback()), "");
  EXPECT_NEAR(secondPlayback().player().secondsInCycle(),
              std::fmod(window().playback().player().secondsInCycle(), 60.0 / 110), 1e-9);
  EXPECT_NEAR(volumeIn(second(), "LV"), beside, 1e-6);
}

TEST_F(OneState, AViewThatComesBesideAnotherInDeformStandsAtItsInstantInPlay) {
  window().playback().toStart();
  window().playback().pause();
  key(Qt::Key_3);
  key(Qt::Key_3, Qt::ControlModifier);
  waitForSecond();
  key(Qt::Key_5);
  waitForSecond();
  EXPECT_EQ(second().live().shownPose(), window().workspace().live().shownPose());
  EXPECT_EQ(offTheTimeline(second(), secondPlayback()), "");
  EXPECT_EQ(secondPlayback().showing(), window().playback().showing());
  key(Qt::Key_2, Qt::ControlModifier);
  waitForSecond();
  // At another rate the heart is at another point of its filling when the cycle begins.
  EXPECT_EQ(offTheTimeline(second(), secondPlayback()), "");
}

TEST_F(OneState, UndoAndRedoInAComparisonLeaveBothViewsWhereTheirTimelinesStand) {
  key(Qt::Key_2, Qt::ControlModifier);
  waitForSecond();
  window().playback().seek(0.4);
  ASSERT_TRUE(window().workspace().perform(document::removeHandles({document().rig().handles.back().id})));
  for (const bool back : {true, false, true}) {
    back ? undo() : redo();
    waitForPeace();
    waitForSecond();
    EXPECT_EQ(disagreement(window()), "");
    EXPECT_EQ(offTheTimeline(window().workspace(), window().playback()), "") << back;
    EXPECT_EQ(offTheTimeline(second(), secondPlayback()), "") << back;
    EXPECT_EQ(second().live().shownPose(), window().workspace().live().shownPose()) << back;
  }
}

TEST_F(OneState, RedoOfARemovedHandleLeavesNoTimelineInTheMiddle) {
  ASSERT_TRUE(window().workspace().perform(document::removeHandles({document().rig().handles.back().id})));
  undo();
  playAndPause(0.3);
  redo();
  ASSERT_EQ(document().rig().handles.size(), kHeartHandles - 1);
  waitForPeace();
  EXPECT_EQ(disagreement(window()), "");
  EXPECT_EQ(offTheTimeline(window().workspace(), window().playback()), "");
}

TEST_F(OneState, AKeysPoseThatIsTakenIsWhereTheTimelineStands) {
  Points pose = document().pose();
  ASSERT_TRUE(window().workspace().perform(document::recordKey(0)));
  pose.col(2).array() += 9;
  ASSERT_TRUE(window().workspace().perform(document::setPose(pose)));
  ASSERT_TRUE(window().workspace().perform(document::recordKey(0.8)));
  const auto& keys = document().keySequence().keys;
  ASSERT_EQ(keys.size(), 2u);
  window().playback().choose(parts().keySequence().sequence());
  window().playback().seek(0.8 / document().keySequence().periodSeconds);
  EXPECT_LT((window().workspace().live().shownPose() - pose).cwiseAbs().maxCoeff(), 1e-9);
  ASSERT_TRUE(parts().keySequence().takePose(keys[0].id));
  waitForPeace();
  EXPECT_EQ(disagreement(window()), "");
  EXPECT_EQ(offTheTimeline(window().workspace(), window().playback()), "");
  undo();
  waitForPeace();
  EXPECT_EQ(offTheTimeline(window().workspace(), window().playback()), "");
}

TEST_F(OneState, OtherCoordinatesBeginCurveAndIndicesAnew) {
  const auto& monitor = window().volumes();
  ASSERT_EQ(monitor.lines().at(1).name, QStringLiteral("LV cavity"));
  ASSERT_TRUE(waitUntil([&] { return monitor.indices(1).has_value(); }));
  const double before = monitor.indices(1)->ejectionFraction;
  ASSERT_TRUE(window().workspace().perform(document::setSystem({"t-celestial", {}})));
  EXPECT_TRUE(waitUntil([&] {
    const auto indices = monitor.indices(1);
    return indices && indices->ejectionFraction != before;
  })) << "the ejection fraction was that of the coordinates before";
}

TEST_F(OneState, AWarningOfOtherHandlesGoesWhenTheyFitAgain) {
  key(Qt::Key_P, Qt::ControlModifier);
  ASSERT_NE(document().rig().handles.size(), kHeartHandles);
  key(Qt::Key_5);
  key(Qt::Key_Space);
  ASSERT_TRUE(message().contains(QStringLiteral("moves its own handles"))) << message().toStdString();
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().rig().handles.size(), kHeartHandles);
  EXPECT_EQ(message(), QString());
}

TEST_F(OneState, AnOfferOfASequencesHandlesEndsWithTheSequence) {
  key(Qt::Key_P, Qt::ControlModifier);
  key(Qt::Key_5);
  key(Qt::Key_Space);
  ASSERT_TRUE(message().contains(QStringLiteral("moves its own handles"))) << message().toStdString();
  window().playback().forgetAll();
  EXPECT_EQ(message(), QString()) << "its button would use the handles of a sequence that is gone";
}

} // namespace
} // namespace viscera::tests
