#include "viscera/heart/heart_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "viscera/sequences/curve.h"

namespace viscera::heart {
namespace {

/// The direction, seen from the long axis, in which the right ventricle's base lies, rad.
constexpr double kRightBaseAngle = 0.436;
/// The right ventricle's own wall, mm.
constexpr double kRightWall = 4;
/// Within this of the left ventricle (mm) what lies outside follows it more than the right one.
constexpr double kWhereRightBegins = 12;
// Coordinates average over a wall of 8 mm: so that its outside lies at `wallRho`, the handles there go
// farther out by these parts of the wall's thickening. Tuned by hand against what
// HeartbeatSetup.WallsMoveAsMeasured... holds on the sample heart's surfaces: the left ventricle's muscle
// keeps its volume within 6 % (5.7 %), its free wall thickens by 30 to 60 % (57 %).
/// Beside the right ventricle, against the muscle's volume: without it 12.6 % are lost.
constexpr double kRightPush = 2.6;
/// Push at the free wall, against both: without it 7.5 % of the muscle are lost, with 0.6 in its place 2.2 %,
/// but the wall thickens by 66 %.
constexpr double kFreePush = 0.2;
/// Push on the septum, against the muscle's volume: without it 11.2 % are lost.
constexpr double kSeptumPush = 1.1;
/// Near the outflow the right ventricle narrows less: by this part of the way, fading over this length (mm).
constexpr double kOutflowEase = 0.4;
constexpr double kOutflowLength = 22;
/// Farther than this from an atrium's centre (mm), in its ear, contraction moves handles less and less.
constexpr double kAtrialBody = 32;

/// The part of an atrium that is cavity: the rest is its wall.
constexpr double kAtrialCavity = 0.75;

/// An atrium's wall of 2.5 mm is thinner than what coordinates average over, so it grows with its cavity.
/// What it gains (260 ml of wall by 44 in exercise) the outside over the right ventricle gives back: its
/// handles come so far inwards (mm) when both atria hold twice what they hold at rest. Tuned by hand on the
/// surfaces of the sample heart: without it the wall changes by 8.2 % in exercise, with it by 4.6 %; the
/// right ventricle's own wall then changes by less than 1 mm.
constexpr double kAtrialRelief = 6;

double square(double x) {
  return x * x;
}

double cube(double x) {
  return x * x * x;
}

} // namespace

HeartMotion::HeartMotion(HeartRig rig, const HeartExcursions& excursions)
    : rig_(std::move(rig)), excursions_(excursions),
      wallsHandled_(!rig_.handlesOf(HeartRole::leftEndocardium).empty()) {
  for (const AtriumAnatomy& atrium : rig_.anatomy.atria) {
    std::vector<double>& shares = atrialShares_.emplace_back();
    for (const HeartHandle& handle : rig_.handles) {
      const double distance = (handle.position - atrium.center).norm();
      const double wall = std::min(distance - std::max(0.0, atrium.surface(handle.position)), kAtrialBody);
      shares.push_back(distance > 0 ? cube(std::max(0.0, wall) / distance) : 1);
    }
  }
}

double HeartMotion::shortening(const HeartState& state) const {
  return 1 - state.emptying * excursions_.leftDescent / rig_.anatomy.length;
}

double HeartMotion::leftScale(const HeartState& state) const {
  // The cavity's volume goes with scale^2 shortening.
  return std::sqrt(state.leftPart / shortening(state));
}

double HeartMotion::descent(const HeartState& state, double phi, double c) const {
  const double right = square(0.5 + 0.5 * std::cos(phi - kRightBaseAngle));
  const double base = (1 - right) * excursions_.leftDescent * state.emptying +
                      right * excursions_.rightDescent * state.rightEmptying;
  return base * std::clamp(1 - c / rig_.anatomy.length, 0.0, 1.0);
}

double HeartMotion::wallRho(const HeartState& state, double rho, double c) const {
  const double inner = rig_.anatomy.endocardium.radiusAt(std::max(c, 0.0));
  const double scale = leftScale(state);
  if (rho <= inner)
    return scale * rho;
  // The muscle between the inner radius and rho keeps its volume, (rho'^2 - rho_i'^2) shortening = muscle
  // (rho^2 - rho_i^2), but for the factor muscle.
  return std::sqrt(square(scale * inner) + state.muscle * (square(rho) - square(inner)) / shortening(state));
}

double HeartMotion::thickening(const HeartState& state, double c) const {
  const double outer = rig_.anatomy.epicardium.radiusAt(std::max(c, rig_.anatomy.baseEpicardium));
  const double inner = rig_.anatomy.endocardium.radiusAt(std::max(c, 0.0));
  // A wall that gets thinner, of a dilated heart, needs no room.
  return std::max(0.0, wallRho(state, outer, c) - leftScale(state) * inner - (outer - inner));
}

double HeartMotion::ventricularRho(const HeartHandle& handle, const HeartState& state) const {
  const double rho = handle.place.rho;
  const double c = handle.place.c;
  if (handle.role == HeartRole::leftEndocardium)
    return state.leftGain * leftScale(state) * rho;
  if (handle.role == HeartRole::septum)
    return wallRho(state, rho, c) + kSeptumPush * thickening(state, c);

  const HeartAnatomy& anatomy = rig_.anatomy;
  const double septum = anatomy.epicardium.radiusAt(std::max(c, anatomy.baseEpicardium));
  const double beyond = handle.surfaceRho - septum;
  const double gap = rho - handle.surfaceRho;
  // Tissue around the left ventricle's wall moves as if it kept its volume too.
  const double away = 0.5 - 0.5 * std::cos(handle.place.phi);
  const double push = (kRightPush + away * (kFreePush - kRightPush)) * thickening(state, c);
  // Where only the outside is handled, nothing averages over a wall: its handles go with it.
  const double aroundLeft =
      wallsHandled_ ? wallRho(state, rho, c) + push : wallRho(state, handle.surfaceRho, c) + gap;
  if (beyond <= 0)
    return aroundLeft;
  const bool inside = handle.role == HeartRole::rightFreeWall;
  const double wall = inside ? 0 : std::min(kRightWall, beyond);
  const double part = state.rightPart + (inside ? state.rightShift : 0);
  const double ease = kOutflowEase * std::exp((anatomy.baseEpicardium - std::max(c, anatomy.baseEpicardium)) /
                                              kOutflowLength);
  const double scale = part + (1 - part) * ease;
  const double aroundRight =
      wallRho(state, septum, c) + (beyond - wall) * scale + wall / std::sqrt(shortening(state)) + gap;
  if (inside || !wallsHandled_)
    return aroundRight;
  const double relief =
      state.atria ? kAtrialRelief * 0.5 * (state.atria->leftPart + state.atria->rightPart - 2) : 0;
  return aroundLeft + sequences::smoothStep(beyond / kWhereRightBegins) * (aroundRight - relief - aroundLeft);
}

Vec3 HeartMotion::movedVentricular(const HeartHandle& handle, const HeartState& state) const {
  const HeartPoint& from = handle.place;
  const double along = std::clamp(from.c / rig_.anatomy.length, 0.0, 1.0);
  const double turn = excursions_.baseTwist + along * (excursions_.apexTwist - excursions_.baseTwist);
  return rig_.anatomy.frame.toWorld(HeartPoint{ventricularRho(handle, state), from.phi + state.twist * turn,
                                               from.c + descent(state, from.phi, from.c)});
}

Vec3 HeartMotion::pushedByAtria(std::size_t row, const AtrialState& atria) const {
  Vec3 push = Vec3::Zero();
  for (std::size_t i = 0; i < atrialShares_.size(); ++i) {
    const AtriumAnatomy& atrium = rig_.anatomy.atria[i];
    const Vec3 outward = rig_.handles[row].position - atrium.center;
    const double share = atrialShares_[i][row];
    // What comes into an atrium leaves the sphere around it: r'^3 = r^3 + what came, by 4 pi / 3.
    const double part = atrium.left ? atria.leftPart : atria.rightPart;
    const double shift = atrium.left ? atria.leftShift : atria.rightShift;
    push += (std::cbrt(1 + share * kAtrialCavity * (part - 1)) - 1 + share * shift) * outward;
  }
  return push;
}

Vec3 HeartMotion::movedAtrial(std::size_t row, const HeartState& state) const {
  const HeartHandle& handle = rig_.handles[row];
  const double down = handle.follow * descent(state, handle.place.phi, handle.place.c);
  const Vec3 along = down * rig_.anatomy.frame.towardsApex();
  if (state.atria)
    return handle.position + pushedByAtria(row, *state.atria) + along;
  const Vec3 outward = handle.position - handle.center;
  const double widening =
      excursions_.atrialFilling * state.emptying - excursions_.atrialContraction * state.atrialContraction;
  const double share = square(std::min(1.0, kAtrialBody / outward.norm()));
  return handle.position + widening * share * outward + along;
}

Vec3 HeartMotion::moved(std::size_t row, const HeartState& state) const {
  const HeartHandle& handle = rig_.handles[row];
  switch (handle.role) {
  case HeartRole::farCorner:
    return handle.position;
  case HeartRole::atrium:
    return movedAtrial(row, state);
  case HeartRole::vessel:
    return handle.position + (state.atria ? pushedByAtria(row, *state.atria) : Vec3::Zero()) +
           handle.follow * descent(state, handle.place.phi, 0) * rig_.anatomy.frame.towardsApex();
  default:
    return movedVentricular(handle, state);
  }
}

void HeartMotion::pose(const HeartState& state, Points& pose) const {
  pose.resize(static_cast<Eigen::Index>(rig_.handles.size()), 3);
  for (Eigen::Index i = 0; i < pose.rows(); ++i)
    pose.row(i) = moved(static_cast<std::size_t>(i), state);
}

} // namespace viscera::heart
