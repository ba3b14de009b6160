#include "viscera/elasticity/elastic_organ.h"

#include <memory>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/core/error.h"

namespace viscera::elasticity {
namespace {

constexpr double kRadius = 40;

/// A ball with a handle beyond each end of the axes.
class ElasticBall : public testing::Test {
protected:
  static void SetUpTestSuite() {
    Progress progress;
    surface_ = tests::sphere(3, kRadius);
    OrganOptions options;
    options.tetrahedra = 400;
    organ_ =
        std::make_unique<ElasticOrgan>(surface_, options, std::make_shared<NeoHookean>(6, 0.49), progress);
  }
  static void TearDownTestSuite() { organ_.reset(); }

  static Points handles() {
    Points rest = Points::Zero(6, 3);
    for (int i = 0; i < 6; ++i)
      rest(i, i / 2) = (i % 2 == 0 ? 1.3 : -1.3) * kRadius;
    return rest;
  }

  /// Where the surface's vertices go.
  static Points moved(const Grips& grips, StaticSolution* solution = nullptr) {
    Progress progress;
    const StaticSolution solved = solveStatic(organ_->body(), {grips.prescribed, {}}, {}, progress);
    if (solution)
      *solution = solved;
    return organ_->atSurface(solved.displacements);
  }

  static inline geometry::TriangleMesh surface_;
  static inline std::unique_ptr<ElasticOrgan> organ_;
};

TEST_F(ElasticBall, IsFilledWithAboutAsManyTetrahedraAsAskedFor) {
  EXPECT_GT(organ_->body().mesh().tetrahedra.rows(), 200);
  EXPECT_LT(organ_->body().mesh().tetrahedra.rows(), 1200);
  EXPECT_GT(organ_->body().volumeMm3(), 0.85 * 4.18879 * kRadius * kRadius * kRadius);
}

TEST_F(ElasticBall, MovesAsAWholeWithAllItsHandles) {
  Points pose = handles();
  const Eigen::RowVector3d shift(3, -5, 7);
  pose.rowwise() += shift;
  StaticSolution solution;
  const Grips grips = gripsOf(*organ_, handles(), pose, {});
  const Points there = moved(grips, &solution);
  EXPECT_EQ(grips.moved, 6);
  EXPECT_NEAR(grips.dragMm, shift.norm(), 1e-12);
  EXPECT_LT((there.rowwise() - shift).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_NEAR(solution.smallestJacobian, 1, 1e-6);
  EXPECT_NEAR(solution.energyMj, 0, 1e-9);
}

TEST_F(ElasticBall, FollowsADraggedHandleAndStaysWhereOthersHoldIt) {
  Points pose = handles();
  pose(0, 0) += 8;
  StaticSolution solution;
  const Grips grips = gripsOf(*organ_, handles(), pose, {});
  const Points there = moved(grips, &solution);
  EXPECT_EQ(grips.moved, 1);
  EXPECT_EQ(grips.held, 5);
  for (Eigen::Index v = 0; v < there.rows(); ++v) {
    if (surface_.points(v, 0) > 0.99 * kRadius) {
      EXPECT_NEAR(there(v, 0), 8, 0.5) << v;
    }
    if (surface_.points(v, 0) < -0.99 * kRadius) {
      EXPECT_LT(there.row(v).norm(), 0.5) << v;
    }
  }
  EXPECT_GT(solution.smallestJacobian, 0.5);
  EXPECT_GT(solution.energyMj, 0);
}

TEST_F(ElasticBall, FollowsAsAWholeWhereOthersAreFree) {
  Points pose = handles();
  pose(0, 0) += 8;
  GripOptions options;
  options.others = GripOptions::Others::free;
  const Grips grips = gripsOf(*organ_, handles(), pose, options);
  EXPECT_EQ(grips.held, 0);
  EXPECT_LT((moved(grips).rowwise() - Eigen::RowVector3d(8, 0, 0)).cwiseAbs().maxCoeff(), 1e-6);
}

TEST_F(ElasticBall, HoldsNothingBesideAMovedPatch) {
  Points rest(7, 3), pose;
  rest << handles(), 1.5 * handles().row(0); // Farther out above the same place.
  pose = rest;
  pose(6, 1) += 5;
  const Grips grips = gripsOf(*organ_, rest, pose, {});
  EXPECT_EQ(grips.moved, 1);
  EXPECT_EQ(grips.held, 5);
  int moving = 0;
  for (const Prescribed& one : grips.prescribed)
    moving += one.displacementMm == 5;
  EXPECT_GE(moving, 3);
}

TEST_F(ElasticBall, HasNoGripsWhereNoHandleMoves) {
  EXPECT_THROW(gripsOf(*organ_, handles(), handles(), {}), DataError);
}

TEST(ElasticOrgan, RefusesAnOpenSurface) {
  geometry::TriangleMesh open = tests::sphere(2, kRadius);
  open.triangles.conservativeResize(open.triangles.rows() - 1, 3);
  Progress progress;
  EXPECT_THROW(ElasticOrgan(open, {}, std::make_shared<NeoHookean>(6, 0.49), progress), DataError);
}

} // namespace
} // namespace viscera::elasticity
