#include "viscera/deformation/group_handles.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/core/error.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::deformation {
namespace {

geometry::TriangleMesh longOrgan() {
  auto organ = tests::sphere(4);
  organ.points = organ.points * Vec3(90, 45, 40).asDiagonal();
  return organ;
}

Points allHandles(const Points& placed, const Grouping& grouping) {
  Points all(placed.rows() + grouping.added.rows(), 3);
  all << placed, grouping.added;
  return all;
}

/// How many points lie in no group's hull.
int uncovered(const Points& handles, const Grouping& grouping, const Points& points) {
  std::vector<bool> covered(static_cast<std::size_t>(points.rows()), false);
  for (const auto& group : grouping.groups) {
    Points own(static_cast<Eigen::Index>(group.handles.size()), 3);
    for (std::size_t i = 0; i < group.handles.size(); ++i)
      own.row(static_cast<Eigen::Index>(i)) = handles.row(group.handles[i]);
    const geometry::ConvexHull hull(own);
    for (Eigen::Index p = 0; p < points.rows(); ++p)
      if (hull.signedDistance(points.row(p).transpose()) < 0)
        covered[std::size_t(p)] = true;
  }
  return static_cast<int>(std::count(covered.begin(), covered.end(), false));
}

TEST(GroupHandles, PartsAlongTheAxisHoldTheWholeOrgan) {
  const auto organ = longOrgan();
  const Points placed = placeHandles(organ);
  for (const int count : {1, 2, 3, 5}) {
    const auto grouping = groupsAlongAxis(placed, organ.points, count);
    EXPECT_EQ(grouping.groups.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(uncovered(allHandles(placed, grouping), grouping, organ.points), 0) << count << " groups";
  }
}

TEST(GroupHandles, ClustersHoldTheWholeOrganAndUseEveryHandle) {
  const auto organ = longOrgan();
  const Points placed = placeHandles(organ);
  const auto grouping = groupsByCluster(placed, organ.points, 4);
  EXPECT_EQ(uncovered(allHandles(placed, grouping), grouping, organ.points), 0);
  for (int handle = 0; handle < placed.rows(); ++handle)
    EXPECT_TRUE(std::any_of(grouping.groups.begin(), grouping.groups.end(),
                            [&](const auto& group) {
                              return std::find(group.handles.begin(), group.handles.end(), handle) !=
                                     group.handles.end();
                            }))
        << "handle " << handle;
}

TEST(GroupHandles, ClustersAreNeverTooSmallToBeUsed) {
  const auto organ = longOrgan();
  for (const int handles : {20, 30, 40, 60})
    for (int count = 2; count <= 8; ++count) {
      const auto grouping = groupsByCluster(placeHandles(organ, {handles}), organ.points, count);
      ASSERT_EQ(grouping.groups.size(), static_cast<std::size_t>(count));
      for (const auto& group : grouping.groups)
        EXPECT_GE(group.handles.size(), 4U) << group.name << " of " << count << ", " << handles << " handles";
    }
}

TEST(GroupHandles, HandlesLieInAnotherClustersHullOrWellOutsideIt) {
  const auto organ = longOrgan();
  const double room = 0.01 * boundsOf(organ.points).diagonal();
  for (const int placed : {20, 40, 60})
    for (const int count : {2, 4, 8}) {
      const Points handles = placeHandles(organ, {placed});
      const auto grouping = groupsByCluster(handles, organ.points, count);
      const Points all = allHandles(handles, grouping);
      for (const auto& group : grouping.groups) {
        EXPECT_TRUE(std::is_sorted(group.handles.begin(), group.handles.end()));
        const geometry::ConvexHull hull(Points(all(group.handles, Eigen::all)));
        for (Eigen::Index row = 0; row < all.rows(); ++row) {
          const double outside = hull.signedDistance(all.row(row).transpose());
          EXPECT_TRUE(outside < 1e-9 || outside >= room)
              << outside << " mm from " << group.name << " of " << count << ", handle " << row;
        }
      }
    }
}

TEST(GroupHandles, EveryOrganGetsTheHandlesNearestToIt) {
  auto left = tests::sphere(3, 20, {-50, 0, 0}), right = tests::sphere(3, 20, {50, 0, 0});
  Points handles(16, 3);
  handles << enclosingHandles(left.points), enclosingHandles(right.points);
  const auto grouping = groupsByOrgan(handles, {left.points, right.points}, {"left", "right"});
  EXPECT_EQ(grouping.added.rows(), 0);
  EXPECT_EQ(grouping.groups[0].name, "left");
  EXPECT_THAT(grouping.groups[1].handles, testing::ElementsAre(8, 9, 10, 11, 12, 13, 14, 15));
}

TEST(GroupHandles, RefusesWhatMakesNoSense) {
  const auto organ = longOrgan();
  const Points placed = placeHandles(organ);
  EXPECT_THROW(groupsAlongAxis(placed, organ.points, 0), UsageError);
  EXPECT_THROW(groupsAlongAxis(placed, organ.points, 2, 1.5), UsageError);
  EXPECT_THROW(groupsByCluster(placed, organ.points, 1000), DataError);
  EXPECT_THROW(groupsAlongAxis(placed, Points(0, 3), 2), DataError);
}

} // namespace
} // namespace viscera::deformation
