#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "library_for_tests.h"
#include "viscera/core/error.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/volume.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::tests {
namespace {

using sample_organs::ImplicitSurface;
using sample_organs::Resolution;

ImplicitSurface surfaceOf(const std::string& root, const std::string& nodes = "") {
  TemporaryLibrary files;
  files.writeRoot("thing", root, nodes);
  return sample_organs::implicitSurface(files.library(), "thing", "surf outer");
}

double volumeOf(const std::string& root) {
  TemporaryLibrary files;
  files.writeRoot("thing", root);
  Progress progress;
  const auto mesh =
      sample_organs::sampleOrgan(files.library(), "thing", Resolution::high, progress).surfaces[0].mesh;
  return geometry::volume(mesh->points, mesh->triangles);
}

} // namespace

TEST(ImplicitSurfaces, OfTheHeartAreFoundByTheNamesOfTheirNodes) {
  const sample_organs::SampleLibrary library = projectLibrary();
  const Vec3 insideLv = {10, 7, 2}, insideRa = {-52, 12, 14}, insideLa = {-14, 47, 28};
  EXPECT_LT(sample_organs::implicitSurface(library, "heart", "ventricles")(insideLv), 0);
  EXPECT_LT(sample_organs::implicitSurface(library, "heart", "RA")(insideRa), 0);
  EXPECT_LT(sample_organs::implicitSurface(library, "heart", "LA")(insideLa), 0);
  EXPECT_GT(sample_organs::implicitSurface(library, "heart", "LA")(insideRa), 0);
  EXPECT_GT(sample_organs::implicitSurface(library, "heart", "surf rv")(insideLv), 0);
}

TEST(ImplicitSurfaces, OfAnUnknownNameNameThoseThereAre) {
  try {
    sample_organs::implicitSurface(projectLibrary(), "heart", "spleen");
    FAIL() << "no error";
  } catch (const UsageError& error) {
    EXPECT_NE(error.tryThis().english().find("\"ventricles\""), std::string::npos) << error.what();
  }
}

TEST(ImplicitSurfaces, OfAStraightTubeAreExactDistances) {
  const ImplicitSurface tube = surfaceOf(R"({"type": "tube", "points": [[0, 0, 0, 5], [0, 0, 30, 5]]})");
  EXPECT_NEAR(tube({9, 0, 15}), 4, 1e-9);
  EXPECT_NEAR(tube({0, 2, 15}), -3, 1e-9);
  EXPECT_NEAR(tube({0, 0, 38}), 3, 1e-9);
  EXPECT_NEAR(tube({3, 0, -4}), 0, 1e-9);
}

TEST(ImplicitSurfaces, OfAConeTouchItsSideSquarely) {
  // A cone of slope g: the distance from a point on the normal through (r(s), s) is along that normal.
  const ImplicitSurface tube = surfaceOf(R"({"type": "tube", "points": [[0, 0, 0, 5], [0, 0, 40, 15]]})");
  const double g = 0.25, sine = g, cosine = std::sqrt(1 - g * g);
  const double s = 20, radius = 10;
  const Vec3 onSide = Vec3(0, 0, s) + radius * Vec3(cosine, 0, -sine);
  EXPECT_NEAR(tube(onSide), 0, 1e-9);
  EXPECT_NEAR(tube(onSide + 4 * Vec3(cosine, 0, -sine)), 4, 1e-9);
}

TEST(ImplicitSurfaces, OfALongBentTubeAgreeWithATrialOfAllItsBalls) {
  std::string points, comma;
  for (int i = 0; i <= 40; ++i) {
    const double angle = 0.5 * i;
    points += comma + "[" + std::to_string(40 * std::cos(angle)) + "," +
              std::to_string(40 * std::sin(angle)) + "," + std::to_string(6.0 * i) + "," +
              std::to_string(6 + 2 * std::sin(angle)) + "]";
    comma = ",";
  }
  const ImplicitSurface whole = surfaceOf(R"({"type": "tube", "points": [)" + points + "]}");
  // Balls along the helix, slightly beside the spline: the tree must not miss the nearest turn.
  for (int i = 2; i < 39; ++i)
    for (const double away : {10.0, 16.0}) {
      const double angle = 0.5 * i;
      const Vec3 out(std::cos(angle), std::sin(angle), 0);
      const double radius = 6 + 2 * std::sin(angle);
      EXPECT_NEAR(whole((40 + away) * out + Vec3(0, 0, 6.0 * i)), away - radius, 0.35) << i;
    }
}

