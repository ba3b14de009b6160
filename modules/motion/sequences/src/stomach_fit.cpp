#include "viscera/sequences/stomach_fit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "viscera/core/error.h"
#include "viscera/sequences/spread_points.h"

namespace viscera::sequences {
namespace {

// Parts of the length of the line.
constexpr double kShortestDuodenum = 0.06; ///< Less than this behind a narrow place is no duodenum.
constexpr double kEnd = 0.03;              ///< Without a duodenum the pylorus lies that far before the end.
/// Behind the pylorus the slices grow to that multiple of the narrowest one at least.
constexpr double kWidensAgain = 1.5;
/// The narrowest slice is at most this part of the widest one.
constexpr double kNarrow = 0.35;

// Lengths in the standard size, mm.
constexpr double kUnreached = 24;     ///< Farther from all handles than this a vertex gets one of its own.
constexpr double kOffTheStomach = 8;  ///< How far off the surface that stands.
constexpr double kBeyondLineEnd = 14; ///< How far before and behind the line its ends are held.
constexpr double kStomachBoxMargin = 0.3;

} // namespace

double pylorusAlong(const std::vector<double>& arcs, const std::vector<double>& areas) {
  assert(arcs.size() == areas.size() && arcs.size() >= 3);
  const double length = arcs.back();
  const auto widest = static_cast<std::size_t>(std::max_element(areas.begin(), areas.end()) - areas.begin());
  for (std::size_t i = widest + 1; i + 1 < areas.size(); ++i) {
    const bool narrow = areas[i] <= areas[i - 1] && areas[i] < areas[i + 1] &&
                        areas[i] < kNarrow * areas[widest] && length - arcs[i] > kShortestDuodenum * length;
    if (!narrow)
      continue;
    const double wideAgain = *std::max_element(areas.begin() + static_cast<std::ptrdiff_t>(i), areas.end());
    const double narrowest = *std::min_element(areas.begin() + static_cast<std::ptrdiff_t>(widest),
                                               areas.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    if (wideAgain > kWidensAgain * areas[i] && areas[i] <= narrowest)
      return arcs[i];
  }
  return (1 - kEnd) * length;
}

StomachAnatomy fitStomach(const Centerline& line, const GastricCourse& course, const AnatomySurface& surface,
                          const Points& points) {
  StomachAnatomy anatomy{line, course, surface, {}, grownBox(points, kStomachBoxMargin)};
  // Parts that rings do not reach are held.
  const auto hold = [&anatomy](const Vec3& place) { anatomy.fixed.push_back({place, Vec3::UnitZ(), 0, 1}); };
  const CrossSection top = line.at(0);
  const CrossSection end = line.at(line.length());
  hold(top.center - kBeyondLineEnd * top.tangent);
  hold(end.center + kBeyondLineEnd * end.tangent);
  const StomachRig rings = makeStomachRig(anatomy);
  for (const Vec3& place : spreadPoints(points, rings.restHandles(), kUnreached))
    hold(movedOff(surface, place, kOffTheStomach));
  return anatomy;
}

} // namespace viscera::sequences
