#include "viscera/deformation/place_handles.h"

#include <gtest/gtest.h>

#include "build_paths.h"
#include "shapes.h"
#include "shared_organs.h"
#include "viscera/core/error.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::deformation {
namespace {

double nearestVertex(const geometry::TriangleMesh& mesh, const Vec3& to) {
  return (mesh.points.rowwise() - to.transpose()).rowwise().norm().minCoeff();
}

double nearestOther(const Points& points, Eigen::Index self) {
  double nearest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    if (i != self)
      nearest = std::min(nearest, (points.row(i) - points.row(self)).norm());
  return nearest;
}

/// A box with a slit in its top that is narrower than twice a handle's offset: an upright U of boxes.
geometry::TriangleMesh slitBlock(double slit) {
  // Outline of the U in the x-y plane, counter-clockwise, pulled along z.
  const double x0 = 0, x1 = 5 - slit / 2, x2 = 5 + slit / 2, x3 = 10, y0 = 0, y1 = 2, y2 = 10;
  const std::vector<Eigen::Vector2d> outline = {{x0, y0}, {x3, y0}, {x3, y2}, {x2, y2},
                                                {x2, y1}, {x1, y1}, {x1, y2}, {x0, y2}};
  geometry::TriangleMesh mesh;
  mesh.points.resize(16, 3);
  for (int i = 0; i < 8; ++i) {
    mesh.points.row(i) << outline[std::size_t(i)].transpose(), 0;
    mesh.points.row(i + 8) << outline[std::size_t(i)].transpose(), 10;
  }
  std::vector<Eigen::Vector3i> triangles;
  for (int i = 0; i < 8; ++i) {
    const int next = (i + 1) % 8;
    triangles.insert(triangles.end(), {{i, next, next + 8}, {i, next + 8, i + 8}});
  }
  for (const Eigen::Vector3i& t :
       {Eigen::Vector3i(0, 1, 4), Eigen::Vector3i(0, 4, 5), Eigen::Vector3i(1, 2, 3),
        Eigen::Vector3i(1, 3, 4), Eigen::Vector3i(0, 5, 6), Eigen::Vector3i(0, 6, 7)}) {
    triangles.emplace_back(t[0] + 8, t[1] + 8, t[2] + 8);
    triangles.emplace_back(t[0], t[2], t[1]);
  }
  mesh.triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    mesh.triangles.row(static_cast<Eigen::Index>(i)) = triangles[i].transpose();
  return mesh;
}

} // namespace

TEST(PlaceHandles, StandOffASphereByTheOffset) {
  const auto organ = tests::sphere(4, 50);
  const Placement placement;
  const Points handles = placeHandles(organ, placement);
  const double diagonal = boundsOf(organ.points).diagonal();
  ASSERT_EQ(handles.rows(), 30);
  for (Eigen::Index i = 8; i < 30; ++i)
    EXPECT_NEAR(handles.row(i).norm(), 50 + 0.03 * diagonal, 1e-4 * diagonal) << i;
}

TEST(PlaceHandles, SpreadEvenly) {
  const auto organ = tests::sphere(4, 50);
  Placement placement;
  placement.enclosing = false;
  placement.count = 50;
  const Points handles = placeHandles(organ, placement);
  double nearest = 1e300, farthest = 0;
  for (Eigen::Index i = 0; i < handles.rows(); ++i) {
    nearest = std::min(nearest, nearestOther(handles, i));
    farthest = std::max(farthest, nearestOther(handles, i));
  }
  // 50 discs on the sphere; farthest-point samples keep within a factor of two of one another.
  EXPECT_LT(farthest, 2 * nearest);
}

TEST(PlaceHandles, EncloseTheOrganWithTheFirstEight) {
  const auto organ = tests::sphere(3, 40, {100, -20, 300});
  const Points handles = placeHandles(organ);
  const geometry::ConvexHull box(handles.topRows(8));
  EXPECT_TRUE(box.outside(organ.points).empty());
  EXPECT_EQ(box.outside(handles, 1e-9).size(), 0u);
  EXPECT_EQ(handles.topRows(8), enclosingHandles(organ.points));
}

TEST(PlaceHandles, StayClearOfTheOtherSideOfANarrowSlit) {
  const auto organ = slitBlock(0.3);
  ASSERT_GT(boundsOf(organ.points).diagonal() * 0.03, 0.3) << "the offset must reach across the slit";
  Placement placement;
  placement.enclosing = false;
  placement.count = 12;
  const Points handles = placeHandles(organ, placement);
  for (Eigen::Index i = 0; i < handles.rows(); ++i) {
    const Vec3 h = handles.row(i).transpose();
    const bool inLeft = h[0] > 0 && h[0]<4.85, inRight = h[0]> 5.15 && h[0] < 10;
    const bool inside = h[2] > 0 && h[2] < 10 && h[1] > 0 && h[1] < 10 && (inLeft || inRight || h[1] < 2);
    EXPECT_FALSE(inside) << "handle " << i << " at " << h.transpose();
  }
}

