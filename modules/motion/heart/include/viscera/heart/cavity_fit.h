#pragma once

#include <functional>
#include <optional>

#include <Eigen/Core>

#include "viscera/heart/cardiac_cycle.h"
#include "viscera/heart/heart_motion.h"
#include "viscera/sequences/pose_compensation.h"

/// Poses the handles of a heart so that its cavities have given volumes.
namespace viscera::heart {

/// Measures the volumes of a heart's cavities when its handles are at `pose` (`n x 3`). May be called from
/// several threads.
using MeasureCavities = std::function<CavityVolumes(const Points& pose)>;

/// The wanted state of a heart at one instant of its beat: its motion and the volumes of its cavities.
struct HeartInstant {
  HeartState state;      ///< Without corrections.
  CavityVolumes volumes; ///< The wanted volumes of the ventricles.
  /// The wanted volumes of the atria, if they are known; `state.atria` is then set too.
  std::optional<CavityVolumes> atria;
};

/// The solution for one instant, from which the search at a near instant can start.
struct FoundCavities {
  /// The left cavity's gain, the right one's shift and, where the atria are known, theirs.
  Eigen::VectorXd corrections;
  Eigen::MatrixXd jacobian; ///< Of the volumes (ml) by the corrections.
};

/// The heart at an instant of a beat, without corrections.
HeartInstant heartInstant(const CardiacCycle& cycle, const CardiacInstant& now);

/// Finds the pose of a heart's handles in which its cavities have given volumes: in every pose the left
/// cavity's gain, the right one's shift and, where the atria's volumes are known, theirs are found on the
/// measured cavities. The handles are affine in them, so that only measuring is repeated, about eight times
/// (two or four equations by Broyden's method). Immutable; as thread-safe as `measure` and `measureAtria`.
class CavityFit {
public:
  /// The largest difference of the cavities' volumes from the wanted ones, ml.
  static constexpr double kToleranceMl = 1e-5;

  /// The atria move by the state where there is no `measureAtria`, and their volumes are not controlled.
  /// Throws `DataError` when the compensation is for another number of handles.
  CavityFit(HeartMotion motion, sequences::PoseCompensation compensation, MeasureCavities measure,
            MeasureCavities measureAtria = {});

  const HeartMotion& motion() const { return motion_; }
  const Points& restHandles() const { return rest_; }

  /// Fills `pose`, and returns the state with the corrections that were found. Throws `DataError` when the
  /// volumes cannot be reached, or are not finite. O(n^2) with a compensation, and eight measurements.
  ///
  /// The search begins with the solution in `found`, if any, and stores its own there: from a near solution,
  /// two measurements are enough. A solution that leads nowhere costs time only.
  HeartState pose(const HeartInstant& instant, Points& pose, FoundCavities* found = nullptr) const;

private:
  HeartMotion motion_;
  sequences::PoseCompensation compensation_;
  MeasureCavities measure_, measureAtria_;
  Points rest_;
};

} // namespace viscera::heart
