#pragma once

#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/sequences/gastric_waves.h"
#include "viscera/sequences/pose_compensation.h"
#include "viscera/sequences/sequence.h"
#include "viscera/sequences/stomach_rig.h"

namespace viscera::sequences {

/// The sequence of peristaltic waves, which run down the stomach while it keeps its volume: the upper stomach
/// takes in the volume that they press out of the antrum.
///
/// A ring at arc length s has the factor `[1 - constriction(s, t)] [1 + B beta(s)]` about its centre, beta a
/// bell over the upper stomach. The handles are affine in B, so the organ's volume is a cubic in B; its root
/// keeps the volume of the organ that `volume` measures to rounding, at every instant and rate. Thread-safe
/// as far as `volume` is.
class Peristalsis final : public Sequence {
public:
  /// Keeps the volume at rest. Throws `DataError` when the compensation is for another number of handles, or
  /// when the upper stomach cannot take in the volume that is pressed out at some instant of a cycle at the
  /// standard rate.
  Peristalsis(StomachRig rig, PoseCompensation compensation, VolumeAlong volume);

  std::string id() const override { return "peristalsis"; }
  Text name() const override { return "Gastric peristalsis"; }
  const Points& restHandles() const override { return rest_; }
  std::vector<HandleGroup> groups() const override { return rig_.groups(); }
  double standardRatePerMinute() const override { return GastricWaves::kStandardRate; }
  double lowestRatePerMinute() const override { return GastricWaves::kLowestRate; }
  double highestRatePerMinute() const override { return GastricWaves::kHighestRate; }
  Text rateRemark(double ratePerMinute) const override { return GastricWaves::rateRemark(ratePerMinute); }

  /// One call of `volume`, and O(n^2). Throws `DataError` when no B keeps the volume.
  void poseAt(double seconds, double ratePerMinute, Points& pose) const override;
  std::vector<Phase> phases(double ratePerMinute) const override { return waves_.phases(ratePerMinute); }

  std::vector<NamedPlace> course() const override { return waves_.places(); }
  std::vector<TravellingMark> travelling(double seconds, double ratePerMinute) const override {
    return waves_.travelling(seconds, ratePerMinute);
  }

  const GastricWaves& waves() const { return waves_; }
  const StomachRig& rig() const { return rig_; }
  double keptMl() const { return keptMl_; }
  /// How much the upper stomach widens at that moment (B).
  double widening(double seconds, double ratePerMinute) const;

private:
  /// The compensated pose without widening, and the difference that a widening of 1 makes.
  void affinePose(double seconds, double ratePerMinute, Points& narrowed, Points& added) const;
  double wideningFor(const Points& narrowed, const Points& added, double seconds) const;

  StomachRig rig_;
  PoseCompensation compensation_;
  VolumeAlong volume_;
  GastricWaves waves_;
  Points rest_;
  double keptMl_ = 0;
};

} // namespace viscera::sequences
