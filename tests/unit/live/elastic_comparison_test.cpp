#include "viscera/live/elastic_comparison.h"

#include <cmath>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/core/error.h"

namespace viscera::live {
namespace {

constexpr double kBallRadius = 40, kBallDrag = 4;

/// A ball with a handle beyond each end of the axes, of which the first is dragged.
class ElasticComparisonOfABall : public testing::Test {
protected:
  ElasticComparisonOfABall() : surface_(tests::sphere(2, kBallRadius)), rest_(Points::Zero(6, 3)) {
    for (int i = 0; i < 6; ++i)
      rest_(i, i / 2) = (i % 2 == 0 ? 1.3 : -1.3) * kBallRadius;
    pose_ = rest_;
    pose_(0, 0) += kBallDrag;
  }

  elasticity::ElasticOrgan organ() {
    elasticity::OrganOptions options;
    options.tetrahedra = 200;
    return {surface_, options, material_, progress_};
  }
  ElasticQuestion question() const {
    return {.surface = surface_.points, .posed = surface_.points, .rest = rest_, .pose = pose_};
  }

  Progress progress_;
  geometry::TriangleMesh surface_;
  Points rest_, pose_;
  std::shared_ptr<const elasticity::Material> material_ = std::make_shared<elasticity::NeoHookean>(1, 0.49);
};

TEST_F(ElasticComparisonOfABall, HasTheDistanceOfEachVertex) {
  const ElasticComparison beside = besideElasticity(organ(), question(), progress_);
  EXPECT_EQ(beside.grips.moved, 1);
  ASSERT_EQ(beside.distancesMm.size(), surface_.points.rows());
  for (Eigen::Index v = 0; v < beside.distancesMm.size(); ++v)
    EXPECT_NEAR(beside.distancesMm[v], (beside.elastic.row(v) - surface_.points.row(v)).norm(), 1e-12);
  EXPECT_GT(beside.apart.maxMm, 0.5 * kBallDrag) << "a pose that stays at rest misses the patch";
  EXPECT_LT(beside.apart.maxMm, 1.2 * kBallDrag);
  EXPECT_LE(beside.apart.medianMm, beside.apart.p95Mm);
  EXPECT_LT(beside.apart.medianMm, 0.5 * kBallDrag);
}

TEST_F(ElasticComparisonOfABall, IsNowhereApartFromThePoseThatElasticityMakes) {
  const elasticity::ElasticOrgan ball = organ();
  const Points elastic = besideElasticity(ball, question(), progress_).elastic;
  const ElasticQuestion again{.surface = surface_.points, .posed = elastic, .rest = rest_, .pose = pose_};
  EXPECT_LT(besideElasticity(ball, again, progress_).apart.maxMm, 1e-9);
}

TEST_F(ElasticComparisonOfABall, LetsPatchesMoveAsThePosedSurface) {
  const Points shifted = surface_.points.rowwise() + Eigen::RowVector3d(1, -2, 0.5);
  ElasticQuestion asked{.surface = surface_.points, .posed = shifted, .rest = rest_, .pose = pose_};
  const elasticity::ElasticOrgan ball = organ();
  EXPECT_GT(besideElasticity(ball, asked, progress_).apart.maxMm, 0.5);
  asked.gripSurface = true;
  EXPECT_LT(besideElasticity(ball, asked, progress_).apart.maxMm, 1e-6) << "it moves as a whole";
}

TEST_F(ElasticComparisonOfABall, NeedsAMovedHandle) {
  pose_ = rest_;
  EXPECT_THROW(besideElasticity(organ(), question(), progress_), DataError);
}

TEST_F(ElasticComparisonOfABall, IsSolvedOnMeshesThatGetFiner) {
  const MeshConvergence found = meshConvergence(surface_, material_, {400, 100, 200}, question(), progress_);
  ASSERT_EQ(found.meshes.size(), 3u);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_GT(found.meshes[i].tetrahedra, found.meshes[i - 1].tetrahedra);
    EXPECT_LT(found.meshes[i].edgeMm, found.meshes[i - 1].edgeMm);
  }
  EXPECT_GT(found.meshes[0].fromFinest.medianMm, 0);
  EXPECT_EQ(found.meshes[2].fromFinest.maxMm, 0) << "it is the finest";
  EXPECT_TRUE(std::isfinite(found.order));
  EXPECT_THROW(meshConvergence(surface_, material_, {100}, question(), progress_), UsageError);
}

} // namespace
} // namespace viscera::live
