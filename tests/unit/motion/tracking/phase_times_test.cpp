#include <gtest/gtest.h>

#include "viscera/tracking/phase_times.h"

namespace viscera::tracking {
namespace {

TEST(PhaseTimes, EvenOnesLeaveRoomForTheFirstPhaseToComeAgain) {
  const PhaseTimes times = PhaseTimes::even(25, 0.829);
  EXPECT_EQ(times.count(), 25U);
  EXPECT_DOUBLE_EQ(times.seconds.front(), 0);
  EXPECT_NEAR(times.seconds.back(), 0.79584, 1e-12);
}

TEST(Unevenness, IsTheSumOfSecondDifferencesAroundTheLoop) {
  const Eigen::VectorXd x = Eigen::VectorXd::Random(7);
  double expected = 0;
  for (int t = 0; t < 7; ++t)
    expected += std::pow(x[(t + 6) % 7] - 2 * x[t] + x[(t + 1) % 7], 2);
  EXPECT_NEAR(x.dot(unevenness(PhaseTimes::even(7, 1.3)) * x), expected, 1e-12);
}

TEST(Unevenness, DoesNotPullAtTheEndsOfWhatIsNoLoop) {
  const Eigen::VectorXd straight = Eigen::VectorXd::LinSpaced(6, 2, 9);
  EXPECT_NEAR(straight.dot(unevenness(PhaseTimes::even(6, 1, false)) * straight), 0, 1e-12);
  EXPECT_GT(straight.dot(unevenness(PhaseTimes::even(6, 1, true)) * straight), 1);
}

TEST(Unevenness, OfUnevenTimesIsZeroForWhatRunsEvenly) {
  const PhaseTimes times{{0, 0.1, 0.15, 0.4, 0.7}, 1, false};
  Eigen::VectorXd even(5);
  for (int t = 0; t < 5; ++t)
    even[t] = 3 * times.seconds[static_cast<std::size_t>(t)] - 1;
  EXPECT_NEAR(even.dot(unevenness(times) * even), 0, 1e-12);
}

TEST(Neighbours, AreBeforeAndAfterInTimeAroundTheLoop) {
  const PhaseTimes times{{0, 0.2, 0.9}, 1, true};
  Neighbours found;
  ASSERT_TRUE(neighboursOf(times, 0, found));
  EXPECT_EQ(found.before, 2U);
  EXPECT_EQ(found.after, 1U);
  EXPECT_NEAR(found.part, 0.1 / 0.3, 1e-12);
  EXPECT_FALSE(neighboursOf({{0, 0.2, 0.9}, 1, false}, 0, found));
}

} // namespace
} // namespace viscera::tracking
