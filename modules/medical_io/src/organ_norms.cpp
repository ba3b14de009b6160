#include "viscera/medical_io/organ_norms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "file_bytes.h"

namespace viscera::medical_io {
namespace {

/// Diagonals of the box around one organ: an adrenal gland has 40 mm, a whole trunk 1 m.
constexpr double kSmallestDiagonalMm = 25;
constexpr double kLargestDiagonalMm = 1500;
/// Within these the guess of another unit is worth naming.
constexpr double kTypicalLowMm = 60;
constexpr double kTypicalHighMm = 600;

using Volumes = std::pair<double, double>;

const std::array<OrganNorm, 7>& norms() {
  static const std::array<OrganNorm, 7> kNorms = {{{"liver", Volumes(1411, 1710), BodySide::right},
                                                   {"spleen", Volumes(180, 238), BodySide::left},
                                                   {"kidney", Volumes(157, 193), BodySide::middle},
                                                   {"heart", Volumes(285, 900), BodySide::middle},
                                                   {"stomach", std::nullopt, BodySide::left},
                                                   {"gallbladder", std::nullopt, BodySide::right},
                                                   {"pancreas", std::nullopt, BodySide::middle}}};
  return kNorms;
}

std::string rounded(double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.3g", value);
  return value >= 1000 && value < 1e6 ? std::to_string(std::lround(value)) : buffer;
}

/// How far a volume is from the norm, as a factor of 1 and more.
double awayFrom(const Volumes& norm, double volumeMl) {
  return std::max({norm.first / volumeMl, volumeMl / norm.second, 1.0});
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
  const auto found =
      std::find_if(norms().begin(), norms().end(), [&](const OrganNorm& norm) { return norm.name == organ; });
  if (found == norms().end())
    return std::nullopt;
  OrganNorm norm = *found;
  norm.side = side.value_or(norm.side);
  return norm;
}

std::optional<std::string> doubtAboutVolume(std::string_view name, double volumeMl) {
  const auto norm = organNorm(name);
  if (!norm || !norm->volumeMl || awayFrom(*norm->volumeMl, volumeMl) <= kNormTolerance)
    return std::nullopt;
  return "a " + std::string(norm->name) + " of " + rounded(volumeMl) + " ml is not life-sized: adults have " +
         rounded(norm->volumeMl->first) + " to " + rounded(norm->volumeMl->second) + " ml";
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
  const bool byVolume = norm && norm->volumeMl && volumeMl > 0;
  const bool odd = byVolume ? awayFrom(*norm->volumeMl, volumeMl) > kNormTolerance
                            : diagonalMm < kSmallestDiagonalMm || diagonalMm > kLargestDiagonalMm;
  std::vector<LengthUnit> fitting;
  for (const LengthUnit& unit : lengthUnits()) {
    const double scaledMl = volumeMl * std::pow(unit.mm, 3);
    if (odd && unit.mm != 1 &&
        (byVolume ? awayFrom(*norm->volumeMl, scaledMl) <= kNormTolerance : isTypical(diagonalMm * unit.mm)))
      fitting.push_back(unit);
  }
  // A shrunken liver has no usual volume in any unit, but still the size of an organ in the right one.
  if (byVolume && odd && fitting.empty())
    return unitsThatFit(name, diagonalMm, 0);
  if (byVolume)
    std::stable_sort(fitting.begin(), fitting.end(), [&](const LengthUnit& a, const LengthUnit& b) {
      return awayFrom(*norm->volumeMl, volumeMl * std::pow(a.mm, 3)) <
             awayFrom(*norm->volumeMl, volumeMl * std::pow(b.mm, 3));
    });
  return fitting;
}

std::optional<std::string> doubtAboutSize(std::string_view name, double diagonalMm) {
  if (diagonalMm >= kSmallestDiagonalMm && diagonalMm <= kLargestDiagonalMm)
    return std::nullopt;
  std::string units;
  for (const LengthUnit& unit : unitsThatFit(name, diagonalMm, 0))
    units += (units.empty() ? "" : " or ") + std::string(unit.name);
  return "the surface is " + rounded(diagonalMm) +
         " mm across, which no organ is; coordinates are taken as millimetres" +
         (units.empty() ? "" : ", they may be " + units);
}

} // namespace viscera::medical_io
