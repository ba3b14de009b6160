#include "viscera/heart/valve_leaflets.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace viscera::heart {
namespace {

using Vec2 = Eigen::Vector2d;

// Lengths in radii of the ring:
constexpr double kCrown = 0.9;        ///< How high the commissures of pockets are above their nadirs.
constexpr double kPocketMeets = 0.5;  ///< How high shut pockets meet in the middle.
constexpr double kSailMeets = 0.3;    ///< The same of sails.
constexpr double kPocketBelly = 0.25; ///< How deep the blood behind it makes a shut leaflet sag.
constexpr double kSailBelly = 0.14;

Vec2 onCircle(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The free edges of all leaflets in the plane of a ring of radius 1, one after the other: shut, and open to
/// the ring.
struct Edges {
  std::vector<Vec2> shut, open;
  double fullArea = 0; ///< Within the open ones.
  double mixed = 0;    ///< The area that belongs to both: see `mixFor`.
};

Edges edgesOf(const ValveForm& form) {
  constexpr int kAlong = Leaflets::kAlong;
  const double sector = 2 * std::numbers::pi / form.leaflets;
  Edges edges;
  for (int leaflet = 0; leaflet < form.leaflets; ++leaflet)
    for (int i = 0; i <= kAlong; ++i) {
      const double u = static_cast<double>(i) / kAlong;
      const double begin = form.turned + leaflet * sector;
      edges.open.push_back(onCircle(begin + u * sector));
      edges.shut.push_back(std::abs(1 - 2 * u) * onCircle(u < 0.5 ? begin : begin + sector));
    }
  for (std::size_t i = 0; i < edges.open.size(); ++i) {
    const std::size_t next = (i + 1) % edges.open.size();
    edges.fullArea += cross(edges.open[i], edges.open[next]) / 2;
    edges.mixed += (cross(edges.open[i], edges.shut[next]) + cross(edges.shut[i], edges.open[next])) / 2;
  }
  return edges;
}

/// The part of the open edges in (1 - part) shut + part open that leaves `fraction` of the full area: the
/// area is a quadratic form of the two, and nothing for the shut ones.
double mixFor(const Edges& edges, double fraction) {
  // The free edge (1 - p) shut + p open has the area p^2 F + p (1 - p) M, F the full and M the mixed one.
  // Over F this is (1 - l) p^2 + l p = fraction with l = M / F, and
  // p = 2 fraction / (l + sqrt(l^2 + 4 (1 - l) fraction)) does not cancel.
  const double linear = edges.mixed / edges.fullArea;
  const double root = std::sqrt(linear * linear + 4 * (1 - linear) * fraction);
  return fraction > 0 ? 2 * fraction / (linear + root) : 0;
}

/// The leaflets over a ring of radius 1 in the plane z = 0, z downstream.
class UnitLeaflets {
public:
  UnitLeaflets(const ValveForm& form, double fraction)
      : form_(form), edges_(edgesOf(form)), part_(mixFor(edges_, fraction)) {}

  /// `along` of the leaflet's edge, `across` from the ring to it.
  Vec3 at(int leaflet, int along, int across) const {
    const auto place = static_cast<std::size_t>(leaflet * (Leaflets::kAlong + 1) + along);
    const Vec2 &ring = edges_.open[place], &shut = edges_.shut[place];
    const Vec2 edge = (1 - part_) * shut + part_ * ring;
    const double u = static_cast<double>(along) / Leaflets::kAlong;
    const double s = static_cast<double>(across) / Leaflets::kAcross;
    const double middle = 1 - std::abs(1 - 2 * u); // 0 at the commissures.
    const double low = form_.semilunar ? kCrown * (1 - 2 * u) * (1 - 2 * u) : 0;
    const double meets = form_.semilunar ? kCrown + (kPocketMeets - kCrown) * middle : kSailMeets * middle;
    // A leaflet keeps its length from ring to edge, length^2 = |ring - shut|^2 + (meets - low)^2: what it no
    // longer reaches inwards it rises.
    const double length = std::hypot((ring - shut).norm(), meets - low);
    const double reach = (ring - edge).norm();
    const double rise = std::sqrt(std::max(0.0, length * length - reach * reach));
    const double belly = (form_.semilunar ? kPocketBelly : kSailBelly) * (1 - part_) *
                         std::sin(std::numbers::pi * u) * 4 * s * (1 - s);
    const Vec2 flat = (1 - s) * ring + s * edge;
    return {flat.x(), flat.y(), low + s * rise - belly};
  }
  double fullArea() const { return edges_.fullArea; }

private:
  ValveForm form_;
  Edges edges_;
  double part_;
};

Triangles trianglesFor(int leaflets) {
  constexpr int kAlong = Leaflets::kAlong, kAcross = Leaflets::kAcross;
  Triangles triangles(2 * leaflets * kAlong * kAcross, 3);
  Eigen::Index row = 0;
  for (int leaflet = 0; leaflet < leaflets; ++leaflet)
    for (int i = 0; i < kAlong; ++i)
      for (int j = 0; j < kAcross; ++j) {
        const int corner = leaflet * Leaflets::kPointsEach + i * (kAcross + 1) + j;
        const int beside = corner + kAcross + 1;
        triangles.row(row++) << corner, beside, beside + 1;
        triangles.row(row++) << corner, beside + 1, corner + 1;
      }
  return triangles;
}

} // namespace

ValveForm formOf(HeartValve valve) {
  switch (valve) {
  case HeartValve::mitral:
    return {2, false, std::numbers::pi / 2};
  case HeartValve::tricuspid:
    return {3, false, 0};
  case HeartValve::aortic:
  case HeartValve::pulmonary:
    break;
  }
  return {3, true, 0};
}

Leaflets leafletsOf(const ValveRing& ring, const ValveForm& form, double orificeMm2) {
  const double area = ring.first.norm() * ring.second.norm();
  const double full = area * edgesOf(form).fullArea;
  const double fraction = std::clamp(orificeMm2 / full, 0.0, 1.0);
  const UnitLeaflets unit(form, fraction);
  const double radius = ring.radius();
  Leaflets leaflets;
  leaflets.orificeMm2 = fraction * full;
  leaflets.points.resize(form.leaflets * Leaflets::kPointsEach, 3);
  Eigen::Index row = 0;
  for (int leaflet = 0; leaflet < form.leaflets; ++leaflet)
    for (int i = 0; i <= Leaflets::kAlong; ++i)
      for (int j = 0; j <= Leaflets::kAcross; ++j) {
        const Vec3 point = unit.at(leaflet, i, j);
        leaflets.points.row(row++) = (ring.center + point.x() * ring.first + point.y() * ring.second +
                                      point.z() * radius * ring.downstream)
                                         .transpose();
      }
  leaflets.triangles = trianglesFor(form.leaflets);
  return leaflets;
}

} // namespace viscera::heart
