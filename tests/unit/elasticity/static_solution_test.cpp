#include "viscera/elasticity/static_solution.h"

#include <algorithm>
#include <memory>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "elastic_grids.h"

namespace viscera::elasticity {
namespace {

constexpr double kPatchTolerance = 1e-10; ///< Of displacements, by the body's size.

/// A block with crooked corners, all of whose surface moves as the matrix `f` says.
void expectHomogeneous(const Eigen::Matrix3d& f, double poisson) {
  const auto crooked = [](const Vec3& p) {
    const bool inside = p.minCoeff() > 0.1 && p.maxCoeff() < 0.9;
    return Vec3(p + (inside ? Vec3(0.05 * p[1], -0.04, 0.03 * p[0]) : Vec3::Zero()));
  };
  QuadraticMesh mesh = test::elasticGrid({2, 2, 2}, [](const Vec3& p) { return p; });
  Points corners = mesh.nodes.topRows(mesh.corners);
  for (Eigen::Index n = 0; n < corners.rows(); ++n)
    corners.row(n) = crooked(corners.row(n).transpose()).transpose();
  mesh = quadraticMesh(corners, mesh.tetrahedra.leftCols<4>());
  Loads loads;
  for (std::int32_t n = 0; n < mesh.nodes.rows(); ++n) {
    const Vec3 at = mesh.nodes.row(n);
    if (at.minCoeff() < 1e-9 || at.maxCoeff() > 1 - 1e-9)
      for (int axis = 0; axis < 3; ++axis)
        loads.prescribed.push_back({n, axis, (f * at - at)[axis]});
  }
  const ElasticBody body(mesh, std::make_shared<NeoHookean>(5, poisson));
  Progress progress;
  SolveOptions options;
  options.tolerance = 1e-12;
  const StaticSolution solution = solveStatic(body, loads, options, progress);
  const Points wanted = mesh.nodes * (f - Eigen::Matrix3d::Identity()).transpose();
  EXPECT_LT((solution.displacements - wanted).cwiseAbs().maxCoeff(), kPatchTolerance);
  EXPECT_NEAR(solution.smallestJacobian, f.determinant(), kPatchTolerance);
  EXPECT_NEAR(solution.largestJacobian, f.determinant(), kPatchTolerance);
}

TEST(StaticSolution, ReproducesHomogeneousDeformations) {
  Eigen::Matrix3d stretch, shear;
  stretch << 1.2, 0.1, 0, 0.05, 0.95, 0, 0, 0.1, 1.1;
  shear << 1, 0.3, 0, 0, 1, 0, 0, 0, 1;
  expectHomogeneous(stretch, 0.3);
  expectHomogeneous(shear, 0.499);
}

/// A bar of 10 x 1 x 1 mm along x, in `cells` boxes, whose first end is held.
struct Bar {
  QuadraticMesh mesh;
  Loads loads;
};

Bar heldBar(const std::array<int, 3>& cells) {
  Bar bar{test::elasticGrid(cells, [](const Vec3& p) { return Vec3(10 * p[0], p[1], p[2]); }), {}};
  for (std::int32_t n = 0; n < bar.mesh.nodes.rows(); ++n)
    if (bar.mesh.nodes(n, 0) < 1e-9)
      for (int axis = 0; axis < 3; ++axis)
        bar.loads.prescribed.push_back({n, axis, 0});
  return bar;
}

TEST(StaticSolution, BendsACantileverAsBeamTheorySays) {
  // Pressure q on a face of width 1 mm: w = q L^4 / (8 E I) + q L^2 / (2 k G A), Timoshenko, k = 10 (1 + nu)
  // / (12 + 11 nu) (Cowper 1966, doi:10.1115/1.3625046).
  constexpr double young = 1000, poisson = 0.3, q = 1e-5, length = 10;
  Bar bar = heldBar({16, 2, 2});
  bar.loads.pressures.push_back({test::facesWhere(bar.mesh, [](const Vec3& p) { return p[2] < 1e-9; }), q});
  const ElasticBody body(bar.mesh, std::make_shared<NeoHookean>(young, poisson));
  Progress progress;
  const StaticSolution solution = solveStatic(body, bar.loads, {}, progress);
  constexpr double inertia = 1.0 / 12, shear = young / (2 * (1 + poisson));
  constexpr double k = 10 * (1 + poisson) / (12 + 11 * poisson);
  constexpr double theory =
      q * length * length * length * length / (8 * young * inertia) + q * length * length / (2 * k * shear);
  const double end = solution.displacements(test::nodeAt(bar.mesh, Vec3(10, 0.5, 0.5)), 2);
  // Theory lets the held end grow across; held in all directions it is stiffer by somewhat less than 2 %.
  EXPECT_NEAR(end, theory, 0.02 * theory);
}

TEST(StaticSolution, KeepsTheVolumeOfANearlyIncompressibleBar) {
  Bar bar = heldBar({8, 1, 1});
  for (std::int32_t n = 0; n < bar.mesh.nodes.rows(); ++n)
    if (bar.mesh.nodes(n, 0) > 10 - 1e-9) {
      bar.loads.prescribed.push_back({n, 0, 0});
      bar.loads.prescribed.push_back({n, 2, 3.0});
    }
  const ElasticBody body(bar.mesh, std::make_shared<NeoHookean>(6, 0.499));
  Progress progress;
  const StaticSolution solution = solveStatic(body, bar.loads, {}, progress);
  double volume = 0;
  for (Eigen::Index t = 0; t < bar.mesh.tetrahedra.rows(); ++t)
    for (const LocalState& at : body.statesOf(t, solution.state))
      volume += at.weightMm3 * at.gradient.determinant();
  EXPECT_NEAR(volume / body.volumeMm3(), 1, 2e-3);
  EXPECT_GT(solution.smallestJacobian, 0.85);
  EXPECT_LT(solution.largestJacobian, 1.15);
  EXPECT_GT(solution.energyMj, 0);
}

TEST(StaticSolution, IsTheSameForAnyNumberOfThreads) {
  Bar bar = heldBar({4, 1, 1});
  bar.loads.pressures.push_back(
      {test::facesWhere(bar.mesh, [](const Vec3& p) { return p[2] < 1e-9; }), 0.002});
  const ElasticBody body(bar.mesh, std::make_shared<NeoHookean>(6, 0.49));
  Progress progress;
  SolveOptions one, several;
  one.threads = Threads{1};
  several.threads = Threads{4};
  EXPECT_EQ(solveStatic(body, bar.loads, one, progress).state,
            solveStatic(body, bar.loads, several, progress).state);
}

TEST(StaticSolution, SaysUpToWhereThereWasAnEquilibriumAndCanBeCancelled) {
  Bar bar = heldBar({2, 1, 1});
  for (std::int32_t n = 0; n < bar.mesh.nodes.rows(); ++n)
    if (bar.mesh.nodes(n, 0) > 10 - 1e-9)
      for (int axis = 0; axis < 3; ++axis)
        bar.loads.prescribed.push_back({n, axis, axis == 0 ? -20.0 : 0.0}); // Through the other end.
  const ElasticBody body(bar.mesh, std::make_shared<NeoHookean>(6, 0.45));
  Progress progress;
  SolveOptions options;
  options.smallestStep = 0.02;
  try {
    solveStatic(body, bar.loads, options, progress);
    ADD_FAILURE() << "a bar was pushed through its own end";
  } catch (const NoEquilibrium& none) {
    EXPECT_LT(none.reached(), 0.6);
  }
  progress.cancel();
  EXPECT_THROW(solveStatic(body, bar.loads, options, progress), Cancelled);
}

TEST(StaticSolution, RefusesANodeThatDoesNotExist) {
  Bar bar = heldBar({1, 1, 1});
  bar.loads.prescribed.push_back({100000, 0, 0});
  const ElasticBody body(bar.mesh, std::make_shared<NeoHookean>(6, 0.45));
  Progress progress;
  EXPECT_THROW(solveStatic(body, bar.loads, {}, progress), DataError);
}

} // namespace
} // namespace viscera::elasticity
