#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/heart/beating_heart.h"
#include "viscera/heart/cavity_fit.h"
#include "viscera/sequences/sequence.h"

namespace viscera::heart {

/// The base of the sequences in which a heart beats by the textbook's cycle: phases, valves and groups of
/// handles.
class Heartbeat : public sequences::Sequence, public BeatingHeart {
public:
  std::string id() const override { return "heartbeat"; }
  Text name() const override { return "Heartbeat"; }
  std::vector<sequences::HandleGroup> groups() const override { return motion().rig().groups(); }
  double standardRatePerMinute() const override { return CardiacCycle::kStandardRateBpm; }
  double lowestRatePerMinute() const override { return CardiacCycle::kLowestRateBpm; }
  double highestRatePerMinute() const override { return CardiacCycle::kHighestRateBpm; }
  double finestStepSeconds() const override { return 0.01; }
  Text rateRemark(double ratePerMinute) const override;
  std::vector<sequences::Phase> phases(double ratePerMinute) const override {
    return CardiacCycle::phases(ratePerMinute);
  }

  const BeatingHeart* heart() const override { return this; }
  std::optional<CardiacBeat> textbookBeat(double ratePerMinute) const override {
    return cycle_.beat(ratePerMinute);
  }
  std::optional<ValveInstants> valves(double seconds, double ratePerMinute) const override {
    return textbookValves(cycle_.beat(ratePerMinute), seconds);
  }
  std::optional<BeatClock> clock(double seconds, double ratePerMinute) const override {
    return clockOf(cycle_.beat(ratePerMinute), seconds);
  }
  std::optional<HeartFrame> frame() const override { return std::nullopt; }

  const CardiacCycle& cycle() const { return cycle_; }
  virtual const HeartMotion& motion() const = 0;

protected:
  explicit Heartbeat(CardiacCycle cycle) : cycle_(cycle) {}

private:
  CardiacCycle cycle_;
};

/// The heartbeat of a heart with modelled cavities, whose volumes are those of the cardiac cycle at every
/// instant and rate. Immutable; as thread-safe as the function that measures the cavities.
class CavityHeartbeat final : public Heartbeat {
public:
  /// Throws `DataError` when the volumes cannot be reached somewhere in a beat.
  CavityHeartbeat(CavityFit fit, CardiacCycle cycle);

  const Points& restHandles() const override { return fit_.restHandles(); }
  const HeartMotion& motion() const override { return fit_.motion(); }
  std::optional<HeartFrame> frame() const override { return motion().rig().anatomy.frame; }
  /// Costs one `CavityFit::pose` from a near solution.
  void poseAt(double seconds, double ratePerMinute, Points& pose) const override;

private:
  struct Solution {
    CavityVolumes volumes;
    FoundCavities found;
  };
  const FoundCavities& nearestTo(const CavityVolumes& volumes) const;

  CavityFit fit_;
  std::vector<Solution> solutions_; ///< Of instants of two beats, from which searches at others start.
};

} // namespace viscera::heart
