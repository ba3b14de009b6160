#include "viscera/sequences/stomach_rig.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "simple_stomach.h"
#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

TEST(StomachRig, ringsStandALittleOutsideTheWall) {
  const StomachRig rig = makeStomachRig(test::simpleStomach());
  for (const StomachHandle& handle : rig.handles) {
    if (handle.region == StomachRegion::fixed || handle.region == StomachRegion::farCorner)
      continue;
    const double wall = test::simpleRadius(handle.s);
    EXPECT_GT((handle.position - handle.center).norm(), wall + 2);
    EXPECT_LT((handle.position - handle.center).norm(), 1.2 * wall + 4);
    EXPECT_NEAR(handle.center.z(), -handle.s, 1e-6);
  }
}

TEST(StomachRig, wideRingsHaveMoreHandles) {
  const StomachRig rig = makeStomachRig(test::simpleStomach());
  const auto count = [&](double low, double high) {
    return std::count_if(rig.handles.begin(), rig.handles.end(),
                         [&](const StomachHandle& handle) { return handle.s > low && handle.s < high; });
  };
  EXPECT_EQ(count(20, 24), 13);
  EXPECT_EQ(count(260, 264), 6);
}

TEST(StomachRig, groupsHoldEveryHandleOnceInOrder) {
  const StomachRig rig = makeStomachRig(test::simpleStomach());
  int next = 0;
  for (const HandleGroup& group : rig.groups())
    for (const int handle : group.handles)
      EXPECT_EQ(handle, next++);
  EXPECT_EQ(next, rig.restHandles().rows());
  EXPECT_EQ(rig.groups().size(), 5u);
}

TEST(StomachRig, refusesACentrelineThatLeavesTheStomachOrEndsEarly) {
  StomachAnatomy outside = test::simpleStomach();
  outside.centerline = Centerline({{0, 0, 0}, {90, 0, -160}, {0, 0, -320}});
  EXPECT_THROW(makeStomachRig(outside), DataError);
  StomachAnatomy early = test::simpleStomach();
  early.centerline = Centerline({{0, 0, 0}, {0, 0, -250}});
  EXPECT_THROW(makeStomachRig(early), DataError);
}

} // namespace
} // namespace viscera::sequences
