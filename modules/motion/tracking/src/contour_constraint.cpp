#include "contour_constraint.h"

#include <algorithm>
#include <limits>

#include "nearest_place.h"
#include "viscera/geometry/normals.h"

namespace viscera::tracking {
namespace {

/// A surface nearly parallel to the plane moves its cut by much: no more than by the inverse of this.
constexpr double kLeastCrossing = 0.3;

double fromSegment(const Vec3& point, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double part = std::clamp((point - a).dot(along) / std::max(along.squaredNorm(), 1e-12), 0.0, 1.0);
  return (point - a - part * along).norm();
}

/// The distance of a point from the lines of a cut.
double fromCut(const Vec3& point, const geometry::PlaneCut& cut) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t line = 0; line < cut.lines(); ++line) {
    const Eigen::Index first = cut.first[line], end = cut.first[line + 1];
    for (Eigen::Index row = first; row < end; ++row) {
      const Eigen::Index next = row + 1 < end ? row + 1 : cut.closed[line] ? first : row;
      least = std::min(least, fromSegment(point, cut.points.row(row), cut.points.row(next)));
    }
  }
  return least;
}

} // namespace

HandleEquations ContourConstraint::at(const Points& pose) const {
  Eigen::Index count = 0;
  for (const CorrectedContour* contour : contours_)
    count += contour->points.rows();
  const Eigen::Index n = rig_.handles();
  HandleEquations equations{Eigen::MatrixXd::Zero(count, 3 * n), Values(count)};
  Eigen::Index row = 0;
  for (const CorrectedContour* contour : contours_) {
    const Eigen::Index first = rig_.firstRow(contour->surface);
    const geometry::TriangleMesh own{
        rig_.vertices(pose, contour->surface), rig_.surfaces()[contour->surface].triangles, {}};
    const NearestPlace nearest(own.points, own.triangles);
    const geometry::Normals normals = geometry::vertexNormals(own);
    for (Eigen::Index i = 0; i < contour->points.rows(); ++i, ++row) {
      const Vec3 wanted = contour->points.row(i);
      const SurfacePlace place = nearest.of(wanted);
      Vec3 normal = Vec3::Zero();
      Eigen::RowVectorXd weights = Eigen::RowVectorXd::Zero(n);
      for (int k = 0; k < 3; ++k) {
        const Eigen::Index vertex = own.triangles(place.triangle, k);
        normal += place.corners[k] * normals.row(vertex).cast<double>().transpose();
        weights += place.corners[k] * rig_.weights().row(first + vertex);
      }
      normal.normalize();
      // Within the plane the cut moves by 1 / |n - (n . m) m| where the surface moves by 1 along n.
      const Vec3 within = normal - normal.dot(contour->plane.normal) * contour->plane.normal;
      const double scale = 1 / std::max(within.norm(), kLeastCrossing);
      for (int axis = 0; axis < 3; ++axis)
        equations.rows.block(row, axis * n, 1, n) = scale * normal[axis] * weights;
      equations.wanted[row] = scale * normal.dot(wanted - place.point);
    }
  }
  return equations;
}

double ContourConstraint::mostMm(const MotionRig& rig, const CorrectedContour& contour, const Points& pose) {
  const Points vertices = rig.vertices(pose, contour.surface);
  const Triangles& triangles = rig.surfaces()[contour.surface].triangles;
  const geometry::PlaneCut cut = geometry::cutSurface({&vertices, &triangles}, contour.plane, Threads{1});
  const NearestPlace nearest(vertices, triangles);
  double most = 0;
  for (Eigen::Index i = 0; i < contour.points.rows(); ++i) {
    const Vec3 point = contour.points.row(i);
    most = std::max(most, cut.lines() > 0 ? fromCut(point, cut) : nearest.of(point).apart);
  }
  return most;
}

double ContourConstraint::mostMm(const Points& pose) const {
  double most = 0;
  for (const CorrectedContour* contour : contours_)
    most = std::max(most, mostMm(rig_, *contour, pose));
  return most;
}

} // namespace viscera::tracking
