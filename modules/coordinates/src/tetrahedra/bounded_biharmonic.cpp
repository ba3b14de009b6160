#include "viscera/coordinates/systems.h"

#include <cstdio>
#include <utility>

#include "tetrahedra/finite_elements.h"
#include "tetrahedra/last_solver.h"
#include "tetrahedra/simplex_program.h"
#include "tetrahedra/tetrahedra_field.h"
#include "viscera/coordinates/pointwise_system.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::coordinates {
namespace {

const Parameter kBiharmonicResolution = resolutionParameter(16, 12);
const Parameter kMargin{.name = "margin",
                        .minimum = 2,
                        .maximum = 100,
                        .standard = 10,
                        .unit = "%",
                        .help = "How far beyond the handles' hull the weights are computed"};

/// Adds the remainder of each point that the weights do not reproduce: three further rows, the unit vectors.
class WithRemainder final : public PoseLift {
public:
  explicit WithRemainder(Eigen::Index handles) : handles_(handles) {}

  Eigen::Index rowCount() const override { return handles_ + 3; }
  Points lift(const Points& pose) const override {
    Points rows(rowCount(), 3);
    rows << pose, Eigen::Matrix3d::Identity();
    return rows;
  }
  Points pullBack(const Points&, const Points& rowGradient) const override {
    return rowGradient.topRows(handles_);
  }

private:
  Eigen::Index handles_;
};

class BoundedBiharmonicSolver final : public PointSolver {
public:
  BoundedBiharmonicSolver(Points handles, TetrahedraField field, std::vector<Text> notes)
      : handles_(std::move(handles)), field_(std::move(field)), notes_(std::move(notes)),
        lift_(std::make_shared<WithRemainder>(handles_.rows())) {}

  std::shared_ptr<const PoseLift> lift() const override { return lift_; }
  std::vector<Text> notes() const override { return notes_; }

  bool solve(const Vec3& point, Values& weights) const override { return add(point, weights, nullptr); }
  bool solveGradients(const Vec3& point, Values& weights, Points& gradients) const override {
    return add(point, weights, &gradients);
  }

private:
  bool add(const Vec3& point, Values& weights, Points* gradients) const {
    const auto place = field_.locate(point);
    if (!place)
      return false;
    const Eigen::Index count = handles_.rows();
    field_.addValues(*place, weights);
    // A point that rounding puts outside its tetrahedron takes no negative share of it.
    weights.head(count) = weights.head(count).cwiseMax(0) / weights.head(count).cwiseMax(0).sum();
    // r = p - sum w_i v_i, constant in every pose: p' = sum w_i v_i' + r = p + sum w_i (v_i' - v_i). Its
    // gradient is I - sum v_i (grad w_i)^T.
    weights.tail<3>() = point - handles_.transpose() * weights.head(count);
    if (gradients) {
      field_.addGradients(*place, *gradients);
      gradients->bottomRows<3>() =
          Eigen::Matrix3d::Identity() - handles_.transpose() * gradients->topRows(count);
    }
    return true;
  }

