#include "viscera/heart/heart_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "viscera/core/error.h"
#include "viscera/sequences/curve.h"
#include "viscera/sequences/spread_points.h"

namespace viscera::heart {
namespace {

using std::numbers::pi;

// Estimating.
constexpr int kGrid = 28;           ///< Samples along the longest side of the box.
constexpr double kCoreDepth = 0.45; ///< Deeper than this part of the deepest point is core.
constexpr double kCoreReach = 1.1;  ///< The body of the heart lies within that many core depths.
/// Thin parts on one side by more than this (their share of the body, times how far off its middle they are)
/// are vessels, which leave the heart at its base.
constexpr double kVessels = 0.1;
constexpr double kBaseBack = 2.0 / 3.0; ///< From the apex to the base, as a part of the whole length.
constexpr double kBulge = 0.06;         ///< Rounder than this the ventricles show no right side.
/// Direction from the axis to the right ventricle of a heart in its place (patient's right and front).
const Vec3 kRightOfPeople(-0.62, -0.78, 0.05);

// Fitting, in the standard size.
constexpr double kFitRayStep = 0.5;
constexpr double kFarthestFromAxis = 120;
constexpr double kShellCenter = 30;  ///< c of the widest place,
constexpr double kShellHalf = 67;    ///< and half the length of the left ventricle from outside;
constexpr double kCavityCenter = 28; ///< the same of its cavity,
constexpr double kCavityHalf = 59;
constexpr double kCavityShare = 25.5 / 36; ///< and its width as a part of the outer one.
constexpr double kNarrowest = 20, kWidest = 60;
constexpr double kBehindBase = 10;   ///< The ventricles end that far behind the base, mm.
constexpr double kFirstAtrial = 12;  ///< Atrial handles begin behind that, mm.
constexpr double kLastAtrial = 60;   ///< Parts farther behind carry vessels and do not move.
constexpr double kSpread = 20;       ///< Between handles on what is behind the base, mm.
constexpr double kVesselSpread = 13; ///< The same on vessels,
constexpr double kVesselOff = 4;     ///< and how far off these they stand, mm.
constexpr double kOffTheHeart = 6;   ///< How far off the surface they stand, mm.
constexpr double kAtrialMiddle = 24; ///< The point that atria contract towards lies that far behind the base.
constexpr double kLastVessel = 25;   ///< Beside the ventricles vessels reach that far towards the apex, mm.
constexpr double kAtrialWidth = 1.4; ///< Atria reach that many radii of the left ventricle from the axis.
/// The part of the base's descent in which vessels take part at their roots; along the axis and along the
/// vessel it fades over these lengths, mm.
constexpr double kVesselFollow = 0.4, kVesselFade = 60, kVesselLength = 25;
constexpr double kHeartBoxMargin = 0.3;

double outermost(const sequences::AnatomySurface& surface, const HeartFrame& frame, double phi, double c) {
  for (double rho = kFarthestFromAxis; rho > 0; rho -= kFitRayStep)
    if (surface(frame.toWorld(HeartPoint{rho, phi, c})) < 0)
      return rho;
  return 0;
}

/// Points inside, on an even grid, with their depth.
struct Inside {
  std::vector<Vec3> points;
  std::vector<double> depths;
};

Inside sampleInside(const sequences::AnatomySurface& surface, const Bounds& box) {
  const double step = (box.high - box.low).maxCoeff() / kGrid;
  Inside inside;
  if (!(step > 0))
    return inside;
  for (double x = box.low.x() + 0.5 * step; x < box.high.x(); x += step)
    for (double y = box.low.y() + 0.5 * step; y < box.high.y(); y += step)
      for (double z = box.low.z() + 0.5 * step; z < box.high.z(); z += step)
        if (const double depth = -surface({x, y, z}); depth > 0) {
          inside.points.emplace_back(x, y, z);
          inside.depths.push_back(depth);
        }
  return inside;
}

/// The points that lie near deep ones, and the thin parts: vessels.
struct Opened {
  std::vector<Vec3> body, thin;
};

Opened opened(const Inside& inside) {
  const double deepest = *std::max_element(inside.depths.begin(), inside.depths.end());
  std::vector<Vec3> core;
  for (std::size_t i = 0; i < inside.points.size(); ++i)
    if (inside.depths[i] > kCoreDepth * deepest)
      core.push_back(inside.points[i]);
  const double reach = kCoreReach * kCoreDepth * deepest;
  Opened parts;
  for (const Vec3& point : inside.points) {
    const bool near = std::any_of(core.begin(), core.end(), [&](const Vec3& deep) {
      return (deep - point).squaredNorm() < reach * reach;
    });
    (near ? parts.body : parts.thin).push_back(point);
  }
  return parts;
}

Vec3 meanOf(const std::vector<Vec3>& points) {
  Vec3 mean = Vec3::Zero();
  for (const Vec3& point : points)
    mean += point / static_cast<double>(points.size());
  return mean;
}

/// Middle and principal axis of the body. The axis points away from the vessels; without vessels, to where
/// the body tapers (third moment).
std::pair<Vec3, Vec3> axisToApex(const Opened& parts) {
  const Vec3 middle = meanOf(parts.body);
  // The eigenvector of the largest eigenvalue of 1/n sum (p - m)(p - m)^T, and the sign of
  // sum ((p - m) . axis)^3, which is positive towards the longer tail.
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& point : parts.body)
    spread += (point - middle) * (point - middle).transpose() / static_cast<double>(parts.body.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread);
  const Vec3 axis = solver.eigenvectors().col(2);
  double skew = 0;
  for (const Vec3& point : parts.body)
    skew += std::pow((point - middle).dot(axis), 3);
  if (!parts.thin.empty()) {
    const double share = static_cast<double>(parts.thin.size()) / static_cast<double>(parts.body.size());
    const double away = (meanOf(parts.thin) - middle).dot(axis) / std::sqrt(solver.eigenvalues()[2]);
    if (std::abs(share * away) > kVessels)
      return {middle, away > 0 ? Vec3(-axis) : axis};
  }
  return {middle, skew < 0 ? Vec3(-axis) : axis};
}

/// The direction across the axis in which the surface reaches farthest around `middle`; people's when it is
/// about round.
Vec3 bulge(const sequences::AnatomySurface& surface, const Vec3& middle, const Vec3& axis, double farthest) {
  constexpr int kRays = 48;
  const Vec3 u = axis.unitOrthogonal();
  const Vec3 v = axis.cross(u);
  // The first harmonic of the radius around the axis, 1/n sum r_k e_k, against its mean.
  Vec3 sum = Vec3::Zero();
  double mean = 0;
  for (int k = 0; k < kRays; ++k) {
    const double angle = 2 * pi * k / kRays;
    const Vec3 direction = std::cos(angle) * u + std::sin(angle) * v;
    double radius = farthest;
    while (radius > 0 && surface(middle + radius * direction) > 0)
      radius -= 0.01 * farthest;
    sum += radius / kRays * direction;
    mean += radius / kRays;
  }
  if (sum.norm() > kBulge * mean)
    return sum.normalized();
  const Vec3 right = kRightOfPeople - kRightOfPeople.dot(axis) * axis;
  return right.norm() > kBulge ? Vec3(right.normalized()) : u;
}

double leftRadius(const sequences::AnatomySurface& surface, const HeartFrame& frame) {
  std::vector<double> radii;
  for (const double c : {15.0, 30.0, 45.0})
    for (int k = -4; k <= 4; ++k) {
      // An ellipsoid's section at c has the radius R sqrt(1 - ((c - c_0) / h)^2).
      const double profile = std::sqrt(1 - std::pow((c - kShellCenter) / kShellHalf, 2));
      radii.push_back(outermost(surface, frame, pi + k * pi / 12, c) / profile);
    }
  std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2), radii.end());
  return std::clamp(radii[radii.size() / 2], kNarrowest, kWidest);
}

