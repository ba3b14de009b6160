#include "viscera/sequences/stomach_rig.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::sequences {
namespace {

using std::numbers::pi;

constexpr double kFirstRing = 10;       ///< From the top of the fundus, mm.
constexpr double kPastPylorus = 6;      ///< How far beyond the pylorus there are rings, mm.
constexpr double kStomachRayStep = 0.5; ///< mm
/// Distance of the wall from the centreline; a ray along the line goes on for long, mm.
constexpr double kFarthestFromLine = 65;
constexpr double kWider = 1.12; ///< A ring's radius as a multiple of the wall's,
constexpr double kOffset = 3;   ///< and what is added to it, mm.
constexpr int kFewestOnAStomachRing = 6;
constexpr int kMostOnARing = 14;
constexpr int kProbes = 8;
/// The part of the way from the middle of the body to the pylorus at which the antrum begins.
constexpr double kAntrumOnTheBody = 0.4;

class StomachRigBuilder {
public:
  StomachRigBuilder(StomachRig& rig, const StomachRigOptions& options)
      : rig_(rig), anatomy_(rig.anatomy), options_(options) {}

  void addRings() {
    const double last = anatomy_.course.pylorus + kPastPylorus;
    int ring = 0;
    for (double s = kFirstRing; s <= last; s += options_.ringDistance, ++ring)
      addRing(s, ring);
  }

  void addFixed() {
    for (const FixedRing& ring : anatomy_.fixed)
      for (const Vec3& place : ringAround(ring.center, ring.axis, ring.radius, ring.count))
        rig_.handles.push_back({StomachRegion::fixed, place, ring.center, 0});
  }

  void addFarCorners() {
    for (const Vec3& corner : cornersOf(anatomy_.box))
      rig_.handles.push_back({StomachRegion::farCorner, corner, corner, 0});
  }

private:
  double wallAt(const CrossSection& section, double angle) const {
    const Vec3 direction = section.across(angle);
    double radius = 0;
    while (radius < kFarthestFromLine && anatomy_.surface(section.center + radius * direction) < 0)
      radius += kStomachRayStep;
    return radius;
  }

  void addRing(double s, int ring) {
    const CrossSection section = anatomy_.centerline.at(s);
    if (anatomy_.surface(section.center) >= 0)
      throw DataError(
          phrase("the centreline leaves the stomach %1 mm below the top of the fundus", static_cast<int>(s)),
          "stomach rig", "move its points into the stomach");
    double mean = 0;
    for (int k = 0; k < kProbes; ++k)
      mean += wallAt(section, 2 * pi * k / kProbes) / kProbes;
    const int count = std::clamp(static_cast<int>(std::lround(2 * pi * mean / options_.spacing)),
                                 kFewestOnAStomachRing, kMostOnARing);
    for (int k = 0; k < count; ++k) {
      // Every other ring is turned by half a step, so that handles do not stand in rows.
      const double angle = 2 * pi * (k + 0.5 * (ring % 2)) / count;
      const double radius = kWider * wallAt(section, angle) + kOffset;
      rig_.handles.push_back(
          {regionAt(s), section.center + radius * section.across(angle), section.center, s});
    }
  }

  StomachRegion regionAt(double s) const {
    const GastricCourse& course = anatomy_.course;
    if (s < course.midBody)
      return s < 0.5 * course.midBody ? StomachRegion::fundus : StomachRegion::body;
    const double way = (s - course.midBody) / (course.pylorus - course.midBody);
    return way < kAntrumOnTheBody ? StomachRegion::body : StomachRegion::antrum;
  }

  StomachRig& rig_;
  const StomachAnatomy& anatomy_;
  const StomachRigOptions& options_;
};

} // namespace

std::vector<HandleGroup> StomachRig::groups() const {
  // Colours that colour-blind users tell apart (Okabe and Ito).
  std::vector<std::pair<StomachRegion, HandleGroup>> regions{
      {StomachRegion::fundus, {"Fundus", {0.90, 0.62, 0.00}, {}}},
      {StomachRegion::body, {"Body", {0.84, 0.37, 0.00}, {}}},
      {StomachRegion::antrum, {"Antrum", {0.80, 0.47, 0.65}, {}}},
      {StomachRegion::fixed, {"Fixed", {0.34, 0.71, 0.91}, {}}},
      {StomachRegion::farCorner, {"Far corners", {0.60, 0.60, 0.60}, {}}}};
  for (std::size_t i = 0; i < handles.size(); ++i)
    for (auto& [region, group] : regions)
      if (handles[i].region == region)
        group.handles.push_back(static_cast<int>(i));
  std::vector<HandleGroup> groups;
  for (auto& [region, group] : regions)
    if (!group.handles.empty())
      groups.push_back(std::move(group));
  return groups;
}

StomachRig makeStomachRig(StomachAnatomy anatomy, const StomachRigOptions& options) {
  if (anatomy.centerline.length() < anatomy.course.pylorus + kPastPylorus)
    throw DataError("the centreline ends before the pylorus", "stomach rig", "lead it into the duodenum");
  StomachRig rig{std::move(anatomy), {}};
  StomachRigBuilder builder(rig, options);
  builder.addRings();
  builder.addFixed();
  builder.addFarCorners();
  return rig;
}

} // namespace viscera::sequences