TEST(PlaceHandles, GiveTheSameHandlesEachTime) {
  const auto organ = tests::sphere(3, 10);
  EXPECT_EQ(placeHandles(organ), placeHandles(organ));
}

TEST(PlaceHandles, RefuseMoreHandlesThanTheSurfaceHasRoomFor) {
  Placement placement;
  placement.count = 1000;
  EXPECT_THROW(placeHandles(tests::box(10, 10, 10), placement), DataError);
}

TEST(PlaceHandles, RefuseTooFewHandlesAndTooSmallSurfaces) {
  Placement placement;
  placement.count = 7;
  EXPECT_THROW(placeHandles(tests::box(), placement), DataError);
  placement.enclosing = false;
  placement.count = 3;
  EXPECT_THROW(placeHandles(tests::box(), placement), DataError);
  EXPECT_THROW(placeHandles(geometry::TriangleMesh(), Placement()), DataError);
}

TEST(PlaceHandles, KeepOffTheBunny) {
  const auto organ = tests::bunny(VISCERA_SHARED_ORGANS);
  if (!organ)
    GTEST_SKIP() << "bunny.obj is not beside the project";
  const Points handles = placeHandles(*organ);
  const double offset = 0.03 * boundsOf(organ->points).diagonal();
  for (Eigen::Index i = 8; i < handles.rows(); ++i)
    EXPECT_GT(nearestVertex(*organ, handles.row(i).transpose()), 0.5 * offset) << i;
}

/// The parts of the handles that lie nearest to each of the organs.
std::vector<int> handlesAround(const std::vector<geometry::TriangleMesh>& organs, const Points& handles,
                               Eigen::Index first) {
  std::vector<int> counts(organs.size());
  for (Eigen::Index row = first; row < handles.rows(); ++row) {
    std::size_t nearest = 0;
    for (std::size_t organ = 1; organ < organs.size(); ++organ)
      if (nearestVertex(organs[organ], handles.row(row).transpose()) <
          nearestVertex(organs[nearest], handles.row(row).transpose()))
        nearest = organ;
    ++counts[nearest];
  }
  return counts;
}

std::vector<const geometry::TriangleMesh*> pointersTo(const std::vector<geometry::TriangleMesh>& organs) {
  std::vector<const geometry::TriangleMesh*> all;
  for (const auto& organ : organs)
    all.push_back(&organ);
  return all;
}

TEST(PlaceHandles, AroundSeveralOrgansGoByTheSizeOfTheirSurfaces) {
  const std::vector<geometry::TriangleMesh> organs = {
      tests::sphere(3, 20, Vec3(-200, 0, 0)), tests::sphere(4, 60), tests::sphere(3, 40, Vec3(300, 0, 0))};
  Placement placement;
  placement.count = 8 + 56; // Areas of 1, 9 and 4: shares of 4, 36 and 16.
  const Points handles = placeHandles(pointersTo(organs), placement);
  EXPECT_EQ(handlesAround(organs, handles, 8), (std::vector<int>{4, 36, 16}));
  for (Eigen::Index row = 8; row < handles.rows(); ++row) {
    const Vec3 place = handles.row(row).transpose();
    EXPECT_GT((place - Vec3(-200, 0, 0)).norm(), 20);
    EXPECT_GT(place.norm(), 60);
    EXPECT_GT((place - Vec3(300, 0, 0)).norm(), 40);
  }
  const Bounds box = boundsOf(handles.topRows(8).eval());
  EXPECT_LT(box.low.x(), -220);
  EXPECT_GT(box.high.x(), 340) << "the box encloses all of them";
}

TEST(PlaceHandles, AroundSeveralOrgansLieInNoneOfThem) {
  const std::vector<geometry::TriangleMesh> organs = {
      tests::sphere(4, 50), tests::sphere(3, 20, Vec3(71, 0, 0))}; // They all but touch.
  Placement placement;
  placement.count = 60;
  const Points handles = placeHandles(pointersTo(organs), placement);
  for (Eigen::Index row = 8; row < handles.rows(); ++row) {
    EXPECT_GT(handles.row(row).norm(), 50);
    EXPECT_GT((handles.row(row).transpose() - Vec3(71, 0, 0)).norm(), 20);
  }
}

TEST(PlaceHandles, AroundOneOfAListAreThoseAroundItAlone) {
  const auto organ = tests::sphere(3, 50);
  EXPECT_EQ(placeHandles(std::vector{&organ}, Placement{}), placeHandles(organ, Placement{}));
}

TEST(PlaceHandles, LeaveOutAFragmentBesideOrgans) {
  std::vector<geometry::TriangleMesh> organs = {tests::sphere(3, 50), tests::sphere(3, 50, Vec3(200, 0, 0))};
  organs[1].points.conservativeResize(3, 3);
  organs[1].triangles = Triangles(1, 3);
  organs[1].triangles << 0, 1, 2;
  EXPECT_EQ(placeHandles(pointersTo(organs), Placement{}).rows(), Placement().count);
}

} // namespace viscera::deformation
