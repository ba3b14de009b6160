#include "viscera/heart/wall_motion.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::heart {
namespace {

using std::numbers::pi;

/// Where a surface's points go.
struct Move {
  double widening = 1; ///< Of the distance from the axis.
  double down = 0;     ///< At the base towards the apex, mm; at the apex (c = 92) nothing.
  double apexTurn = 0; ///< rad, growing from the base.
};

/// Points of an ellipsoid about the axis c, in even steps of both angles.
Points shell(double radius, double halfLength, const Move& move, double sideways = 0) {
  constexpr double kCenter = 28, kLength = 92;
  Points points(60 * 60, 3);
  Eigen::Index row = 0;
  for (int i = 0; i < 60; ++i)
    for (int k = 0; k < 60; ++k) {
      const double polar = pi * (i + 0.5) / 60, phi = 2 * pi * k / 60;
      const double c = std::max(1.0, kCenter + halfLength * std::cos(polar));
      const double along = std::clamp(c / kLength, 0.0, 1.0);
      const double rho = move.widening * radius * std::sin(polar);
      const double angle = phi + along * move.apexTurn;
      points.row(row++) << rho * std::cos(angle) + sideways, rho * std::sin(angle),
          c + move.down * (1 - along);
    }
  return points;
}

class Heart {
public:
  explicit Heart(const Move& left, const Move& outer, double rightDown)
      : left_(shell(25.5, 59, left)), outer_(shell(33.5, 65, outer)),
        right_(shell(40, 52, {1, rightDown, 0}, 27)) {}
  HeartSurfaces surfaces() const { return {left_, right_, outer_}; }

private:
  Points left_, outer_, right_;
};

TEST(WallGauge, MeasuresWhatTheSurfacesDo) {
  const Heart rest({}, {}, 0);
  const WallGauge gauge(HeartFrame(), rest.surfaces());
  const WallPlaces before = gauge.at(rest.surfaces());
  EXPECT_NEAR(before.leftBaseMm, 0, 1e-12);
  EXPECT_NEAR(before.apexTurn, 0, 1e-12);
  EXPECT_NEAR(before.wallMm, 8, 0.5);
  const Heart systole({0.7, 15, 0.2}, {0.9, 15, 0.2}, 20);
  const WallPlaces after = gauge.at(systole.surfaces());
  EXPECT_NEAR(after.leftBaseMm, 15, 1.5);
  EXPECT_NEAR(after.rightBaseMm, 20, 1.5);
  EXPECT_NEAR(after.apexTurn - after.baseTurn, 0.2 * 67 / 92, 0.01);
  EXPECT_NEAR(after.wallMm, 0.9 * 33.5 - 0.7 * 25.5, 1);
  const WallMotion motion = wallMotion({before, after});
  EXPECT_NEAR(motion.mapseMm, after.leftBaseMm, 1e-9);
  EXPECT_NEAR(motion.tapseMm, after.rightBaseMm, 1e-9);
  EXPECT_NEAR(motion.thickeningPercent, 100 * (after.wallMm / before.wallMm - 1), 1e-9);
}

TEST(WallGauge, DoesNotSeeWhatMovesTheWholeHeart) {
  const Heart rest({}, {}, 0);
  const HeartFrame frame({3, 4, 5}, {1, 0, 0}, {0, 0.6, 0.8});
  const auto placed = [&](const Points& points) {
    Points there(points.rows(), 3);
    for (Eigen::Index row = 0; row < points.rows(); ++row)
      there.row(row) = frame.toWorld(Vec3(points.row(row)));
    return there;
  };
  const Heart systole({0.8, 12, 0.1}, {0.9, 12, 0.1}, 18);
  const WallPlaces here = WallGauge(HeartFrame(), rest.surfaces()).at(systole.surfaces());
  const Points left = placed(rest.surfaces().leftCavity), right = placed(rest.surfaces().rightCavity),
               outer = placed(rest.surfaces().outer);
  const Points leftNow = placed(systole.surfaces().leftCavity),
               rightNow = placed(systole.surfaces().rightCavity), outerNow = placed(systole.surfaces().outer);
  const WallPlaces there = WallGauge(frame, {left, right, outer}).at({leftNow, rightNow, outerNow});
  EXPECT_NEAR(here.leftBaseMm, there.leftBaseMm, 1e-9);
  EXPECT_NEAR(here.apexTurn, there.apexTurn, 1e-9);
  EXPECT_NEAR(here.wallMm, there.wallMm, 1e-9);
}

TEST(WallGauge, RefusesSurfacesThatItCannotMeasure) {
  const Heart rest({}, {}, 0);
  const HeartSurfaces all = rest.surfaces();
  const Points few = all.leftCavity.topRows(5);
  EXPECT_THROW(WallGauge(HeartFrame(), {few, all.rightCavity, all.outer}), DataError);
  EXPECT_THROW(WallGauge(HeartFrame(), all).at({few, all.rightCavity, all.outer}), DataError);
}

TEST(WallMotion, EveryNumberHasARangeAndASource) {
  for (const WallMotionRange& range : wallMotionRanges()) {
    EXPECT_LT(range.low, range.high) << range.name;
    EXPECT_NE(std::string(range.source).find("doi"), std::string::npos) << range.name;
  }
}

} // namespace
} // namespace viscera::heart
