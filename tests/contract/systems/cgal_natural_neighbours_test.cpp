#include <iterator>
#include <map>
#include <random>
#include <utility>
#include <vector>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/natural_neighbor_coordinates_3.h>
#include <gtest/gtest.h>

#include "clouds.h"
#include "viscera/coordinates/systems.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::coordinates {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel>;

/// Sibson's coordinates by CGAL; empty where it has none.
std::vector<double> bySibson(const Delaunay& handles,
                             const std::map<Delaunay::Vertex_handle, std::size_t>& rows, const Vec3& point) {
  std::vector<std::pair<Delaunay::Vertex_handle, double>> shares;
  double sum = 0;
  const auto result = CGAL::sibson_natural_neighbor_coordinates_3(
      handles, Kernel::Point_3(point[0], point[1], point[2]), std::back_inserter(shares), sum);
  if (!result.third)
    return {};
  std::vector<double> coordinates(rows.size());
  for (const auto& [vertex, share] : shares)
    coordinates[rows.at(vertex)] += share / sum;
  return coordinates;
}

/// Another library's Sibson coordinates as an oracle, on random clouds of different sizes and places.
TEST(NaturalNeighboursOracle, AgreeWithCgalOnRandomClouds) {
  for (const int count : {8, 20, 60}) {
    SCOPED_TRACE(count);
    const Vec3 center(20, -80, 300);
    HandleSet handles;
    handles.positions = tests::cloud(count, static_cast<unsigned>(count), 50, center);
    Delaunay triangulation;
    std::map<Delaunay::Vertex_handle, std::size_t> rows;
    for (Eigen::Index i = 0; i < handles.positions.rows(); ++i)
      rows[triangulation.insert({handles.positions(i, 0), handles.positions(i, 1),
                                 handles.positions(i, 2)})] = static_cast<std::size_t>(i);
    const geometry::ConvexHull hull(handles.positions);
    Points points = tests::cloud(1500, 3, 40, center);
    Eigen::Index inside = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
      if (hull.signedDistance(points.row(i).transpose()) < -1)
        points.row(inside++) = points.row(i);
    ASSERT_GT(inside, 100);
    Progress progress;
    const auto binding = naturalNeighbours()->bind(handles, points.topRows(inside), {}, progress);
    ASSERT_TRUE(binding->report().failures.empty());
    std::vector<Values> ours;
    for (int i = 0; i < count; ++i)
      ours.push_back(binding->influence(i));
    for (Eigen::Index p = 0; p < inside; ++p) {
      const std::vector<double> theirs = bySibson(triangulation, rows, points.row(p).transpose());
      ASSERT_EQ(theirs.size(), ours.size()) << "point " << p;
      for (std::size_t i = 0; i < ours.size(); ++i)
        ASSERT_NEAR(ours[i][p], theirs[i], 1e-9) << "point " << p << ", handle " << i;
    }
  }
}

} // namespace
} // namespace viscera::coordinates
