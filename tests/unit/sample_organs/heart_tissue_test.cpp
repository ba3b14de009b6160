#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "closed_surface.h"
#include "library_for_tests.h"
#include "self_intersections.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/self_intersections.h"
#include "viscera/geometry/signed_distance.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/winding_number.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::tests {
namespace {

using geometry::TriangleMesh;
using sample_organs::Resolution;
using Mesh = std::shared_ptr<const TriangleMesh>;

Mesh cachedSurface(const std::string& name, Resolution resolution = Resolution::medium,
                   Threads threads = {}) {
  Progress progress;
  return sample_organs::sampleSurface(projectLibrary(), "heart", name, resolution, progress, threads).mesh;
}

const TriangleMesh& tissue() {
  static const Mesh mesh = cachedSurface("tissue");
  return *mesh;
}

bool inTissue(const Vec3& point) {
  static const geometry::WindingNumber winding(tissue());
  return winding.inside(point);
}

const Vec3 kMitralPlane(-8, 22, 18);
const Vec3 kToSeptum = Vec3(-0.62, -0.78, 0.05).normalized();
const Vec3 kToApex = Vec3(0.64, -0.55, -0.54).normalized();
const Vec3 kDown = kToApex.cross(kToSeptum).normalized();

/// A point in the left ventricle's frame.
Vec3 inVentricle(double a, double b, double c) {
  return kMitralPlane + a * kToSeptum + b * kDown + c * kToApex;
}

/// How far one can go from a point before tissue begins, mm.
double freeWay(const Vec3& from, const Vec3& direction) {
  constexpr double kStep = 0.1, kFar = 60;
  double way = 0;
  while (way < kFar && !inTissue(from + way * direction))
    way += kStep;
  return way;
}

/// The mean diameter of the lumen around a point across a direction, mm.
double diameterAt(const Vec3& middle, const Vec3& along) {
  const Vec3 first = along.unitOrthogonal(), second = along.normalized().cross(first);
  constexpr int kRays = 16;
  double sum = 0;
  for (int i = 0; i < kRays; ++i) {
    const double angle = 2 * std::numbers::pi * i / kRays;
    sum += freeWay(middle, std::cos(angle) * first + std::sin(angle) * second);
  }
  return 2 * sum / kRays;
}

/// The least mean diameter across a direction near a point, mm.
double narrowestNear(const Vec3& middle, const Vec3& along) {
  double least = 1e9;
  for (double shift = -5; shift <= 5; shift += 1)
    least = std::min(least, diameterAt(middle + shift * along, along));
  return least;
}

class HeartTissue : public testing::TestWithParam<Resolution> {};

TEST_P(HeartTissue, IsOneClosedManifoldSurfaceThatDoesNotMeetItself) {
  const Mesh mesh = cachedSurface("tissue", GetParam());
  EXPECT_TRUE(expectClosedSurface(*mesh).outward());
}

INSTANTIATE_TEST_SUITE_P(At, HeartTissue,
                         testing::Values(Resolution::low, Resolution::medium, Resolution::high),
                         [](const auto& instance) { return sample_organs::nameOf(instance.param); });

TEST(HeartTissueSurface, DoesNotDependOnTheNumberOfThreads) {
  const Mesh one = cachedSurface("tissue", Resolution::low, Threads{1});
  const Mesh three = cachedSurface("tissue", Resolution::low, Threads{3});
  EXPECT_TRUE(one->points == three->points);
  EXPECT_TRUE(one->triangles == three->triangles);
  EXPECT_TRUE(one->colors == three->colors);
}

/// Each of the twelve ends is open, and the only handles are the heart's own two and the moderator band.
TEST(HeartTissueSurface, IsOpenAtTheTwelveEndsOfTheVesselsAndNowhereElse) {
  const auto euler = [](const TriangleMesh& mesh) { return mesh.points.rows() - mesh.triangles.rows() / 2; };
  const auto outer = euler(*cachedSurface("outer"));
  const auto left = euler(*cachedSurface("blood_left")), right = euler(*cachedSurface("blood_right"));
  EXPECT_EQ(left, 2) << "a wall inside the left heart has a hole";
  EXPECT_EQ(right, 0) << "the moderator band is the one bridge in the right heart";
  EXPECT_EQ(euler(tissue()), outer + left + right - 2 * 12);
}

TEST(HeartTissueSurface, HasTheBloodOfBothSidesApart) {
  EXPECT_FALSE(surfacesMeet(*cachedSurface("blood_left"), *cachedSurface("blood_right")));
}

/// The outside is the outer surface itself but for the ends of the vessels.
TEST(HeartTissueSurface, HasTheOuterSurfaceOutside) {
  std::set<std::array<double, 3>> points;
  for (const auto& p : tissue().points.rowwise())
    points.insert({p.x(), p.y(), p.z()});
  const Mesh outer = cachedSurface("outer");
  Eigen::Index kept = 0;
  for (const auto& p : outer->points.rowwise())
    kept += points.count({p.x(), p.y(), p.z()}) > 0;
  EXPECT_GT(static_cast<double>(kept), 0.8 * static_cast<double>(outer->points.rows()));
}

/// Away from valves and papillary muscles, in the right atrium from the crest, the wall inside is where
/// the cavities are that volumes come from.
TEST(HeartTissueSurface, FollowsTheCavitiesInside) {
  static const Mesh mesh = cachedSurface("tissue");
  const geometry::SignedDistance distance(mesh);
  for (const char* name : {"lv", "rv", "la", "ra"}) {
    const Mesh cavity = cachedSurface(name);
    Eigen::Index near = 0;
    for (const auto& p : cavity->points.rowwise())
      near += std::abs(distance(p.transpose())) < 0.6;
    const double share = std::string(name) == "ra" ? 0.55 : 0.6;
    EXPECT_GT(static_cast<double>(near), share * static_cast<double>(cavity->points.rows())) << name;
  }
}

/// Basal, middle and apical ring of 6, 6 and 4 segments; where the right ventricle begins, fat and vessels of
/// the groove count with the wall.
TEST(HeartTissueSurface, HasALeftVentricularWallOfHealthyThicknessInSixteenSegments) {
  struct Ring {
    double height;
    int segments;
    double first; ///< Where the first segment's middle is, in segments from the septum's.
  };
  const sample_organs::ImplicitSurface cavity =
      sample_organs::implicitSurface(projectLibrary(), "heart", "surf lv");
  for (const auto& [height, segments, first] : {Ring{18, 6, 0.5}, Ring{42, 6, 0.5}, Ring{68, 4, 0}})
    for (int s = 0; s < segments; ++s) {
      const double angle = 2 * std::numbers::pi * (s + first) / segments;
      const Vec3 out = std::cos(angle) * kToSeptum + std::sin(angle) * kDown;
      Vec3 at = inVentricle(0, 0, height);
      while (cavity(at) < 0.3)
        at += 0.1 * out;
      const Vec3 inside = at;
      while (inTissue(at))
        at += 0.1 * out;
      const double thickness = (at - inside).norm() + 0.3;
      EXPECT_GT(thickness, 6.5) << height << " mm, segment " << s;
      EXPECT_LT(thickness, 15) << height << " mm, segment " << s;
    }
}

TEST(HeartTissueSurface, HasAThinApex) {
  const double start = 80 + freeWay(inVentricle(0, 0, 80), kToApex);
  Vec3 at = inVentricle(0, 0, start + 0.2);
  while (inTissue(at))
    at += 0.1 * kToApex;
  EXPECT_NEAR((at - inVentricle(0, 0, start)).norm(), 2.5, 1.2);
}

/// At its narrowest about as wide as the ring in which the valve is drawn.
TEST(HeartTissueSurface, IsOpenThroughTheRingsOfTheValves) {
  struct Opening {
    const char* name;
    Vec3 middle, along;
    double diameter, tolerance;
  };
  const auto direction = [](double a, double b, double c) -> Vec3 {
    return a * kToSeptum + b * kDown + c * kToApex;
  };
  const Opening openings[] = {{"mitral", inVentricle(-5.2, 7, -1), kToApex, 26, 4},
                              {"aortic", inVentricle(7.5, -10, -5), direction(0.28, -0.38, -0.88), 22, 4},
                              {"tricuspid", inVentricle(40.6, 14.2, 3), direction(0.26, 0.09, 0.96), 28, 5},
                              {"pulmonary", inVentricle(28, -37, 18), direction(-0.36, -0.81, -0.46), 24, 3}};
  for (const auto& [name, middle, along, diameter, tolerance] : openings)
    EXPECT_NEAR(narrowestNear(middle, along.normalized()), diameter, tolerance) << name;
}

TEST(HeartTissueSurface, HasVesselsAsWideAsInHealthyAdults) {
  struct Place {
    const char* name;
    Vec3 middle, along;
    double low, high;
  };
  const Place places[] = {{"ascending aorta", {-22, 4, 58}, {-11, -3, 32}, 24, 32},
                          {"aortic arch", {-10, 27, 105}, {27, 29, 10}, 21, 28},
                          {"descending aorta", {15, 57, 72}, {0, 0, 1}, 18, 25},
                          {"pulmonary trunk", {12, -6, 61}, {9, 27, 21}, 22, 30},
                          {"left pulmonary artery", {34, 30, 73}, {22, 21, -5}, 16, 24},
                          {"right pulmonary artery", {-44, 40, 64}, {-46, 5, -8}, 15, 24},
                          {"superior vena cava", {-48, 16, 76}, {0, 0, 1}, 16, 22},
                          {"inferior vena cava", {-47, 19, -26}, {0, 0, 1}, 18, 27},
                          {"pulmonary vein", {14, 60, 45}, {32, 14, 9}, 12, 18}};
  for (const auto& [name, middle, along, low, high] : places) {
    const double diameter = diameterAt(middle, along.normalized());
    EXPECT_GT(diameter, low) << name;
    EXPECT_LT(diameter, high) << name;
  }
}

/// A ridge of the inner surface, beside the smooth cavity that volumes come from.
TEST(HeartTissueSurface, HasACrestInTheRightAtrium) {
  const auto blood = sample_organs::implicitSurface(projectLibrary(), "heart", "right_blood");
  const auto cavity = sample_organs::implicitSurface(projectLibrary(), "heart", "ra_cavity");
  const auto places = sample_organs::namedPlaces(projectLibrary(), "heart", "ra");
  ASSERT_FALSE(places.empty());
  EXPECT_EQ(places[0].name, "Terminal crest");
  EXPECT_NEAR(cavity(places[0].at), 0, 1);
  EXPECT_GT(blood(places[0].at), 1.5) << "muscle where the cavity ends";
}

using Path = std::vector<Vec3>;

void expectBloodAlong(const std::string& name, const Path& path) {
  static const geometry::WindingNumber outer(*cachedSurface("outer"));
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    for (double t = 0; t <= 1; t += 0.02) {
      const Vec3 at = path[i] + t * (path[i + 1] - path[i]);
      ASSERT_FALSE(inTissue(at)) << name << " is stopped at " << at.transpose();
      ASSERT_TRUE(outer.inside(at)) << name << " leaves the heart at " << at.transpose();
    }
}

/// From each vein through the valves to each artery without touching a wall.
TEST(HeartTissueSurface, LetsBloodThroughFromEveryVeinToEveryArtery) {
  const Vec3 leftAtrium(-14, 47, 28), rightAtrium(-50, 12, 16);
  const Path veins[] = {{{22, 63, 47}, {14, 60, 45}, {-2, 52, 40}, leftAtrium},
                        {{22, 67.5, 16.5}, {14, 64, 18}, {-2, 54, 22}, leftAtrium},
                        {{-54, 61.5, 45}, {-48, 59, 44}, {-34, 52, 40}, leftAtrium},
                        {{-54, 65, 14.5}, {-48, 62, 16}, {-34, 54, 20}, leftAtrium}};
  for (const Path& vein : veins)
    expectBloodAlong("pulmonary vein", vein);
  const Vec3 left = inVentricle(0, 0, 22), bulb(-15, 8, 43);
  expectBloodAlong("left heart", {leftAtrium,
                                  inVentricle(-8, 6, -6),
                                  inVentricle(-5.2, 7, 1),
                                  left,
                                  inVentricle(9, -12, 6),
                                  inVentricle(7.5, -10, -4),
                                  bulb,
                                  {-22, 4, 58}});
  const Path arch = {{-22, 4, 58}, {-26, 5, 75}, {-22, 13, 93}, {-10, 27, 105}, {5, 42, 103}, {14, 53, 88}};
  expectBloodAlong("aortic arch", arch);
  expectBloodAlong("descending aorta", {{14, 53, 88}, {15, 57, 72}, {15, 58, 69.5}});
  expectBloodAlong("brachiocephalic trunk",
                   {{-22, 13, 93}, {-20, 16, 100}, {-25, 14, 114}, {-28, 12.5, 122}});
  expectBloodAlong("left carotid artery", {{-10, 27, 105}, {-9, 27, 109}, {-8, 25, 120}, {-7.4, 23, 126}});
  expectBloodAlong("left subclavian artery", {{5, 42, 103}, {3, 38, 108}, {7, 38, 119}, {10, 37, 124}});
  expectBloodAlong("superior vena cava", {{-48, 16.8, 85}, {-48, 16, 76}, {-49, 15, 56}, rightAtrium});
  expectBloodAlong("inferior vena cava", {{-46.2, 20.6, -36}, {-47, 19, -26}, {-49, 15, -8}, rightAtrium});
  const Vec3 trunk(7, -19, 48);
  expectBloodAlong("right heart", {rightAtrium,
                                   inVentricle(38, 17, -9),
                                   inVentricle(40.6, 14.2, 0),
                                   inVentricle(44, 8, 16),
                                   inVentricle(40, -14, 26),
                                   inVentricle(33, -26, 24),
                                   inVentricle(28, -37, 18),
                                   trunk,
                                   {12, -6, 61},
                                   {15, 5, 67}});
  expectBloodAlong("left pulmonary artery", {{15, 5, 67}, {24, 19, 73}, {34, 30, 73}, {39, 34.5, 71}});
  expectBloodAlong("right pulmonary artery",
                   {{15, 5, 67}, {4, 26, 69}, {-18, 36, 68}, {-44, 40, 64}, {-55, 40.5, 62}});
}

/// Endocardium and intima have colours of their own, without the fat and the vessels of the outside.
TEST(HeartTissueSurface, HasNothingOfTheOutsidesPaintInside) {
  const Eigen::RowVector3d fat = 255 * Eigen::RowVector3d(0.90, 0.76, 0.46);
  const Eigen::RowVector3d artery = 255 * Eigen::RowVector3d(0.80, 0.12, 0.09);
  const Eigen::RowVector3d vein = 255 * Eigen::RowVector3d(0.27, 0.33, 0.60);
  const sample_organs::ImplicitSurface outer =
      sample_organs::implicitSurface(projectLibrary(), "heart", "surf outer", Resolution::medium);
  const auto blood = [](const char* side) {
    return sample_organs::implicitSurface(projectLibrary(), "heart", side, Resolution::medium);
  };
  const sample_organs::ImplicitSurface left = blood("left_blood"), right = blood("right_blood");
  Eigen::Index inside = 0;
  for (Eigen::Index v = 0; v < tissue().points.rows(); ++v) {
    const Vec3 at = tissue().points.row(v);
    if (outer(at) > -0.8 || std::min(std::abs(left(at)), std::abs(right(at))) > 0.05)
      continue;
    ++inside;
    const Eigen::RowVector3d color = tissue().colors.row(v).cast<double>();
    for (const auto& paint : {fat, artery, vein})
      ASSERT_GT((color - paint).norm(), 35) << tissue().points.row(v);
  }
  EXPECT_GT(inside, 7000);
}

} // namespace
} // namespace viscera::tests
