#include "viscera/live/motion_runner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "session_fixture.h"
#include "viscera/core/error.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/live/cycle_curves.h"
#include "viscera/live/motion_copy.h"

namespace viscera::live {
namespace {

constexpr double kPeriodSeconds = 2;

/// Squeezes the handles towards an axis and lets go of them again, twisting a little.
class Squeeze final : public sequences::Sequence {
public:
  explicit Squeeze(Points rest) : rest_(std::move(rest)) {}
  std::string id() const override { return "squeeze"; }
  Text name() const override { return "Squeeze"; }
  const Points& restHandles() const override { return rest_; }
  double standardRatePerMinute() const override { return 60 / kPeriodSeconds; }
  double lowestRatePerMinute() const override { return 10; }
  double highestRatePerMinute() const override { return 60; }
  void poseAt(double seconds, double rate, Points& pose) const override {
    const double grip = (1 - std::cos(2 * std::numbers::pi * seconds * rate / 60)) / 2;
    pose = rest_;
    for (Eigen::Index i = 0; i < pose.rows(); ++i) {
      const double angle = 0.004 * grip * rest_(i, 2);
      const Vec3 at = (1 - 0.2 * grip) * Vec3(rest_(i, 0), rest_(i, 1), 0);
      pose.row(i) << std::cos(angle) * at.x() - std::sin(angle) * at.y(),
          std::sin(angle) * at.x() + std::cos(angle) * at.y(), rest_(i, 2);
    }
  }
  std::vector<sequences::Phase> phases(double) const override { return {{"squeeze", 0, 1}}; }

private:
  Points rest_;
};

/// An egg bound to handles that squeeze it, in a document of its own.
class Runner : public testing::Test {
protected:
  void SetUp() override {
    auto mesh = tests::sphere(4);
    mesh.points = mesh.points * Vec3(40, 35, 60).asDiagonal();
    document::Organ egg = document::makeOrgan("Egg", std::move(mesh));
    restMl_ = egg.restVolumeMm3 / kMm3PerMl;
    const Points handles = deformation::placeHandles(*egg.mesh, {24, true, 0.05, 0.15});
    undo_.perform(document::addOrgans({{std::move(egg), -1}}));
    undo_.perform(document::addHandles(document::newHandles(handles)));
    moving_ = std::make_shared<Squeeze>(handles);
    runner_.setSequence(moving_);
  }
  document::OrganId egg() const { return document_.organs().front()->id; }
  double shownMl(double seconds) {
    runner_.show(seconds);
    return runner_.volumesMl().front();
  }
  void prescribe(std::vector<sequences::Key> keys) {
    runner_.prescribe(PrescribedVolume{egg(), sequences::Curve::periodic(std::move(keys), 1)});
  }

