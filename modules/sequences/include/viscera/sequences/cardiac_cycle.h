#pragma once

#include <vector>

#include "viscera/sequences/curve.h"
#include "viscera/sequences/sequence.h"

namespace viscera::sequences {

/// What the two ventricles hold.
struct CavityVolumes {
  double leftMl = 0;
  double rightMl = 0;
};

/// How long each part of one beat lasts, s.
struct CardiacTimes {
  double atrialSystole = 0;
  double isovolumicContraction = 0;
  double ejection = 0;
  double isovolumicRelaxation = 0;
  double rapidFilling = 0;
  double diastasis = 0; ///< The rest of diastole, in which little flows.

  double systole() const { return isovolumicContraction + ejection; }
  double cycle() const { return systole() + atrialSystole + isovolumicRelaxation + rapidFilling + diastasis; }
};

/// What happens in one beat, and when. Events are kept over a reference phase in [0, 1) that starts with the
/// atria's contraction; `referencePhase` says where in it a beat of a given rate is. So every rate passes
/// through the same states, and only the time between them changes. Immutable; thread-safe; every member is
/// O(1).
///
/// Standard volumes: left ventricle 130.5 ml at the end of diastole, 55 ml at the end of systole (ejection
/// fraction 0.58; cardiac magnetic resonance gives 135 +- 26 and 42 +- 12 ml in women, 160 +- 29 and 50 +- 16
/// ml in men); right ventricle 138 and 66 ml on a curve of the same shape.
class CardiacCycle {
public:
  static constexpr double kLowestRateBpm = 20;
  static constexpr double kStandardRateBpm = 75;
  static constexpr double kHighestRateBpm = 220;
  static constexpr CavityVolumes kEndDiastole{130.5, 138.0};
  static constexpr CavityVolumes kEndSystole{55.0, 66.0};

  /// A heart that holds `endDiastole` at most and `endSystole` at least. Throws `DataError` unless all four
  /// are positive and each ventricle's end-systolic volume is the smaller one.
  explicit CardiacCycle(const CavityVolumes& endDiastole = kEndDiastole,
                        const CavityVolumes& endSystole = kEndSystole);

  const CavityVolumes& endDiastole() const { return endDiastole_; }
  const CavityVolumes& endSystole() const { return endSystole_; }

  /// What the ventricles hold at reference phase `phase` (any number; periodic with 1).
  CavityVolumes volumes(double phase) const;
  /// How much of the stroke has left the ventricles: 0 at the end of diastole, 1 at the end of systole.
  double emptying(double phase) const;
  /// The ventricles' twist about their long axis as a part of the largest one; slightly negative when it
  /// starts.
  double twist(double phase) const;
  /// How far the atria are contracted, 0 to 1.
  double atrialContraction(double phase) const;

  /// The parts of a beat at `rateBpm` (clamped to the rates above). Systole, from the closing of the mitral
  /// valve to that of the aortic valve, takes 0.30 to 0.33 s up to 150 beats a minute and three quarters of
  /// the beat above; diastole takes the rest: in long beats the diastasis stretches, in short ones all its
  /// parts shrink together.
  static CardiacTimes times(double rateBpm);

  /// The reference phase at `seconds` after the start of a beat of that rate. Strictly ascending,
  /// continuously differentiable in time, continuous in the rate, and 1 larger after each beat.
  double referencePhase(double seconds, double rateBpm) const;

  /// The parts of a beat by name; diastasis belongs to filling.
  static std::vector<Phase> phases(double rateBpm);

private:
  CavityVolumes endDiastole_;
  CavityVolumes endSystole_;
  Curve leftMl_; ///< Of the standard heart.
  Curve twist_;
  Curve atrial_;
};

} // namespace viscera::sequences
