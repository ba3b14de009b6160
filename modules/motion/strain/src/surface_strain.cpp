#include "viscera/strain/surface_strain.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "viscera/geometry/volume.h"

namespace viscera::strain {
namespace {

/// Smaller triangles have no directions, mm^2.
constexpr double kLeastArea = 1e-9;

} // namespace

EndocardialSegments::EndocardialSegments(const Points& rest, const Triangles& triangles,
                                         const std::vector<bool>& cap, const HeartAxes& axes) {
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    if (!cap.empty() && cap[static_cast<std::size_t>(t)])
      continue;
    const Vec3 a = rest.row(triangles(t, 0)), b = rest.row(triangles(t, 1)), c = rest.row(triangles(t, 2));
    const Vec3 first = b - a, second = c - a, normal = first.cross(second);
    Facet facet;
    facet.segment = segmentOf(axes, (a + b + c) / 3);
    if (facet.segment == 0 || !(normal.norm() > 2 * kLeastArea))
      continue;
    for (int k = 0; k < 3; ++k)
      facet.corners[static_cast<std::size_t>(k)] = triangles(t, k);
    const Vec3 out = normal.normalized();
    Vec3 up = -axes.down() + axes.down().dot(out) * out;
    if (!(up.norm() > 0))
      up = out.unitOrthogonal();
    up.normalize();
    Eigen::Matrix<double, 3, 2> edges;
    edges << first, second;
    const Eigen::Matrix<double, 2, 3> inverse = (edges.transpose() * edges).inverse() * edges.transpose();
    facet.along = inverse * up;
    facet.around = inverse * up.cross(out);
    ++counts_[static_cast<std::size_t>(facet.segment)];
    ++counts_[0];
    facets_.push_back(facet);
  }
}

EndocardialSegments::Means EndocardialSegments::between(const Points& reference, const Points& now) const {
  Means means;
  std::array<double, kSegments + 1> areas{};
  for (const Facet& facet : facets_) {
    const auto edgesAt = [&facet](const Points& points) {
      Eigen::Matrix<double, 3, 2> edges;
      edges.col(0) = (points.row(facet.corners[1]) - points.row(facet.corners[0])).transpose();
      edges.col(1) = (points.row(facet.corners[2]) - points.row(facet.corners[0])).transpose();
      return edges;
    };
    const Eigen::Matrix<double, 3, 2> before = edgesAt(reference), after = edgesAt(now);
    const double area = before.col(0).cross(before.col(1)).norm() / 2;
    const double along = (after * facet.along).norm() / (before * facet.along).norm() - 1;
    const double around = (after * facet.around).norm() / (before * facet.around).norm() - 1;
    const double areaNow = after.col(0).cross(after.col(1)).norm() / 2;
    for (const int place : {facet.segment, 0}) {
      const auto i = static_cast<std::size_t>(place);
      areas[i] += area;
      means.longitudinal[i] += area * along;
      means.circumferential[i] += area * around;
      means.area[i] += areaNow - area;
    }
  }
  for (std::size_t i = 0; i < areas.size(); ++i)
    if (areas[i] > 0)
      for (auto* values : {&means.longitudinal, &means.circumferential, &means.area})
        (*values)[i] /= areas[i];
  return means;
}

double areaWithout(const Points& points, const Triangles& triangles, const std::vector<bool>& leftOut) {
  double area = 0;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    if (leftOut.empty() || !leftOut[static_cast<std::size_t>(t)])
      area += geometry::areaOf(points, triangles, t);
  return area;
}

} // namespace viscera::strain