  document::Document document_;
  document::UndoStack undo_{document_};
  coordinates::Registry registry_ = coordinates::builtInRegistry();
  ManualEventLoop box_;
  JobQueue jobs_{box_.post()};
  LiveBinding live_{document_, registry_, jobs_, {std::numeric_limits<double>::infinity(), {2}}};
  MotionRunner runner_{document_.state(), live_};
  std::shared_ptr<const Squeeze> moving_;
  double restMl_ = 0;
};

TEST_F(Runner, ShowsTheInstantAndMeasuresIt) {
  Points pose;
  moving_->poseAt(0.7, 30, pose);
  runner_.show(0.7);
  const std::vector<double> milliliters = runner_.volumesMl();
  EXPECT_EQ(live_.shownPose(), pose);
  ASSERT_EQ(milliliters.size(), 1u);
  EXPECT_EQ(milliliters[0], live_.volume(egg()).nowMl);
  EXPECT_LT(milliliters[0], 0.95 * restMl_);
}

TEST_F(Runner, MeasuresAFrameOnceAndOnlyForWhomItShowsVolumes) {
  undo_.perform(document::addOrgans({{document::makeOrgan("Ball", tests::sphere(2)), -1}}));
  const std::uint64_t before = live_.measurings();
  for (int frame = 1; frame <= 10; ++frame)
    runner_.show(0.1 * frame);
  EXPECT_EQ(live_.measurings(), before) << "nobody asked for a volume";
  for (std::uint64_t frame = 1; frame <= 10; ++frame) {
    runner_.show(0.13 * static_cast<double>(frame));
    for (int reader = 0; reader < 3; ++reader) { // A table, a list and a chart.
      const std::vector<double> milliliters = runner_.volumesMl();
      for (std::size_t i = 0; i < milliliters.size(); ++i)
        EXPECT_EQ(milliliters[i], live_.volume(document_.organs()[i]->id).nowMl);
    }
    EXPECT_EQ(live_.measurings(), before + frame) << "one loop over both organs";
  }
}

TEST_F(Runner, ALockedVolumeStaysInAMotionThatWouldLoseAThirdOfIt) {
  EXPECT_LT(shownMl(kPeriodSeconds / 2), 0.8 * restMl_);
  undo_.perform(document::setVolumeLocked(egg(), true));
  for (int i = 0; i < 200; ++i)
    EXPECT_NEAR(shownMl(i * 0.0137) / restMl_, 1, 1e-9) << "instant " << i;
  EXPECT_TRUE(runner_.obstacle().empty());
}

TEST_F(Runner, ACopyOfTheOrgansShowsTheSamePointsToTheBitWithItsLocksWhateverTheDocumentDoes) {
  undo_.perform(document::moveHandles({document_.rig().handles[3].id}, tests::row(50, 10, 5)));
  undo_.perform(document::setVolumeLocked(egg(), true));
  const document::DocumentState state = document_.state();
  PosedCopy copy = live_.copy();
  const document::OrganId organ = egg();
  EXPECT_EQ(*copy.sharedPoints(organ), live_.points(organ));
  MotionRunner copied(state, copy);
  copied.setSequence(moving_);
  std::vector<Points> seen;
  std::vector<double> volumes;
  for (int i = 0; i < 12; ++i) {
    volumes.push_back(shownMl(i * 0.17));
    seen.push_back(live_.points(organ));
  }
  undo_.perform(document::removeAllOrgans());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    copied.show(static_cast<double>(i) * 0.17);
    EXPECT_EQ(copied.volumesMl().front(), volumes[i]);
    EXPECT_EQ(*copy.sharedPoints(organ), seen[i]) << "instant " << i;
  }
}

TEST_F(Runner, ACopyOfTheMotionGivesTheSamePosesUnderLocksAndStopsWhereTheyCannotBeKept) {
  undo_.perform(document::setVolumeLocked(egg(), true));
  const MotionCause cause = causeOf(runner_);
  const PosedCycle cycle = posedCycle(runner_, live_.copy());
  EXPECT_EQ(cycle.periodSeconds, kPeriodSeconds);
  for (const double fraction : {0.0, 0.3, 0.5}) {
    runner_.show(fraction * kPeriodSeconds);
    EXPECT_EQ(cycle.poseAt(fraction), live_.shownPose()) << fraction;
  }
  EXPECT_EQ(causeOf(runner_), cause) << "showing changes nothing that a cycle depends on";
  undo_.perform(document::setPose(1.01 * document_.pose()));
  EXPECT_NE(causeOf(runner_), cause) << "the lock keeps the volume of the pose";
  undo_.undo();
  EXPECT_EQ(causeOf(runner_), cause);
  undo_.perform(document::setVolumeLocked(egg(), false));
  EXPECT_NE(causeOf(runner_), cause);
  prescribe({{0, restMl_}, {0.5, 40 * restMl_}});
  const PosedCycle tooFar = posedCycle(runner_, live_.copy());
  const Points kept = tooFar.poseAt(0);
  EXPECT_EQ(tooFar.poseAt(0.5), kept);
  runner_.setSequence(nullptr);
  EXPECT_THROW(posedCycle(runner_, live_.copy()), UsageError);
}

TEST_F(Runner, APrescribedVolumeIsMetAtEveryInstant) {
  const std::vector<sequences::Key> keys = {{0, restMl_}, {0.4, 0.85 * restMl_}, {0.7, 1.05 * restMl_}};
  const auto curve = sequences::Curve::periodic(keys, 1);
  prescribe(keys);
  runner_.requireReachable();
  for (int i = 0; i < 200; ++i) {
    const double seconds = i * 0.0137;
    const double wanted = curve.at(std::fmod(seconds / kPeriodSeconds, 1));
    EXPECT_NEAR(shownMl(seconds) / wanted, 1, 1e-9) << "instant " << i;
  }
  EXPECT_FALSE(document_.organs().front()->volumeLocked);
  EXPECT_TRUE(document::atRest(document_.state())) << "the document is as it was";
}

TEST_F(Runner, OnlyTheHandlesThatMayCompensateLeaveTheMotion) {
  const std::vector<int> some = {8, 9, 10, 11, 13, 15, 17, 19, 21, 22};
  std::vector<document::HandleId> ids;
  for (const int row : some)
    ids.push_back(document_.rig().handles[static_cast<std::size_t>(row)].id);
  document::HandleEdit edit;
  edit.compensates = true;
  undo_.perform(document::editHandles(ids, edit));
  prescribe({{0, 0.98 * restMl_}});
  runner_.show(0.3);
  Points without;
  moving_->poseAt(0.3, 30, without);
  for (int i = 0; i < without.rows(); ++i)
    EXPECT_EQ(live_.shownPose().row(i) == without.row(i),
              std::find(some.begin(), some.end(), i) == some.end())
        << "handle " << i;
}

TEST_F(Runner, TheSameInstantIsTheSamePoseWhateverWasPlayedBefore) {
  prescribe({{0, restMl_}});
  runner_.show(0.77);
  const Points first = live_.shownPose();
  runner_.show(1.9);
  runner_.show(0.77);
  EXPECT_EQ(live_.shownPose(), first);
}

TEST_F(Runner, SaysAtWhichInstantAVolumeIsOutOfReachAndStaysWhereItWas) {
  document::HandleEdit edit;
  edit.compensates = true;
  undo_.perform(document::editHandles({document_.rig().handles[10].id}, edit));
  prescribe({{0, restMl_}, {0.5, 40 * restMl_}});
  try {
    runner_.requireReachable();
    FAIL() << "forty times the volume by one handle";
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("of the cycle"));
    EXPECT_FALSE(error.tryThis().empty());
  }
  runner_.show(0);
  const Points before = live_.shownPose();
  EXPECT_TRUE(runner_.obstacle().empty());
  runner_.show(1);
  EXPECT_FALSE(runner_.obstacle().empty());
  EXPECT_EQ(live_.shownPose(), before);
}

