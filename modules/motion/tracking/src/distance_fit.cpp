#include "viscera/tracking/distance_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <Eigen/Cholesky>

#include "viscera/core/phrase.h"
#include "viscera/tracking/rims.h"
#include "viscera/tracking/surface_series.h"

namespace viscera::tracking {
namespace {

constexpr double kDistanceFloor = 1e-9;
constexpr Eigen::Index kPointsAtOnce = 512;
/// Distances of all phases are kept when they take no more than that.
constexpr std::size_t kMostKeptBytes = std::size_t{600} << 20U;
/// A rig of another organ is brought to the first phase as something stiff first.
constexpr std::array<double, 3> kForeignBending = {1e-2, 1e-3, 1e-4};
constexpr int kForeignSteps = 4;

/// Distances of all vertices, and along what they grow.
struct Offsets {
  Values distance; ///< `m` mm.
  Points normal;   ///< `m x 3`, unit.
};

Offsets offsetsAt(const MotionRig& rig, const PhaseTargets& targets, const Points& pose, Threads threads) {
  const Points vertices = rig.vertices(pose);
  Offsets offsets{Values(vertices.rows()), Points(vertices.rows(), 3)};
  for (std::size_t surface = 0; surface < rig.surfaces().size(); ++surface) {
    const Eigen::Index first = rig.firstRow(surface);
    parallelRanges(rig.rows(surface), kPointsAtOnce, threads, [&](Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index v = first + begin; v < first + end; ++v) {
        Vec3 normal;
        offsets.distance[v] = targets.distances[surface]->at(vertices.row(v).transpose(), normal);
        offsets.normal.row(v) = normal.transpose();
      }
    });
  }
  return offsets;
}

/// The vertices of a rig's rims, one below the other.
class RigRims {
public:
  RigRims(const MotionRig& rig, const DistanceFitOptions& options) {
    Eigen::Index count = 0;
    for (const RimRows& rim : options.rims)
      count += static_cast<Eigen::Index>(rim.rows.size());
    weights_.resize(count, rig.handles());
    shares_.resize(count);
    const double width = options.rimMm > 0 ? options.rimMm : softnessFor(rig.rest(), 0, 1);
    count = 0;
    for (std::size_t i = 0; i < options.rims.size(); ++i) {
      const RimRows& rim = options.rims[i];
      const auto size = static_cast<Eigen::Index>(rim.rows.size());
      weights_.middleRows(count, size) = rig.weights()(rim.rows, Eigen::all);
      const geometry::TriangleMesh& surface = rig.surfaces()[rim.surface];
      const double area = vertexAreas(surface.points, surface.triangles).sum();
      const Values lengths = lengthsAlong(rig.vertices(rig.rest())(rim.rows, Eigen::all));
      shares_.segment(count, size) = width / (area * static_cast<double>(rig.surfaces().size())) * lengths;
      of_.insert(of_.end(), rim.rows.size(), i);
      count += size;
    }
  }

  bool empty() const { return of_.empty(); }
  const Eigen::MatrixXd& weights() const { return weights_; } ///< `k x n`.
  const Values& shares() const { return shares_; }            ///< `k`.

  /// How far each vertex is from its line, and the direction of that line.
  void from(const std::vector<Points>& lines, const Points& pose, Points& away, Points& along) const {
    const Points points = weights_ * pose;
    away.resize(points.rows(), 3);
    along.resize(points.rows(), 3);
    for (Eigen::Index v = 0; v < points.rows(); ++v) {
      const Vec3 point = points.row(v);
      const PlaceOnRim place = nearestOnRim(lines[of_[static_cast<std::size_t>(v)]], point);
      away.row(v) = (point - place.point).transpose();
      along.row(v) = place.direction.transpose();
    }
  }

private:
  std::vector<std::size_t> of_;
  Eigen::MatrixXd weights_;
  Values shares_;
};

/// Where a phase is to be in time, and how much that counts.
struct Pull {
  Points to;
  double weight = 0; ///< 0: nowhere.
};

/// One phase's problem: its normal matrix, in x, y and z of all handles below each other.
class PhaseFit {
public:
  PhaseFit(const MotionRig& rig, const DistanceFitOptions& options, Threads threads)
      : rig_(rig), options_(options), threads_(threads), rims_(rig, options) {}

