#pragma once

#include <string>
#include <vector>

#include "viscera/sequences/sequence.h"

namespace viscera::sequences {

/// Where the waves of a stomach arise and end, and how deep they are; places are arc lengths of its
/// centreline from the top of the fundus, mm.
struct GastricCourse {
  double midBody = 101; ///< Where waves arise.
  double pylorus = 272; ///< Where they end.
  double depth = 1; ///< How deep waves are, as a part of an adult's, above 0: less where folds would meet.
};

/// The ring-shaped contractions that run down the stomach. At the standard rate one arises every 20 s, takes
/// 63 s for the 171 mm to the pylorus, and three are on their way at a time (an unvarying 2.7 mm/s in the
/// antrum: doi 10.1002/jmri.20738; 3.0 +- 0.2 a minute, occlusion 58 +- 14 %:
/// doi 10.1046/j.1365-2982.2001.00285.x, which measured 1.6 mm/s; waves of the electrical control run at 3 to
/// 6 mm/s, contractions do not). The pylorus shuts before the terminal antral contraction has come to it,
/// halfway through its last 28 mm, and throws most of the content back; it opens while the wave fades (seen
/// by ultrasound in 22 people: "Coordinated motor activity of the human gastroduodenal region", Dig Dis Sci
/// 1985; flow through it: doi 10.1136/gut.25.12.1384). At other rates waves run as fast and arise more or
/// less often, above 4 a minute the shallower the more often. Immutable; thread-safe; every member is
/// O(waves).
class GastricWaves {
public:
  static constexpr double kLowestRate = 1;
  static constexpr double kStandardRate = 3;
  static constexpr double kHighestRate = 6;
  /// Slower is bradygastria, faster tachygastria (doi 10.5056/jnm.2013.19.1.5).
  static constexpr double kLowestNormalRate = 2;
  static constexpr double kHighestNormalRate = 4;
  static constexpr double kSpeed = 2.7; ///< Of every wave, mm/s.

  /// Throws `DataError` unless the pylorus lies beyond the middle of the body and the depth is above 0.
  explicit GastricWaves(const GastricCourse& course = {});

  const GastricCourse& course() const { return course_; }

  /// How long a wave takes from the middle of the body to the pylorus, s.
  double transitSeconds() const;

  /// The place of a wave `age` seconds after it arose; it does not move while it forms and fades.
  double position(double age) const;
  /// The part of the radius by which it narrows the stomach there, at the standard rate.
  double depth(double age) const;
  /// How far the pylorus is closed, 0 to 1: shut.
  double pyloricClosure(double seconds, double ratePerMinute) const;

  /// The part of the radius by which all waves and the pylorus together narrow the stomach at arc length `s`,
  /// below 1. Periodic with 60 / rate; continuously differentiable.
  double constriction(double s, double seconds, double ratePerMinute) const;

  /// Where the waves are that narrow the stomach by more than 5 %, the oldest first.
  std::vector<double> positions(double seconds, double ratePerMinute) const;

  /// Places from the top of the fundus to the pylorus, as parts of that way: fundus, body, antrum, pylorus.
  std::vector<NamedPlace> places() const;
  /// The waves of `positions` as parts of that way, with the part of the radius by which each narrows the
  /// stomach.
  std::vector<TravellingMark> travelling(double seconds, double ratePerMinute) const;

  /// "Bradygastria: ..." and "Tachygastria: ..."; empty for rates that healthy people have.
  static Text rateRemark(double ratePerMinute);

  /// The parts of a cycle, named after the place of the wave that is farthest on its way.
  std::vector<Phase> phases(double ratePerMinute) const;

private:
  /// The ages of the present waves, the oldest first.
  std::vector<double> ages(double seconds, double ratePerMinute) const;
  /// The same at any rate.
  double depth(double age, double ratePerMinute) const;
  /// The part of its radius by which a wave of that age makes the pylorus close.
  double pylorusClosureAt(double age) const;
  /// The part of the way from the middle of the body to the pylorus, 0 to 1.
  double progress(double age) const;
  const char* placeOf(double age) const;

  GastricCourse course_;
  double length_;
};

} // namespace viscera::sequences
