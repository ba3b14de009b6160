#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "held_value.h"
#include "shapes.h"
#include "thick_cylinder.h"
#include "viscera/core/error.h"
#include "viscera/geometry/close_holes.h"
#include "viscera/strain/aha_segments.h"
#include "viscera/strain/heart_axes.h"
#include "viscera/strain/valve_caps.h"

namespace viscera::strain {
namespace {

using geometry::TriangleMesh;

/// A right ventricle that lies on the side of -x of a left one, from -60 to +60 degrees about it.
TriangleMesh rightVentricle() {
  TriangleMesh mesh = tests::ventricle(1, 70);
  for (Eigen::Index row = 0; row < mesh.points.rows(); ++row) {
    // The disc becomes a crescent: x is its depth, y its angle.
    const double angle = mesh.points(row, 1) * std::numbers::pi / 3;
    const double radius = 34 + 8 * (1 - std::abs(mesh.points(row, 1))) * mesh.points(row, 0);
    mesh.points.row(row) << -radius * std::cos(angle), radius * std::sin(angle), mesh.points(row, 2);
  }
  return mesh;
}

void turn(TriangleMesh& mesh, const Eigen::Matrix3d& rotation, const Vec3& shift) {
  mesh.points = ((mesh.points * rotation.transpose()).rowwise() + shift.transpose()).eval();
}

TEST(HeartAxes, AreFoundFromTheFanThatClosesTheValve) {
  const FoundAxes found = findAxes(tests::ventricle(20, 80), nullptr);
  EXPECT_LT(found.axes.base().norm(), 1e-9);
  EXPECT_LT((found.axes.apex() - Vec3(0, 0, 80)).norm(), 1e-9);
  EXPECT_FALSE(found.oriented);
  EXPECT_EQ(std::count(found.cap.begin(), found.cap.end(), true), 48);
}

/// As label maps are contoured: flat at the base, but without a fan.
TEST(HeartAxes, AreFoundFromTheFlatEndOfASurfaceWithoutAFan) {
  TriangleMesh mesh = tests::ventricle(20, 80);
  mesh.points.row(48 * 40) << 1.5, -1, 0; // No longer the mean of its rim.
  const Eigen::Matrix3d rotation = Eigen::AngleAxisd(2.1, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  turn(mesh, rotation, Vec3(10, 20, 30));
  const FoundAxes found = findAxes(mesh, nullptr);
  EXPECT_LT((found.axes.base() - Vec3(10, 20, 30)).norm(), 0.6);
  EXPECT_LT((found.axes.apex() - (rotation * Vec3(0, 0, 80) + Vec3(10, 20, 30))).norm(), 1e-9);
}

TEST(HeartAxes, CountFromTheAnteriorInsertionOfTheRightVentricleHoweverTheHeartLies) {
  tests::HeldValue held("the septum's segments on the right ventricle's side, and no others", 0, "wrong");
  for (const double angle : {0.0, 0.9, 2.4}) {
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(angle, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    TriangleMesh left = tests::ventricle(20, 80), right = rightVentricle();
    turn(left, rotation, Vec3(5, 6, 7));
    turn(right, rotation, Vec3(5, 6, 7));
    const FoundAxes found = findAxes(left, &right);
    EXPECT_TRUE(found.oriented);
    // 120 degrees at the base, less towards the apex.
    EXPECT_GT(found.septumDegrees, 90);
    EXPECT_LT(found.septumDegrees, 120);
    const Vec3 septum = rotation * Vec3(-30, 0, 0), side = rotation * Vec3(0, 0, 25) + Vec3(5, 6, 7);
    EXPECT_NEAR(found.axes.angleOf(side + septum), 0.5 * found.septumDegrees * std::numbers::pi / 180, 0.02);
    for (const Segment& segment : segments())
      if (segment.ring < 2) {
        // The segments between both ventricles, and only those, are on the right one's side.
        const double middle =
            (0.5 * (segment.fromDegrees + segment.toDegrees) - 120) * std::numbers::pi / 180;
        const double away = found.axes.across(middle).dot(septum.normalized());
        held.add((away > 0.7) == segment.septal ? 0 : 1);
      }
  }
}

TEST(HeartAxes, TakeWhatIsClicked) {
  AxisLandmarks given;
  given.base = Vec3(0, 0, 2);
  given.apex = Vec3(1, 0, 79);
  given.insertion = Vec3(-10, -20, 30);
  const FoundAxes found = findAxes(tests::ventricle(20, 80), nullptr, given);
  EXPECT_TRUE(found.oriented);
  EXPECT_EQ(found.axes.base(), *given.base);
  EXPECT_EQ(found.axes.apex(), *given.apex);
  EXPECT_NEAR(found.axes.angleOf(*given.insertion), 0, 1e-9);
}

TEST(HeartAxes, RefuseWhatHasNone) {
  EXPECT_THROW(HeartAxes(Vec3::Zero(), Vec3::Zero(), Vec3::UnitX()), DataError);
  EXPECT_THROW(HeartAxes(Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitZ()), DataError);
  EXPECT_THROW(findAxes(TriangleMesh(), nullptr), DataError);
}

TEST(ValveCaps, AreAllFansAndTheLargestIsTheMitralOne) {
  const ValveCaps caps = valveCaps(tests::closedTube(20, 0, 90, 32, 20));
  EXPECT_EQ(caps.caps, 2);
  EXPECT_EQ(std::count(caps.triangles.begin(), caps.triangles.end(), true), 64);
}

/// A reader puts the middle of a cap at the mean of the rim's edges, so that an uneven rim does not pull it.
TEST(ValveCaps, AreThoseThatAReaderHasClosed) {
  TriangleMesh open = tests::ventricle(20, 80);
  for (Eigen::Index row = 0; row < open.points.rows(); ++row) {
    const double x = open.points(row, 0), y = open.points(row, 1);
    const double turn = 0.6 * std::sin(std::atan2(y, x)); // Vertices crowd on one side.
    open.points.row(row) << x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn),
        open.points(row, 2);
  }
  constexpr std::int32_t kMiddle = 48 * 40;
  std::vector<Eigen::RowVector3i> wall;
  for (Eigen::Index t = 0; t < open.triangles.rows(); ++t)
    if ((open.triangles.row(t).array() != kMiddle).all())
      wall.emplace_back(open.triangles.row(t));
  open.triangles.resize(static_cast<Eigen::Index>(wall.size()), 3);
  for (std::size_t t = 0; t < wall.size(); ++t)
    open.triangles.row(static_cast<Eigen::Index>(t)) = wall[t];
  const TriangleMesh closed = geometry::closeHoles(open).mesh;
  const ValveCaps caps = valveCaps(closed);
  EXPECT_EQ(caps.caps, 1);
  EXPECT_EQ(std::count(caps.triangles.begin(), caps.triangles.end(), true), 48);
  const FoundAxes found = findAxes(closed, nullptr);
  EXPECT_LT((found.axes.apex() - Vec3(0, 0, 80)).norm(), 1e-9);
}

TEST(ValveCaps, OfASphereIsSomethingSmall) {
  const ValveCaps caps = valveCaps(tests::sphere(4, 30));
  const auto marked = std::count(caps.triangles.begin(), caps.triangles.end(), true);
  EXPECT_LT(marked, 0.2 * static_cast<double>(caps.triangles.size()));
}

} // namespace
} // namespace viscera::strain
