#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/heart/clinical_numbers.h"

/// The table of a ventricle's numbers as a clinic writes it: at the ends of diastole and systole, also for
/// each square metre of body surface.
namespace viscera::heart {

/// The ends of diastole and systole, fractions of the cycle.
struct CycleEnds {
  double diastole = 0;
  double systole = 0;

  bool operator==(const CycleEnds&) const = default;
};

/// The ends that a user has chosen; none: they are found.
struct ChosenEnds {
  std::optional<double> diastole; ///< Fraction of the cycle, [0, 1].
  std::optional<double> systole;  ///< The same.

  bool operator==(const ChosenEnds&) const = default;
};

/// Where the volume is largest and smallest, the first of equal ones, unless chosen otherwise. `fractions`
/// ascend, one for each volume. Throws `UsageError` for no volumes and for numbers that differ in count.
/// O(samples).
CycleEnds cycleEnds(const std::vector<double>& fractions, const std::vector<double>& volumesMl,
                    const ChosenEnds& chosen = {});

/// The indices with the volumes at these ends, linear between the samples. Throws as `cycleEnds`, and as
/// `cardiacIndices`. A stroke volume is negative where the chosen ends are the wrong way round. O(samples).
CardiacIndices cardiacIndicesAt(const CycleEnds& ends, const std::vector<double>& fractions,
                                const std::vector<double>& volumesMl, double ratePerMinute);

/// The body surface by Mosteller, m2, of a height in cm and a weight in kg. Throws `UsageError` for less than
/// 30 cm or 1 kg, or more than 250 cm or 400 kg.
double bodySurfaceM2(double heightCm, double weightKg);

/// The mass of the muscle that is among organs with their names and volumes at rest, ml: of the first
/// myocardium, 1.05 g a ml; none without one.
std::optional<double> muscleGrams(const std::vector<std::pair<std::string, double>>& organs);

/// One row of the table.
struct HeartNumber {
  std::string id;              ///< "edv", "esv", "sv", "ef", "co", "mass": stable, for files.
  Text name;                   ///< "end-diastolic volume"
  std::string unit;            ///< "ml", "%", "l/min", "g"
  double value = 0;            ///< In that unit.
  std::optional<double> perM2; ///< For each square metre; none for an ejection fraction, and without surface.
  int digits = 1;              ///< Decimals that are worth showing.
};

/// EDV, ESV, SV, EF, CO and, where it is known, the mass. Without a body surface (0) nothing is indexed.
std::vector<HeartNumber> heartNumbers(const CardiacIndices& indices, std::optional<double> massG,
                                      double bodySurfaceM2);

/// The tables of several ventricles as CSV with a header, one line for each number:
/// `organ,number,value,unit,value_per_m2`, numbers with a decimal point.
std::string heartNumbersCsv(const std::vector<std::pair<std::string, std::vector<HeartNumber>>>& ventricles);

} // namespace viscera::heart
