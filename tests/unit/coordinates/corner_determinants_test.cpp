#include "viscera/coordinates/corner_determinants.h"

#include <memory>

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "clouds.h"
#include "shapes.h"
#include "viscera/coordinates/systems.h"

namespace viscera::coordinates {
namespace {

struct BoundSphere {
  geometry::TriangleMesh mesh = tests::sphere(2);
  std::shared_ptr<const Binding> binding;

  explicit BoundSphere(int handles) {
    HandleSet set;
    set.positions = 1.5 * tests::onSphere(handles);
    Progress progress;
    binding = builtInSystems().front()->bind(set, mesh.points, {}, progress);
  }

  double expected(int i, int j, int k) const {
    const Values columns[] = {binding->influence(i), binding->influence(j), binding->influence(k)};
    double sum = 0;
    for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
      Eigen::Matrix3d corner;
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
          corner(row, column) = columns[column][mesh.triangles(t, row)];
      sum += corner.determinant();
    }
    return sum;
  }
};

} // namespace

/// More handles than one panel of columns, and a number that none of the loops' units divides.
TEST(CornerDeterminants, AreThoseOfTheTrianglesCorners) {
  const BoundSphere sphere(37);
  const CornerDeterminants determinants(*sphere.binding, sphere.mesh.triangles);
  ASSERT_EQ(determinants.handles(), 37);
  CornerDeterminants::Sums sums;
  for (const int k : {2, 15, 16, 17, 36}) {
    determinants.ofHandle(k, sums);
    for (int i = 0; i < k; i += 3)
      for (int j = i + 1; j < k; j += 2)
        EXPECT_NEAR(sums(i, j), sphere.expected(i, j, k), 1e-15) << i << ' ' << j << ' ' << k;
  }
}

/// Nothing but the triangles counts: vertices of no triangle, and blocks of vertices that a handle does not
/// reach.
TEST(CornerDeterminants, OfASurfaceWithoutTrianglesAreZero) {
  const BoundSphere sphere(9);
  const CornerDeterminants determinants(*sphere.binding, Triangles(0, 3));
  CornerDeterminants::Sums sums;
  determinants.ofHandle(8, sums);
  EXPECT_EQ(sums.topLeftCorner(8, 8), CornerDeterminants::Sums::Zero(8, 8));
}

} // namespace viscera::coordinates
