#include "viscera/geometry/surface_gap.h"

#include <cmath>
#include <limits>
#include <memory>
#include <random>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/core/error.h"
#include "viscera/geometry/signed_distance.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::geometry {
namespace {

SurfaceBoxes boxesOf(const TriangleMesh& mesh) {
  return {mesh.points, mesh.triangles};
}

/// Places of a triangle, `steps` along each side.
template <class Take>
void sampleTriangles(const TriangleMesh& mesh, int steps, Take take) {
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto [a, b, c] = cornersOf(mesh.points, mesh.triangles, t);
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j)
        take(Vec3(a + (b - a) * i / steps + (c - a) * j / steps));
  }
}

TriangleMesh moved(TriangleMesh mesh, const Vec3& by) {
  mesh.points.rowwise() += by.transpose();
  return mesh;
}

TEST(SurfaceGap, OfTwoBoxesIsBetweenTheirFacesEdgesOrCorners) {
  const TriangleMesh box = tests::box(2, 3, 5);
  for (const Vec3& by : {Vec3(6, 1, 1), Vec3(5, 7, 1), Vec3(-5, -7, 9)}) {
    const SurfaceGap gap = gapBetween(boxesOf(box), boxesOf(moved(box, by)));
    const Vec3 sides(2, 3, 5);
    EXPECT_NEAR(gap.mm, (by.cwiseAbs() - sides).cwiseMax(0.0).norm(), 1e-12);
    EXPECT_NEAR((gap.to - gap.from).norm(), gap.mm, 1e-12);
  }
}

TEST(SurfaceGap, BetweenTwoCrossedEdgesIsInsideOfBoth) {
  // Two wedges whose ridges cross at a right angle, 3 mm apart.
  TriangleMesh low = tests::tetrahedron(), high = low;
  low.points << -5, 0, 0, 5, 0, 0, 0, -3, -4, 0, 3, -4;
  high.points << 0, -5, 3, 0, 5, 3, -3, 0, 8, 3, 0, 8;
  const SurfaceGap gap = gapBetween(boxesOf(low), boxesOf(high));
  EXPECT_NEAR(gap.mm, 3, 1e-12);
  EXPECT_LE((gap.from - Vec3(0, 0, 0)).norm(), 1e-12);
  EXPECT_LE((gap.to - Vec3(0, 0, 3)).norm(), 1e-12);
}

// Distances of dense samples from a tree of another kind.
TEST(SurfaceGap, AgreesWithSamplesOfUnevenSurfaces) {
  std::mt19937 random(11);
  std::normal_distribution<double> number;
  for (int i = 0; i < 6; ++i) {
    TriangleMesh first = tests::sphere(3, 10), second = tests::sphere(2, 7);
    for (TriangleMesh* mesh : {&first, &second})
      for (Eigen::Index row = 0; row < mesh->points.rows(); ++row)
        mesh->points.row(row) *= 1 + 0.15 * std::sin(3 * mesh->points(row, i % 3) + i);
    const Vec3 way = Vec3(number(random), number(random), number(random)).normalized();
    second = moved(second, 24 * way);
    const SurfaceGap gap = gapBetween(boxesOf(first), boxesOf(second));
    const SignedDistance toFirst(std::make_shared<const TriangleMesh>(first));
    double sampled = std::numeric_limits<double>::infinity();
    sampleTriangles(second, 8,
                    [&](const Vec3& place) { sampled = std::min(sampled, std::abs(toFirst(place))); });
    EXPECT_LE(gap.mm, sampled + 1e-9);
    EXPECT_NEAR(gap.mm, sampled, 0.05);
    EXPECT_NEAR(toFirst(gap.to), gap.mm, 1e-9) << "the end lies where it says";
    EXPECT_NEAR(std::abs(toFirst(gap.from)), 0, 1e-9);
  }
}

TEST(SurfaceGap, IsNothingWhereSurfacesCrossAndTheWayOutWhereOneIsInside) {
  const TriangleMesh ball = tests::sphere(3, 10);
  const SurfaceGap crossing = gapBetween(boxesOf(ball), boxesOf(tests::sphere(3, 5, Vec3(8, 1, 0))));
  EXPECT_EQ(crossing.mm, 0);
  EXPECT_EQ(crossing.from, crossing.to);
  const SignedDistance toBall(std::make_shared<const TriangleMesh>(ball));
  EXPECT_NEAR(toBall(crossing.from), 0, 1e-9);
  const SurfaceGap inside = gapBetween(boxesOf(ball), boxesOf(tests::sphere(3, 2, Vec3(5, 0, 0))));
  EXPECT_NEAR(inside.mm, 3, 0.05);
  // A box that stands in another one's face, with all its edges outside of the other's corners.
  TriangleMesh spike = tests::box(1, 1, 9);
  const SurfaceGap pierced = gapBetween(boxesOf(tests::box(5, 5, 5)), boxesOf(moved(spike, Vec3(2, 2, 3))));
  EXPECT_EQ(pierced.mm, 0);
}

TEST(SurfaceGap, FollowsASurfaceAndIsTheSameFromAnOlderOne) {
  const TriangleMesh ball = tests::sphere(4, 10);
  SurfaceBoxes follower = boxesOf(ball), other = boxesOf(tests::sphere(4, 6, Vec3(30, 2, 5)));
  std::optional<SurfaceGap> last;
  for (int step = 0; step < 5; ++step) {
    Points bent = ball.points;
    bent.col(0) *= 1 + 0.2 * step;
    bent.col(2).array() += step;
    follower.follow(bent);
    last = gapBetween(follower, other, last);
    const SurfaceGap fresh = gapBetween(SurfaceBoxes(bent, ball.triangles), other);
    EXPECT_NEAR(last->mm, fresh.mm, 1e-12);
    EXPECT_NEAR((last->to - last->from).norm(), last->mm, 1e-12);
  }
}

TEST(SurfaceGap, OfNothingIsRefused) {
  EXPECT_THROW(gapBetween(SurfaceBoxes(Points(0, 3), Triangles(0, 3)), boxesOf(tests::box())), UsageError);
}

} // namespace
} // namespace viscera::geometry