  /// Steps until nothing moves; how many were made.
  int run(const PhaseTargets& targets, double bending, const Pull& pull, int most, Points& pose,
          Progress& progress) {
    for (int step = 1;; ++step) {
      progress.throwIfCancelled();
      const Offsets offsets = offsetsAt(rig_, targets, pose, threads_);
      const Values weights = weightsOf(offsets);
      if (!rims_.empty())
        rims_.from(targets.rims, pose, awayFromRim_, alongRim_);
      factorise(offsets, weights, bending, pull.weight);
      // Right side of the step: -(W^T (w d n) + bending B P + pull (P - to) + W_r^T w_r (W_r P - c)), with
      // coordinates W, distances d along unit normals n, weights w, the pose P, and c the places on rims that
      // are nearest to a rig's own rims W_r P.
      const Points pushed = weights.cwiseProduct(offsets.distance).asDiagonal() * offsets.normal;
      Points gradient = -(rig_.weights().transpose() * pushed) - bending * (rig_.bending() * pose);
      if (pull.weight > 0)
        gradient -= pull.weight * (pose - pull.to);
      if (!rims_.empty())
        gradient -= rims_.weights().transpose() * (rims_.shares().asDiagonal() * awayFromRim_);
      const Points change = solve(gradient);
      pose += change;
      const double largest = std::sqrt(rig_.vertices(change).rowwise().squaredNorm().maxCoeff());
      if (step == most || !(largest >= options_.stillMm))
        return step;
    }
  }

  /// Solves with the matrix of the last step.
  Points solve(const Points& gradient) const {
    const Eigen::VectorXd stacked = gradient.reshaped();
    const Eigen::VectorXd found = solver_.solve(stacked);
    return found.reshaped(rig_.handles(), 3);
  }

private:
  /// The weight of each vertex; less of far ones where the fit is robust.
  Values weightsOf(const Offsets& offsets) const {
    if (!(options_.robustMm > 0))
      return rig_.shares();
    // w = share r / max(|d|, r): the weights with which least squares have Huber's estimate for their fixed
    // point.
    const Eigen::ArrayXd far = offsets.distance.array().abs().max(options_.robustMm);
    return (rig_.shares().array() * options_.robustMm / far).matrix();
  }

  /// What holds the vertices of rims: everything across the rim, little along it.
  Values rimScale(Eigen::Index row, Eigen::Index column) const {
    Values scale = (options_.sliding - 1) * alongRim_.col(row).cwiseProduct(alongRim_.col(column));
    if (row == column)
      scale.array() += 1;
    return scale.cwiseProduct(rims_.shares());
  }

  void factorise(const Offsets& offsets, const Values& weights, double bending, double pull) {
    static constexpr std::array<std::pair<int, int>, 6> kBlocks = {
        {{0, 0}, {1, 0}, {1, 1}, {2, 0}, {2, 1}, {2, 2}}};
    const Eigen::Index n = rig_.handles();
    matrix_.resize(3 * n, 3 * n);
    // Block (r, c) of the normal matrix: W^T diag(w ((1 - sliding) n_r n_c + sliding delta_rc)) W, and in the
    // diagonal blocks bending B + (floor + pull) I.
    parallelRanges(6, 1, threads_, [&](Eigen::Index begin, Eigen::Index) {
      const auto [row, column] = kBlocks[static_cast<std::size_t>(begin)];
      Values scale =
          (1 - options_.sliding) * offsets.normal.col(row).cwiseProduct(offsets.normal.col(column));
      if (row == column)
        scale.array() += options_.sliding;
      scale.array() *= weights.array();
      const Eigen::MatrixXd scaled = scale.asDiagonal() * rig_.weights();
      Eigen::MatrixXd half(n, n);
      half.triangularView<Eigen::Lower>() = rig_.weights().transpose() * scaled;
      if (!rims_.empty())
        half.triangularView<Eigen::Lower>() +=
            rims_.weights().transpose() * rimScale(row, column).asDiagonal() * rims_.weights();
      Eigen::MatrixXd block = half.selfadjointView<Eigen::Lower>();
      if (row == column) {
        block += bending * rig_.bending();
        block.diagonal().array() += kDistanceFloor + pull;
      }
      matrix_.block(row * n, column * n, n, n) = block;
    });
    solver_.compute(matrix_); // Reads the lower half only.
  }

