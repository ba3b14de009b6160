#include "cavity_form.h"

#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>

#include "sequence_binding.h"
#include "viscera/coordinates/weights_binding.h"
#include "viscera/core/error.h"

namespace viscera::motion {
namespace {

/// Combinations whose singular value is a smaller part of the largest are left out.
constexpr double kNegligible = 1e-5;

Eigen::MatrixXd weightsOf(const coordinates::Binding& binding) {
  Eigen::MatrixXd weights(binding.pointCount(), binding.handleCount());
  for (int handle = 0; handle < weights.cols(); ++handle)
    weights.col(handle) = binding.influence(handle);
  return weights;
}

/// The combinations of handles that move the points at all, as orthonormal columns.
Eigen::MatrixXd basisOf(const Eigen::MatrixXd& weights) {
  const Eigen::MatrixXd gram = weights.transpose() * weights;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
  const Eigen::VectorXd& squares = eigen.eigenvalues(); // Ascending.
  Eigen::Index first = 0;
  while (squares[first] < kNegligible * kNegligible * squares[squares.size() - 1])
    ++first;
  return eigen.eigenvectors().rightCols(squares.size() - first);
}

/// The combinations at `pose`, and the origin behind them, whose weight makes each point's sum 1: so the
/// volume does not change when all move together, which the form relies on.
Points combinationsAt(const Eigen::MatrixXd& basis, const Points& pose) {
  Points combined = Points::Zero(basis.cols() + 1, 3);
  const Points centered = pose.rowwise() - pose.colwise().mean();
  combined.topRows(basis.cols()).noalias() = basis.transpose() * centered;
  return combined;
}

deformation::VolumeForm formOf(const geometry::TriangleMesh& rest, const Eigen::MatrixXd& weights,
                               const Eigen::MatrixXd& basis, Threads threads) {
  const Eigen::MatrixXd combined = weights * basis;
  coordinates::TiledWeights tiled(weights.rows(), basis.cols() + 1);
  for (Eigen::Index point = 0; point < weights.rows(); ++point) {
    for (Eigen::Index k = 0; k < basis.cols(); ++k)
      tiled.set(point, k, combined(point, k));
    tiled.set(point, basis.cols(), 1 - combined.row(point).sum());
  }
  const coordinates::WeightsBinding binding(std::move(tiled), Points::Zero(basis.cols() + 1, 3), rest.points,
                                            {}, 0, threads);
  auto form = deformation::VolumeForm::of(rest, binding, threads);
  if (!form)
    throw DataError("the volume of a cavity is no cubic form of its handles", "heart",
                    "choose coordinates that are linear in the handles");
  return std::move(*form);
}

CavityForm cavityOf(const sample_organs::SampleOrgan& organ, const char* name, const SampleHeart& heart,
                    Threads threads) {
  const MovedVolume moved(surfaceOf(organ, name), heart.rest, heart.system, threads);
  return {*surfaceOf(organ, name), moved.binding(), threads};
}

} // namespace

CavityForm::CavityForm(const geometry::TriangleMesh& rest, const coordinates::Binding& binding,
                       Threads threads)
    : basis_(basisOf(weightsOf(binding))), form_(formOf(rest, weightsOf(binding), basis_, threads)) {}

double CavityForm::at(const Points& pose) const {
  return form_.volume(combinationsAt(basis_, pose)) / kMm3PerMl;
}

CavityForms::CavityForms(const sample_organs::SampleOrgan& organ, const SampleHeart& heart, Threads threads)
    : left_(cavityOf(organ, "lv", heart, threads)), right_(cavityOf(organ, "rv", heart, threads)) {}

} // namespace viscera::motion
