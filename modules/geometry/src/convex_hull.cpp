#include "viscera/geometry/convex_hull.h"

#include <algorithm>
#include <string>

#include <Eigen/Eigenvalues>

#include "viscera/core/error.h"
#include "viscera/geometry/hull_facets.h"

namespace viscera::geometry {
namespace {

constexpr double kFlat = 1e-9;

void requireUsable(const Points& points) {
  if (points.rows() < 4)
    throw DataError("a convex hull needs at least 4 points, there are " + std::to_string(points.rows()));
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    if (!points.row(i).allFinite())
      throw DataError("point " + std::to_string(i) + " has a coordinate that is not a finite number");
  // The extent along the direction in which the points are thinnest.
  const Points centered = points.rowwise() - points.colwise().mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(centered.transpose() * centered);
  const double thickness = (centered * axes.eigenvectors().col(0)).cwiseAbs().maxCoeff();
  if (thickness <= kFlat * boundsOf(points).diagonal())
    throw DataError("all points lie in one plane", {}, "move one out of the plane");
}

} // namespace

ConvexHull::ConvexHull(const Points& points) : diagonal_(boundsOf(points).diagonal()) {
  requireUsable(points);
  // About the centre: Qhull's own tolerances grow with the largest coordinate.
  const Vec3 center = boundsOf(points).center();
  const auto facets = hullFacets(points.rowwise() - center.transpose());
  if (!facets)
    throw DataError("the convex hull of " + std::to_string(points.rows()) + " points cannot be computed", {},
                    "points that coincide or are almost flat cause this");
  triangles_ = facets->triangles;
  std::vector<Eigen::Vector4d> planes;
  for (Eigen::Index facet = 0; facet < facets->planes.rows(); ++facet) {
    Eigen::Vector4d plane = facets->planes.row(facet).transpose();
    plane[3] -= plane.head<3>().dot(center);
    const bool known = std::any_of(planes.begin(), planes.end(), [&](const Eigen::Vector4d& p) {
      return (p.head<3>() - plane.head<3>()).norm() < kFlat && std::abs(p[3] - plane[3]) < kFlat * diagonal_;
    });
    if (!known)
      planes.push_back(plane);
  }
  planes_.resize(static_cast<Eigen::Index>(planes.size()), 4);
  for (std::size_t i = 0; i < planes.size(); ++i)
    planes_.row(static_cast<Eigen::Index>(i)) = planes[i].transpose();
}

double ConvexHull::signedDistance(const Vec3& point) const {
  return (planes_.leftCols<3>() * point + planes_.col(3)).maxCoeff();
}

std::vector<int> ConvexHull::outside(const Points& points, double margin) const {
  std::vector<int> list;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
    if (signedDistance(points.row(i).transpose()) > margin)
      list.push_back(static_cast<int>(i));
  return list;
}

} // namespace viscera::geometry