/// How far a point is from the body of the heart, about: 0 in it, in its walls and close to them.
class BodyDistance {
public:
  BodyDistance(const sequences::AnatomySurface& surface, const Bounds& box)
      : body_(opened(sampleInside(surface, box)).body), cell_((box.high - box.low).maxCoeff() / kGrid) {}

  double operator()(const Vec3& point) const {
    double nearest2 = std::numeric_limits<double>::infinity();
    for (const Vec3& one : body_)
      nearest2 = std::min(nearest2, (one - point).squaredNorm());
    return std::max(0.0, std::sqrt(nearest2) - kCells * cell_ - kOffTheHeart);
  }

private:
  static constexpr double kCells = 1.2; ///< Samples lie that many cells from the walls of the body at most.

  std::vector<Vec3> body_;
  double cell_;
};

/// Handles on what lies behind the base: near the axis they move with the atria; vessels, which are what is
/// thin or far out, take part in the descent the less the farther away they are, and get more handles, so
/// that their walls move as one.
void addBehindBase(HeartAnatomy& anatomy, const sequences::AnatomySurface& surface, const Points& points) {
  const HeartFrame& frame = anatomy.frame;
  const double width = anatomy.epicardium.radius;
  const BodyDistance offBody(surface, boundsOf(points));
  const auto isVessel = [&](const Vec3& p) {
    const HeartPoint at = frame.cylindrical(p);
    return at.c < kLastVessel && (at.c < -kLastAtrial || at.rho > kAtrialWidth * width || offBody(p) > 0);
  };
  const auto isAtrium = [&](const Vec3& p) { return frame.toLocal(p).z() < -kFirstAtrial && !isVessel(p); };
  AtriumAnatomy atria{surface, frame.toWorld(HeartPoint{0, 0, -kAtrialMiddle}), {}};
  for (const Vec3& place :
       sequences::spreadPoints(sequences::rowsWhere(points, isAtrium), Points(0, 3), kSpread))
    atria.appendage.push_back(sequences::movedOff(surface, place, kOffTheHeart));
  const auto isFarOut = [&](const Vec3& p) {
    return isVessel(p) && (frame.toLocal(p).z() < -kFirstAtrial || offBody(p) > 0);
  };
  for (const Vec3& place :
       sequences::spreadPoints(sequences::rowsWhere(points, isFarOut), Points(0, 3), kVesselSpread)) {
    const Vec3 handle = sequences::movedOff(surface, place, kVesselOff);
    const HeartPoint at = frame.cylindrical(handle);
    const double follow = kVesselFollow * sequences::smoothStep(1 + at.c / kVesselFade) *
                          sequences::smoothStep(2 - at.rho / width) *
                          sequences::smoothStep(1 - offBody(handle) / kVesselLength);
    anatomy.vessels.push_back({handle, Vec3::UnitZ(), 0, 1, follow});
  }
  if (!atria.appendage.empty())
    anatomy.atria.push_back(std::move(atria));
}

} // namespace

