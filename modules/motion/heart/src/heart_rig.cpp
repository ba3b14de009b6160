#include "viscera/heart/heart_rig.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/sequences/curve.h"

namespace viscera::heart {
namespace {

using std::numbers::pi;

constexpr double kHeartRayStep = 0.5;    ///< mm
constexpr double kFarthestRho = 120;     ///< mm; no heart is wider.
constexpr double kFarthestAtrium = 80;   ///< From an atrium's centre to its wall, mm.
constexpr double kAtrialOffset = 6;      ///< Between an atrium and its handles, mm.
constexpr double kAtrialReach = 45;      ///< As far from the ventricles an atrium stays where it is, mm.
constexpr double kClearOfVentricles = 2; ///< An atrial handle's least distance from them, mm.
constexpr double kClearOfVessels = 2;    ///< Any handle's least distance from the great vessels, mm.
constexpr double kThinnestCavity = 3;    ///< Of the right ventricle, where it still has a free wall, mm.
constexpr double kWidening = 1.25;       ///< How much wider both ventricles are than the left one.
constexpr double kFreeWallRho = 58;      ///< About the right free wall's distance from the axis, mm.
constexpr double kFreeWallReach = 1.2;   ///< How far it reaches around the axis to either side, rad.
constexpr double kFreeWallLength = 76;   ///< How far along the axis it is looked for, mm.
constexpr double kRowCloseness = 0.85;   ///< Of its rows, as a part of the spacing.
constexpr double kSeptumReach = 0.9;     ///< rad
constexpr double kSeptumLength = 74;     ///< mm
constexpr int kFewestOnAHeartRing = 5;
constexpr std::size_t kFewestHeartHandles = 8;

/// The outermost distance from the axis at which the ray (phi, c) is inside.
std::optional<double> outermost(const HeartFrame& frame, const sequences::AnatomySurface& surface, double phi,
                                double c) {
  for (double rho = kFarthestRho; rho > 0; rho -= kHeartRayStep)
    if (surface(frame.toWorld(HeartPoint{rho, phi, c})) < 0)
      return rho;
  return std::nullopt;
}

/// The distance from the axis at which the ray (phi, c) first leaves the surface; nothing when it starts
/// outside.
std::optional<double> firstExit(const HeartFrame& frame, const sequences::AnatomySurface& surface, double phi,
                                double c) {
  if (surface(frame.toWorld(HeartPoint{0, phi, c})) >= 0)
    return std::nullopt;
  double rho = 0;
  while (rho < kFarthestRho && surface(frame.toWorld(HeartPoint{rho + kHeartRayStep, phi, c})) < 0)
    rho += kHeartRayStep;
  return rho;
}

/// The k-th of `count` directions that are spread evenly.
Vec3 spiralDirection(int k, int count) {
  // Even steps of z are even areas of the sphere; the golden angle keeps turns apart.
  const double z = 1 - (2.0 * k + 1) / count;
  const double angle = k * pi * (3 - std::sqrt(5.0));
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

/// The k-th angle of a ring; every other ring is turned by half a step, so that handles do not stand in
/// columns.
double ringAngle(int k, int count, int ring) {
  return 2 * pi * (k + 0.5 * (ring % 2)) / count;
}

/// Adds the handles of each part.
class HeartRigBuilder {
public:
  HeartRigBuilder(HeartRig& rig, const HeartRigOptions& options)
      : rig_(rig), anatomy_(rig.anatomy), options_(options) {}

  void addEndocardium() {
    constexpr double kFirst = 1;
    const HeartShell& shell = anatomy_.endocardium;
    const int rings = ringsBetween(kFirst, shell.apex());
    for (int ring = 0; ring < rings; ++ring) {
      const double c = kFirst + (shell.apex() - kFirst) * ring / rings;
      const double rho = shell.radiusAt(c);
      const int count = countAround(rho);
      for (int k = 0; k < count; ++k)
        addVentricular(HeartRole::leftEndocardium, {rho, ringAngle(k, count, ring), c}, rho);
    }
    addVentricular(HeartRole::leftEndocardium, {0, 0, shell.apex() - 1}, 0);
  }

  void addEpicardium() {
    const HeartShell& shell = anatomy_.epicardium;
    const double base = anatomy_.baseEpicardium;
    const int rings = ringsBetween(base, shell.apex());
    for (int ring = 0; ring < rings; ++ring) {
      const double c = base + (shell.apex() - base) * ring / rings;
      const int count = countAround(kWidening * shell.radiusAt(c) + options_.offset);
      for (int k = 0; k < count; ++k) {
        const double phi = ringAngle(k, count, ring);
        const auto wall = options_.firstWall ? firstExit(anatomy_.frame, anatomy_.ventricles, phi, c)
                                             : outermost(anatomy_.frame, anatomy_.ventricles, phi, c);
        if (!wall)
          continue;
        const HeartPoint place{*wall + options_.offset, phi, c};
        if (clearOfVessels(anatomy_.frame.toWorld(place)))
          addVentricular(HeartRole::epicardium, place, *wall);
      }
    }
    addVentricular(HeartRole::epicardium, {0, 0, shell.apex() + options_.offset}, 0);
  }

  void addRightFreeWall() {
    const double step = options_.spacing / kFreeWallRho;
    const int side = static_cast<int>(kFreeWallReach / step);
    for (double c = 4; c < kFreeWallLength; c += kRowCloseness * options_.spacing) {
      for (int k = -side; k <= side; ++k) {
        const auto wall = outermost(anatomy_.frame, anatomy_.rightCavity, k * step, c);
        if (wall && *wall > anatomy_.epicardium.radiusAt(c) + kThinnestCavity)
          addVentricular(HeartRole::rightFreeWall, {*wall, k * step, c}, *wall);
      }
    }
  }

  void addSeptum() {
    const double step = options_.spacing / anatomy_.epicardium.radius;
    const int side = static_cast<int>(kSeptumReach / step);
    for (double c = 6; c < kSeptumLength; c += options_.spacing) {
      const double rho = anatomy_.epicardium.radiusAt(c);
      for (int k = -side; k <= side; ++k)
        addVentricular(HeartRole::septum, {rho, k * step, c}, rho);
    }
  }

  void addAtria() {
    for (const AtriumAnatomy& atrium : anatomy_.atria) {
      for (int k = 0; k < options_.atrialHandles; ++k) {
        const Vec3 direction = spiralDirection(k, options_.atrialHandles);
        double distance = kFarthestAtrium;
        while (distance > 0 && atrium.surface(atrium.center + distance * direction) > 0)
          distance -= kHeartRayStep;
        const Vec3 position = atrium.center + (distance + kAtrialOffset) * direction;
        if (anatomy_.ventricles(position) > kClearOfVentricles && clearOfVessels(position))
          addAtrial(atrium, position);
      }
      for (const Vec3& position : atrium.appendage)
        addAtrial(atrium, position);
    }
  }

  void addVessels() {
    for (const VesselRing& ring : anatomy_.vessels) {
      for (const Vec3& place : sequences::ringAround(ring.center, ring.axis, ring.radius, ring.count)) {
        HeartHandle handle = handleAt(HeartRole::vessel, place);
        handle.follow = ring.follow;
        rig_.handles.push_back(handle);
      }
    }
  }

  void addFarCorners() {
    for (const Vec3& corner : sequences::cornersOf(anatomy_.box))
      rig_.handles.push_back(handleAt(HeartRole::farCorner, corner));
  }

private:
  int ringsBetween(double begin, double end) const {
    return std::max(2, static_cast<int>(std::lround((end - begin) / options_.spacing)));
  }

  int countAround(double rho) const {
    return std::max(kFewestOnAHeartRing, static_cast<int>(std::lround(2 * pi * rho / options_.spacing)));
  }

  bool clearOfVessels(const Vec3& position) const {
    return anatomy_.greatVessels(position) > kClearOfVessels;
  }

  HeartHandle handleAt(HeartRole role, const Vec3& position) const {
    HeartHandle handle;
    handle.role = role;
    handle.position = position;
    handle.place = anatomy_.frame.cylindrical(position);
    return handle;
  }

  void addVentricular(HeartRole role, const HeartPoint& place, double surfaceRho) {
    HeartHandle handle;
    handle.role = role;
    handle.place = place;
    handle.position = anatomy_.frame.toWorld(place);
    handle.surfaceRho = surfaceRho;
    rig_.handles.push_back(handle);
  }

  void addAtrial(const AtriumAnatomy& atrium, const Vec3& position) {
    HeartHandle handle = handleAt(HeartRole::atrium, position);
    handle.center = atrium.center;
    handle.follow = sequences::smoothStep(1 - anatomy_.ventricles(position) / kAtrialReach);
    rig_.handles.push_back(handle);
  }

  HeartRig& rig_;
  const HeartAnatomy& anatomy_;
  const HeartRigOptions& options_;
};

/// How the handles of a role are shown.
struct RoleLook {
  HeartRole role;
  const char* name;
  Vec3 color;
};

/// Roles in the order in which the builder adds them; colours that colour-blind users tell apart (Okabe and
/// Ito).
const std::vector<RoleLook>& roleLooks() {
  static const std::vector<RoleLook> looks{{HeartRole::leftEndocardium, "LV endocardium", {0.84, 0.37, 0.00}},
                                           {HeartRole::epicardium, "Epicardium", {0.90, 0.62, 0.00}},
                                           {HeartRole::rightFreeWall, "RV free wall", {0.00, 0.45, 0.70}},
                                           {HeartRole::septum, "Septum", {0.80, 0.47, 0.65}},
                                           {HeartRole::atrium, "Atria", {0.00, 0.62, 0.45}},
                                           {HeartRole::vessel, "Great vessels", {0.34, 0.71, 0.91}},
                                           {HeartRole::farCorner, "Far corners", {0.60, 0.60, 0.60}}};
  return looks;
}

} // namespace

double HeartShell::radiusAt(double c) const {
  const double x = (c - center) / halfLength;
  return radius * std::sqrt(std::max(0.0, 1 - x * x));
}

std::vector<int> HeartRig::handlesOf(HeartRole role) const {
  std::vector<int> rows;
  for (std::size_t i = 0; i < handles.size(); ++i)
    if (handles[i].role == role)
      rows.push_back(static_cast<int>(i));
  return rows;
}

std::vector<sequences::HandleGroup> HeartRig::groups() const {
  std::vector<sequences::HandleGroup> groups;
  for (const RoleLook& look : roleLooks())
    if (sequences::HandleGroup group{look.name, look.color, handlesOf(look.role)}; !group.handles.empty())
      groups.push_back(std::move(group));
  return groups;
}

HeartRig makeHeartRig(HeartAnatomy anatomy, const HeartRigOptions& options) {
  HeartRig rig{std::move(anatomy), {}};
  HeartRigBuilder builder(rig, options);
  if (options.cavities)
    builder.addEndocardium();
  builder.addEpicardium();
  if (options.cavities) {
    builder.addRightFreeWall();
    builder.addSeptum();
  }
  builder.addAtria();
  builder.addVessels();
  builder.addFarCorners();
  for (const HeartRole role : {HeartRole::epicardium, HeartRole::rightFreeWall}) {
    if (role == HeartRole::rightFreeWall && !options.cavities)
      continue;
    const std::size_t count = rig.handlesOf(role).size();
    if (count < kFewestHeartHandles)
      throw DataError(
          phrase("a ventricle is not where its frame says: only %n {handle meets|handles meet} its wall",
                 count),
          "heart rig", "check the landmarks of base, apex and right ventricle");
  }
  return rig;
}

} // namespace viscera::heart
