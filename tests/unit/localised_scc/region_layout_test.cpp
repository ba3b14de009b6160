#include "viscera/localised_scc/region_layout.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "group_scenes.h"
#include "viscera/core/error.h"

namespace viscera::localised_scc {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

RegionLayout layoutOf(const std::string& scene, double offset = 8) {
  for (const auto& candidate : tests::groupScenes())
    if (candidate.name == scene)
      return RegionLayout(tests::groupsOfBoxes(candidate.boxes), offset);
  throw std::logic_error(scene);
}

std::string messageOf(const coordinates::HandleSet& handles) {
  try {
    const RegionLayout layout(handles, 5);
  } catch (const DataError& error) {
    return error.what();
  }
  return {};
}

TEST(RegionLayout, ZonesOfAFaceAnEdgeAndAPointAreFound) {
  EXPECT_EQ(layoutOf("ZoneIsAFace").zones().at(0).parts.at(0).common.dimension(), 2);
  EXPECT_EQ(layoutOf("ZoneIsAnEdge").zones().at(0).parts.at(0).common.dimension(), 1);
  EXPECT_EQ(layoutOf("ZoneIsAPoint").zones().at(0).parts.at(0).common.dimension(), 0);
}

TEST(RegionLayout, ThreeRegionsThatMeetShareOneZoneForAllOfThem) {
  const auto layout = layoutOf("ThreeMeetInOnePlace");
  ASSERT_EQ(layout.zones().size(), 1u);
  EXPECT_THAT(layout.zones()[0].regions, ElementsAre(0, 1, 2));
  EXPECT_EQ(layout.zones()[0].parts.size(), 3u);
}

TEST(RegionLayout, AChainHasAZoneALink) {
  const auto layout = layoutOf("ChainOfFour");
  ASSERT_EQ(layout.zones().size(), 3u);
  EXPECT_THAT(layout.zones()[1].regions, ElementsAre(1, 2));
}

TEST(RegionLayout, SharesAddUpToOneAndAreNoneOutside) {
  const auto layout = layoutOf("TwoOverlap");
  for (double x = 1; x < 109; x += 0.7) {
    const auto shares = layout.shares({x, 20, 20});
    double sum = 0;
    for (const auto& share : shares)
      sum += share.weight;
    EXPECT_NEAR(sum, 1, 1e-14) << "at x = " << x;
  }
  EXPECT_TRUE(layout.shares({200, 0, 0}).empty());
}

TEST(RegionLayout, FarFromAZoneOnlyTheOwnRegionCounts) {
  const auto shares = layoutOf("TwoOverlap").shares({10, 20, 20});
  ASSERT_EQ(shares.size(), 1u);
  EXPECT_EQ(shares[0].set, 0);
}

TEST(RegionLayout, CutsAnOffsetBeyondItsBoundAndSaysSo) {
  const auto layout = layoutOf("TwoOverlap", 500);
  EXPECT_NEAR(layout.regions()[0].offsetBound, 5, 1e-6); // From (60, 40, 0) to the zone's edge at z = 5.
  EXPECT_LT(layout.regions()[0].offset, layout.regions()[0].offsetBound);
  EXPECT_THAT(inEnglish(layout.notes()), testing::Contains(HasSubstr("'box 1' is cut to")));
  EXPECT_THAT(inEnglish(layoutOf("TwoOverlap", 4).notes()), testing::IsEmpty());
}

TEST(RegionLayout, WithoutGroupsAllHandlesAreOneRegion) {
  auto handles = tests::groupsOfBoxes({{{0, 0, 0}, {1, 1, 1}}});
  handles.groups.clear();
  const RegionLayout layout(handles, 1);
  EXPECT_EQ(layout.regions().size(), 1u);
  EXPECT_TRUE(layout.zones().empty());
}

TEST(RegionLayout, NamesAGroupThatIsTooSmallOrFlat) {
  auto handles = tests::groupsOfBoxes({{{0, 0, 0}, {1, 1, 1}}, {{0.5, 0, 0}, {2, 1, 1}}});
  auto small = handles;
  small.groups[1].handles.resize(3);
  EXPECT_THAT(messageOf(small), HasSubstr("group 'box 2': It has 3 handles"));
  auto flat = handles;
  flat.groups[0].handles = {0, 1, 2, 3};
  EXPECT_THAT(messageOf(flat), HasSubstr("group 'box 1': All its handles lie in one plane"));
  auto wrong = handles;
  wrong.groups[0].handles.push_back(99);
  EXPECT_THAT(messageOf(wrong), HasSubstr("handle 99"));
}

TEST(RegionLayout, SaysHowManyHandlesAreInNoGroup) {
  auto handles = tests::groupsOfBoxes({{{0, 0, 0}, {1, 1, 1}}, {{5, 5, 5}, {6, 6, 6}}});
  handles.groups.pop_back();
  EXPECT_THAT(inEnglish(RegionLayout(handles, 1).notes()),
              testing::Contains(HasSubstr("8 handles are in no group")));
}

} // namespace
} // namespace viscera::localised_scc
