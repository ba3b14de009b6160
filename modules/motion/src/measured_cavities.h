#pragma once

#include "sample_heart.h"
#include "sequence_binding.h"
#include "viscera/sample_organs/sample_organ.h"
#include "viscera/sequences/cardiac_cycle.h"

namespace viscera::motion {

/// What the cavities of the sample heart hold in any pose of its handles, by their surfaces themselves: a
/// third of a millisecond for both, which is less than a form of all handles takes. Immutable; thread-safe.
class MeasuredCavities {
public:
  /// Binds both. Some 20 ms.
  MeasuredCavities(const sample_organs::SampleOrgan& organ, const SampleHeart& heart, Threads threads)
      : left_(surfaceOf(organ, "lv"), heart.rest, heart.system, threads),
        right_(surfaceOf(organ, "rv"), heart.rest, heart.system, threads) {}

  sequences::CavityVolumes at(const Points& pose) const { return {left_.at(pose), right_.at(pose)}; }

private:
  MovedVolume left_;
  MovedVolume right_;
};

} // namespace viscera::motion
