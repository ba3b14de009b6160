#include "viscera/coordinates/systems.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/LU>

#include "choice_parameter.h"
#include "mean_value/triangle_share.h"
#include "same_place.h"
#include "sphere/sphere_samples.h"
#include "viscera/coordinates/cage/cage.h"
#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {
namespace {

const Parameter kLevel = countParameter("level", "Divisions of the icosahedron: 20 * 4^level rays", 0, 5, 2);

/// Triangles that span less, seen from the point, are hit by no ray.
constexpr double kThin = 1e-14;
/// A ray through an edge belongs to both sides.
constexpr double kRayOnEdge = 1e-12;

/// The nearest triangle that every ray hits.
struct Hits {
  Values nearness; ///< One over the distance, 1/mm; 0 where there is none.
  Eigen::VectorXi triangles;
  Eigen::Matrix3Xd shares; ///< Of the corners, divided by the distance.
};

class PositiveMeanValueSolver final : public PointSolver {
public:
  PositiveMeanValueSolver(const Points& handles, Triangles cage, int level)
      : handles_(handles), cage_(std::move(cage)), size_(boundsOf(handles).diagonal()),
        samples_(sphereSamples(level)) {}

  bool solve(const Vec3& point, Values& weights) const override {
    const Points corners = handles_.rowwise() - point.transpose();
    if (onCage(corners, weights))
      return true;
    if (!insideCage(corners))
      return false;
    const Hits hits = hitsFrom(corners);
    if (!(hits.nearness.minCoeff() > 0))
      return false;
    // w_i = sum over the rays of area b_i / r, for int b_i / r dw over all directions w: r is the distance of
    // the nearest hit and b_i the barycentric coordinate of corner i there.
    for (Eigen::Index ray = 0; ray < hits.triangles.size(); ++ray)
      for (int i = 0; i < 3; ++i)
        weights[cage_(hits.triangles[ray], i)] += samples_.areas[ray] * hits.shares(i, ray);
    weights /= weights.sum();
    return true;
  }

private:
  /// Barycentric weights of a point on the cage, where half of the rays see nothing or the triangle at no
  /// distance; false, and nothing, when it is not there.
  bool onCage(const Points& corners, Values& weights) const {
    for (Eigen::Index t = 0; t < cage_.rows(); ++t) {
      const BesideTriangle place = besideTriangle(geometry::cornersOf(corners, cage_, t));
      if (!(std::max(place.height, place.beside) <= kSamePlace * size_))
        continue; // Not there, or a triangle without an area.
      for (int i = 0; i < 3; ++i)
        weights[cage_(t, i)] = std::max(place.shares[i], 0.0);
      weights /= weights.sum();
      return true;
    }
    return false;
  }

  /// Sums the solid angles of all triangles, which is 4 pi inside.
  bool insideCage(const Points& corners) const {
    double angle = 0;
    for (Eigen::Index t = 0; t < cage_.rows(); ++t) {
      const auto [a, b, c] = geometry::cornersOf(corners, cage_, t);
      const double la = a.norm(), lb = b.norm(), lc = c.norm();
      angle +=
          2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return angle > 2 * std::numbers::pi;
  }

  Hits hitsFrom(const Points& corners) const {
    const Eigen::Index rays = samples_.areas.size();
    Hits hits{Values::Zero(rays), Eigen::VectorXi::Zero(rays), Eigen::Matrix3Xd::Zero(3, rays)};
    Eigen::Matrix3Xd shares(3, rays);
    for (Eigen::Index t = 0; t < cage_.rows(); ++t) {
      Eigen::Matrix3d frame;
      double lengths = 1;
      for (int i = 0; i < 3; ++i) {
        frame.col(i) = corners.row(cage_(t, i)).transpose();
        lengths *= frame.col(i).norm();
      }
      if (std::abs(frame.determinant()) < kThin * lengths)
        continue;
      // A ray's direction w = sum shares_i v_i meets the triangle at r w = sum b_i v_i with sum b_i = 1: the
      // shares are b_i / r, and their sum is 1 / r.
      shares.noalias() = frame.inverse() * samples_.directions;
      for (Eigen::Index ray = 0; ray < rays; ++ray) {
        const double nearness = shares.col(ray).sum();
        if (nearness > hits.nearness[ray] && shares.col(ray).minCoeff() >= -kRayOnEdge * nearness) {
          hits.nearness[ray] = nearness;
          hits.triangles[ray] = static_cast<int>(t);
          hits.shares.col(ray) = shares.col(ray).cwiseMax(0);
        }
      }
    }
    return hits;
  }

  Points handles_;
  Triangles cage_;
  double size_;
  SphereSamples samples_;
};

} // namespace

/// Mean value coordinates computed from only the part of the cage that is visible from the point (thesis 2.3;
/// Lipman, Kopf, Cohen-Or, Levin 2007, Symposium on Geometry Processing): positive in any cage. By rays to
/// the centres of an icosahedron's triangles divided `level` times, weighted by areas; their symmetry makes
/// the identity exact. The coordinates jump a little where a ray moves to another triangle. O(rays x
/// triangles) a point.
std::shared_ptr<const CoordinateSystem> positiveMeanValue() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{.id = "positive-mean-value",
                        .name = "Positive mean value",
                        .summary = "Mean value of what can be seen of a cage, by rays; positive in any cage",
                        .traits = {.needsCage = true,
                                   .positive = true,
                                   .interpolates = true,
                                   .rotationInvariant = false,
                                   .continuous = false,
                                   .smooth = false},
                        .parameters = {kLevel}},
      [](const HandleSet& handles, const ParameterValues& parameters) {
        return std::make_unique<PositiveMeanValueSolver>(handles.positions, cageOf(handles),
                                                         static_cast<int>(parameters.get(kLevel)));
      });
}

} // namespace viscera::coordinates
