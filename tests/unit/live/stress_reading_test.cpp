#include "viscera/live/stress_reading.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "viscera/live/stress_marks_reader.h"

namespace viscera::live {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

/// One tetrahedron at the origin with edges of 10 mm along the axes, whose corners carry different numbers.
class OneTetrahedron : public testing::Test {
protected:
  OneTetrahedron() {
    deformation::WitnessMesh mesh;
    mesh.points.resize(4, 3);
    mesh.points << 0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 10;
    mesh.tetrahedra.resize(1, 4);
    mesh.tetrahedra << 0, 1, 2, 3;
    mesh.witnesses = 1;
    mesh_ = std::make_shared<const deformation::WitnessMesh>(mesh);
    posed_ = 2 * mesh.points;
    map_.rotationalStress = Values::LinSpaced(4, 0.1, 0.4);
    map_.volumeRatio = Values::LinSpaced(4, 0.8, 1.1);
    map_.stretchMax = Values::LinSpaced(4, 1.1, 1.4);
    map_.stretchMin = Values::LinSpaced(4, 0.9, 0.6);
  }
  std::vector<StressReading> read(const std::vector<Vec3>& places, double reach = 0.5) const {
    Points rest(static_cast<Eigen::Index>(places.size()), 3);
    for (std::size_t i = 0; i < places.size(); ++i)
      rest.row(static_cast<Eigen::Index>(i)) = places[i].transpose();
    return TissuePoints(mesh_, rest, reach).read(posed_, map_);
  }

  std::shared_ptr<const deformation::WitnessMesh> mesh_;
  Points posed_;
  deformation::StressMap map_;
};

TEST_F(OneTetrahedron, IsReadLinearlyAndExactlyAtItsCorners) {
  const auto readings = read({{10, 0, 0}, {2.5, 2.5, 2.5}});
  EXPECT_EQ(readings[0].stressDegrees, kDegrees * map_.rotationalStress[1]);
  EXPECT_EQ(readings[0].volumeRatio, map_.volumeRatio[1]);
  EXPECT_EQ(readings[0].now, Vec3(20, 0, 0));
  EXPECT_NEAR(readings[1].stressDegrees, kDegrees * 0.25, 1e-12);
  EXPECT_NEAR(readings[1].stretchMax, 1.25, 1e-12);
  EXPECT_NEAR(readings[1].stretchMin, 0.75, 1e-12);
  EXPECT_LT((readings[1].now - Vec3::Constant(5)).norm(), 1e-12);
  EXPECT_EQ(readings[1].rest, Vec3::Constant(2.5));
  EXPECT_EQ(valueOf(readings[1], StressQuantity::volumeRatio), readings[1].volumeRatio);
  EXPECT_EQ(valueOf(readings[1], StressQuantity::folded), 0);
}

TEST_F(OneTetrahedron, ReadsItsNearestPlaceWithinReachAndNothingBeyond) {
  const auto readings = read({{-0.3, 2, 2}, {-0.6, 2, 2}});
  EXPECT_TRUE(readings[0].inTissue);
  EXPECT_LT((readings[0].now - Vec3(0, 4, 4)).norm(), 0.3);
  EXPECT_FALSE(readings[1].inTissue);
  for (const StressQuantityDescription& quantity : stressQuantities())
    EXPECT_TRUE(std::isnan(valueOf(readings[1], quantity.quantity))) << quantity.id;
}

TEST_F(OneTetrahedron, FoldedTissueHasNoNumberButSaysSo) {
  map_.volumeRatio[2] = -0.1;
  const auto readings = read({{2.5, 2.5, 2.5}, {10, 0, 0}, {0, 10, 0}});
  EXPECT_TRUE(readings[0].folded);
  EXPECT_TRUE(std::isnan(valueOf(readings[0], StressQuantity::rotationalStress)));
  EXPECT_EQ(valueOf(readings[0], StressQuantity::folded), 1);
  EXPECT_FALSE(readings[1].folded) << "a corner of its own";
  EXPECT_TRUE(readings[2].folded);
}

TEST_F(OneTetrahedron, AProfileHasItsDistancesAndGaps) {
  Points along = placesAlong({-2, 1, 1}, {14, 1, 1}, 17);
  EXPECT_EQ(Vec3(along.row(0).transpose()), Vec3(-2, 1, 1));
  EXPECT_EQ(Vec3(along.row(16).transpose()), Vec3(14, 1, 1));
  const StressProfile profile = profileOf(TissuePoints(mesh_, along, 1e-9).read(posed_, map_));
  for (int i = 0; i < 17; ++i) {
    const auto at = static_cast<std::size_t>(i);
    EXPECT_NEAR(profile.mm[at], i, 1e-12);
    EXPECT_EQ(profile.readings[at].inTissue, i >= 2 && i <= 10) << i;
  }
}

TEST_F(OneTetrahedron, MarksOfItsOrganAreReadAndThoseOfOthersAreNot) {
  document::StressMarks marks;
  marks.probes = {{{1}, 1, {7}, Vec3(0, 0, 0)}, {{2}, 2, {8}, Vec3(1, 1, 1)}, {{3}, 4, {7}, Vec3(10, 0, 0)}};
  marks.lines = {{{5}, {3}, {1}}};
  document::DocumentState state;
  state.stressMarks = std::make_shared<const document::StressMarks>(marks);
  StressMarksReader reader;
  const ReadMarks read = reader.read(state, {7}, mesh_, posed_, map_);
  ASSERT_EQ(read.probes.size(), 2U);
  EXPECT_EQ(read.probes[1].probe.number, 4);
  EXPECT_EQ(read.probes[1].reading.stressDegrees, kDegrees * map_.rotationalStress[1]);
  ASSERT_EQ(read.profiles.size(), 1U);
  EXPECT_EQ(read.profiles[0].name, "4-1");
  EXPECT_EQ(read.profiles[0].profile.mm.size(), static_cast<std::size_t>(kProfilePoints));
  EXPECT_NEAR(read.profiles[0].profile.mm.back(), 10, 1e-12);
  // Another pose is read without another place; marks that are gone are gone.
  posed_ *= 2;
  EXPECT_EQ(reader.read(state, {7}, mesh_, posed_, map_).probes[1].reading.now, Vec3(40, 0, 0));
  EXPECT_TRUE(reader.read(document::DocumentState(), {7}, mesh_, posed_, map_).probes.empty());
  EXPECT_TRUE(reader.read(state, {7}, nullptr, posed_, map_).probes.empty());
}

} // namespace
} // namespace viscera::live
