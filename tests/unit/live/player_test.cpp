#include "viscera/live/player.h"

#include <atomic>
#include <cmath>
#include <numbers>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "counting_system.h"
#include "session_fixture.h"
#include "viscera/core/error.h"
#include "viscera/document/rig_commands.h"

namespace viscera::live {
namespace {

using ::testing::HasSubstr;

/// Handles that swing along z once a cycle.
class Swing final : public sequences::Sequence {
public:
  Swing() {
    rest_.resize(10, 3);
    const auto handles = tests::cubeHandles();
    for (Eigen::Index i = 0; i < 10; ++i)
      rest_.row(i) = handles[static_cast<std::size_t>(i)].rest.transpose();
  }
  std::string id() const override { return "swing"; }
  Text name() const override { return "Swing"; }
  const Points& restHandles() const override { return rest_; }
  std::vector<sequences::HandleGroup> groups() const override { return {{"Top", {1, 0, 0}, {4, 8}}}; }
  double standardRatePerMinute() const override { return 60; }
  double lowestRatePerMinute() const override { return 30; }
  double highestRatePerMinute() const override { return 240; }
  void poseAt(double seconds, double ratePerMinute, Points& pose) const override {
    pose = rest_;
    pose.col(2).array() += std::sin(2 * std::numbers::pi * seconds * ratePerMinute / 60);
  }
  std::vector<sequences::Phase> phases(double) const override { return {{"up", 0, 0.25}, {"down", 0.25, 1}}; }

private:
  Points rest_;
};

/// A bound ball that swings, under a clock that the test turns.
struct Stage : tests::BoundSession {
  double now = 1000;
  Player player{document.state(), live, [this] { return now; }};

  Stage() {
    player.setSequence(std::make_shared<Swing>(), organ());
    player.match();
  }
  void pass(double seconds) {
    now += seconds;
    player.advance();
  }
  Points swung(double fraction) const {
    Points pose;
    Swing().poseAt(fraction, 60, pose);
    return pose;
  }
};

/// A second ball at a rate of its own, under the same time.
struct Second : tests::BoundSession {
  Player player;

