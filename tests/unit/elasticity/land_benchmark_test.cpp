#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "elastic_grids.h"
#include "viscera/elasticity/static_solution.h"

/// Problems 1 and 2 of Land et al. 2015, doi:10.1098/rspa.2015.0641, on coarse meshes. The paper compares
/// eleven programs: the range is the one within which we know them to agree (no table was at hand), and
/// the bounds are that range and 1 % more.
namespace viscera::elasticity {
namespace {

constexpr double kBulkKpa = 1e4; ///< Incompressible there.
constexpr double kAllowed = 0.01;

/// Whether `value` is in the range of the programs of the paper, or no farther from it than allowed.
void expectAgreed(double value, double low, double high) {
  const double slack = kAllowed * std::max(std::abs(low), std::abs(high));
  EXPECT_GT(value, low - slack);
  EXPECT_LT(value, high + slack);
}

TEST(LandBenchmark, BarUnderPressureBendsAsTheConsensus) {
  const QuadraticMesh mesh =
      test::elasticGrid({20, 2, 2}, [](const Vec3& p) { return Vec3(10 * p[0], p[1], p[2]); });
  Loads loads;
  for (std::int32_t n = 0; n < mesh.nodes.rows(); ++n)
    if (mesh.nodes(n, 0) < 1e-9)
      for (int axis = 0; axis < 3; ++axis)
        loads.prescribed.push_back({n, axis, 0});
  loads.pressures.push_back({test::facesWhere(mesh, [](const Vec3& p) { return p[2] < 1e-9; }), 0.004});
  const ElasticBody body(mesh, std::make_shared<Guccione>(Guccione::Constants{2, 8, 2, 4}, kBulkKpa));
  Progress progress;
  const StaticSolution solution = solveStatic(body, loads, {}, progress);
  const Eigen::Index end = test::nodeAt(mesh, Vec3(10, 0.5, 1));
  expectAgreed(1 + solution.displacements(end, 2), 4.15, 4.2);
}

/// A quarter of the ellipsoid between 7 x 17 mm and 10 x 20 mm, cut at z = 5 mm. The first two parameters run
/// over a square that is bent to a quarter of a disc around the apex, the third from inside to outside.
Vec3 placeInEllipsoid(const Vec3& at) {
  const double radius = std::max(at[0], at[1]);
  double angle = 0;
  if (radius > 0)
    angle = std::numbers::pi / 4 * (at[0] >= at[1] ? at[1] / at[0] : 2 - at[0] / at[1]);
  const double across = 7 + 3 * at[2], along = 17 + 3 * at[2];
  const double polar = radius * std::acos(-5 / along);
  return {across * std::sin(polar) * std::sin(angle), across * std::sin(polar) * std::cos(angle),
          -along * std::cos(polar)};
}

TEST(LandBenchmark, EllipsoidInflatesAsTheConsensus) {
  const std::array<int, 3> cells = {6, 6, 1};
  const QuadraticMesh square = test::elasticGrid(cells, [](const Vec3& p) { return p; });
  const QuadraticMesh mesh = test::elasticGrid(cells, placeInEllipsoid);
  Loads loads;
  for (std::int32_t n = 0; n < mesh.nodes.rows(); ++n) {
    const bool base = std::max(square.nodes(n, 0), square.nodes(n, 1)) > 1 - 1e-9;
    for (int axis = 0; axis < 3; ++axis) // The base is held, planes of symmetry across themselves.
      if (base || (axis == 0 && square.nodes(n, 1) < 1e-9) || (axis == 1 && square.nodes(n, 0) < 1e-9))
        loads.prescribed.push_back({n, axis, 0});
  }
  loads.pressures.push_back({test::facesWhere(square, [](const Vec3& p) { return p[2] < 1e-9; }), 10});
  const ElasticBody body(mesh, std::make_shared<Guccione>(Guccione::Constants{10, 1, 1, 1}, kBulkKpa));
  Progress progress;
  SolveOptions options;
  options.loadSteps = 4;
  const StaticSolution solution = solveStatic(body, loads, options, progress);
  const auto apex = [&](double z) {
    return z + solution.displacements(test::nodeAt(mesh, Vec3(0, 0, z)), 2);
  };
  expectAgreed(apex(-17), -27, -26.5);
  expectAgreed(apex(-20), -28.5, -28);
}

} // namespace
} // namespace viscera::elasticity
