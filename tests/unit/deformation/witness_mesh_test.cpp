#include "viscera/deformation/witness_mesh.h"

#include <gtest/gtest.h>

#include "clouds.h"
#include "shapes.h"
#include "viscera/core/error.h"
#include "viscera/deformation/grid_witnesses.h"
#include "viscera/deformation/witness_interpolation.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/volume.h"

namespace viscera::deformation {
namespace {

WitnessMesh oneTetrahedron() {
  WitnessMesh mesh;
  mesh.points = tests::tetrahedron(2, 3, 4).points;
  mesh.tetrahedra.resize(1, 4);
  mesh.tetrahedra << 0, 1, 2, 3;
  mesh.witnesses = 4;
  return mesh;
}

WitnessMesh gridInSphere(int wanted, Threads threads = {}) {
  Progress progress;
  return gridWitnesses(tests::sphere(4, 30, {1, 2, 3}), wanted, progress, threads);
}

TEST(WitnessMesh, KnowsVolumesAndTheOutwardSkin) {
  const WitnessMesh mesh = oneTetrahedron();
  requireUsable(mesh, "test");
  EXPECT_DOUBLE_EQ(tetrahedronVolumes(mesh.points, mesh.tetrahedra)[0], 4);
  EXPECT_DOUBLE_EQ(geometry::volume(mesh.points, skinOf(mesh.tetrahedra)), 4);
}

TEST(WitnessMesh, RefusesWhatCannotBeDrawn) {
  WitnessMesh turned = oneTetrahedron(), flat = turned, beyond = turned, infinite = turned, empty = turned;
  turned.tetrahedra << 1, 0, 2, 3;
  flat.points(3, 2) = 0;
  beyond.tetrahedra(0, 2) = 4;
  infinite.points(1, 1) = std::numeric_limits<double>::infinity();
  empty.witnesses = 0;
  for (const WitnessMesh& mesh : {turned, flat, beyond, infinite, empty})
    EXPECT_THROW(requireUsable(mesh, "test"), DataError);
}

TEST(GridWitnesses, AreAsManyAsWantedAllInsideAndFillTheOrgan) {
  for (const int wanted : {200, 3000, 20'000}) {
    const WitnessMesh mesh = gridInSphere(wanted);
    EXPECT_NEAR(double(mesh.witnesses), wanted, 0.05 * wanted);
    EXPECT_EQ(mesh.witnesses, mesh.points.rows());
    EXPECT_LT((mesh.points.rowwise() - Eigen::RowVector3d(1, 2, 3)).rowwise().norm().maxCoeff(), 30);
    requireUsable(mesh, "test");
  }
  const WitnessMesh fine = gridInSphere(20'000);
  const double ball = 4.0 / 3 * M_PI * 27'000;
  const double filled = tetrahedronVolumes(fine.points, fine.tetrahedra).sum();
  EXPECT_LT(filled, ball);
  EXPECT_GT(filled, 0.85 * ball);
  EXPECT_TRUE(geometry::checkSurface({fine.points, skinOf(fine.tetrahedra), {}}).outward());
}

TEST(GridWitnesses, AreTheSameForAnyNumberOfThreads) {
  const WitnessMesh one = gridInSphere(2000, {1}), three = gridInSphere(2000, {3});
  EXPECT_EQ(one.points, three.points);
  EXPECT_EQ(one.tetrahedra, three.tetrahedra);
}

TEST(GridWitnesses, RefuseASurfaceThatEnclosesNothing) {
  Progress progress;
  geometry::TriangleMesh sheet = tests::box(10, 10, 0);
  EXPECT_THROW(gridWitnesses(sheet, 500, progress), DataError);
  EXPECT_THROW(gridWitnesses({}, 500, progress), DataError);
  progress.cancel();
  EXPECT_THROW(gridWitnesses(tests::box(), 500, progress), Cancelled);
}

TEST(WitnessInterpolation, ReproducesLinearFunctionsInsideAndValuesAtPoints) {
  const WitnessMesh mesh = gridInSphere(3000);
  const Vec3 slope(0.3, -2, 1.5);
  const Values values = (mesh.points * slope).array() + 7;
  Values result;
  const Points inside = tests::cloud(500, 3, 12, {1, 2, 3});
  WitnessInterpolation(mesh, inside)(values, result);
  EXPECT_LT((result - Values((inside * slope).array() + 7)).cwiseAbs().maxCoeff(), 1e-11);
  WitnessInterpolation(mesh, mesh.points)(values, result);
  EXPECT_EQ(result, values);
}

TEST(WitnessInterpolation, TakesTheNearestOutside) {
  const WitnessMesh mesh = gridInSphere(3000);
  const Vec3 slope(0.3, -2, 1.5);
  Values result;
  const geometry::TriangleMesh skin = tests::sphere(3, 31, {1, 2, 3});
  WitnessInterpolation(mesh, skin.points)(mesh.points * slope, result);
  const double spacing = std::cbrt(4.0 / 3 * M_PI * 27'000 / 3000);
  EXPECT_LT((result - Values(skin.points * slope)).cwiseAbs().maxCoeff(), 2 * spacing * slope.norm());
}

TEST(WitnessInterpolation, DoesWithoutTetrahedra) {
  WitnessMesh mesh = oneTetrahedron();
  mesh.tetrahedra.resize(0, 4);
  Values result;
  Points targets(2, 3);
  targets << 1.9, 0.1, 0, 50, 50, 500;
  WitnessInterpolation(mesh, targets)(Values::LinSpaced(4, 0, 3), result);
  EXPECT_EQ(result[0], 1);
  EXPECT_EQ(result[1], 3);
}

} // namespace
} // namespace viscera::deformation
