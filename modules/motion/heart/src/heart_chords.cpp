#include "viscera/heart/heart_chords.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/heart/heart_frame.h"

namespace viscera::heart {
namespace {

/// Part of the way between its ends by which a slack chord bows.
constexpr double kMostBow = 0.125;
/// How far from the middle of a muscle's tip its chords begin, rad on the round tip.
constexpr double kTipSpread = 0.9;

/// The round tip of a papillary muscle in the definition of the sample heart, in the left ventricle's frame.
struct Tip {
  Vec3 middle, along;
  double radius = 0;
};

/// A muscle's tip with the commissure of the valve that it is below: that where this leaflet begins.
struct Holder {
  HeartValve valve;
  Tip tip;
  int leaflet = 0;
};

/// The mitral valve's first leaflet is the posterior one, which begins at the posteromedial commissure; those
/// of the tricuspid valve are inferior, septal and anterior.
const std::array<Holder, 5>& holders() {
  static const std::array<Holder, 5> all = {
      {{HeartValve::mitral, {{-3, 11.4, 29}, {1.4, -5.4, -15}, 3.5}, 0},
       {HeartValve::mitral, {{-5.4, -10.5, 29}, {2.5, 5.1, -15}, 3.5}, 1},
       {HeartValve::tricuspid, {{48, 2, 28}, {-2, 7, -13}, 2.8}, 0},
       {HeartValve::tricuspid, {{39, 19, 25}, {2, -5, -13}, 2.3}, 1},
       {HeartValve::tricuspid, {{36, -7, 18}, {7, 8, -7}, 2}, 2}}};
  return all;
}

/// Points of a leaflet's edge that a muscle holds, from its commissure on.
std::vector<int> heldAlong(HeartValve valve) {
  return valve == HeartValve::mitral ? std::vector<int>{2, 5, 8, 11} : std::vector<int>{3, 7, 11};
}

Vec3 edgeOf(const Leaflets& leaflets, const Chord& chord) {
  const int column = chord.leaflet * Leaflets::kPointsEach + chord.along * (Leaflets::kAcross + 1);
  return leaflets.points.row(column + Leaflets::kAcross).transpose();
}

/// Across a line and away from the ring's axis; zero where no direction is.
Vec3 outwardsAt(const Vec3& middle, const Vec3& along, const ValveRing& ring) {
  Vec3 out = middle - ring.center;
  out -= out.dot(ring.downstream) * ring.downstream;
  out -= out.dot(along) * along;
  constexpr double kNoDirectionMm = 1e-6;
  return out.norm() > kNoDirectionMm ? Vec3(out.normalized()) : Vec3::Zero();
}

} // namespace

std::vector<Chord> sampleHeartChords() {
  const HeartFrame frame = sampleHeartFrame();
  std::vector<Chord> chords;
  for (const Holder& holder : holders()) {
    const Vec3 along = holder.tip.along.normalized();
    const Vec3 across = along.unitOrthogonal(), other = along.cross(across);
    const std::vector<int> held = heldAlong(holder.valve);
    const int leaflets = formOf(holder.valve).leaflets;
    for (std::size_t i = 0; i < 2 * held.size(); ++i) {
      const bool before = i >= held.size(); // On the sail that ends at the commissure.
      const int from = held[i % held.size()];
      const double turn = std::numbers::pi * static_cast<double>(i) / static_cast<double>(held.size());
      const Vec3 aside = std::cos(turn) * across + std::sin(turn) * other;
      const Vec3 place = holder.tip.middle +
                         holder.tip.radius * (std::cos(kTipSpread) * along + std::sin(kTipSpread) * aside);
      chords.push_back({holder.valve, before ? (holder.leaflet + leaflets - 1) % leaflets : holder.leaflet,
                        before ? Leaflets::kAlong - from : from, frame.toWorld(place)});
    }
  }
  return chords;
}

HeartChords::HeartChords(const Points& walls) : chords_(sampleHeartChords()) {
  if (walls.rows() == 0)
    throw DataError(misuse("chords need the walls of a heart to hold on to"), "heart");
  const ValveRings rings = sampleHeartRings();
  for (const Chord& chord : chords_) {
    Eigen::Index nearest = 0;
    (walls.rowwise() - chord.muscle.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
    vertices_.push_back(nearest);
    const Leaflets shut = leafletsOf(rings.at(static_cast<std::size_t>(chord.valve)), formOf(chord.valve), 0);
    lengths_.push_back((edgeOf(shut, chord) - walls.row(nearest).transpose()).norm());
  }
}

Points HeartChords::at(std::size_t i, const Leaflets& leaflets, const ValveRing& ring,
                       const Points& walls) const {
  const Vec3 from = walls.row(vertices_.at(i)).transpose(), to = edgeOf(leaflets, chords_.at(i));
  const double way = (to - from).norm();
  Points line(kPointsEach, 3);
  // A shallow parabola of sagitta h over a way d is d + 8 h^2 / (3 d) long.
  const double slack = std::max(0.0, lengths_.at(i) - way);
  const double bow = std::min(kMostBow * way, std::sqrt(3 * way * slack / 8));
  const Vec3 out = way > 0 ? outwardsAt((from + to) / 2, (to - from) / way, ring) : Vec3(Vec3::Zero());
  for (int p = 0; p < kPointsEach; ++p) {
    const double part = static_cast<double>(p) / (kPointsEach - 1);
    line.row(p) = ((1 - part) * from + part * to + 4 * part * (1 - part) * bow * out).transpose();
  }
  return line;
}

} // namespace viscera::heart
