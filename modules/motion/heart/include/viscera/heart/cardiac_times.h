#pragma once

#include <algorithm>

namespace viscera::heart {

/// The lowest and the highest rate, in beats a minute, at which the regressions below were measured:
/// Weissler's men at rest from 50, Lance and Spodick's men on a bicycle up to 171. Beyond them the lines are
/// extrapolated.
inline constexpr double kLowestMeasuredBpm = 50;
inline constexpr double kHighestMeasuredBpm = 171;

/// A beat begins so long before the atria contract, s: before the P wave of the electrocardiogram, which
/// lasts 0.08 to 0.11 s and comes before its contraction. The textbook's beat and that of a circulation both
/// do.
inline constexpr double kBeforeAtria = 0.08;

/// How long each part of one beat of the left heart lasts, s.
struct CardiacTimes {
  double cycle = 0;
  double atrialSystole = 0; ///< The A wave of the inflow, to the closing of the mitral valve.
  double isovolumicContraction = 0;
  double ejection = 0;
  double isovolumicRelaxation = 0;
  double earlyFilling = 0; ///< The E wave; in fast hearts it ends while the atria contract.

  /// Time from the closing of the mitral valve to that of the aortic valve.
  double systole() const { return isovolumicContraction + ejection; }
  double diastole() const { return cycle - systole(); }
  /// How long the mitral valve is open.
  double filling() const { return diastole() - isovolumicRelaxation; }
  /// Between the two waves, when little flows; 0 where they overlap.
  double diastasis() const { return std::max(0.0, filling() - earlyFilling - atrialSystole); }
  /// The time in which both waves overlap.
  double overlap() const { return std::max(0.0, earlyFilling + atrialSystole - filling()); }
};

/// The times at `rateBpm`, of healthy adults. O(1).
///
/// * Ejection: max(413 - 1.7 rate, 371 - 1.2 rate) ms, 130 ms at least: men at rest (Weissler and others
///   1968, doi 10.1161/01.CIR.37.2.149) and upright on a bicycle (Lance and Spodick, 18 men, +- 13.9
///   ms).
/// * Isovolumic contraction: 40 ms at 65 a minute (40 +- 10 in the Copenhagen study), 0.4 ms less for each
///   beat more, as the pre-ejection period at rest (Lewis and others 1977, doi 10.1161/01.CIR.56.2.146;
///   that contraction shortens as that does: Nandi and Spodick 1977); between 40 and 25 ms.
/// * Isovolumic relaxation: 96 ms at 65 (96 +- 19, Copenhagen), falling exponentially so that it has lost
///   54 % when the rate has risen by 85 %, as in supine exercise (30 young people, echo-polygraphy, 1985);
///   between 110 and 25 ms.
/// * E wave 200 ms and A wave 110 ms at 75, shorter by 18 and 16 % whenever the rate doubles (Chung and
///   others 2004, doi 10.1152/ajpheart.00404.2004). Diastasis, the remaining time, vanishes at 93; above that
///   the waves overlap. E lasts no longer than the valve is open, A 0.8 of that.
CardiacTimes cardiacTimes(double rateBpm);

/// The part of the stroke volume at rest that a heart with these times still fills with: 1 until diastole is
/// so short that blood would have to enter faster than `kFastestFilling`, then less.
double strokePart(const CardiacTimes& times, double strokeMl);

/// The mean flow into a ventricle over diastole, ml/s, at maximum stress: 219 +- 92 ml/s for each m2 of
/// the body in 161 people sent for a stress echocardiogram (Bombardini and others 2008,
/// doi 10.1186/1476-7120-6-15), here 1.75 m2, which is a choice. A bound, not a measured fall:
/// docs/sequences.md lists sources that disagree.
inline constexpr double kFastestFilling = 219 * 1.75;

/// The times at which the valves of one ventricle open and close, s after the beginning of a beat, in their
/// order: in a fast heart the last ones belong to the beat that has begun then.
struct VentricleClock {
  double inletShuts = 0; ///< Mitral or tricuspid valve.
  double outletOpens = 0;
  double outletShuts = 0;
  double inletOpens = 0;

  double isovolumicContraction() const { return outletOpens - inletShuts; }
  double isovolumicRelaxation() const { return inletOpens - outletShuts; }
};

VentricleClock leftClock(const CardiacTimes& times);

/// The right ventricle's: it works against a sixth of the pressure, so its valves rest for a shorter time.
/// The tricuspid valve shuts after the mitral one (10 ms at rest) and opens before it, the pulmonary valve
/// opens before the aortic one and shuts after it (15 ms: the split second sound). Relaxation is shorter than
/// the left one's on average in 42 healthy people (Larrazet and others, J Am Soc Echocardiogr
/// 1997;10:699-706); the parts themselves are textbook values.
VentricleClock rightClock(const CardiacTimes& times);

} // namespace viscera::heart
