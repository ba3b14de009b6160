#include <cmath>

#include <gtest/gtest.h>

#include "held_value.h"
#include "thick_cylinder.h"
#include "viscera/strain/strain_curve.h"
#include "viscera/strain/wall_means.h"

namespace viscera::strain {
namespace {

/// Points of a wall around the z axis, some in each of segments 1 to 16.
WallPoints wallAroundZ() {
  const HeartAxes axes(Vec3::Zero(), Vec3(0, 0, 90), Vec3::UnitX());
  std::vector<double> volumes;
  WallPoints wall;
  for (int i = 0; i < 720; ++i) {
    const double angle = 0.5 + i, height = 89.0 * i / 720;
    const Vec3 place(25 * std::cos(angle), 25 * std::sin(angle), height);
    wall.rows.push_back(i);
    wall.axes.push_back(localAxes(Vec3(place.x(), place.y(), 0), -Vec3::UnitZ()));
    wall.segments.push_back(segmentOf(axes, place));
    volumes.push_back(1 + 0.01 * (i % 7));
  }
  wall.volumes = Eigen::Map<const Values>(volumes.data(), static_cast<Eigen::Index>(volumes.size()));
  wall.depth = Values::Constant(wall.volumes.size(), 0.5);
  return wall;
}

void stretched(const WallPoints& wall, double along, double across, std::vector<Eigen::Matrix3d>& gradients) {
  gradients.assign(wall.rows.size(), Vec3(across, across, along).asDiagonal());
}

TEST(WallMeans, OfAUniformStretchAreTheStretchFromAnyReference) {
  const WallPoints wall = wallAroundZ();
  std::vector<Eigen::Matrix3d> reference, now;
  stretched(wall, 1.1, 0.9, reference);
  stretched(wall, 0.88, 1.08, now);
  const WallMeans means = WallReference(wall, reference).meansAt(now);
  for (std::size_t k = 0; k <= 16; ++k) {
    EXPECT_NEAR(means.longitudinal[k], -0.2, 1e-12) << k;
    EXPECT_NEAR(means.circumferential[k], 0.2, 1e-12) << k;
    EXPECT_NEAR(means.radial[k], 0.2, 1e-12) << k;
  }
  EXPECT_TRUE(std::isnan(means.radial[17])) << "no point lies in the cap";
}

/// Draws whose strain is known have deviations that are known, however many threads draw.
TEST(WallMeans, DeviateAsTheDrawsDo) {
  const WallPoints wall = wallAroundZ();
  constexpr int kDraws = 24;
  std::vector<double> errors;
  for (int draw = 0; draw < kDraws; ++draw)
    errors.push_back(0.02 * std::sin(7.0 * draw));
  const DrawnGradients gradients = [&](int draw, auto& reference, auto& now) {
    stretched(wall, 1, 1, reference);
    stretched(wall, 0.85 + errors[static_cast<std::size_t>(draw)], 0.9, now);
  };
  Progress progress;
  const WallMeans one = deviationsOfMeans(wall, gradients, kDraws, progress, Threads{1});
  const WallMeans four = deviationsOfMeans(wall, gradients, kDraws, progress, Threads{4});
  tests::HeldValue held("deviations of segments for draws whose strain is known", 1e-9);
  for (std::size_t k = 0; k <= 16; ++k) {
    held.add(one.longitudinal[k] - deviationOf(errors));
    EXPECT_NEAR(one.circumferential[k], 0, 1e-12) << k;
    EXPECT_EQ(one.longitudinal[k], four.longitudinal[k]) << k;
  }
  EXPECT_TRUE(std::isnan(one.longitudinal[17]));
}

} // namespace
} // namespace viscera::strain
