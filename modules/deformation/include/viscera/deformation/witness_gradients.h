#pragma once

#include <memory>
#include <span>
#include <vector>

#include "viscera/coordinates/coordinate_system.h"
#include "viscera/coordinates/tiled_weights.h"
#include "viscera/deformation/rotational_stress.h"

namespace viscera::deformation {

/// The greatest that each point of a neo-Hookean tissue feels over several poses, by its shear modulus: their
/// stretches are extremes of different poses, from which it does not follow.
struct TissueExtremes {
  Values vonMisesPerShear;
  Values energyPerShear;
  double poisson = 0; ///< Poisson's ratio of the energy.
};

/// The stress map of a pose: the distortion at every witness point.
struct StressMap {
  Values rotationalStress; ///< rad.
  Values volumeRatio;      ///< det M.
  Values stretchMax;
  Values stretchMin;
  int folded = 0;                                           ///< Witnesses with det M <= 0.
  std::shared_ptr<const TissueExtremes> extremes = nullptr; ///< Of the extremes over several poses only.
};

/// Summary statistics of a stress map: mean, largest and others. Folded witnesses are left out of the angles
/// and counted apart; the angles are zeros when there are no others.
struct StressStatistics {
  double min = 0;          ///< rad.
  double mean = 0;         ///< rad.
  double percentile95 = 0; ///< rad.
  double max = 0;          ///< rad.
  int folded = 0;          ///< Witnesses with det M <= 0.
};

/// Statistics of the first `count` points of the map only: a `WitnessMesh` has its witness points first.
StressStatistics statisticsOf(const StressMap& map, Eigen::Index count);

/// The derivatives of the coordinates at fixed witness points inside an organ, laid out so that a new pose's
/// whole map is one pass: `M = sum_i v'_i (grad a_i)^T` (thesis 5.2). Thread-safe once it is filled.
class WitnessGradients {
public:
  /// Makes room for `witnesses` points that `put` fills in portions; their derivatives are zero until then.
  /// `lift` is that of the gradients passed to `put`.
  WitnessGradients(Eigen::Index witnesses, Eigen::Index handles,
                   std::shared_ptr<const coordinates::PoseLift> lift = {});

  /// Fills in the points [begin, begin + count), whose numbers in the failures of `gradients` begin with 0;
  /// those get the identity. Portions come in ascending order.
  void put(Eigen::Index begin, const coordinates::CoordinateGradients& gradients, Eigen::Index count);

  Eigen::Index witnesses() const { return witnesses_; }
  Eigen::Index handles() const { return handles_; }
  bool closedForm() const { return closedForm_; }
  /// Whether the deformation gradients are linear in the pose, with `gradient` for their derivatives.
  bool linear() const { return !lift_; }
  const std::vector<int>& failures() const { return failures_; }

  /// The deformation gradient of one witness at `pose` (`handles x 3`, mm). O(handles).
  Eigen::Matrix3d deformationGradient(Eigen::Index witness, const Points& pose) const;

  /// Writes all of them into `gradients` (resized); the identity where a witness has failed. O(witnesses
  /// x handles); bitwise independent of the number of threads. Throws `DataError` for a pose of another size.
  void deformationGradients(const Points& pose, std::vector<Eigen::Matrix3d>& gradients,
                            Threads threads = {}) const;

  /// The derivative of one handle's coordinate at one witness, 1/mm. For lifted poses this is only a part of
  /// the handle's effect.
  Vec3 gradient(Eigen::Index witness, Eigen::Index handle) const {
    return {data_(rowOf(witness, 0), handle), data_(rowOf(witness, 1), handle),
            data_(rowOf(witness, 2), handle)};
  }
  /// Whether the witness has no coordinates and gets the identity.
  bool failed(Eigen::Index witness) const { return failed_[static_cast<std::size_t>(witness)]; }

  /// Fills `map` (resized) at `pose`. O(witnesses x handles); bitwise independent of the number of threads.
  /// Throws `DataError` for a pose of another size.
  void evaluate(const Points& pose, StressMap& map, Threads threads = {}) const;
  /// The same for several poses at the first `count` witnesses, `maps[i]` of `poses[i]`: the derivatives are
  /// read from memory once for all of them, since memory limits the speed with many handles. Same values to
  /// the bit.
  void evaluate(std::span<const Points> poses, std::span<StressMap> maps, Eigen::Index count,
                Threads threads = {}) const;

private:
  static constexpr Eigen::Index kTile = coordinates::TiledWeights::kTile;
  /// Three tiles for 16 witnesses, one for each axis.
  static Eigen::Index rowOf(Eigen::Index witness, Eigen::Index axis) {
    return (3 * (witness / kTile) + axis) * kTile + witness % kTile;
  }
  Points lifted(const Points& pose) const { return lift_ ? lift_->lift(pose) : pose; }
  /// The pose about its first handle: the gradients add up to zero, so the origin cancels, and the sums stay
  /// small. Throws `DataError` for a pose of another size.
  Points localPose(const Points& pose) const;
  /// Calls `take(witness, gradient)` for the first `count` witnesses' share of a tile.
  template <class Take>
  void gradientsOfTile(Eigen::Index tile, const Points& local, Eigen::Index count, const Take& take) const;
  void evaluateTile(Eigen::Index tile, const Points& local, StressMap& map) const;

  Eigen::Index witnesses_;
  Eigen::Index handles_;
  std::shared_ptr<const coordinates::PoseLift> lift_;
  Eigen::Index rows_; ///< Of a lifted pose; `handles_` where there is no lift.
  bool closedForm_ = true;
  std::vector<int> failures_;
  std::vector<bool> failed_;
  /// Row `rowOf(w, a)`: the derivatives of all coordinates at witness w along axis a.
  coordinates::TiledWeights data_;
};

/// The derivatives of the coordinates at `points` (`n x 3`, the points of a witness mesh), taken in portions
/// so that memory holds them once only: `n x handles x 24` bytes. Reports progress and may be cancelled
/// between the portions. Points without coordinates are in the result's failures. Throws what
/// `coordinates::CoordinateSystem::gradients` throws.
std::shared_ptr<const WitnessGradients>
bindWitnesses(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
              const Points& points, const coordinates::BindOptions& options, Progress& progress);

} // namespace viscera::deformation
