#include "viscera/geometry/winding_number.h"

#include <gtest/gtest.h>

#include "clouds.h"
#include "shapes.h"

namespace viscera::geometry {
namespace {

TEST(WindingNumber, IsOneInsideAndZeroOutsideAClosedSurface) {
  const WindingNumber winding(tests::sphere(4, 20, {5, 6, 7}));
  const Points points = tests::cloud(2000, 4, 40, {5, 6, 7});
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const double radius = (points.row(i) - Eigen::RowVector3d(5, 6, 7)).norm();
    if (std::abs(radius - 20) > 0.5) {
      EXPECT_NEAR(winding(points.row(i).transpose()), radius < 20 ? 1 : 0, 0.02);
    }
  }
}

TEST(WindingNumber, IsMinusOneInsideASurfaceTurnedInsideOut) {
  TriangleMesh mesh = tests::box(10, 10, 10);
  mesh.triangles.col(1).swap(mesh.triangles.col(2));
  EXPECT_NEAR(WindingNumber(mesh)({4, 5, 6}), -1, 1e-12);
}

TEST(WindingNumber, FadesThroughAHole) {
  TriangleMesh mesh = tests::box(10, 10, 10);
  mesh.triangles = mesh.triangles.bottomRows(10).eval(); // Without the side z = 0.
  const WindingNumber winding(mesh);
  EXPECT_TRUE(winding.inside({5, 5, 6}));
  EXPECT_FALSE(winding.inside({5, 5, -6}));
  EXPECT_GT(winding({5, 5, 6}), winding({5, 5, 1}));
  EXPECT_GT(winding({5, 5, 1}), winding({5, 5, -3}));
}

TEST(WindingNumber, OfNothingIsZero) {
  EXPECT_EQ(WindingNumber(TriangleMesh())(Vec3::Zero()), 0);
}

} // namespace
} // namespace viscera::geometry
