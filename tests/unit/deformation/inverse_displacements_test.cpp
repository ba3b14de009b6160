#include "viscera/deformation/inverse_displacements.h"

#include <gtest/gtest.h>

#include "clouds.h"
#include "shapes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"

namespace viscera::deformation {
namespace {

/// Handles on a sphere, some of them moved so far that the field is not small.
class InverseDisplacements : public testing::Test {
protected:
  InverseDisplacements() {
    handles_.positions = tests::sphere(1, 80).points;
    pose_ = handles_.positions;
    for (Eigen::Index i = 0; i < pose_.rows(); ++i)
      if (pose_(i, 0) > 40)
        pose_.row(i) += Eigen::RowVector3d(15, 20, -10);
  }

  DisplacementGrid field(const GridOptions& grid) {
    return inverseDisplacements(*coordinates::sCelestial(), handles_, pose_, {}, grid, progress_);
  }

  /// Where rest points go, by the coordinates alone.
  Points posed(const Points& rest) {
    Points moved;
    coordinates::sCelestial()->bind(handles_, rest, {}, progress_)->deform(pose_, moved);
    return moved;
  }

  coordinates::HandleSet handles_;
  Points pose_;
  Progress progress_;
};

TEST_F(InverseDisplacements, LeadFromThePosedSpaceBackToRest) {
  const DisplacementGrid grid = field({{{-20, -20, -20}, {20, 20, 20}}, 4}); // Well within the hull.
  EXPECT_EQ(grid.size, Eigen::Vector3i(11, 11, 11));
  EXPECT_EQ(grid.unreached, 0);
  EXPECT_LE(grid.largestErrorMm, 0.004);
  Points places(grid.vectors.rows(), 3);
  for (Eigen::Index row = 0; row < places.rows(); ++row)
    places.row(row) = grid.point(row).transpose();
  const Points rest = places + grid.vectors;
  EXPECT_GT(grid.vectors.rowwise().norm().maxCoeff(), 5) << "something has to move";
  EXPECT_LT((posed(rest) - places).rowwise().norm().maxCoeff(), 0.005)
      << "not the forward field, which would be off by millimetres";
}

TEST_F(InverseDisplacements, GoOnWithoutAJumpOutsideTheHull) {
  const DisplacementGrid grid = field({{{-120, -4, -4}, {120, 4, 4}}, 2});
  EXPECT_EQ(grid.unreached, 0);
  for (Eigen::Index x = 1; x < grid.size[0]; ++x)
    EXPECT_LT((grid.vectors.row(x) - grid.vectors.row(x - 1)).norm(), 2.5) << grid.point(x).transpose();
}

TEST_F(InverseDisplacements, OfARestPoseAreNothing) {
  pose_ = handles_.positions;
  EXPECT_LT(field({{{-90, -90, -90}, {90, 90, 90}}, 20}).vectors.cwiseAbs().maxCoeff(), 1e-9);
}

TEST_F(InverseDisplacements, OfAShiftAreTheShiftBackEverywhere) {
  pose_ = handles_.positions.rowwise() + Eigen::RowVector3d(3, -2, 1);
  const DisplacementGrid grid = field({{{-100, -100, -100}, {100, 100, 100}}, 25});
  EXPECT_LT((grid.vectors.rowwise() - Eigen::RowVector3d(-3, 2, -1)).cwiseAbs().maxCoeff(), 1e-9);
}

TEST_F(InverseDisplacements, RefuseSpacingsThatMakeNoSense) {
  EXPECT_THROW(field({{{0, 0, 0}, {1, 1, 1}}, 0}), UsageError);
  EXPECT_THROW(field({{{-200, -200, -200}, {200, 200, 200}}, 0.1}), UsageError);
  progress_.cancel();
  EXPECT_THROW(field({{{0, 0, 0}, {1, 1, 1}}, 1}), Cancelled);
}

} // namespace
} // namespace viscera::deformation
