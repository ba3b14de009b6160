#include "viscera/heart/heart_rig.h"

#include <set>

#include <gtest/gtest.h>

#include "simple_heart.h"
#include "viscera/core/error.h"

namespace viscera::heart {
namespace {

TEST(HeartRig, groupsHoldEveryHandleOnceInOrder) {
  const HeartRig rig = makeHeartRig(test::simpleHeart());
  int next = 0;
  for (const sequences::HandleGroup& group : rig.groups()) {
    EXPECT_FALSE(group.handles.empty()) << group.name;
    for (const int handle : group.handles)
      EXPECT_EQ(handle, next++);
  }
  EXPECT_EQ(next, rig.restHandles().rows());
}

TEST(HeartRig, handlesLieWhereTheirRoleSays) {
  const HeartAnatomy heart = test::simpleHeart();
  const HeartRig rig = makeHeartRig(heart);
  for (const HeartHandle& handle : rig.handles) {
    const double ventricles = heart.ventricles(handle.position);
    switch (handle.role) {
    case HeartRole::leftEndocardium:
      EXPECT_NEAR(handle.place.rho, heart.endocardium.radiusAt(handle.place.c), 5) << handle.place.c;
      EXPECT_LT(ventricles, 0);
      break;
    case HeartRole::epicardium:
      EXPECT_GT(ventricles, 1);
      break;
    case HeartRole::rightFreeWall:
      EXPECT_NEAR(heart.rightCavity(handle.position), 0, 1);
      break;
    case HeartRole::septum:
      EXPECT_NEAR(handle.place.rho, heart.epicardium.radiusAt(handle.place.c), 1e-9);
      break;
    case HeartRole::atrium:
      EXPECT_GT(ventricles, 0);
      break;
    case HeartRole::vessel:
    case HeartRole::farCorner:
      break;
    }
  }
}

TEST(HeartRig, farCornersEncloseEverything) {
  const HeartRig rig = makeHeartRig(test::simpleHeart());
  const std::vector<int> corners = rig.handlesOf(HeartRole::farCorner);
  EXPECT_EQ(corners.size(), 8u);
  const Bounds& box = rig.anatomy.box;
  for (const HeartHandle& handle : rig.handles) {
    EXPECT_TRUE((handle.position.array() >= box.low.array()).all());
    EXPECT_TRUE((handle.position.array() <= box.high.array()).all());
  }
}

TEST(HeartRig, noTwoHandlesShareAPlace) {
  const HeartRig rig = makeHeartRig(test::simpleHeart());
  for (std::size_t i = 0; i < rig.handles.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT((rig.handles[i].position - rig.handles[j].position).norm(), 1) << i << " " << j;
}

TEST(HeartRig, closerSpacingGivesMoreHandles) {
  HeartRigOptions close;
  close.spacing = 14;
  EXPECT_GT(makeHeartRig(test::simpleHeart(), close).handles.size(),
            makeHeartRig(test::simpleHeart()).handles.size() + 50);
}

TEST(HeartRig, isTheSameEveryTime) {
  EXPECT_EQ(makeHeartRig(test::simpleHeart()).restHandles(), makeHeartRig(test::simpleHeart()).restHandles());
}

TEST(HeartRig, refusesAFrameThatMissesTheHeart) {
  HeartAnatomy heart = test::simpleHeart();
  heart.frame = HeartFrame({0, 0, 900}, {1, 0, 0}, {0, 0, 1});
  EXPECT_THROW(makeHeartRig(heart), DataError);
}

} // namespace
} // namespace viscera::heart
