#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viscera/core/phrase.h"

/// A table of normal ranges of healthy adults, each row with its source. Charts, the check of imported
/// organs, the circulation, reports and lessons read it.
namespace viscera::anatomy {

/// The sex for which a normal range is wanted.
enum class Sex {
  either, ///< From the lower bound of one sex to the upper bound of the other.
  women,
  men,
};

/// The person with whose normal ranges a number is compared: sex and body surface.
struct Person {
  Sex sex = Sex::either;
  double bodySurfaceM2 = 0; ///< m2; 0: not known, ranges are those of people of any size.

  bool operator==(const Person&) const = default;
};

/// Body surfaces that a person may be given, m2.
inline constexpr double kSmallestBodySurfaceM2 = 1.2;
inline constexpr double kLargestBodySurfaceM2 = 2.8;

/// Mean and standard deviation.
struct Measured {
  double mean = 0;
  double deviation = 0;
};

/// A range of values; infinite where there is no bound.
struct Range {
  double low = 0;
  double high = 0;

  bool holds(double value) const { return value >= low && value <= high; }
};

/// The statistical meaning of the bounds of a row.
enum class Kind {
  spread,   ///< Mean minus to mean plus two standard deviations: 19 of 20 healthy people lie within.
  limits,   ///< As the source draws them: a guideline, or what is customary.
  averages, ///< From the mean of women to that of men: people differ by more than that.
};

/// A bound from which, or below which, a number is a sign of a disease.
struct DiseaseLimit {
  std::string name;   ///< "severe stenosis"
  double bound = 0;   ///< In the unit of the row.
  bool above = true;  ///< Ill from the bound on; else up to it.
  std::string source; ///< With its DOI.
};

/// One row of the table: a number with its normal range and source.
struct Norm {
  std::string id;       ///< "lv.edv"
  std::string subject;  ///< "Left ventricle"
  std::string quantity; ///< "end-diastolic volume"
  std::string unit;     ///< "ml"
  Kind kind = Kind::spread;
  std::string
      people; ///< The people and the method: "800 healthy people of 45 to 74 years, by magnetic resonance".
  std::string source; ///< "Petersen 2017, doi 10.1186/s12968-017-0327-9"
  std::optional<Measured> women = {};
  std::optional<Measured> men = {};
  std::optional<Measured> bothSexes = {};  ///< If the source does not distinguish the sexes.
  std::optional<Measured> womenPerM2 = {}; ///< A square metre of body surface.
  std::optional<Measured> menPerM2 = {};
  std::optional<Range> limits = {};       ///< Of `Kind::limits`.
  std::vector<DiseaseLimit> disease = {}; ///< Not the range of healthy people, which ends before.

  /// Whether the row distinguishes women and men, or small and large people.
  bool knowsSex() const { return women.has_value(); }
  bool knowsSize() const { return womenPerM2.has_value(); }
};

/// All rows, those of one subject together. O(1) after the first call; thread-safe, as all of this module.
const std::vector<Norm>& norms();

/// The row of that id. Throws `UsageError` when there is none.
const Norm& norm(std::string_view id);

/// Computes the normal range for a person. Properties of the person that the row does not distinguish are
/// ignored.
///
///     const Norm& volume = norm("lv.edv");
///     const Range range = rangeOf(volume, {Sex::women, 1.8});
///     const bool usual = range.holds(120);
Range rangeOf(const Norm& norm, const Person& person = {});

/// Describes how `rangeOf` is computed: "women, mean +- 2 standard deviations, for 1.8 m2 of body surface".
Text meaningOf(const Norm& norm, const Person& person = {});

/// "women and men", "women", "men".
std::string_view nameOf(Sex sex);
/// Parses "either", "women" or "men" from files; anything else is either.
Sex sexFromId(std::string_view id);
std::string_view idOf(Sex sex);

} // namespace viscera::anatomy
