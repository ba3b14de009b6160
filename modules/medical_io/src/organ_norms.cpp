#include "viscera/medical_io/organ_norms.h"
#include "viscera/core/phrase.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "file_bytes.h"
#include "viscera/anatomy/norms.h"

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

/// Names and sides of known organs, and their row in the table of normal ranges.
const std::array<OrganNorm, 8>& knownOrgans() {
  static const std::array<OrganNorm, 8> kOrgans = {
      {{"liver", "a liver", "liver.volume", BodySide::right},
       {"spleen", "a spleen", "spleen.volume", BodySide::left},
       {"kidney", "a kidney", "kidney.left", BodySide::middle},
       {"heart", "a heart", "heart.volume", BodySide::middle},
       {"myocardium", "a myocardium", "heart.muscle", BodySide::middle},
       {"stomach", "a stomach", {}, BodySide::left},
       {"gallbladder", "a gallbladder", {}, BodySide::right},
       {"pancreas", "a pancreas", "pancreas.volume", BodySide::middle}}};
  return kOrgans;
}

std::string roundedText(double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.3g", value);
  return value >= 1000 && value < 1e6 ? std::to_string(std::lround(value)) : buffer;
}

/// How far a volume is from what is normal, as a part of how far a life-sized organ may be; 1 and less for
/// those.
double awayFrom(const OrganNorm& organ, double volumeMl) {
  const anatomy::Norm& norm = anatomy::norm(organ.volume);
  const anatomy::Range range = anatomy::rangeOf(norm);
  const double factor = std::max({range.low / volumeMl, volumeMl / range.high, 1.0});
  return factor / (norm.kind == anatomy::Kind::averages ? kAwayFromAverages : kAwayFromSpread);
}

/// "19 of 20 adults have 814 to 1906 ml".
std::string whatAdultsHave(const anatomy::Norm& norm) {
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

std::optional<OrganNorm> organNorm(std::string_view name) {
  std::string organ, word;
  std::optional<BodySide> side;
  const auto endWord = [&] {
    if (word == "left" || word == "l")
      side = BodySide::left;
    else if (word == "right" || word == "r")
      side = BodySide::right;
    else
      organ += word;
    word.clear();
  };
  for (const char c : lowered(name))
    if (c >= 'a' && c <= 'z')
      word += c;
    else
      endWord();
  endWord();
  const auto found = std::find_if(knownOrgans().begin(), knownOrgans().end(),
                                  [&](const OrganNorm& norm) { return norm.name == organ; });
  if (found == knownOrgans().end())
    return std::nullopt;
  OrganNorm norm = *found;
  norm.side = side.value_or(norm.side);
  if (norm.name == "kidney" && norm.side == BodySide::right)
    norm.volume = "kidney.right";
  return norm;
}

std::optional<std::string> doubtAboutVolume(std::string_view name, double volumeMl) {
  const auto norm = organNorm(name);
  if (!norm || norm->volume.empty() || awayFrom(*norm, volumeMl) <= 1)
    return std::nullopt;
  return phrase("%1 of %2 ml is not life-sized: %3", norm->one, roundedText(volumeMl),
                whatAdultsHave(anatomy::norm(norm->volume)));
}

const std::vector<LengthUnit>& lengthUnits() {
  static const std::vector<LengthUnit> kUnits = {{"mm", "millimetres", 1},  {"um", "micrometres", 1e-3},
                                                 {"cm", "centimetres", 10}, {"in", "inches", 25.4},
                                                 {"m", "metres", 1000},     {"km", "kilometres", 1e6},
                                                 {"nm", "nanometres", 1e-6}};
  return kUnits;
}

std::vector<LengthUnit> unitsThatFit(std::string_view name, double diagonalMm, double volumeMl) {
  const auto norm = organNorm(name);
  const bool byVolume = norm && !norm->volume.empty() && volumeMl > 0;
  const bool odd = byVolume ? awayFrom(*norm, volumeMl) > 1
                            : diagonalMm < kSmallestDiagonalMm || diagonalMm > kLargestDiagonalMm;
  std::vector<LengthUnit> fitting;
  for (const LengthUnit& unit : lengthUnits()) {
    const double scaledMl = volumeMl * std::pow(unit.mm, 3);
    if (odd && unit.mm != 1 && (byVolume ? awayFrom(*norm, scaledMl) <= 1 : isTypical(diagonalMm * unit.mm)))
      fitting.push_back(unit);
  }
  // A shrunken liver has no usual volume in any unit, but still the size of an organ in the right one.
  if (byVolume && odd && fitting.empty())
    return unitsThatFit(name, diagonalMm, 0);
  if (byVolume)
    std::stable_sort(fitting.begin(), fitting.end(), [&](const LengthUnit& a, const LengthUnit& b) {
      return awayFrom(*norm, volumeMl * std::pow(a.mm, 3)) < awayFrom(*norm, volumeMl * std::pow(b.mm, 3));
    });
  return fitting;
}

std::optional<std::string> doubtAboutSize(std::string_view name, double diagonalMm) {
  if (diagonalMm >= kSmallestDiagonalMm && diagonalMm <= kLargestDiagonalMm)
    return std::nullopt;
  std::string units;
  for (const LengthUnit& unit : unitsThatFit(name, diagonalMm, 0))
    units = units.empty() ? std::string(unit.name) : phrase("%1 / %2", units, unit.name);
  return units.empty() ? phrase("the size of %1 mm is implausible for an organ; coordinates are assumed to "
                                "be in millimetres",
                                roundedText(diagonalMm))
                       : phrase("the size of %1 mm is implausible for an organ; coordinates are assumed to "
                                "be in millimetres, they may be in %2",
                                roundedText(diagonalMm), units);
}

} // namespace viscera::medical_io
