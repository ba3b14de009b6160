#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/anatomy/norms.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/live/strain_reading.h"

/// How certain the strain of a segment is after a motion was fitted to measured surfaces.
namespace viscera::live {
namespace {

/// A half of an ellipsoid, closed at z = 0, with its apex at z = `depth`.
std::shared_ptr<const geometry::TriangleMesh> chamber(double radius, double depth, const Vec3& middle) {
  auto mesh = std::make_shared<geometry::TriangleMesh>(tests::sphere(4));
  for (Eigen::Index row = 0; row < mesh->points.rows(); ++row) {
    const Vec3 place = mesh->points.row(row);
    mesh->points.row(row) =
        (Vec3(radius * place.x(), radius * place.y(), std::max(0.0, place.z()) * depth) + middle).transpose();
  }
  return mesh;
}

/// A heart whose measured surfaces are where the poses move them, but for `errorMm` at each vertex.
MovedOrgans fittedHeart(double errorMm) {
  MovedOrgans moved;
  moved.organs = {{"EPI", chamber(34, 95, Vec3::Zero())},
                  {"LV", chamber(20, 80, Vec3(0, 0, 0.5))},
                  {"RV", chamber(12, 60, Vec3(-52, 0, 0.5))}};
  moved.handles.positions = deformation::placeHandles(tests::sphere(4, 140), {.count = 40});
  moved.system = coordinates::builtInRegistry().find("s-celestial");
  moved.corresponding = true;
  moved.measured.resize(moved.organs.size());
  for (int phase = 0; phase < 3; ++phase) {
    const Vec3 scale = phase == 1 ? Vec3(0.8, 0.8, 0.9) : Vec3(Vec3::Ones());
    moved.seconds.push_back(0.3 * phase);
    moved.poses.push_back(moved.handles.positions * scale.asDiagonal());
    for (std::size_t i = 0; i < moved.organs.size(); ++i) {
      Points points = moved.organs[i].mesh->points * scale.asDiagonal();
      for (Eigen::Index row = 0; row < points.rows(); ++row)
        points(row, row % 3) += row % 2 == 0 ? errorMm : -errorMm;
      moved.measured[i].push_back(points);
    }
  }
  return moved;
}

StrainReading readFitted(const MovedOrgans& moved, Threads threads = {}) {
  StrainOptions options;
  options.witnesses = 6000;
  Progress progress;
  return readStrain(moved, options, progress, threads);
}

double deviationOf(const StrainReading& reading, int segment) {
  return strainDeviation(reading, segment, StrainDirection::circumferential).value_or(-1);
}

TEST(StrainConfidence, OfAMotionThatFitsExactlyIsComplete) {
  const StrainReading reading = readFitted(fittedHeart(0));
  ASSERT_TRUE(reading.deviations);
  EXPECT_NEAR(deviationOf(reading, 7), 0, 1e-4);
  EXPECT_TRUE(reliablePeak(reading, 7, StrainDirection::circumferential));
}

TEST(StrainConfidence, FallsWithWhatTheFitLeavesHoweverManyThreadsDraw) {
  const StrainReading one = readFitted(fittedHeart(0.5), Threads{1});
  const StrainReading twice = readFitted(fittedHeart(1), Threads{3});
  ASSERT_TRUE(one.deviations && twice.deviations);
  for (const int segment : {7, 10, 12}) {
    EXPECT_GT(deviationOf(one, segment), 0) << segment;
    EXPECT_NEAR(deviationOf(twice, segment) / deviationOf(one, segment), 2, 0.1) << segment;
  }
  EXPECT_EQ(deviationOf(readFitted(fittedHeart(0.5), Threads{3}), 7), deviationOf(one, 7));
}

/// Nothing is known about the errors along the wall of a motion that was fitted by distances.
TEST(StrainConfidence, IsNotKnownWherePointsAreNot) {
  MovedOrgans moved = fittedHeart(0.5);
  moved.corresponding = false;
  const StrainReading byDistances = readFitted(moved);
  EXPECT_FALSE(byDistances.deviations);
  for (int segment = 1; segment <= strain::kSegments; ++segment)
    EXPECT_FALSE(reliablePeak(byDistances, segment, StrainDirection::longitudinal)) << segment;
  EXPECT_TRUE(byDistances.strain.gls) << "means stay";
  moved.corresponding = true;
  moved.measured.clear();
  EXPECT_FALSE(readFitted(moved).deviations) << "a motion that is computed has no errors";
}

TEST(StrainConfidence, CountsAgainstTheDistanceFromTheRange) {
  StrainReading reading(
      strain::FoundAxes{strain::HeartAxes(Vec3::Zero(), Vec3(0, 0, 80), Vec3::UnitX()), {}, true, 120});
  reading.corresponding = true;
  reading.strain.seconds = {0, 0.3};
  const anatomy::Range healthy = anatomy::rangeOf(anatomy::norm("lv.gls"));
  for (strain::SegmentStrain& segment : reading.strain.segments) {
    segment.number = static_cast<int>(&segment - reading.strain.segments.data()) + 1;
    segment.enough = true;
    segment.longitudinal = {0, 0.01 * (healthy.high + 2)}; // Two points too weak.
    segment.thickening = {0, 0.4};
  }
  EXPECT_TRUE(reliablePeak(reading, 3, StrainDirection::longitudinal)) << "nothing is known against it";
  reading.deviations.emplace();
  reading.deviations->longitudinal[3] = 0.019;
  reading.deviations->longitudinal[4] = 0.021;
  EXPECT_TRUE(reliablePeak(reading, 3, StrainDirection::longitudinal));
  EXPECT_FALSE(reliablePeak(reading, 4, StrainDirection::longitudinal));
  EXPECT_NEAR(strainDeviation(reading, 4, StrainDirection::longitudinal).value(), 2.1, 1e-9);
  EXPECT_TRUE(reliablePeak(reading, 4, StrainDirection::thickening)) << "no deviation of it is known";
  EXPECT_NEAR(strainValue(reading, 4, StrainDirection::thickening, StrainMoment::peak).value(), 40, 1e-9);
}

TEST(StrainConfidence, TurnsAreTakenByTheirSize) {
  EXPECT_EQ(largestTurn({0, -9, 8}), -9);
  EXPECT_FALSE(largestTurn({}));
}

} // namespace
} // namespace viscera::live
