#include "viscera/coordinates/systems.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "green/cage_normals.h"
#include "green/triangle_potentials.h"
#include "viscera/coordinates/cage/cage.h"
#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {
namespace {

/// Part of the cage's size: a point this near to a triangle is on it.
constexpr double kOnCage = 1e-11;

/// The triangle that covers most of the sphere around the point; all of it where the point touches it.
struct Covering {
  Eigen::Index triangle = -1;
  double angle = -1;
  Vec3 foot = Vec3::Zero();
  double height = 0;

  void take(const Covering& other) {
    if (other.angle > angle)
      *this = other;
  }
};

class GreenSolver final : public PointSolver {
public:
  GreenSolver(const Points& handles, const Triangles& cage)
      : handles_(handles), cage_(cage), tolerance_(kOnCage * boundsOf(handles).diagonal()),
        lift_(std::make_shared<CageNormals>(handles, cage)) {}

  std::shared_ptr<const PoseLift> lift() const override { return lift_; }

  bool solve(const Vec3& point, Values& weights) const override { return add(point, weights, nullptr); }
  bool solveGradients(const Vec3& point, Values& weights, Points& gradients) const override {
    return add(point, weights, &gradients);
  }

private:
  bool add(const Vec3& point, Values& weights, Points* gradients) const {
    constexpr double kWhole = 4 * std::numbers::pi;
    // p = sum_i phi_i v_i + sum_t psi_t n_t: rows of the corners (phi), then of the triangles (psi), which
    // meet the stretched normals of `CageNormals`.
    double angle = 0;
    Covering covering;
    for (Eigen::Index t = 0; t < cage_.rows(); ++t) {
      const auto [a, b, c] = geometry::cornersOf(handles_, cage_, t);
      const SeenTriangle triangle(a - point, b - point, c - point);
      const bool touching = triangle.touches(tolerance_);
      const TrianglePotentials found = triangle.potentials(touching, gradients != nullptr);
      angle += found.solidAngle;
      covering.take({t, touching ? kWhole : std::abs(found.solidAngle), triangle.foot(), triangle.height()});
      const Eigen::Index face = handles_.rows() + t;
      weights[face] = found.face;
      for (int k = 0; k < 3; ++k)
        weights[cage_(t, k)] += found.corners[k];
      if (gradients) {
        gradients->row(face) = found.faceGradient.transpose();
        for (int k = 0; k < 3; ++k)
          gradients->row(cage_(t, k)) += found.cornerGradients.row(k);
      }
    }
    const bool onCage = covering.angle == kWhole;
    if (!onCage && !(angle > kWhole / 2))
      return false;
    // The solid angles sum to 4 pi from inside. On the cage that leaves what the triangles there cover as
    // seen from just inside, next to an edge what rounding has taken from its triangles. A solid angle d more
    // gives lambda_k(foot) d to the corners and -h d to the normal, which together are d p.
    const double missing = (kWhole - angle) / kWhole;
    for (int k = 0; k < 3; ++k)
      weights[cage_(covering.triangle, k)] += covering.foot[k] * missing;
    weights[handles_.rows() + covering.triangle] -= covering.height * missing;
    return !onCage || gradients == nullptr;
  }

  Points handles_;
  Triangles cage_;
  double tolerance_;
  std::shared_ptr<const PoseLift> lift_;
};

} // namespace

/// Green coordinates (Lipman, Levin and Cohen-Or 2008, doi 10.1145/1360612.1360677): inside a closed cage of
/// any shape a point is a sum of the cage's corners and of its triangles' normals, by Green's third identity.
/// The normals in a pose are those of the posed cage, scaled by the stretch of their triangles.
///
/// They reproduce every point at rest and follow every similarity; they do not follow other affine motions,
/// and do not interpolate handles; in return they nearly keep angles. The points are not linear in the pose,
/// so the volume is no cubic along a motion of the handles and a lock works by Newton steps. Coordinates in
/// closed form, by solid angles and logarithms of the edges, which is the same integral as in the paper; with
/// derivatives. Points outside the cage have no coordinates: the continuation through a face of the paper's
/// section 6 is left out. O(triangles) a point.
std::shared_ptr<const CoordinateSystem> greenCoordinates() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{.id = "green",
                        .name = "Green",
                        .summary = "By corners and normals of a cage of any shape; nearly keeps angles, and "
                                   "does not interpolate its handles",
                        .traits = {.needsCage = true, .closedFormGradient = true, .affine = false}},
      [](const HandleSet& handles, const ParameterValues&) {
        return std::make_unique<GreenSolver>(handles.positions, cageOf(handles));
      });
}

} // namespace viscera::coordinates
