#include "viscera/heart/scaled_sequence.h"

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::heart {
namespace {

/// Four handles that swell and shrink, with waves along a course, as a stomach has them, and with keys.
class Waves final : public sequences::Sequence {
public:
  std::string id() const override { return "waves"; }
  Text name() const override { return "Waves"; }
  const Points& restHandles() const override { return rest_; }
  double standardRatePerMinute() const override { return 60; }
  double lowestRatePerMinute() const override { return 30; }
  double highestRatePerMinute() const override { return 90; }
  void poseAt(double seconds, double, Points& pose) const override { pose = (1 + 0.1 * seconds) * rest_; }
  std::vector<sequences::Phase> phases(double) const override { return {}; }
  std::vector<sequences::NamedPlace> course() const override { return {{"cardia", 0}, {"pylorus", 1}}; }
  std::vector<sequences::TravellingMark> travelling(double seconds, double) const override {
    return {{seconds, 0.7}};
  }
  std::vector<double> keys() const override { return {0, 0.5}; }

private:
  Points rest_ = Points::Identity(4, 3);
};

TEST(ScaledSequence, MultipliesPosesAndTellsTheSameWaysAndKeys) {
  const auto standard = std::make_shared<Waves>();
  const ScaledSequence large(standard, 1.4);
  EXPECT_TRUE(large.restHandles().isApprox(1.4 * standard->restHandles(), 1e-15));
  Points pose, standardPose;
  large.poseAt(0.3, 60, pose);
  standard->poseAt(0.3, 60, standardPose);
  EXPECT_TRUE(pose.isApprox(1.4 * standardPose, 1e-15));
  ASSERT_EQ(large.course().size(), 2u);
  EXPECT_EQ(large.course().back().name, "pylorus");
  ASSERT_EQ(large.travelling(0.25, 60).size(), 1u);
  EXPECT_EQ(large.travelling(0.25, 60)[0].place, 0.25);
  EXPECT_EQ(large.travelling(0.25, 60)[0].strength, 0.7);
  EXPECT_EQ(large.keys(), (std::vector<double>{0, 0.5}));
  EXPECT_EQ(large.heart(), nullptr) << "the standard sequence has none";
}

TEST(ScaledSequence, RefusesASizeThatIsNoPositiveNumber) {
  const auto standard = std::make_shared<Waves>();
  for (const double size : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(ScaledSequence(standard, size), DataError) << size;
}

} // namespace
} // namespace viscera::heart
