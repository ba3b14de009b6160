#include "viscera/geometry/close_holes.h"

#include <vector>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/volume.h"

namespace viscera::geometry {
namespace {

/// The mesh without the triangles for which `gone` says so.
template <class Gone>
TriangleMesh withoutWhere(TriangleMesh mesh, Gone gone) {
  std::vector<Eigen::Vector3i> kept;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    if (!gone(t, mesh))
      kept.push_back(mesh.triangles.row(t).transpose());
  mesh.triangles.resize(static_cast<Eigen::Index>(kept.size()), 3);
  for (std::size_t i = 0; i < kept.size(); ++i)
    mesh.triangles.row(static_cast<Eigen::Index>(i)) = kept[i].transpose();
  return mesh;
}

double highest(const TriangleMesh& mesh, Eigen::Index t) {
  return std::max({mesh.points(mesh.triangles(t, 0), 2), mesh.points(mesh.triangles(t, 1), 2),
                   mesh.points(mesh.triangles(t, 2), 2)});
}

TEST(CloseHoles, AMissingSideOfABoxIsFlatAgainAndTheVolumeExact) {
  const TriangleMesh box = tests::box(2, 3, 4);
  const auto open = withoutWhere(box, [](Eigen::Index t, const TriangleMesh&) { return t < 2; });
  ASSERT_EQ(checkSurface(open).boundaryEdges, 4);
  const ClosedSurface closed = closeHoles(open);
  EXPECT_EQ(closed.holes, 1);
  const SurfaceReport report = checkSurface(closed.mesh);
  EXPECT_TRUE(report.closed());
  EXPECT_TRUE(report.manifold());
  EXPECT_NEAR(report.volumeMm3, 24, 1e-13);
  ASSERT_EQ(closed.rims.size(), 1U);
  double around = 0;
  const std::vector<std::int32_t>& rim = closed.rims.front();
  for (std::size_t i = 0; i < rim.size(); ++i)
    around += (box.points.row(rim[(i + 1) % rim.size()]) - box.points.row(rim[i])).norm();
  EXPECT_NEAR(around, 10, 1e-13) << "the sides of the missing one, 2 by 3, in their order";
}

TEST(CloseHoles, AMissingTriangleComesBackWithoutANewPoint) {
  const TriangleMesh ball = tests::sphere(2);
  const auto open = withoutWhere(ball, [](Eigen::Index t, const TriangleMesh&) { return t == 17; });
  const ClosedSurface closed = closeHoles(open);
  EXPECT_EQ(closed.mesh.points, ball.points);
  EXPECT_EQ(closed.mesh.triangles.rows(), ball.triangles.rows());
  EXPECT_NEAR(volume(closed.mesh.points, closed.mesh.triangles), volume(ball.points, ball.triangles), 1e-14);
}

TEST(CloseHoles, ACutBallIsClosedByAFlatCapThatRunsTheSameWayRound) {
  TriangleMesh ball = tests::sphere(4);
  ball.colors = Colors::Constant(ball.points.rows(), 3, 200);
  const auto open =
      withoutWhere(ball, [](Eigen::Index t, const TriangleMesh& m) { return highest(m, t) > 0.5; });
  const SurfaceReport before = checkSurface(open);
  ASSERT_GT(before.boundaryEdges, 20);
  const ClosedSurface closed = closeHoles(open);
  const SurfaceReport after = checkSurface(closed.mesh);
  EXPECT_EQ(closed.holes, 1);
  EXPECT_TRUE(after.outward());
  EXPECT_TRUE(after.manifold());
  EXPECT_EQ(closed.mesh.points.topRows(open.points.rows()), open.points);
  EXPECT_EQ(closed.mesh.colors.rows(), closed.mesh.points.rows());
  EXPECT_EQ(closed.mesh.colors(closed.mesh.colors.rows() - 1, 0), 200);
  EXPECT_LE(after.boundaryEdges, 0);
}

TEST(CloseHoles, SeveralHolesAreClosedAlsoWhereTwoTouchAtAVertex) {
  const TriangleMesh ball = tests::sphere(3);
  // Two triangles that share only a vertex, and one far away.
  const std::int32_t shared = ball.triangles(0, 0);
  std::vector<Eigen::Index> around;
  for (Eigen::Index t = 0; t < ball.triangles.rows(); ++t)
    if ((ball.triangles.row(t).array() == shared).any())
      around.push_back(t);
  ASSERT_GE(around.size(), 4u);
  const auto touches = [&](Eigen::Index a, Eigen::Index b) {
    int common = 0;
    for (int i = 0; i < 3; ++i)
      common += (ball.triangles.row(b).array() == ball.triangles(a, i)).any();
    return common;
  };
  Eigen::Index opposite = -1;
  for (const Eigen::Index t : around)
    if (t != around.front() && touches(around.front(), t) == 1)
      opposite = t;
  ASSERT_GE(opposite, 0);
  const auto open = withoutWhere(ball, [&](Eigen::Index t, const TriangleMesh& m) {
    return t == around.front() || t == opposite || t == m.triangles.rows() - 1;
  });
  const ClosedSurface closed = closeHoles(open);
  EXPECT_EQ(closed.holes, 3);
  EXPECT_TRUE(checkSurface(closed.mesh).closed());
  EXPECT_TRUE(checkSurface(closed.mesh).manifold());
}

TEST(CloseHoles, AClosedSurfaceIsLeftAlone) {
  const TriangleMesh ball = tests::sphere(2);
  const ClosedSurface closed = closeHoles(ball);
  EXPECT_EQ(closed.holes, 0);
  EXPECT_EQ(closed.mesh.triangles, ball.triangles);
}

TEST(CloseHoles, TrianglesThatRunAgainstEachOtherBesideAHoleAreRefusedByName) {
  TriangleMesh mesh;
  mesh.points = tests::box().points;
  mesh.triangles.resize(2, 3);
  mesh.triangles << 0, 1, 2, 1, 2, 3; // The second runs the wrong way.
  EXPECT_THROW(closeHoles(mesh), DataError);
}

} // namespace
} // namespace viscera::geometry
