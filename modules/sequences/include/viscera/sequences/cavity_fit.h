#pragma once

#include <functional>

#include "viscera/sequences/cardiac_cycle.h"
#include "viscera/sequences/heart_motion.h"
#include "viscera/sequences/pose_compensation.h"

namespace viscera::sequences {

/// What the cavities of a heart hold when its handles are at `pose` (`n x 3`). May be asked from several
/// threads.
using MeasureCavities = std::function<CavityVolumes(const Points& pose)>;

/// What a heart is to be like at one instant of its beat.
struct HeartInstant {
  HeartState state;      ///< Without corrections.
  CavityVolumes volumes; ///< What its cavities are to hold.
};

/// The heart at an instant of a beat, without corrections.
HeartInstant heartInstant(const CardiacCycle& cycle, const CardiacInstant& now);

/// The handles of a heart whose cavities hold what they are to hold: in every pose the left cavity's gain and
/// the right one's shift are found on the measured cavities. The handles are affine in the two, so that only
/// measuring is repeated, about eight times (two equations by Broyden's method). Immutable; as thread-safe as
/// `measure`.
class CavityFit {
public:
  /// How near the cavities come to what they are to hold, ml.
  static constexpr double kToleranceMl = 1e-5;

  /// Throws `DataError` when the compensation is for another number of handles.
  CavityFit(HeartMotion motion, PoseCompensation compensation, MeasureCavities measure);

  const HeartMotion& motion() const { return motion_; }
  const Points& restHandles() const { return rest_; }

  /// Fills `pose`, and returns the state with the corrections that were found. Throws `DataError` when the
  /// volumes cannot be reached, or are not finite. O(n^2) with a compensation, and eight measurements.
  HeartState pose(const HeartInstant& instant, Points& pose) const;

private:
  HeartMotion motion_;
  PoseCompensation compensation_;
  MeasureCavities measure_;
  Points rest_;
};

} // namespace viscera::sequences