  const MotionRig& rig_;
  const DistanceFitOptions& options_;
  Threads threads_;
  RigRims rims_;
  Points awayFromRim_, alongRim_; ///< At the last pose.
  Eigen::MatrixXd matrix_;
  Eigen::LLT<Eigen::MatrixXd> solver_;
};

/// The distances of the phases, kept from the first sweep to the second as far as memory allows.
class KeptTargets {
public:
  KeptTargets(const std::function<PhaseTargets(std::size_t)>& make, std::size_t phases)
      : make_(make), kept_(phases) {}

  std::shared_ptr<const PhaseTargets> of(std::size_t phase) {
    if (kept_[phase])
      return kept_[phase];
    auto made = std::make_shared<const PhaseTargets>(make_(phase));
    if (bytes_ + made->bytes() <= kMostKeptBytes) {
      bytes_ += made->bytes();
      kept_[phase] = made;
    }
    return made;
  }

private:
  const std::function<PhaseTargets(std::size_t)>& make_;
  std::vector<std::shared_ptr<const PhaseTargets>> kept_;
  std::size_t bytes_ = 0;
};

/// Where a phase should be by its neighbours.
Pull pullOf(const MotionFit& fit, const PhaseTimes& times, std::size_t phase, double weight) {
  Neighbours neighbours;
  if (!(weight > 0) || !neighboursOf(times, phase, neighbours))
    return {};
  return {(1 - neighbours.part) * fit.poses[neighbours.before] +
              neighbours.part * fit.poses[neighbours.after],
          weight};
}

} // namespace

std::size_t PhaseTargets::bytes() const {
  std::size_t sum = 0;
  for (const auto& distance : distances)
    sum += distance->bytes();
  for (const Points& rim : rims)
    sum += sizeof(double) * static_cast<std::size_t>(rim.size());
  return sum;
}

MotionFit fitDistances(const MotionRig& rig, const std::function<PhaseTargets(std::size_t)>& targets,
                       const PhaseTimes& times, const DistanceFitOptions& options, Progress& progress,
                       Threads threads) {
  KeptTargets kept(targets, times.count());
  PhaseFit phaseFit(rig, options, threads);
  MotionFit fit;
  const auto count = static_cast<double>(times.count());
  for (std::size_t phase = 0; phase < times.count(); ++phase) {
    progress.report(0.75 * static_cast<double>(phase) / count, phrase("fitting phase %1", phase + 1));
    Points pose = fit.poses.empty() ? rig.rest() : fit.poses.back();
    const auto target = kept.of(phase);
    if (phase == 0 && options.foreignRig)
      for (const double bending : kForeignBending)
        phaseFit.run(*target, bending, {}, kForeignSteps, pose, progress);
    fit.steps.push_back(phaseFit.run(*target, options.fit.bending, {}, options.steps, pose, progress));
    fit.poses.push_back(std::move(pose));
  }
  for (std::size_t phase = 0; phase < times.count(); ++phase) {
    progress.report(0.75 + 0.25 * static_cast<double>(phase) / count,
                    phrase("smoothing phase %1", phase + 1));
    Points& pose = fit.poses[phase];
    const auto target = kept.of(phase);
    fit.steps[phase] +=
        phaseFit.run(*target, options.fit.bending, pullOf(fit, times, phase, options.fit.smoothing),
                     options.smoothingSteps, pose, progress);
    fit.freeVolumesMl.push_back(rig.volumesMl(rig.vertices(pose)));
    if (options.fit.keepVolumes) {
      const Metric metric = [&](const Points& gradient) { return phaseFit.solve(gradient); };
      Points free = pose;
      fit.volumes.push_back(solveVolumes(rig, target->volumesMl, metric, free));
      pose = std::move(free);
    }
  }
  progress.report(1);
  return fit;
}

} // namespace viscera::tracking
