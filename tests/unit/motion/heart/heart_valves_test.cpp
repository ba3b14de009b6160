#include "viscera/heart/heart_valves.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "viscera/heart/valve_leaflets.h"

namespace viscera::heart {
namespace {

constexpr std::array<HeartValve, kHeartValves> kValves = {HeartValve::mitral, HeartValve::aortic,
                                                          HeartValve::tricuspid, HeartValve::pulmonary};

ValveRing ellipse() {
  return {{1, 2, 3}, {12, 0, 0}, {0, 15, 0}, {0, 0, 1}};
}

/// Where a point lies in the ring, in its half axes, and how far downstream, mm.
Vec3 within(const ValveRing& ring, const Vec3& point) {
  const Vec3 offset = point - ring.center;
  return {offset.dot(ring.first) / ring.first.squaredNorm(),
          offset.dot(ring.second) / ring.second.squaredNorm(), offset.dot(ring.downstream)};
}

Vec3 pointOf(const Leaflets& leaflets, int leaflet, int along, int across) {
  return leaflets.points.row(leaflet * Leaflets::kPointsEach + along * (Leaflets::kAcross + 1) + across)
      .transpose();
}

/// What the free edges leave open, measured as a polygon seen along the flow.
double measuredOrifice(const ValveRing& ring, const Leaflets& leaflets, int count) {
  std::vector<Vec3> edge;
  for (int leaflet = 0; leaflet < count; ++leaflet)
    for (int i = 0; i <= Leaflets::kAlong; ++i)
      edge.push_back(pointOf(leaflets, leaflet, i, Leaflets::kAcross));
  double area = 0;
  for (std::size_t i = 0; i < edge.size(); ++i)
    area += ring.downstream.dot((edge[i] - ring.center).cross(edge[(i + 1) % edge.size()] - ring.center)) / 2;
  return area;
}

/// What the leaflets cover, seen along the flow.
double coveredArea(const ValveRing& ring, const Leaflets& leaflets) {
  double area = 0;
  for (const auto& triangle : leaflets.triangles.rowwise()) {
    const Vec3 a = leaflets.points.row(triangle[0]), b = leaflets.points.row(triangle[1]),
               c = leaflets.points.row(triangle[2]);
    area += std::abs(ring.downstream.dot((b - a).cross(c - a))) / 2;
  }
  return area;
}

TEST(ValveLeaflets, LeaveExactlyTheOrificeThatIsAskedFor) {
  const ValveRing ring = ellipse();
  for (const HeartValve valve : kValves)
    for (const double wanted : {0.0, 20.0, 70.0, 200.0, 400.0, 550.0}) {
      const ValveForm form = formOf(valve);
      const Leaflets leaflets = leafletsOf(ring, form, wanted);
      EXPECT_NEAR(leaflets.orificeMm2, wanted, 1e-9);
      EXPECT_NEAR(measuredOrifice(ring, leaflets, form.leaflets), wanted, 1e-9);
    }
}

TEST(ValveLeaflets, NeverLeaveMoreThanTheRing) {
  const ValveRing ring = ellipse();
  const Leaflets leaflets = leafletsOf(ring, formOf(HeartValve::aortic), 1e4);
  EXPECT_LE(leaflets.orificeMm2, ring.areaMm2());
  EXPECT_GT(leaflets.orificeMm2, 0.99 * ring.areaMm2());
}

TEST(ValveLeaflets, CoverTheRingAndMeetWhenTheyAreShut) {
  const ValveRing ring = ellipse();
  for (const HeartValve valve : kValves) {
    const ValveForm form = formOf(valve);
    const Leaflets leaflets = leafletsOf(ring, form, 0);
    EXPECT_NEAR(coveredArea(ring, leaflets), ring.areaMm2(), 0.01 * ring.areaMm2());
    const Vec3 middle = pointOf(leaflets, 0, Leaflets::kAlong / 2, Leaflets::kAcross);
    for (int leaflet = 1; leaflet < form.leaflets; ++leaflet)
      EXPECT_LT((pointOf(leaflets, leaflet, Leaflets::kAlong / 2, Leaflets::kAcross) - middle).norm(), 1e-9);
  }
}

/// Sectors are disjoint, so leaflets that stay within theirs cannot cross.
TEST(ValveLeaflets, StayWithinTheirSectorsSoThatNoneCrossesAnother) {
  const ValveRing ring = ellipse();
  for (const HeartValve valve : kValves)
    for (const double orifice : {0.0, 40.0, 300.0, 560.0}) {
      const ValveForm form = formOf(valve);
      const Leaflets leaflets = leafletsOf(ring, form, orifice);
      const double half = std::numbers::pi / form.leaflets;
      for (int leaflet = 0; leaflet < form.leaflets; ++leaflet)
        for (int i = 0; i < Leaflets::kPointsEach; ++i) {
          const Vec3 place =
              within(ring, leaflets.points.row(leaflet * Leaflets::kPointsEach + i).transpose());
          EXPECT_LT(place.head<2>().norm(), 1 + 1e-9);
          if (place.head<2>().norm() < 1e-9)
            continue;
          const double middle = form.turned + (2 * leaflet + 1) * half;
          EXPECT_LT(std::abs(std::remainder(std::atan2(place.y(), place.x()) - middle, 2 * std::numbers::pi)),
                    half + 1e-6);
        }
    }
}

TEST(ValveLeaflets, SwingDownstreamAsTheyOpenAndKeepTheirLength) {
  const ValveRing ring{{0, 0, 0}, {12, 0, 0}, {0, 12, 0}, {0, 0, 1}};
  for (const HeartValve valve : kValves) {
    const ValveForm form = formOf(valve);
    double before = -std::numeric_limits<double>::infinity();
    double length = 0;
    for (const double orifice : {0.0, 100.0, 250.0, 400.0}) {
      const Leaflets leaflets = leafletsOf(ring, form, orifice);
      const Vec3 edge = pointOf(leaflets, 0, Leaflets::kAlong / 2, Leaflets::kAcross);
      const Vec3 hinge = pointOf(leaflets, 0, Leaflets::kAlong / 2, 0);
      EXPECT_GT(edge.z(), before);
      before = edge.z();
      if (orifice > 0) {
        EXPECT_NEAR((edge - hinge).norm(), length, 1e-9);
      }
      length = (edge - hinge).norm();
    }
  }
}

TEST(CarriedRing, FollowsTheSurfaceAroundIt) {
  const ValveRing ring = ellipse();
  Points disc(400, 3);
  for (Eigen::Index i = 0; i < disc.rows(); ++i) {
    const double angle = 0.7 * static_cast<double>(i), radius = 0.08 * static_cast<double>(i);
    disc.row(i) << 1 + radius * std::cos(angle), 2 + radius * std::sin(angle), 3;
  }
  const CarriedRing carried(ring, disc);
  EXPECT_LT((carried.at(disc).center - ring.center).norm(), 1e-9);
  const Eigen::AngleAxisd turn(0.4, Vec3(1, 2, -1).normalized());
  const Vec3 shift(5, -3, 9);
  const Points moved = ((0.9 * turn.toRotationMatrix() * disc.transpose()).colwise() + shift).transpose();
  const ValveRing now = carried.at(moved);
  EXPECT_LT((now.center - (0.9 * (turn * ring.center) + shift)).norm(), 1e-9);
  EXPECT_LT((now.downstream - turn * ring.downstream).norm(), 1e-9);
  EXPECT_LT((now.second - 0.9 * (turn * ring.second)).norm(), 1e-9);
  EXPECT_NEAR(now.areaMm2(), 0.81 * ring.areaMm2(), 1e-6);
}

} // namespace
} // namespace viscera::heart
