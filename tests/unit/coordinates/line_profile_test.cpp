#include "viscera/coordinates/measure/line_profile.h"

#include <atomic>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "lines.h"
#include "viscera/coordinates/pointwise_system.h"
#include "viscera/core/error.h"

namespace viscera::coordinates {
namespace {

/// A made-up system of which it is known how it behaves along x: handle 0 gets `value(x)`, the others what is
/// left.
class MadeUp final : public PointwiseSystem {
public:
  using Function = std::function<double(double x)>;
  explicit MadeUp(const Function& value)
      : PointwiseSystem(
            {.id = "made-up", .name = "Made up", .summary = "For tests"},
            [value](const HandleSet&, const ParameterValues&) { return std::make_unique<Solver>(value); }) {}

private:
  class Solver final : public PointSolver {
  public:
    explicit Solver(Function value) : value_(std::move(value)) {}
    bool solve(const Vec3& point, Values& weights) const override {
      weights[0] = value_(point[0]);
      weights[1] = 1 - weights[0];
      return std::isfinite(weights[0]);
    }

  private:
    Function value_;
  };
};

LineProperties measure(MadeUp::Function value) {
  Progress progress;
  return measureAlong(MadeUp(value), tests::handlesAroundLine(9), {tests::kLineFrom, tests::kLineTo}, 400, {},
                      progress);
}

TEST(PointwiseSystem, LooksAtEveryPointWhetherItIsCancelled) {
  Progress progress;
  std::atomic<int> solved{0};
  const MadeUp slow([&](double) {
    ++solved;
    progress.cancel();
    return 0.5;
  });
  EXPECT_THROW(slow.bind(tests::handlesAroundLine(9), Points::Zero(1000, 3), {{}, {1}}, progress), Cancelled);
  EXPECT_EQ(solved, 1);
}

TEST(LineProfile, FindsNothingOnASmoothCurve) {
  const auto found = measure([](double x) { return std::exp(-x * x / 200); });
  EXPECT_EQ(found.largestJump, 0);
  EXPECT_EQ(found.kinks, 0);
  EXPECT_LE(found.localMaxima, 2); // One of handle 0; the rest is highest at both ends.
}

TEST(LineProfile, MeasuresTheHeightOfAJump) {
  const auto found = measure([](double x) { return std::sin(x / 10) + (x > 7.13 ? 0.01 : 0.0); });
  EXPECT_NEAR(found.largestJump, 0.01, 1e-4);
}

TEST(LineProfile, FindsASmallJumpBesideSteepSlopes) {
  const auto found = measure([](double x) { return std::tanh(x + 20) + (x > 7.13 ? 0.01 : 0.0); });
  EXPECT_NEAR(found.largestJump, 0.01, 1e-4);
}

TEST(LineProfile, CountsKinksAndMeasuresThem) {
  const auto found = measure([](double x) { return 0.02 * std::abs(x - 3.3) + 0.05 * std::abs(x + 20.71); });
  EXPECT_EQ(found.largestJump, 0);
  EXPECT_EQ(found.kinks, 2);
  EXPECT_NEAR(found.largestKink, 0.1, 1e-4);
}

TEST(LineProfile, DoesNotTakeASteepSlopeForAJump) {
  const auto found = measure([](double x) { return std::tanh(40 * (x - 0.123)); });
  EXPECT_EQ(found.largestJump, 0);
  EXPECT_EQ(found.kinks, 0);
}

/// Three inside and one at each end.
TEST(LineProfile, CountsMaximaButNotRipplesOfRounding) {
  EXPECT_EQ(measure([](double x) { return std::cos(x / 5) + 1e-9 * std::cos(100 * x); }).localMaxima, 5);
}

TEST(LineProfile, TakesGapsForNoJumps) {
  const auto found = measure([](double x) { return x > 10 && x < 20 ? std::nan("") : 0.001 * x; });
  EXPECT_EQ(found.largestJump, 0);
  EXPECT_EQ(found.report.failures.size(), 39u);
}

} // namespace
} // namespace viscera::coordinates