TEST_F(Runner, ACycleMeasuredAheadHasTheVolumesOfItsFramesToTheBit) {
  PosedCopy organs = live_.copy();
  MotionRunner ahead(document_.state(), organs);
  ahead.setSequence(moving_);
  Progress progress;
  const CycleCurves curves = measureCycle(ahead, progress);
  ASSERT_GE(curves.fractions.size(), 61u);
  EXPECT_EQ(curves.fractions.front(), 0);
  EXPECT_EQ(curves.fractions.back(), 1);
  ASSERT_EQ(curves.milliliters.size(), 1u);
  for (std::size_t i = 0; i < curves.fractions.size(); i += 7)
    EXPECT_EQ(shownMl(curves.fractions[i] * kPeriodSeconds), curves.milliliters[0][i]) << i;
  const auto half = std::find(curves.fractions.begin(), curves.fractions.end(), 0.5);
  ASSERT_NE(half, curves.fractions.end());
  EXPECT_LT(curves.milliliters[0][static_cast<std::size_t>(half - curves.fractions.begin())], 0.7 * restMl_);
}

TEST_F(Runner, ACycleOfALockedVolumeIsAStraightLine) {
  undo_.perform(document::setVolumeLocked(egg(), true));
  Progress progress;
  const CycleCurves curves = measureCycle(runner_, progress);
  for (const double milliliters : curves.milliliters[0])
    EXPECT_NEAR(milliliters, restMl_, 1e-9 * restMl_);
  EXPECT_EQ(curves.obstacle.english(), "");
}

TEST_F(Runner, MeasuringACycleCanBeCancelledAndNeedsSomethingThatMoves) {
  Progress progress;
  progress.cancel();
  EXPECT_THROW(measureCycle(runner_, progress), Cancelled);
  MotionRunner still(document_.state(), live_);
  Progress other;
  EXPECT_THROW(measureCycle(still, other), UsageError);
}

TEST_F(Runner, HandlesOfAnotherRigAreLeftAlone) {
  undo_.perform(document::removeHandles({document_.rig().handles[3].id}));
  EXPECT_FALSE(runner_.movable());
  EXPECT_NEAR(shownMl(0.7), restMl_, 1e-9);
  EXPECT_EQ(live_.shownPose(), document_.pose());
}

} // namespace
} // namespace viscera::live