  explicit Second(Stage& first) : player(first.player, document.state(), live) {
    player.setSequence(std::make_shared<Swing>(), organ());
    first.player.match();
  }
  bool showsWhatItSays() const {
    Points pose;
    Swing().poseAt(player.secondsInCycle(), player.ratePerMinute(), pose);
    return (live.shownPose() - pose).norm() < 1e-12;
  }
};

constexpr double kRounding = 1e-9;

TEST(Player, StandsStillUntilItPlays) {
  Stage s;
  s.pass(5);
  EXPECT_EQ(s.player.fraction(), 0);
  EXPECT_EQ(s.player.ratePerMinute(), 60);
  s.player.play();
  s.pass(0.25);
  EXPECT_NEAR(s.player.fraction(), 0.25, kRounding);
  s.player.pause();
  s.pass(5);
  EXPECT_NEAR(s.player.fraction(), 0.25, kRounding);
  s.player.play();
  s.pass(0.25);
  EXPECT_NEAR(s.player.fraction(), 0.5, kRounding) << "the time of the pause was played";
}

TEST(Player, PausesAtTheInstantThatIsShown) {
  Stage s;
  s.player.play();
  s.pass(0.125);
  s.now += 0.5;
  s.player.pause();
  EXPECT_NEAR(s.player.fraction(), 0.125, kRounding);
  EXPECT_LT((s.live.shownPose() - s.swung(0.125)).norm(), kRounding);
}

TEST(Player, KeepsAPrescribedVolumeWhileASequenceTakesThePlaceOfItsLike) {
  Stage s;
  const double rest = s.document.organ(s.organ())->restVolumeMm3 / kMm3PerMl;
  s.player.prescribe(PrescribedVolume{s.organ(), sequences::Curve::periodic({{0, 1.01 * rest}}, 1)});
  s.player.exchangeSequence(std::make_shared<Swing>());
  ASSERT_TRUE(s.player.runner().prescribed());
  s.player.seek(0.3);
  EXPECT_NEAR(s.live.volume(s.organ()).nowMl, 1.01 * rest, 1e-6 * rest);
  s.player.setSequence(std::make_shared<Swing>(), s.organ());
  EXPECT_FALSE(s.player.runner().prescribed()) << "another one begins without";
}

TEST(Player, ShowsTheSamePoseEveryCycle) {
  Stage s;
  s.player.play();
  s.pass(0.375);
  const Points first = s.live.shownPose();
  for (int cycle = 0; cycle < 7; ++cycle) {
    s.pass(1);
    EXPECT_LT((s.live.shownPose() - first).norm(), kRounding);
  }
  EXPECT_NEAR(s.player.playedSeconds(), 7.375, kRounding);
}

TEST(Player, ShowsBitwiseTheSamePoseForTheSamePlace) {
  Stage a, b;
  a.player.play();
  a.pass(17.3);
  a.player.seek(0.3);
  b.player.seek(0.3);
  EXPECT_EQ(a.live.shownPose(), b.live.shownPose());
  EXPECT_EQ(a.live.points(a.organ()), b.live.points(b.organ()));
}

TEST(Player, GoesOnFromTheSamePlaceAtAnotherRateAndShowsIt) {
  Stage s;
  s.player.play();
  s.pass(0.5);
  s.now += 0.25;
  s.player.setRatePerMinute(120);
  EXPECT_NEAR(s.player.fraction(), 0.75, kRounding) << "what had passed, passed at the old rate";
  EXPECT_LT((s.live.shownPose() - s.swung(0.75)).norm(), kRounding);
  s.pass(0.1);
  EXPECT_NEAR(s.player.fraction(), 0.95, kRounding);
  EXPECT_NEAR(s.player.secondsInCycle(), 0.475, kRounding);
}

TEST(Player, PassesSlowlyInSlowMotionWithTheSequencesOwnTime) {
  Stage s;
  s.player.setSpeed(0.25);
  s.player.play();
  s.pass(1);
  EXPECT_NEAR(s.player.fraction(), 0.25, kRounding);
  EXPECT_NEAR(s.player.playedSeconds(), 0.25, kRounding);
}

TEST(Player, StopsAtTheEndWithoutLoopAndBeginsAgain) {
  Stage s;
  s.player.setLoop(false);
  s.player.play();
  s.pass(3.7);
  EXPECT_EQ(s.player.fraction(), 1);
  EXPECT_FALSE(s.player.running());
  EXPECT_NEAR(s.player.playedSeconds(), 1, kRounding);
  EXPECT_FALSE(s.player.advance());
  s.player.play();
  EXPECT_EQ(s.player.fraction(), 0);
  EXPECT_TRUE(s.player.running());
}

TEST(Player, NamesThePhase) {
  Stage s;
  EXPECT_EQ(s.player.phase().english(), "up");
  s.player.seek(0.25);
  EXPECT_EQ(s.player.phase().english(), "down");
}

TEST(Player, RefusesRatesSpeedsAndPlacesOutOfRange) {
  Stage s;
  EXPECT_THROW(s.player.setRatePerMinute(29), UsageError);
  EXPECT_THROW(s.player.setRatePerMinute(std::nan("")), UsageError);
  EXPECT_THROW(s.player.setSpeed(0), UsageError);
  EXPECT_THROW(s.player.seek(1.1), UsageError);
  s.player.setSequence(nullptr, {});
  EXPECT_THROW(s.player.setRatePerMinute(60), UsageError);
  s.player.play();
  EXPECT_FALSE(s.player.running());
}

TEST(Player, ShowsThePoseThatIsWantedAndComesBackToItsInstant) {
  Stage s;
  s.undo.perform(document::moveHandles({s.handle(9)}, tests::row(45, 3, -1)));
  s.player.play();
  s.pass(0.25);
  s.player.setPose(WantedPose::document);
  EXPECT_FALSE(s.player.running());
  EXPECT_EQ(s.live.shownPose(), s.document.pose());
  s.player.setPose(WantedPose::rest);
  EXPECT_EQ(s.live.shownPose(), s.document.rig().restPositions());
  s.player.play();
  EXPECT_FALSE(s.player.running()) << "nobody would see it";
  s.player.setPose(WantedPose::sequence);
  EXPECT_LT((s.live.shownPose() - s.swung(0.25)).norm(), kRounding);
  s.player.stop();
  EXPECT_EQ(s.live.shownPose(), s.document.pose());
}

TEST(Player, ShowsAPlaceThatWasSetWhileAnotherPoseWasWantedOnceTheSequencesIs) {
  Stage s;
  s.player.setPose(WantedPose::document);
  s.player.seek(0.25);
  EXPECT_EQ(s.player.fraction(), 0) << "nobody would see it";
  s.player.setPlace(0.25);
  EXPECT_EQ(s.player.fraction(), 0.25);
  EXPECT_FALSE(s.player.showing());
  EXPECT_EQ(s.live.shownPose(), s.document.pose());
  s.player.setPose(WantedPose::sequence);
  EXPECT_LT((s.live.shownPose() - s.swung(0.25)).norm(), kRounding);
  EXPECT_THROW(s.player.setPlace(1.5), UsageError);
}

TEST(Player, StopsAtTheBeginningWhenTheHandlesAreNoLongerTheSequences) {
  for (const bool playing : {true, false}) {
    Stage s;
    s.player.play();
    s.pass(0.3);
    if (!playing)
      s.player.pause();
    s.undo.perform(document::removeHandles({s.handle(8)}));
    s.player.match();
    EXPECT_FALSE(s.player.running());
    EXPECT_FALSE(s.player.started());
    EXPECT_EQ(s.player.fraction(), 0);
    EXPECT_EQ(s.live.shownPose(), s.document.pose());
    s.undo.undo();
    s.player.match();
    EXPECT_FALSE(s.player.showing());
    EXPECT_EQ(s.live.shownPose(), s.document.pose());
    s.player.play();
    s.pass(0.25);
    EXPECT_LT((s.live.shownPose() - s.swung(0.25)).norm(), kRounding);
  }
}

TEST(Player, AnEditThatLeavesTheHandlesWhereTheyAreDoesNotEndTheMotion) {
  Stage s;
  s.player.seek(0.25);
  document::HandleEdit locked;
  locked.locked = true;
  s.undo.perform(document::editHandles({s.handle(8)}, locked));
  s.player.match();
  EXPECT_TRUE(s.player.showing());
  EXPECT_LT((s.live.shownPose() - s.swung(0.25)).norm(), kRounding);
}

TEST(Player, AllViewsAreAtTheSameSecondsAndShowWhatTheySay) {
  Stage s;
  s.player.seek(0.7);
  Second other(s);
  EXPECT_NEAR(other.player.secondsInCycle(), 0.7, kRounding) << "it joins where the first one is";
  EXPECT_TRUE(other.showsWhatItSays());
  other.player.setRatePerMinute(100);
  EXPECT_NEAR(other.player.secondsInCycle(), 0.1, kRounding) << "in its second cycle";
  EXPECT_TRUE(other.showsWhatItSays());
  s.player.step(0.25);
  EXPECT_NEAR(s.player.secondsInCycle(), 0.95, kRounding);
  EXPECT_NEAR(other.player.secondsInCycle(), 0.35, kRounding);
  EXPECT_TRUE(other.showsWhatItSays());
  s.player.play();
  s.pass(0.5);
  s.now += 0.3;
  s.player.pause();
  EXPECT_NEAR(s.player.secondsInCycle(), 0.45, kRounding);
  EXPECT_TRUE(other.showsWhatItSays());
  other.undo.perform(document::removeHandles({other.handle(0)}));
  s.player.seek(0.5);
  EXPECT_FALSE(other.player.showing());
  EXPECT_TRUE(s.player.showing()) << "one that cannot be moved holds up nobody";
}

TEST(SequenceRig, FitsTheRigThatTheSequenceBringsAndNoOther) {
  const Swing swing;
  tests::Session s;
  EXPECT_NO_THROW(document::requireFits(s.document.rig(), swing));
  s.undo.perform(document::moveRestHandles({s.handle(8)}, tests::row(0, 1, 40)));
  try {
    document::requireFits(s.document.rig(), swing);
    FAIL() << "a rig with a moved handle was taken";
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("H-9"));
  }
  s.undo.perform(document::removeHandles({s.handle(8)}));
  EXPECT_THROW(document::requireFits(s.document.rig(), swing), DataError);
  s.undo.perform(document::replaceRig(document::rigOf(swing)));
  EXPECT_NO_THROW(document::requireFits(s.document.rig(), swing));
  ASSERT_EQ(s.document.rig().groups.size(), 1u);
  EXPECT_EQ(s.document.rig().groups[0].handles, (std::vector<document::HandleId>{s.handle(4), s.handle(8)}));
}

/// Four corners go out and in again: the ball would gain and lose volume.
class Breathe final : public sequences::Sequence {
public:
  std::string id() const override { return "breathe"; }
  Text name() const override { return "Breathe"; }
  const Points& restHandles() const override { return swing_.restHandles(); }
  double standardRatePerMinute() const override { return 60; }
  double lowestRatePerMinute() const override { return 30; }
  double highestRatePerMinute() const override { return 240; }
  void poseAt(double seconds, double ratePerMinute, Points& pose) const override {
    pose = restHandles();
    pose.topRows(4) *= 1 + 0.1 * std::sin(2 * std::numbers::pi * seconds * ratePerMinute / 60);
  }
  std::vector<sequences::Phase> phases(double) const override { return {{"breath", 0, 1}}; }

private:
  Swing swing_;
};

TEST(Player, UnderALockNoFrameMakesTheVolumeFormAndAllKeepTheVolumeExactly) {
  constexpr double kAllowedVolumeError = 1e-9;
  tests::BoundSession s;
  const auto counts = std::make_shared<tests::BindingCounts>();
  std::atomic<int> madeHere{0};
  counts->beforeInfluence = [&madeHere, here = std::this_thread::get_id()] {
    if (std::this_thread::get_id() == here)
      ++madeHere;
  };
  s.registry.add(std::make_shared<tests::CountingSystem>(counts), "test");
  s.undo.perform(document::setSystem({"counting", {}}));
  s.undo.perform(document::setVolumeLocked(s.organ(), true));
  double now = 1000;
  Player player(
      s.document.state(), s.live, [&now] { return now; }, &s.jobs);
  player.setSequence(std::make_shared<Breathe>(), s.organ());
  player.setPose(WantedPose::sequence);
  const auto kept = [&] {
    return std::abs(s.live.volume(s.organ()).relativeChange()) <= kAllowedVolumeError;
  };
  player.seek(0.25);
  ASSERT_TRUE(player.runner().obstacle().empty()) << player.runner().obstacle();
  const Points early = s.live.shownPose();
  EXPECT_GT(counts->pullBacks, 0) << "the surface itself was passed over";
  EXPECT_TRUE(kept());
  EXPECT_FALSE(s.jobs.idle()) << "the form is made on the queue";
  s.box.runUntil([&] { return s.jobs.idle(); });
  EXPECT_EQ(counts->influences, 10) << "a column for each handle";
  const int pullBacks = counts->pullBacks;
  player.play();
  for (int frame = 0; frame < 20; ++frame) {
    now += 0.05;
    player.advance();
    EXPECT_TRUE(kept()) << "frame " << frame;
  }
  EXPECT_EQ(counts->pullBacks, pullBacks) << "the form is there";
  EXPECT_EQ(madeHere, 0);
  player.pause();
  player.seek(0.25);
  EXPECT_LT((s.live.shownPose() - early).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_TRUE(s.jobs.idle()) << "what is ready is not made again";
}

} // namespace
} // namespace viscera::live
