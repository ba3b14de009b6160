#include "surface_warnings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>

#include "file_bytes.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::medical_io {
namespace {

/// Diagonals of the box around one organ: an adrenal gland has 40 mm, a whole trunk 1 m.
constexpr double kSmallestDiagonalMm = 25;
constexpr double kLargestDiagonalMm = 1500;
/// Within these the guess of another unit is worth naming.
constexpr double kTypicalLowMm = 60;
constexpr double kTypicalHighMm = 600;

struct Unit {
  std::string_view name;
  double mm;
};
constexpr std::array<Unit, 6> kUnits = {{{"micrometres", 1e-3},
                                         {"centimetres", 10},
                                         {"inches", 25.4},
                                         {"metres", 1000},
                                         {"kilometres", 1e6},
                                         {"nanometres", 1e-6}}};

/// Normal volumes of adults in ml, women's and men's. An organ may well be half or twice that, but not a
/// quarter.
struct Normal {
  std::string_view name;
  double low;
  double high;
};
constexpr std::array<Normal, 4> kNormals = {
    {{"liver", 1411, 1710}, {"spleen", 180, 238}, {"kidney", 157, 193}, {"heart", 285, 900}}};
constexpr double kTolerance = 3;

std::string rounded(double value) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.3g", value);
  return value >= 1000 && value < 1e6 ? std::to_string(std::lround(value)) : buffer;
}

std::string unitsThatFit(double diagonal) {
  std::string list;
  for (const Unit& unit : kUnits) {
    const double mm = diagonal * unit.mm;
    if (mm < kTypicalLowMm || mm > kTypicalHighMm)
      continue;
    list += (list.empty() ? "" : " or ") + std::string(unit.name);
  }
  return list;
}

void warnOfSize(SurfaceFile& surface) {
  const double diagonal = boundsOf(surface.mesh.points).diagonal();
  if (diagonal >= kSmallestDiagonalMm && diagonal <= kLargestDiagonalMm)
    return;
  const std::string units = unitsThatFit(diagonal);
  surface.warnings.push_back("the surface is " + rounded(diagonal) +
                             " mm across, which no organ is; coordinates are taken as millimetres" +
                             (units.empty() ? "" : ", they may be " + units));
}

/// "Kidney_left 2" is a kidney; "kidney_tumour" or "liver vessels" have no normal size.
std::string organOf(std::string_view name) {
  std::string organ;
  std::string word;
  const auto endWord = [&] {
    if (word != "left" && word != "right" && word != "l" && word != "r")
      organ += word;
    word.clear();
  };
  for (const char c : lowered(name))
    if (c >= 'a' && c <= 'z')
      word += c;
    else
      endWord();
  endWord();
  return organ;
}

} // namespace

std::optional<std::string> implausibleVolume(std::string_view name, double volumeMl) {
  const std::string organ = organOf(name);
  const auto* normal =
      std::find_if(kNormals.begin(), kNormals.end(), [&](const Normal& n) { return n.name == organ; });
  if (normal == kNormals.end() ||
      (volumeMl >= normal->low / kTolerance && volumeMl <= normal->high * kTolerance))
    return std::nullopt;
  return "a " + std::string(normal->name) + " of " + rounded(volumeMl) +
         " ml is not life-sized: adults have " + rounded(normal->low) + " to " + rounded(normal->high) +
         " ml";
}

void appendSurfaceWarnings(SurfaceFile& surface) {
  warnOfSize(surface);
  const geometry::SurfaceReport report = geometry::checkSurface(surface.mesh);
  for (std::string& fault : geometry::faults(report))
    surface.warnings.push_back(std::move(fault));
  if (!report.closed())
    return;
  if (auto warning = implausibleVolume(surface.name, std::abs(report.volumeMm3) / kMm3PerMl))
    surface.warnings.push_back(std::move(*warning));
}

} // namespace viscera::medical_io
