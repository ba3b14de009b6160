#include "viscera/coordinates/systems.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "tetrahedra/finite_elements.h"
#include "tetrahedra/last_solver.h"
#include "tetrahedra/tetrahedra_field.h"
#include "viscera/coordinates/cage/cage.h"
#include "viscera/coordinates/pointwise_system.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::coordinates {
namespace {

const Parameter kHarmonicResolution = resolutionParameter(32, 20);

/// Part of the cage's size, and of barycentric coordinates: a point so near to a triangle lies on it.
constexpr double kOnCageFace = 1e-9;

class HarmonicSolver final : public PointSolver {
public:
  explicit HarmonicSolver(TetrahedraField field) : field_(std::move(field)) {}

  bool solve(const Vec3& point, Values& weights) const override {
    const auto place = field_.locate(point);
    if (place)
      field_.addValues(*place, weights);
    return place.has_value();
  }

  bool solveGradients(const Vec3& point, Values& weights, Points& gradients) const override {
    const auto place = field_.locate(point);
    if (place) {
      field_.addValues(*place, weights);
      field_.addGradients(*place, gradients);
    }
    return place.has_value();
  }

private:
  TetrahedraField field_;
};

/// The coordinates of a point on the cage: its barycentric coordinates in the triangle it lies on.
Eigen::RowVectorXd onCage(const Vec3& point, const Points& handles, const Triangles& cage) {
  const double size = boundsOf(handles).diagonal();
  Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(handles.rows());
  for (Eigen::Index t = 0; t < cage.rows(); ++t) {
    const auto [a, b, c] = geometry::cornersOf(handles, cage, t);
    const Vec3 area = (b - a).cross(c - a), way = point - a;
    const double twice = area.norm();
    if (std::abs(way.dot(area)) > kOnCageFace * size * twice)
      continue;
    // b_B = ((x - a) x (c - a)) . n / |n|^2 and b_C = ((b - a) x (x - a)) . n / |n|^2, with n = (b - a) x (c
    // - a).
    const double ofB = way.cross(c - a).dot(area) / (twice * twice);
    const double ofC = (b - a).cross(way).dot(area) / (twice * twice);
    if (std::min({ofB, ofC, 1 - ofB - ofC}) < -kOnCageFace)
      continue;
    row[cage(t, 0)] = 1 - ofB - ofC;
    row[cage(t, 1)] = ofB;
    row[cage(t, 2)] = ofC;
    return row;
  }
  throw Error(70, misuse("a point of the divided cage is not on the cage"), "harmonic coordinates",
              "try another resolution, or a cage without needle-like triangles");
}

std::unique_ptr<const PointSolver> prepareHarmonic(const HandleSet& handles, const Points&,
                                                   const BindOptions& options, Progress& progress) {
  const Triangles cage = cageOf(handles);
  // Handles that are no corners of the cage are none of the domain's either.
  std::vector<int> corners(cage.data(), cage.data() + cage.size());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  geometry::TriangleMesh surface;
  surface.points.resize(static_cast<Eigen::Index>(corners.size()), 3);
  for (std::size_t i = 0; i < corners.size(); ++i)
    surface.points.row(static_cast<Eigen::Index>(i)) = handles.positions.row(corners[i]);
  surface.triangles = cage.unaryExpr([&](std::int32_t corner) {
    return static_cast<std::int32_t>(std::lower_bound(corners.begin(), corners.end(), corner) -
                                     corners.begin());
  });
  FilledDomain domain = filledDomain(surface, Points(0, 3), options.parameters.get(kHarmonicResolution),
                                     "harmonic coordinates", options, progress);
  std::vector<Eigen::Index> fixed(static_cast<std::size_t>(domain.onSurface));
  std::iota(fixed.begin(), fixed.end(), 0);
  Eigen::MatrixXd given(domain.onSurface, handles.positions.rows());
  for (Eigen::Index i = 0; i < domain.onSurface; ++i)
    given.row(i) = onCage(domain.solid.points.row(i).transpose(), handles.positions, cage);
  // Laplace's equation with linear elements: K w = 0 at the points inside, w given on the cage.
  const Eigen::MatrixXd values =
      leastEnergy(stiffness(domain.solid), fixed, given, options.threads, progress);
  return std::make_unique<HarmonicSolver>(TetrahedraField(std::move(domain.solid), values));
}

} // namespace

/// Harmonic coordinates (Joshi et al. 2007, doi 10.1145/1276377.1276466; thesis 2.3): inside a closed cage of
/// any shape each coordinate is the solution of Laplace's equation that is linear on the cage's triangles, 1
/// at its handle and 0 at the others.
///
/// The system solves it by linear finite elements on tetrahedra whose edges are about a `resolution`-th of
/// the cage's diagonal; the error falls with its square. Linear functions are among the elements, so identity
/// and unity are exact on any tetrahedra. True harmonic coordinates are positive in any cage; on tetrahedra
/// with obtuse angles the elements may fall below zero by a little, which is why the traits do not promise
/// it. Derivatives are those of the elements: constant in each tetrahedron. Points outside the cage have no
/// coordinates. A factorisation of about `resolution^3 / 2` unknowns, then O(handles) a point.
std::shared_ptr<const CoordinateSystem> harmonic() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{
          .id = "harmonic",
          .name = "Harmonic",
          .summary =
              "Solutions of Laplace's equation in a cage of any shape; local, and without negative lobes",
          .traits = {.needsCage = true,
                     .needsTetrahedra = true,
                     .interpolates = true,
                     .closedFormGradient = true,
                     .rotationInvariant = false,
                     .smooth = false},
          .parameters = {kHarmonicResolution}},
      keepingTheLastSolver(prepareHarmonic));
}

} // namespace viscera::coordinates