HeartLandmarks estimateHeartLandmarks(const sequences::AnatomySurface& surface, const Bounds& box) {
  const Inside inside = sampleInside(surface, box);
  if (inside.points.empty())
    throw DataError("the surface has no inside", "heart landmarks", "give apex and base yourself");
  const Opened parts = opened(inside);
  const auto [middle, axis] = axisToApex(parts);
  double back = 0;
  for (const Vec3& point : parts.body)
    back = std::min(back, (point - middle).dot(axis));
  double tip = box.diagonal();
  while (tip > 0 && surface(middle + tip * axis) > 0)
    tip -= 1e-3 * box.diagonal();
  HeartLandmarks landmarks;
  landmarks.apex = middle + tip * axis;
  landmarks.base = landmarks.apex - kBaseBack * (tip - back) * axis;
  const Vec3 widest = landmarks.base + 0.35 * (landmarks.apex - landmarks.base);
  const double width = 0.5 * (tip - back);
  landmarks.right = widest + 0.5 * width * bulge(surface, widest, axis, 2 * width);
  return landmarks;
}

HeartAnatomy fitHeart(const HeartLandmarks& landmarks, const sequences::AnatomySurface& surface,
                      const Points& points) {
  if (surface(landmarks.base) >= 0)
    throw DataError("the base does not lie inside the heart", "heart landmarks",
                    "put it on the middle of the mitral valve");
  HeartAnatomy anatomy;
  anatomy.frame =
      HeartFrame(landmarks.base, landmarks.right - landmarks.base, landmarks.apex - landmarks.base);
  const double radius = leftRadius(surface, anatomy.frame);
  anatomy.endocardium = {kCavityShare * radius, kCavityCenter, kCavityHalf};
  anatomy.epicardium = {radius, kShellCenter, kShellHalf};
  anatomy.baseEpicardium = -6;
  anatomy.length = 92;
  anatomy.ventricles = [surface, frame = anatomy.frame](const Vec3& p) {
    return std::max(surface(p), -kBehindBase - frame.toLocal(p).z());
  };
  anatomy.rightCavity = anatomy.ventricles;
  anatomy.greatVessels = [](const Vec3&) { return kFarthestFromAxis; };
  addBehindBase(anatomy, surface, points);
  anatomy.box = sequences::grownBox(points, kHeartBoxMargin);
  return anatomy;
}

} // namespace viscera::heart
