#include "viscera/motion/player.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "session_fixture.h"
#include "viscera/core/error.h"
#include "viscera/document/sequence_rig.h"

namespace viscera::motion {
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
  std::string name() const override { return "Swing"; }
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

/// A player whose clock the test turns.
struct Stage {
  double now = 1000;
  Player player{[this] { return now; }};

  Stage() { player.setSequence(std::make_shared<Swing>()); }
  void pass(double seconds) {
    now += seconds;
    player.advance();
  }
  Points pose() const {
    Points out;
    player.pose(out);
    return out;
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

TEST(Player, PausesWhereTheClockIsAndNotAtTheLastFrame) {
  Stage s;
  s.player.play();
  s.now += 0.125;
  s.player.pause();
  EXPECT_NEAR(s.player.fraction(), 0.125, kRounding);
}

TEST(Player, RepeatsTheSamePoseEveryCycle) {
  Stage s;
  s.player.play();
  s.pass(0.375);
  const Points first = s.pose();
  for (int cycle = 0; cycle < 7; ++cycle) {
    s.pass(1);
    EXPECT_LT((s.pose() - first).norm(), kRounding);
  }
  EXPECT_NEAR(s.player.playedSeconds(), 7.375, kRounding);
}

TEST(Player, GivesBitwiseTheSamePoseForTheSamePlace) {
  Stage a, b;
  a.player.play();
  a.pass(17.3);
  a.player.seek(0.3);
  b.player.seek(0.3);
  EXPECT_EQ(a.pose(), b.pose());
}

TEST(Player, GoesOnFromTheSamePlaceAtAnotherRate) {
  Stage s;
  s.player.play();
  s.pass(0.5);
  s.now += 0.25;
  s.player.setRatePerMinute(120);
  EXPECT_NEAR(s.player.fraction(), 0.75, kRounding) << "what had passed, passed at the old rate";
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
  EXPECT_FALSE(s.player.playing());
  EXPECT_NEAR(s.player.playedSeconds(), 1, kRounding);
  EXPECT_FALSE(s.player.advance());
  s.player.play();
  EXPECT_EQ(s.player.fraction(), 0);
  EXPECT_TRUE(s.player.playing());
}

TEST(Player, NamesThePhase) {
  Stage s;
  EXPECT_EQ(s.player.phase(), "up");
  s.player.seek(0.25);
  EXPECT_EQ(s.player.phase(), "down");
}

TEST(Player, RefusesRatesSpeedsAndPlacesOutOfRange) {
  Stage s;
  EXPECT_THROW(s.player.setRatePerMinute(29), UsageError);
  EXPECT_THROW(s.player.setRatePerMinute(std::nan("")), UsageError);
  EXPECT_THROW(s.player.setSpeed(0), UsageError);
  EXPECT_THROW(s.player.seek(1.1), UsageError);
  s.player.setSequence(nullptr);
  EXPECT_THROW(s.player.setRatePerMinute(60), UsageError);
  s.player.play();
  EXPECT_FALSE(s.player.playing());
}

TEST(Player, FitsTheRigThatTheSequenceBringsAndNoOther) {
  const Swing swing;
  tests::Session s;
  EXPECT_NO_THROW(requireFits(s.document.rig(), swing));
  s.undo.perform(document::moveRestHandles({s.handle(8)}, tests::row(0, 1, 40)));
  try {
    requireFits(s.document.rig(), swing);
    FAIL() << "a rig with a moved handle was taken";
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("H-9"));
  }
  s.undo.perform(document::removeHandles({s.handle(8)}));
  EXPECT_THROW(requireFits(s.document.rig(), swing), DataError);
  s.undo.perform(document::replaceRig(document::rigOf(swing)));
  EXPECT_NO_THROW(requireFits(s.document.rig(), swing));
  ASSERT_EQ(s.document.rig().groups.size(), 1u);
  EXPECT_EQ(s.document.rig().groups[0].handles, (std::vector<document::HandleId>{s.handle(4), s.handle(8)}));
}

} // namespace
} // namespace viscera::motion
