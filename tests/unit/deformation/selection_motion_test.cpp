#include "viscera/deformation/selection_motion.h"

#include <numbers>

#include <gtest/gtest.h>

namespace viscera::deformation {
namespace {

Points cross() {
  Points points(4, 3);
  points << 10, 0, 0, -10, 0, 0, 0, 10, 0, 0, 0, 10;
  return points;
}

TEST(SelectionMotion, TranslationMovesOnlyTheSelection) {
  const Points moved = translated(cross(), {1, 3}, {1, 2, 3});
  EXPECT_EQ(moved.row(0), cross().row(0));
  EXPECT_EQ(moved.row(1), Eigen::RowVector3d(-9, 2, 3));
}

TEST(SelectionMotion, RotationKeepsDistancesFromTheAxis) {
  const Points moved = rotated(cross(), {0, 1, 2}, Vec3::Zero(), Vec3::UnitZ(), std::numbers::pi / 2);
  EXPECT_LT((moved.row(0) - Eigen::RowVector3d(0, 10, 0)).norm(), 1e-14);
  EXPECT_LT((moved.row(2) - Eigen::RowVector3d(-10, 0, 0)).norm(), 1e-14);
}

TEST(SelectionMotion, ScalingIsAboutTheCenter) {
  const Points moved = scaled(cross(), {0, 1}, {5, 0, 0}, {2, 1, 1});
  EXPECT_EQ(moved.row(0), Eigen::RowVector3d(15, 0, 0));
  EXPECT_EQ(moved.row(1), Eigen::RowVector3d(-25, 0, 0));
}

TEST(SelectionMotion, MirroredDragMovesThePartnerByTheMirroredVector) {
  const MirrorPlane sagittal;
  const auto partners = mirrorPartners(cross(), {0, 2}, sagittal, 1);
  EXPECT_EQ(partners, (std::vector<int>{1, -1}));
  const Points moved = mirroredTranslation(cross(), {0, 2}, partners, sagittal, {1, 2, 3});
  EXPECT_EQ(moved.row(0), Eigen::RowVector3d(11, 2, 3));
  EXPECT_EQ(moved.row(1), Eigen::RowVector3d(-11, 2, 3));
  EXPECT_EQ(moved.row(3), cross().row(3));
}

TEST(SelectionMotion, ASelectedPartnerIsNotMovedTwice) {
  const MirrorPlane sagittal;
  const Points moved = mirroredTranslation(cross(), {0, 1}, {1, 0}, sagittal, {0, 4, 0});
  EXPECT_EQ(moved.row(1), Eigen::RowVector3d(-10, 4, 0));
}

} // namespace
} // namespace viscera::deformation
