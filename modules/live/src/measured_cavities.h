#pragma once

#include "sample_heart.h"
#include "sequence_binding.h"
#include "viscera/heart/cardiac_cycle.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::live {

/// Measures the volumes of the sample heart's cavities in any pose of its handles, from their posed surfaces:
/// a third of a millisecond for both ventricles, less for both atria, which is less than a volume form of all
/// handles takes. Immutable; thread-safe.
class MeasuredCavities {
public:
  /// Binds all four. Some 30 ms.
  MeasuredCavities(const sample_organs::SampleOrgan& organ, const SampleHeart& heart, Threads threads)
      : left_(surfaceOf(organ, "lv"), heart.rest, heart.system, threads),
        right_(surfaceOf(organ, "rv"), heart.rest, heart.system, threads),
        leftAtrium_(surfaceOf(organ, "la"), heart.rest, heart.system, threads),
        rightAtrium_(surfaceOf(organ, "ra"), heart.rest, heart.system, threads) {}

  heart::CavityVolumes at(const Points& pose) const { return {left_.at(pose), right_.at(pose)}; }
  heart::CavityVolumes atriaAt(const Points& pose) const {
    return {leftAtrium_.at(pose), rightAtrium_.at(pose)};
  }

private:
  MovedVolume left_;
  MovedVolume right_;
  MovedVolume leftAtrium_;
  MovedVolume rightAtrium_;
};

} // namespace viscera::live