  Points handles_;
  TetrahedraField field_;
  std::vector<Text> notes_;
  std::shared_ptr<const PoseLift> lift_;
};

/// The hull of the handles, `factor` times as large.
geometry::TriangleMesh enlargedHull(const Points& handles, double factor) {
  const Triangles triangles = geometry::ConvexHull(handles).triangles();
  const Eigen::RowVector3d middle = boundsOf(handles).center().transpose();
  std::vector<int> names(static_cast<std::size_t>(handles.rows()), -1);
  geometry::TriangleMesh hull;
  hull.triangles = triangles;
  hull.points.resize(handles.rows(), 3);
  std::int32_t next = 0;
  for (Eigen::Index i = 0; i < triangles.size(); ++i) {
    int& name = names[static_cast<std::size_t>(triangles.data()[i])];
    if (name < 0) {
      name = next++;
      hull.points.row(name) = middle + factor * (handles.row(triangles.data()[i]) - middle);
    }
    hull.triangles.data()[i] = name;
  }
  hull.points.conservativeResize(next, 3);
  return hull;
}

std::vector<Text> notesOn(const SimplexSolution& solution, const SimplexLimits& limits) {
  if (solution.converged)
    return {};
  char text[200];
  std::snprintf(text, sizeof text,
                "Bounded biharmonic weights did not converge in %d iterations: residuals %.1e (bounds) and "
                "%.1e (energy) instead of %.0e. They are bounded and add up to 1, but not of least energy.",
                solution.iterations, solution.primal, solution.dual, limits.tolerance);
  return {text};
}

std::unique_ptr<const PointSolver> prepareBiharmonic(const HandleSet& handles, const Points&,
                                                     const BindOptions& options, Progress& progress) {
  const Points& positions = handles.positions;
  FilledDomain domain = filledDomain(enlargedHull(positions, 1 + options.parameters.get(kMargin) / 100),
                                     positions, options.parameters.get(kBiharmonicResolution),
                                     "bounded biharmonic weights", options, progress);
  SolidMesh scaled = domain.solid; // In units of its size, so that residuals mean the same for every organ.
  scaled.points /= boundsOf(scaled.points).diagonal();
  // Least tr(W^T K^T M^-1 K W), K the stiffness and M the lumped mass, where each row of W is >= 0 and adds
  // up to 1, and that of a handle is the handle's alone.
  SimplexProgram program;
  program.mass = lumpedMass(scaled);
  const SparseMatrix laplacian = stiffness(scaled);
  program.energy = laplacian.transpose() * program.mass.cwiseInverse().asDiagonal() * laplacian;
  for (Eigen::Index handle = 0; handle < positions.rows(); ++handle)
    program.fixed.push_back(domain.onSurface + handle);
  const SimplexLimits limits;
  const SimplexSolution solution = solveOnSimplex(program, limits, options.threads, progress);
  return std::make_unique<BoundedBiharmonicSolver>(
      positions, TetrahedraField(std::move(domain.solid), solution.weights), notesOn(solution, limits));
}

} // namespace

/// Bounded biharmonic weights of point handles (Jacobson et al. 2011, doi 10.1145/1964921.1964973): among all
/// weights in [0, 1] that add up to 1 and are 1 at their handle, those of least bilaplacian energy
/// `1/2 sum_i int (laplace w_i)^2`.
///
/// This is the joint problem, in which unity is a constraint on all handles together, and not the cheaper
/// variant that bounds each handle alone and normalises afterwards. The domain is the convex hull of the
/// handles, enlarged by `margin` percent about its middle, in tetrahedra whose edges are about a
/// `resolution`-th of its diagonal and which have the handles among their corners; the bilaplacian is
/// `K M^-1 K` with the lumped mass M. The weights keep bounds and unity exactly; how far they are from the
/// least energy is their residual, and the report has a note where that stays above 1e-4.
///
/// The weights do not reproduce a point: `p = sum w_i v_i` is false. A point moves by the weighted motions of
/// its handles, `p' = p + sum w_i (v'_i - v_i)`, so it follows translations but no other affine motion.
/// Weights are linear between the corners of the tetrahedra; derivatives are constant in each.
std::shared_ptr<const CoordinateSystem> boundedBiharmonic() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{
          .id = "bounded-biharmonic",
          .name = "Bounded biharmonic weights",
          .summary =
              "Weights of least bending between 0 and 1; smooth and local, and follow translations only",
          .traits = {.needsTetrahedra = true,
                     .positive = true,
                     .interpolates = true,
                     .closedFormGradient = true,
                     .rotationInvariant = false,
                     .smooth = false,
                     .affine = false},
          .parameters = {kBiharmonicResolution, kMargin}},
      keepingTheLastSolver(prepareBiharmonic));
}

} // namespace viscera::coordinates