TEST(ImplicitSurfaces, CombineAsTheyAreNamed) {
  const std::string a = R"({"type": "ellipsoid", "center": [0, 0, 0], "radii": [10, 10, 10]})";
  const std::string b = R"({"type": "ellipsoid", "center": [12, 0, 0], "radii": [10, 10, 10]})";
  const std::string both = "[" + a + ", " + b + "]}";
  const Vec3 onlyA = {-5, 0, 0}, shared = {6, 0, 0}, onlyB = {17, 0, 0};
  const ImplicitSurface united = surfaceOf(R"({"type": "union", "children": )" + both);
  const ImplicitSurface common = surfaceOf(R"({"type": "intersect", "children": )" + both);
  const ImplicitSurface rest =
      surfaceOf(R"({"type": "subtract", "from": )" + a + R"(, "children": [)" + b + "]}");
  for (const Vec3& point : {onlyA, shared, onlyB})
    EXPECT_LT(united(point), 0);
  EXPECT_LT(common(shared), 0);
  EXPECT_GT(common(onlyA), 0);
  EXPECT_GT(common(onlyB), 0);
  EXPECT_LT(rest(onlyA), 0);
  EXPECT_GT(rest(shared), 0);
}

TEST(ImplicitSurfaces, BlendOverTheirWidthOnly) {
  const std::string children = R"("children": [
      {"type": "ellipsoid", "center": [0, 0, 0], "radii": [10, 10, 10]},
      {"type": "ellipsoid", "center": [12, 0, 0], "radii": [10, 10, 10]}]})";
  const ImplicitSurface sharp = surfaceOf(R"({"type": "union", )" + children);
  const ImplicitSurface soft = surfaceOf(R"({"type": "union", "k": 4, )" + children);
  const Vec3 seam = {6, 8, 0}, pole = {-10, 0, 0};
  EXPECT_NEAR(sharp(seam) - soft(seam), 1, 1e-9); // a quarter of the width
  EXPECT_EQ(sharp(pole), soft(pole));
}

TEST(ImplicitSurfaces, InAFrameAreTurnedMirroredScaledAndMoved) {
  const ImplicitSurface placed =
      surfaceOf(R"({"type": "frame", "origin": [100, 0, 0], "rotate_deg": [0, 0, 90],
      "mirror": [-1, 1, 1], "scale": 2, "child":
      {"type": "ellipsoid", "center": [10, 0, 0], "radii": [3, 3, 3]}})");
  EXPECT_NEAR(placed({100, -20, 0}), -6, 1e-9);
  EXPECT_NEAR(placed({100, -20, 10}), 4, 1e-9);
}

TEST(ImplicitSurfaces, CarryVesselsThatSinkWhereTheyEnd) {
  const std::string stem = R"({"type": "surface_vessels", "base": )" + std::string(kBall) +
                           R"(, "paths": [{"r0": 2, "r1": 2, "lift": 0.5, )";
  const std::string points = R"("points": [[21, 2, 3], [15, 16, 3], [1, 22, 3]]}]})";
  const ImplicitSurface plain = surfaceOf(stem + points);
  const ImplicitSurface fading = surfaceOf(stem + R"("fade": [0, 12], )" + points);
  const Vec3 center = {1, 2, 3}, start = {1, 0, 0}, end = {0, 1, 0};
  EXPECT_LT(plain(center + 22.5 * start), 0);
  EXPECT_LT(plain(center + 22.5 * end), 0);
  EXPECT_LT(fading(center + 22.5 * start), 0);
  EXPECT_GT(fading(center + 20.2 * end), 0);
}

TEST(ImplicitSurfaces, BecomeMeshesOfTheirVolume) {
  const double ball = 4.0 / 3 * std::numbers::pi * 20 * 20 * 20;
  EXPECT_NEAR(volumeOf(kBall), ball, 0.01 * ball);
  const double cylinder = std::numbers::pi * 10 * 10 * 40;
  EXPECT_NEAR(
      volumeOf(R"({"type": "tube", "caps": ["flat", "flat"], "points": [[0, 0, 0, 10], [0, 0, 40, 10]]})"),
      cylinder, 0.015 * cylinder);
}

TEST(ImplicitSurfaces, KeepOnlyTheLargestOfSeparatePieces) {
  const double ball = 4.0 / 3 * std::numbers::pi * 20 * 20 * 20;
  EXPECT_NEAR(volumeOf(R"({"type": "union", "children": [)" + std::string(kBall) +
                       R"(, {"type": "ellipsoid", "center": [60, 0, 0], "radii": [8, 8, 8]}]})"),
              ball, 0.01 * ball);
}

} // namespace viscera::tests
