#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/deformation/grid_witnesses.h"
#include "viscera/live/stress_quantity.h"
#include "viscera/live/witness_sampling.h"

namespace viscera::live {
namespace {

std::string saidOf(std::initializer_list<double> ratios, Eigen::Index count) {
  deformation::StressMap map;
  map.volumeRatio.resize(static_cast<Eigen::Index>(ratios.size()));
  std::copy(ratios.begin(), ratios.end(), map.volumeRatio.data());
  return volumeRemark(map, count).english();
}

TEST(VolumeRemark, SaysByHowMuchTissueIsSqueezedOrSwollenWhereLivingTissueIsNot) {
  EXPECT_EQ(saidOf({1, 0.81, 1.24}, 3), "");
  EXPECT_EQ(saidOf({1, 0.168, 1.1}, 3).find("Tissue is squeezed to 17 % of its volume."), 0U)
      << saidOf({1, 0.168, 1.1}, 3);
  EXPECT_EQ(saidOf({1, 2.5}, 2).find("Tissue is swollen to 250 % of its volume."), 0U);
  EXPECT_EQ(
      saidOf({0.5, 1.5}, 2)
          .find("Tissue is squeezed to 50 % of its volume in one place and swollen to 150 % in another."),
      0U);
  EXPECT_EQ(saidOf({1, 1, 0.2}, 2), "") << "the third one is no witness";
  EXPECT_EQ(saidOf({1, -0.5, std::numeric_limits<double>::quiet_NaN()}, 3), "") << "folded, which is counted";
}

TEST(WitnessesBesideCavities, SayHowManyOfThoseAskedForAreLeft) {
  WitnessOptions options;
  options.wanted = 2000;
  Progress progress;
  WitnessSample sample;
  sample.mesh = std::make_shared<const deformation::WitnessMesh>(
      deformation::gridWitnesses(tests::sphere(3, 30), options.wanted, progress));
  const auto cavity = [](double radius) {
    return std::make_shared<const geometry::TriangleMesh>(tests::sphere(3, radius));
  };
  EXPECT_TRUE(withoutCavities(sample, {cavity(9)}, options).remarks.empty()) << "hardly any are missing";
  const WitnessSample left = withoutCavities(sample, {cavity(24)}, options);
  ASSERT_LT(left.mesh->witnesses, 1700);
  ASSERT_EQ(left.remarks.size(), 1U);
  EXPECT_EQ(left.remarks.front().english().find("There are " + std::to_string(left.mesh->witnesses) +
                                                " witness points of 2000"),
            0U)
      << left.remarks.front().english();
}

} // namespace
} // namespace viscera::live
