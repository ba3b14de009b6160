#include "viscera/heart/heart_motion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "simple_heart.h"

namespace viscera::heart {
namespace {

HeartState endSystole() {
  HeartState state;
  state.emptying = 1;
  state.rightEmptying = 1;
  state.leftPart = 55 / 130.5;
  state.rightPart = 66.0 / 138;
  state.twist = 1;
  return state;
}

class HeartMotionTest : public ::testing::Test {
protected:
  HeartMotion motion_{makeHeartRig(test::simpleHeart())};
  Points rest_ = motion_.rig().restHandles();
  Points pose_;

  Vec3 displacement(int handle) const { return (pose_.row(handle) - rest_.row(handle)).transpose(); }
};

TEST_F(HeartMotionTest, leavesARestingHeartAlone) {
  motion_.pose(HeartState{}, pose_);
  EXPECT_LT((pose_ - rest_).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_F(HeartMotionTest, baseDescendsWhileTheApexStays) {
  const HeartState state = endSystole();
  motion_.pose(state, pose_);
  const Vec3 axis = motion_.rig().anatomy.frame.towardsApex();
  for (const int handle : motion_.rig().handlesOf(HeartRole::epicardium)) {
    const HeartPoint& place = motion_.rig().handles[static_cast<std::size_t>(handle)].place;
    const double down = displacement(handle).dot(axis);
    if (place.c < 0) {
      EXPECT_GT(down, 12);
    }
    if (place.c > motion_.rig().anatomy.length) {
      EXPECT_LT(displacement(handle).norm(), 1e-12);
    }
    EXPECT_GE(down, 0);
  }
  EXPECT_NEAR(motion_.descent(state, M_PI, 0), 12.5, 0.1);
  EXPECT_NEAR(motion_.descent(state, 0.436, 0), 21.5, 0.1);
}

TEST_F(HeartMotionTest, wallOfTheLeftVentricleKeepsItsVolume) {
  // A slice of the wall between the cavity and any layer of it: its area times its thickness along the axis
  // stays.
  const HeartState state = endSystole();
  const HeartShell& cavity = motion_.rig().anatomy.endocardium;
  for (const double c : {5.0, 30.0, 60.0, 80.0}) {
    const double inner = cavity.radiusAt(c);
    for (const double rho : {inner + 2, inner + 6, inner + 11}) {
      const double before = rho * rho - inner * inner;
      const double innerAfter = motion_.wallRho(state, inner, c);
      const double after = std::pow(motion_.wallRho(state, rho, c), 2) - innerAfter * innerAfter;
      EXPECT_NEAR(after * motion_.shortening(state), before, 1e-9 * before) << c << " " << rho;
    }
  }
}

TEST_F(HeartMotionTest, heavierMuscleLiesAroundTheSameCavity) {
  HeartState heavy = endSystole();
  heavy.muscle = 1.4;
  const HeartState healthy = endSystole();
  EXPECT_EQ(motion_.leftScale(heavy), motion_.leftScale(healthy));
  const double inner = motion_.rig().anatomy.endocardium.radiusAt(30);
  EXPECT_EQ(motion_.wallRho(heavy, inner, 30), motion_.wallRho(healthy, inner, 30));
  const auto section = [&](const HeartState& state) {
    return std::pow(motion_.wallRho(state, inner + 8, 30), 2) -
           std::pow(motion_.wallRho(state, inner, 30), 2);
  };
  EXPECT_NEAR(section(heavy) / section(healthy), 1.4, 1e-9);
}

TEST_F(HeartMotionTest, cavityScaleGivesTheVolumeOfAnEllipsoid) {
  const HeartState state = endSystole();
  EXPECT_NEAR(std::pow(motion_.leftScale(state), 2) * motion_.shortening(state), state.leftPart, 1e-12);
}

TEST_F(HeartMotionTest, wallThickensInSystole) {
  const HeartState state = endSystole();
  const double inner = motion_.rig().anatomy.endocardium.radiusAt(30);
  const double thickness = motion_.wallRho(state, 36, 30) - motion_.wallRho(state, inner, 30);
  EXPECT_GT(thickness, 1.2 * (36 - inner));
}

TEST_F(HeartMotionTest, wallIsContinuousWhereTheCavityEnds) {
  const HeartState state = endSystole();
  const double inner = motion_.rig().anatomy.endocardium.radiusAt(30);
  EXPECT_NEAR(motion_.wallRho(state, inner - 1e-9, 30), motion_.wallRho(state, inner + 1e-9, 30), 1e-7);
}

TEST_F(HeartMotionTest, rightFreeWallComesCloserToTheSeptum) {
  const HeartState state = endSystole();
  motion_.pose(state, pose_);
  const HeartAnatomy& heart = motion_.rig().anatomy;
  for (const int row : motion_.rig().handlesOf(HeartRole::rightFreeWall)) {
    const HeartPoint before = motion_.rig().handles[static_cast<std::size_t>(row)].place;
    const HeartPoint after = heart.frame.cylindrical(pose_.row(row).transpose());
    const double septum = heart.epicardium.radiusAt(before.c);
    const double septumAfter = motion_.wallRho(state, septum, before.c);
    EXPECT_LT(after.rho - septumAfter, 0.8 * (before.rho - septum));
    EXPECT_GT(after.rho - septumAfter, 0.3 * (before.rho - septum));
  }
}

TEST_F(HeartMotionTest, gainsMoveOnlyTheWallOfTheirCavity) {
  HeartState state = endSystole();
  Points plain;
  motion_.pose(state, plain);
  state.leftGain = 0.9;
  state.rightShift = -0.1;
  motion_.pose(state, pose_);
  for (Eigen::Index i = 0; i < pose_.rows(); ++i) {
    const HeartHandle& handle = motion_.rig().handles[static_cast<std::size_t>(i)];
    const bool wall = (handle.role == HeartRole::leftEndocardium && handle.place.rho > 0) ||
                      handle.role == HeartRole::rightFreeWall;
    EXPECT_EQ((pose_.row(i) - plain.row(i)).norm() > 1e-9, wall) << i;
  }
}

TEST_F(HeartMotionTest, baseAndApexTurnAgainstEachOther) {
  HeartState state;
  state.twist = 1;
  motion_.pose(state, pose_);
  const HeartFrame& frame = motion_.rig().anatomy.frame;
  for (const int row : motion_.rig().handlesOf(HeartRole::epicardium)) {
    const HeartPoint before = motion_.rig().handles[static_cast<std::size_t>(row)].place;
    if (before.rho < 1)
      continue;
    double turn = frame.cylindrical(pose_.row(row).transpose()).phi - before.phi;
    turn = std::remainder(turn, 2 * M_PI);
    if (before.c <= 0) {
      EXPECT_NEAR(turn, -0.070, 1e-9);
    }
    if (before.c > 70) {
      EXPECT_GT(turn, 0.1);
    }
  }
}

TEST_F(HeartMotionTest, atriaContractTowardsTheirCentreAndFillInSystole) {
  const auto meanDistance = [&](const HeartState& state) {
    motion_.pose(state, pose_);
    double sum = 0;
    for (const int row : motion_.rig().handlesOf(HeartRole::atrium))
      sum +=
          (pose_.row(row).transpose() - motion_.rig().handles[static_cast<std::size_t>(row)].center).norm();
    return sum;
  };
  const double atRest = meanDistance(HeartState{});
  HeartState contracted;
  contracted.atrialContraction = 1;
  EXPECT_LT(meanDistance(contracted), 0.95 * atRest);
  EXPECT_GT(meanDistance(endSystole()), 1.05 * atRest);
}

TEST_F(HeartMotionTest, farCornersAndCutVesselsStay) {
  motion_.pose(endSystole(), pose_);
  for (const int row : motion_.rig().handlesOf(HeartRole::farCorner))
    EXPECT_EQ(displacement(row).norm(), 0);
  for (const int row : motion_.rig().handlesOf(HeartRole::vessel)) {
    const double follow = motion_.rig().handles[static_cast<std::size_t>(row)].follow;
    if (follow == 0) {
      EXPECT_EQ(displacement(row).norm(), 0);
    } else {
      EXPECT_GT(displacement(row).norm(), 5);
    }
  }
}

} // namespace
} // namespace viscera::heart
