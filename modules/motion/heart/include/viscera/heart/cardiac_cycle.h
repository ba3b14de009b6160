#pragma once

#include <vector>

#include "viscera/heart/cardiac_times.h"
#include "viscera/sequences/curve.h"
#include "viscera/sequences/sequence.h"

namespace viscera::heart {

/// The volumes of the left and the right ventricle, or of the two atria.
struct CavityVolumes {
  double leftMl = 0;
  double rightMl = 0;
};

/// The state of the cardiac cycle at one instant: volumes, emptying, twist and contraction of the atria.
struct CardiacInstant {
  CavityVolumes volumes;
  /// The part of the stroke volume at rest that has left each ventricle: 0 at the end of diastole at rest, 1
  /// at the end of systole. At rates too fast for filling it does not return to 0.
  double leftEmptying = 0;
  double rightEmptying = 0;
  double twist = 0;             ///< Part of the largest one; slightly negative when it starts.
  double atrialContraction = 0; ///< 0 to 1.
};

/// The course of one heartbeat at a given rate. Immutable; thread-safe.
class CardiacBeat {
public:
  const CardiacTimes& times() const { return times_; }
  const VentricleClock& left() const { return left_; }
  const VentricleClock& right() const { return right_; }
  /// The stroke volume as a part of that at rest.
  double strokePart() const { return stroke_; }

  /// The heart at `seconds` after the start of a beat; periodic. Continuously differentiable in time and
  /// continuous in the rate. O(1).
  CardiacInstant at(double seconds) const;

private:
  friend class CardiacCycle;
  CardiacBeat(double rateBpm, const CavityVolumes& endDiastole, const CavityVolumes& endSystole);
  double emptying(double secondsInBeat, const VentricleClock& clock) const;

  CavityVolumes endDiastole_;
  CavityVolumes endSystole_;
  CardiacTimes times_;
  VentricleClock left_;
  VentricleClock right_;
  double stroke_ = 1;
  sequences::Curve twist_;
  sequences::Curve atrial_;
};

/// The events of the left heart in one beat, s after its beginning, each no earlier than the one before;
/// later ones may lie beyond the end of the beat.
struct LeftHeartEvents {
  double cycle = 0;
  double atriaContract = 0;
  VentricleClock valves;   ///< Mitral and aortic.
  double earlyFilling = 0; ///< How long the E wave lasts after the mitral valve has opened.
};

/// The parts of a beat by name, covering [0, 1]: atrial systole, isovolumic contraction, rapid and reduced
/// ejection (the first 45 % of the time and the rest), isovolumic relaxation, rapid filling, diastasis; the
/// part in which the beat begins and ends comes first and last. Parts that take no time are missing. The
/// textbook's heartbeat and that of a circulation both use it. O(1).
std::vector<sequences::Phase> phasesOf(const LeftHeartEvents& events);

/// The textbook's cardiac cycle: volumes and events of a beat at any rate. A beat starts `kBeforeAtria`
/// before the atria's contraction; how long its parts last at each rate is `cardiacTimes`.
///
/// Standard volumes at rest: left ventricle 130.5 ml at the end of diastole, 55 ml at the end of systole
/// (ejection fraction 0.58, the mean of healthy men: UK Biobank, doi 10.1186/s12968-017-0327-9); right
/// ventricle 138 and 62.5 ml: it ejects as much as the left one. A beat empties the ventricles to the same
/// volumes at every rate; how full they get depends on the time for filling (`strokePart`). Immutable;
/// thread-safe.
///
///     const CardiacBeat beat = CardiacCycle().beat(75);
///     const double duringEjection = beat.at(beat.left().outletOpens + 0.1).volumes.leftMl;
class CardiacCycle {
public:
  static constexpr double kLowestRateBpm = 20;
  static constexpr double kStandardRateBpm = 75;
  static constexpr double kHighestRateBpm = 220;
  static constexpr CavityVolumes kEndDiastole{130.5, 138.0};
  static constexpr CavityVolumes kEndSystole{55.0, 62.5};

  /// A heart whose largest volumes at rest are `endDiastole` and whose smallest are `endSystole`. Throws
  /// `DataError` unless all four are positive and each ventricle's end-systolic volume is the smaller one.
  explicit CardiacCycle(const CavityVolumes& endDiastole = kEndDiastole,
                        const CavityVolumes& endSystole = kEndSystole);

  const CavityVolumes& endDiastole() const { return endDiastole_; }
  const CavityVolumes& endSystole() const { return endSystole_; }

  /// The beat at a rate, clamped to the rates above. O(1), about a microsecond.
  CardiacBeat beat(double rateBpm) const;

  /// The same as `beat(rateBpm).at(seconds)`.
  CardiacInstant at(double seconds, double rateBpm) const { return beat(rateBpm).at(seconds); }

  /// The parts of a beat by name (`phasesOf`); two thirds of the stroke leave in the rapid ejection.
  /// Diastasis is missing where the waves of filling overlap.
  static std::vector<sequences::Phase> phases(double rateBpm);

private:
  CavityVolumes endDiastole_;
  CavityVolumes endSystole_;
};

} // namespace viscera::heart
