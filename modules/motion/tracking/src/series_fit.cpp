#include "viscera/tracking/series_fit.h"

#include <cassert>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace viscera::tracking {
namespace {

/// Keeps factorisations positive where weights are degenerate.
constexpr double kFactorFloor = 1e-9;

/// The points of all surfaces in one phase below each other, `m x 3`.
Points phaseOf(const MotionRig& rig, const std::vector<SurfaceSeries>& series, std::size_t phase) {
  Points all(rig.weights().rows(), 3);
  for (std::size_t surface = 0; surface < series.size(); ++surface)
    all.middleRows(rig.firstRow(surface), rig.rows(surface)) = series[surface].phases[phase];
  return all;
}

/// Column t: the displacements of the handles in phase t, those of x, y and z below each other.
Eigen::MatrixXd displacements(const Eigen::MatrixXd& normal, const Eigen::MatrixXd& wanted,
                              const PhaseTimes& times, double smoothing, Progress& progress) {
  // N X + smoothing X U = R with the symmetric U = Q diag(l) Q^T of the phases' times: with Y = X Q each
  // column is a system of its own, (N + smoothing l_m I) y_m = (R Q)_m.
  const Eigen::Index n = normal.rows();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(unevenness(times));
  const Eigen::MatrixXd byMode = wanted * modes.eigenvectors();
  Eigen::MatrixXd found(wanted.rows(), wanted.cols());
  for (Eigen::Index mode = 0; mode < byMode.cols(); ++mode) {
    progress.report(0.3 + 0.4 * static_cast<double>(mode) / static_cast<double>(byMode.cols()), "fitting");
    progress.throwIfCancelled();
    const Eigen::MatrixXd matrix =
        normal + smoothing * modes.eigenvalues()[mode] * Eigen::MatrixXd::Identity(n, n);
    found.col(mode).reshaped(n, 3) = matrix.llt().solve(byMode.col(mode).reshaped(n, 3));
  }
  return found * modes.eigenvectors().transpose();
}

} // namespace

MotionFit fitSeries(const MotionRig& rig, const std::vector<SurfaceSeries>& series, const PhaseTimes& times,
                    const FitOptions& options, Progress& progress) {
  assert(!series.empty() && series.front().phases.size() == times.count());
  const Eigen::Index n = rig.handles();
  // Normal equations of the weighted least squares: N = W^T S W + bending B, R = W^T S (phase - rest).
  const Eigen::MatrixXd weighted = rig.weights().transpose() * rig.shares().asDiagonal();
  const Eigen::MatrixXd normal = weighted * rig.weights() + options.bending * rig.bending() +
                                 kFactorFloor * Eigen::MatrixXd::Identity(n, n);
  const Points rest = rig.vertices(rig.rest());
  Eigen::MatrixXd wanted(3 * n, static_cast<Eigen::Index>(times.count()));
  for (std::size_t phase = 0; phase < times.count(); ++phase) {
    progress.report(0.3 * static_cast<double>(phase) / static_cast<double>(times.count()), "fitting");
    progress.throwIfCancelled();
    wanted.col(static_cast<Eigen::Index>(phase)).reshaped(n, 3) =
        weighted * (phaseOf(rig, series, phase) - rest);
  }
  const Eigen::MatrixXd moved = displacements(normal, wanted, times, options.smoothing, progress);
  const Eigen::LLT<Eigen::MatrixXd> solver(normal);
  const Metric metric = [&](const Points& gradient) { return Points(solver.solve(gradient)); };
  MotionFit fit;
  for (std::size_t phase = 0; phase < times.count(); ++phase) {
    progress.report(0.7 + 0.3 * static_cast<double>(phase) / static_cast<double>(times.count()),
                    "keeping volumes");
    progress.throwIfCancelled();
    Points pose = rig.rest() + moved.col(static_cast<Eigen::Index>(phase)).reshaped(n, 3);
    fit.freeVolumesMl.push_back(rig.volumesMl(rig.vertices(pose)));
    if (options.keepVolumes)
      fit.volumes.push_back(solveVolumes(rig, rig.volumesMl(phaseOf(rig, series, phase)), metric, pose));
    fit.poses.push_back(std::move(pose));
    fit.steps.push_back(1);
  }
  progress.report(1);
  return fit;
}

} // namespace viscera::tracking
