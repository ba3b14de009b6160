#include "viscera/sequences/centerline.h"

#include <cmath>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

const std::vector<Vec3> kBends{{0, 0, 0}, {20, 5, 0}, {35, 30, 10}, {20, 60, 30}, {-10, 62, 34}};

std::vector<Vec3> circle(double radius, int points) {
  std::vector<Vec3> list;
  for (int k = 0; k < points; ++k) {
    const double angle = M_PI * k / (points - 1);
    list.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  return list;
}

TEST(Centerline, passesThroughItsPointsInOrder) {
  const Centerline line(kBends);
  double before = -1;
  for (const Vec3& point : kBends) {
    const double s = line.nearest(point);
    EXPECT_LT((line.at(s).center - point).norm(), 0.6);
    EXPECT_GT(s, before);
    before = s;
  }
}

TEST(Centerline, measuresArcLength) {
  EXPECT_NEAR(Centerline({{0, 0, 0}, {0, 0, 30}, {0, 0, 100}}).length(), 100, 1e-9);
  EXPECT_NEAR(Centerline(circle(40, 24)).length(), M_PI * 40, 0.1);
  const Centerline line(kBends);
  for (double s = 0; s + 5 < line.length(); s += 5)
    EXPECT_NEAR((line.at(s + 5).center - line.at(s).center).norm(), 5, 0.35);
}

TEST(Centerline, crossSectionsAreOrthonormalAndDoNotTurnAboutTheLine) {
  const Centerline line(kBends);
  for (double s = 0; s < line.length(); s += 0.7) {
    const CrossSection a = line.at(s);
    EXPECT_NEAR((a.u.cross(a.v) - a.tangent).norm(), 0, 1e-9);
    EXPECT_NEAR(a.across(M_PI / 2).dot(a.v), 1, 1e-12);
    const CrossSection b = line.at(s + 1);
    // What u changes lies along the tangent, up to second order.
    EXPECT_LT(std::abs((b.u - a.u).dot(a.v)), 0.02) << s;
  }
}

TEST(Centerline, staysWithinItsPointsWhereTheyAreUneven) {
  // Uniform Catmull-Rom would loop here.
  const Centerline line({{0, 0, 0}, {100, 0, 0}, {101, 1, 0}, {102, 40, 0}});
  for (double s = 1; s < line.length(); s += 1)
    EXPECT_GT((line.at(s).center - line.at(s - 1).center).dot(Vec3(1, 1, 0)), 0) << s;
}

TEST(Centerline, clampsToItsEnds) {
  const Centerline line(kBends);
  EXPECT_EQ(line.at(-5).center, line.at(0).center);
  EXPECT_EQ(line.at(1e6).center, line.at(line.length()).center);
}

TEST(Centerline, refusesPointsThatAreNoLine) {
  EXPECT_THROW(Centerline({{0, 0, 0}}), DataError);
  EXPECT_THROW(Centerline({{0, 0, 0}, {0, 0, 0}}), DataError);
  EXPECT_THROW(Centerline({{0, 0, 0}, {NAN, 0, 0}}), DataError);
}

} // namespace
} // namespace viscera::sequences
