#include "viscera/medical_io/plausible_size.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

#include "viscera/anatomy/organ_facts.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

/// Diagonals of the box around one organ: an adrenal gland has 40 mm, a whole trunk 1 m.
constexpr double kSmallestDiagonalMm = 25;
constexpr double kLargestDiagonalMm = 1500;
/// Within these the guess of another unit is worth naming.
constexpr double kTypicalLowMm = 60;
constexpr double kTypicalHighMm = 600;

/// Life-sized organs differ from a range of 19 of 20 people, or from means, by at most these factors.
constexpr double kAwayFromSpread = 1.5;
constexpr double kAwayFromAverages = 3;

Text roundedText(double value) {
  return value >= 1000 && value < 1e6 ? Text(std::lround(value)) : inDigits(value);
}

/// The organ that a name means, and its normal volume.
struct Expected {
  anatomy::Part organ;
  const anatomy::Norm* volume = nullptr; ///< Never null.
};

/// None for an organ without a known volume, and for one whose volume depends on what it holds.
std::optional<Expected> expectedOf(std::string_view name) {
  const auto part = anatomy::partNamed(name);
  const anatomy::Norm* volume = part ? anatomy::volumeNormOf(*part) : nullptr;
  if (!volume || anatomy::organ(part->organ).fills)
    return std::nullopt;
  return Expected{*part, volume};
}

/// How far a volume is from what is normal, as a part of how far a life-sized organ may be; 1 and less for
/// those.
double awayFrom(const Expected& organ, double volumeMl) {
  const anatomy::Range range = anatomy::rangeOf(*organ.volume);
  const double factor = std::max({range.low / volumeMl, volumeMl / range.high, 1.0});
  return factor / (organ.volume->kind == anatomy::Kind::averages ? kAwayFromAverages : kAwayFromSpread);
}

/// "a kidney", for sentences.
std::string oneOf(const anatomy::Part& organ) {
  std::string title(anatomy::organ(organ.organ).title);
  title[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(title[0])));
  return "a " + title;
}

/// "19 of 20 adults have 814 to 1906 ml".
Text whatAdultsHave(const anatomy::Norm& norm) {
  const anatomy::Range range = anatomy::rangeOf(norm);
  return norm.kind == anatomy::Kind::averages
             ? phrase("women and men have on average %1 to %2 ml", roundedText(range.low),
                      roundedText(range.high))
             : phrase("19 of 20 adults have %1 to %2 ml", roundedText(range.low), roundedText(range.high));
}

bool isTypical(double diagonalMm) {
  return diagonalMm >= kTypicalLowMm && diagonalMm <= kTypicalHighMm;
}

} // namespace

std::optional<Text> doubtAboutVolume(std::string_view name, double volumeMl) {
  const auto expected = expectedOf(name);
  if (!expected || awayFrom(*expected, volumeMl) <= 1)
    return std::nullopt;
  return phrase("%1 of %2 ml is not life-sized: %3", named(oneOf(expected->organ)), roundedText(volumeMl),
                whatAdultsHave(*expected->volume));
}

const std::vector<LengthUnit>& lengthUnits() {
  static const std::vector<LengthUnit> kUnits = {{"mm", "millimetres", 1},  {"um", "micrometres", 1e-3},
                                                 {"cm", "centimetres", 10}, {"in", "inches", 25.4},
                                                 {"m", "metres", 1000},     {"km", "kilometres", 1e6},
                                                 {"nm", "nanometres", 1e-6}};
  return kUnits;
}

std::vector<LengthUnit> unitsThatFit(std::string_view name, double diagonalMm, double volumeMl) {
  const auto expected = expectedOf(name);
  const bool byVolume = expected && volumeMl > 0;
  const bool odd = byVolume ? awayFrom(*expected, volumeMl) > 1
                            : diagonalMm < kSmallestDiagonalMm || diagonalMm > kLargestDiagonalMm;
  std::vector<LengthUnit> fitting;
  for (const LengthUnit& unit : lengthUnits()) {
    const double scaledMl = volumeMl * std::pow(unit.mm, 3);
    if (odd && unit.mm != 1 &&
        (byVolume ? awayFrom(*expected, scaledMl) <= 1 : isTypical(diagonalMm * unit.mm)))
      fitting.push_back(unit);
  }
  // A shrunken liver has no usual volume in any unit, but still the size of an organ in the right one.
  if (byVolume && odd && fitting.empty())
    return unitsThatFit(name, diagonalMm, 0);
  if (byVolume)
    std::stable_sort(fitting.begin(), fitting.end(), [&](const LengthUnit& a, const LengthUnit& b) {
      return awayFrom(*expected, volumeMl * std::pow(a.mm, 3)) <
             awayFrom(*expected, volumeMl * std::pow(b.mm, 3));
    });
  return fitting;
}

std::optional<Text> doubtAboutSize(std::string_view name, double diagonalMm) {
  if (diagonalMm >= kSmallestDiagonalMm && diagonalMm <= kLargestDiagonalMm)
    return std::nullopt;
  Text units;
  for (const LengthUnit& unit : unitsThatFit(name, diagonalMm, 0))
    units = units.empty() ? named(unit.name) : phrase("%1 / %2", units, named(unit.name));
  return units.empty() ? phrase("the size of %1 mm is implausible for an organ; coordinates are assumed to "
                                "be in millimetres",
                                roundedText(diagonalMm))
                       : phrase("the size of %1 mm is implausible for an organ; coordinates are assumed to "
                                "be in millimetres, they may be in %2",
                                roundedText(diagonalMm), units);
}

std::optional<double> lifeSizeFactor(std::string_view name, double volumeMl) {
  const auto part = anatomy::partNamed(name);
  const anatomy::Norm* volume = part ? anatomy::volumeNormOf(*part) : nullptr;
  if (!volume || !(volumeMl > 0))
    return std::nullopt;
  const anatomy::Range range = anatomy::rangeOf(*volume);
  return std::cbrt(0.5 * (range.low + range.high) / volumeMl);
}

} // namespace viscera::medical_io
