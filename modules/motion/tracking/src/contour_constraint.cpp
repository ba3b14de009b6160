#include "contour_constraint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "nearest_place.h"
#include "viscera/geometry/normals.h"

namespace viscera::tracking {
namespace {

/// A surface nearly parallel to the plane moves its cut by much: no more than by the inverse of this.
constexpr double kLeastCrossing = 0.3;
/// When it is near enough, mm; how far a surface may move for it, by the distance of the contour.
constexpr double kMetWell = 0.15, kFarthestShare = 1.5, kFarthestMm = 1;
/// How loosely contours are met at first and at last, in parts of their own stiffness.
constexpr std::array<double, 9> kDampings = {0.3, 0.1, 0.03, 0.01, 0.003, 0.001, 3e-4, 1e-4, 3e-5};
constexpr int kBendRounds = 4;

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

Eigen::MatrixXd ContourMeeting::answer(const Eigen::MatrixXd& derivatives) const {
  const Eigen::Index n = rig_.handles();
  Eigen::MatrixXd answer(derivatives.rows(), derivatives.cols());
  for (int axis = 0; axis < 3; ++axis)
    answer.middleRows(axis * n, n) = cost_.solve(derivatives.middleRows(axis * n, n));
  return answer;
}

VolumeResidual ContourMeeting::bend(const ContourConstraint& contours, double damping,
                                    const std::function<Values(const Values&)>& within, const Points& start,
                                    Points& bent) const {
  VolumeResidual volumes{Values::Zero(static_cast<Eigen::Index>(rig_.surfaces().size())), 0, true};
  bent = start;
  for (int round = 0; round < kBendRounds; ++round) {
    // min u^T N u + |C u - e|^2 / d has u = N^-1 C^T (C N^-1 C^T + d)^-1 e.
    HandleEquations equations = contours.at(bent);
    const Points done = bent - start;
    equations.wanted += equations.rows * Eigen::VectorXd(done.reshaped());
    const Eigen::MatrixXd least = answer(equations.rows.transpose());
    Eigen::MatrixXd schur = equations.rows * least;
    schur.diagonal().array() += damping * schur.diagonal().mean();
    const Eigen::LLT<Eigen::MatrixXd> solver(schur);
    const Eigen::VectorXd change = least * solver.solve(equations.wanted);
    bent = start + change.reshaped(start.rows(), 3);
    if (!within)
      continue;
    const Values now = rig_.volumesMl(rig_.vertices(bent)), wanted = within(now);
    // Volumes change where that does not move the contours.
    const Metric beside = [&](const Points& gradient) {
      const Eigen::VectorXd free = answer(Eigen::VectorXd(gradient.reshaped()));
      const Eigen::VectorXd kept = free - least * solver.solve(equations.rows * free);
      return Points(kept.reshaped(gradient.rows(), 3));
    };
    if (wanted != now)
      volumes = solveVolumes(rig_, wanted, beside, bent);
  }
  return volumes;
}

/// Handles are farther apart than points, and equalities alone would bend the surface wildly between them:
/// the loosest ones that are near enough bend it least.
ContoursMet ContourMeeting::meet(const ContourConstraint& contours,
                                 const std::function<Values(const Values&)>& within, Points& pose) const {
  const Points start = pose;
  const auto folds = [&](const Points& at) { return (stiffness_.ratios(at).array() <= 0).count(); };
  const auto leastFolds = folds(start);
  double nearest = contours.mostMm(start);
  const double farthest = kFarthestShare * nearest + kFarthestMm;
  ContoursMet met{{Values::Zero(static_cast<Eigen::Index>(rig_.surfaces().size())), 0, true}};
  for (const double damping : kDampings) {
    if (nearest <= kMetWell)
      break;
    Points bent;
    const VolumeResidual volumes = bend(contours, damping, within, start, bent);
    const double moved = std::sqrt(rig_.vertices(bent - start).rowwise().squaredNorm().maxCoeff());
    const double most = contours.mostMm(bent);
    met.heldBack = folds(bent) > leastFolds;
    if (met.heldBack || moved > farthest)
      break;
    if (most >= nearest)
      continue;
    nearest = most;
    pose = bent;
    met.volumes = volumes;
  }
  return met;
}

} // namespace viscera::tracking
