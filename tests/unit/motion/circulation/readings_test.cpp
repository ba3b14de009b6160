#include "viscera/circulation/readings.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "solved.h"
#include "viscera/circulation/parameters.h"

namespace viscera::circulation {
namespace {

/// The titles of the numbers that are not normal.
std::vector<std::string> oddOnes(const Indices& indices) {
  std::vector<std::string> odd;
  for (const Reading& reading : readings())
    if (const auto normal = normalOf(reading); normal && !normal->holds(reading.of(indices)))
      odd.push_back(reading.title);
  return odd;
}

bool isOdd(const std::string& scenario, const std::string& title) {
  const auto odd = oddOnes(solve(scenario).indices);
  return std::find(odd.begin(), odd.end(), title) != odd.end();
}

TEST(Readings, AreAllNormalAtRest) {
  EXPECT_EQ(oddOnes(solve("rest").indices), std::vector<std::string>());
}

TEST(Readings, ShowWhatIsWrongInIllness) {
  EXPECT_TRUE(isOdd("heart-failure-reduced-ef", "Ejection fraction"));
  EXPECT_FALSE(isOdd("heart-failure-preserved-ef", "Ejection fraction"));
  EXPECT_TRUE(isOdd("heart-failure-preserved-ef", "Left atrium, mean"));
  EXPECT_TRUE(isOdd("hypertension", "Aorta, systolic"));
  EXPECT_TRUE(isOdd("aortic-stenosis", "Aortic gradient, mean"));
  EXPECT_TRUE(isOdd("mitral-regurgitation", "Mitral regurgitation"));
  EXPECT_TRUE(isOdd("tamponade", "Right atrium, mean"));
}

TEST(Readings, RangesAreWrittenWithTheBoundsTheyHave) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(rangeText({4, 8, {}}, 1).english(), "4.0 - 8.0");
  EXPECT_EQ(rangeText({1200, kInfinity, {}}, 0).english(), "from 1200");
  EXPECT_EQ(rangeText({-kInfinity, 20, {}}, 0).english(), "up to 20");
}

TEST(Readings, EveryControlMarksANormalRangeThatHoldsItsValueAtRest) {
  for (const ParameterInfo& info : parameterInfos())
    if (info.control) {
      ASSERT_TRUE(info.normal) << info.name;
      EXPECT_TRUE(info.normal->holds(info.rest)) << info.name;
      EXPECT_FALSE(info.normal->source.empty()) << info.name;
    }
}

} // namespace
} // namespace viscera::circulation
