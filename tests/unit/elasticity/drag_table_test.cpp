#include "viscera/elasticity/drag_table.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"

namespace viscera::elasticity {
namespace {

constexpr double kToyRadius = 40;

/// A ball whose triangles are those of its tetrahedra, so that its vertices are nodes.
DragScene toyScene(DragOptions options = {}) {
  const geometry::TriangleMesh ball = tests::sphere(2, kToyRadius);
  options.organ.tetrahedra = 900;
  options.handles = 12;
  options.witnesses = 40;
  Progress progress;
  return dragScene("ball", ball, hullAround(ball.points, options.handles, options.gap), options, progress);
}

TEST(DragTable, FindsNoDifferenceWhereSkinAndHandlesMoveAffinely) {
  const DragScene scene = toyScene();
  Eigen::Matrix3d map;
  map << 1.06, 0.08, 0, 0.02, 0.97, 0.03, 0, 0.05, 0.99;
  const auto moved = [&](const Points& points) -> Points { return points * map.transpose(); };
  const Points& nodes = scene.elastic->body().mesh().nodes;
  Loads loads;
  for (const std::int32_t node : scene.elastic->skin())
    for (int axis = 0; axis < 3; ++axis)
      loads.prescribed.push_back({node, axis, (moved(nodes) - nodes)(node, axis)});
  Progress progress;
  const StaticSolution solution = solveStatic(scene.elastic->body(), loads, {}, progress);
  SolvedScene solved{scene, {readDrag(scene, moved(scene.handles.positions), solution)}};

  std::vector<coordinates::SystemVariant> variants;
  for (const auto& system : coordinates::builtInSystems())
    if (system->traits().affine && system->traits().everywhere && !system->traits().needsTetrahedra &&
        system->id() != "numerical-integration")
      variants.push_back({system, {}});
  ASSERT_GE(variants.size(), 8U);
  for (const SystemDrags& system : compareDrags(variants, {solved}, {}, progress)) {
    ASSERT_EQ(system.drags(), 1U) << system.id << ": " << system.organs[0].refusal;
    EXPECT_LT(system.middle().p95, 0.01) << system.id;
    EXPECT_LT(system.middle().relative, 0.01) << system.id;
  }
}

TEST(DragTable, DragsTheSameHandlesForAnyNumberOfThreads) {
  DragOptions options;
  options.drags = 2;
  const DragScene scene = toyScene(options);
  Progress progress;
  const auto one = solveDrags({scene}, options, Threads{1}, progress);
  const auto two = solveDrags({scene}, options, Threads{2}, progress);
  ASSERT_EQ(one[0].solved(), 2U);
  EXPECT_NE(one[0].drags[0].handle, one[0].drags[1].handle);
  for (std::size_t d = 0; d < 2; ++d) {
    EXPECT_EQ(one[0].drags[d].displacements, two[0].drags[d].displacements);
    EXPECT_EQ(one[0].drags[d].stress, two[0].drags[d].stress);
    EXPECT_NEAR(one[0].drags[d].dragMm, 0.05 * scene.diagonalMm, 1e-9);
    EXPECT_GT(one[0].drags[d].displacements.rowwise().norm().maxCoeff(), 0.5 * one[0].drags[d].dragMm);
  }
  progress.cancel();
  EXPECT_THROW(solveDrags({scene}, options, {}, progress), Cancelled);
}

TEST(DragTable, NamesASystemThatCannotPoseAndWhy) {
  DragOptions options;
  options.drags = 1;
  Progress progress;
  auto solved = solveDrags({toyScene(options)}, options, {}, progress);
  solved[0].scene.handles.cage.resize(0, 3);
  solved[0].scene.points.row(0) << 500, 0, 0;
  for (const auto& system : coordinates::builtInSystems())
    if (system->id() == "s-celestial") {
      const SystemDrags found = compareDrags({{system, {}}}, solved, {}, progress)[0];
      EXPECT_NE(found.organs[0].refusal.find("have no coordinates"), std::string::npos);
      EXPECT_EQ(found.drags(), 0U);
      EXPECT_TRUE(std::isnan(found.middle().median));
    }
}

TEST(DragTable, EnclosesPointsWithCornersOfOneHull) {
  const Points box = tests::box(100, 40, 20).points;
  const coordinates::HandleSet handles = hullAround(box, 30, 0.03);
  EXPECT_EQ(handles.positions.rows(), 30);
  EXPECT_EQ(handles.cage.rows(), 2 * 30 - 4) << "triangles of a closed surface with 30 corners";
  EXPECT_THROW(hullAround(box, 3, 0.03), DataError);
}

TEST(DragTable, CorrelatesRanks) {
  Values a(4), b(4), even = Values::Constant(4, 2.0);
  a << 1, 2, 3, 10;
  b << 2, 4, 4, 5;
  EXPECT_DOUBLE_EQ(rankCorrelation(a, a), 1);
  EXPECT_DOUBLE_EQ(rankCorrelation(a, -a), -1);
  EXPECT_NEAR(rankCorrelation(a, b), 0.948683298, 1e-8) << "equal numbers share their rank";
  EXPECT_TRUE(std::isnan(rankCorrelation(a, even)));
}

} // namespace
} // namespace viscera::elasticity
