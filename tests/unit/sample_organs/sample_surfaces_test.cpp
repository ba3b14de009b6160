#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "closed_surface.h"
#include "library_for_tests.h"
#include "self_intersections.h"
#include "viscera/core/error.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/self_intersections.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::tests {
namespace {

using sample_organs::Resolution;

/// What one surface should be: volumes in ml with their share of tolerance, triangles low, medium and high.
struct Expected {
  double volumeMl;
  double tolerance;
  std::map<Resolution, int> triangles;
};

constexpr Resolution kLow = Resolution::low, kMedium = Resolution::medium, kHigh = Resolution::high;

const std::map<std::string, std::map<std::string, Expected>>& expectedOrgans() {
  static const std::map<std::string, std::map<std::string, Expected>> organs = {
      {"heart",
       {{"outer", {886, 0.02, {{kLow, 3000}, {kMedium, 30000}, {kHigh, 200000}}}},
        {"lv", {130.5, 0.015, {{kLow, 1000}, {kMedium, 6000}, {kHigh, 30000}}}},
        {"rv", {138, 0.03, {{kLow, 1000}, {kMedium, 8000}, {kHigh, 40000}}}},
        {"la", {59.9, 0.03, {{kLow, 800}, {kMedium, 4000}, {kHigh, 20000}}}},
        {"ra", {56.6, 0.03, {{kLow, 800}, {kMedium, 4000}, {kHigh, 20000}}}}}},
      {"stomach", {{"outer", {860, 0.015, {{kLow, 3000}, {kMedium, 30000}, {kHigh, 150000}}}}}},
      {"liver", {{"outer", {1613, 0.015, {{kLow, 3000}, {kMedium, 30000}, {kHigh, 130000}}}}}},
      {"kidney_left", {{"outer", {148.4, 0.03, {{kLow, 3000}, {kMedium, 30000}, {kHigh, 150000}}}}}},
      {"kidney_right", {{"outer", {142.6, 0.03, {{kLow, 3000}, {kMedium, 30000}, {kHigh, 150000}}}}}},
      {"stomach_and_bowel", {{"outer", {3604, 0.03, {{kLow, 10000}, {kMedium, 60000}, {kHigh, 350000}}}}}},
      {"digestive_system",
       {{"outer", {3604, 0.03, {{kLow, 10000}, {kMedium, 60000}, {kHigh, 350000}}}},
        {"liver", {1554, 0.015, {{kLow, 3000}, {kMedium, 30000}, {kHigh, 130000}}}},
        {"pancreas", {70.5, 0.03, {{kLow, 2000}, {kMedium, 12000}, {kHigh, 60000}}}},
        {"spleen", {181, 0.03, {{kLow, 1500}, {kMedium, 10000}, {kHigh, 50000}}}},
        {"omentum", {155, 0.05, {{kLow, 3000}, {kMedium, 16000}, {kHigh, 80000}}}}}}};
  return organs;
}

class SampleSurfaces : public testing::TestWithParam<std::tuple<std::string, Resolution>> {};

std::string nameOfCase(const testing::TestParamInfo<SampleSurfaces::ParamType>& info) {
  std::string organ = std::get<0>(info.param);
  organ.erase(std::remove(organ.begin(), organ.end(), '_'), organ.end());
  return organ + "_" + sample_organs::nameOf(std::get<1>(info.param));
}

void expectClosedOrgan(const sample_organs::SampleSurface& surface, const Expected& expected,
                       Resolution resolution) {
  const geometry::TriangleMesh& mesh = *surface.mesh;
  const geometry::SurfaceReport report = expectClosedSurface(mesh);
  const double wanted = expected.triangles.at(resolution);
  EXPECT_NEAR(static_cast<double>(mesh.triangles.rows()), wanted, 0.05 * wanted);
  // Large triangles cut corners: the low resolution loses up to 3 % more.
  const double tolerance = expected.tolerance + (resolution == kLow ? 0.03 : 0.0);
  EXPECT_NEAR(report.volumeMm3 / kMm3PerMl, expected.volumeMl, tolerance * expected.volumeMl);
}

} // namespace

TEST_P(SampleSurfaces, AreClosedManifoldOutwardOfTheRightSizeAndDoNotIntersectThemselves) {
  const auto& [name, resolution] = GetParam();
  Progress progress;
  const sample_organs::SampleOrgan organ =
      sample_organs::sampleOrgan(projectLibrary(), name, resolution, progress);
  const auto& expected = expectedOrgans().at(name);
  ASSERT_EQ(organ.surfaces.size(), expected.size());
  EXPECT_EQ(organ.surfaces.front().name, "outer");
  for (const sample_organs::SampleSurface& surface : organ.surfaces) {
    SCOPED_TRACE(surface.name);
    expectClosedOrgan(surface, expected.at(surface.name), resolution);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, SampleSurfaces,
                         testing::Combine(testing::Values("heart", "stomach", "liver", "kidney_left",
                                                          "kidney_right", "stomach_and_bowel",
                                                          "digestive_system"),
                                          testing::Values(kLow, kMedium, kHigh)),
                         nameOfCase);

TEST(SampleOrgans, AreAllChecked) {
  for (const std::string& name : sample_organs::sampleNames(projectLibrary()))
    EXPECT_EQ(expectedOrgans().count(name), 1U) << name << " has no expected values in this test";
}

TEST(SampleOrgans, HeartCavitiesLieInsideTheWallAndApart) {
  Progress progress;
  const sample_organs::SampleOrgan heart =
      sample_organs::sampleOrgan(projectLibrary(), "heart", kMedium, progress);
  for (std::size_t i = 0; i < heart.surfaces.size(); ++i)
    for (std::size_t j = i + 1; j < heart.surfaces.size(); ++j)
      EXPECT_FALSE(surfacesMeet(*heart.surfaces[i].mesh, *heart.surfaces[j].mesh))
          << heart.surfaces[i].name << ", " << heart.surfaces[j].name;
  const sample_organs::ImplicitSurface wall =
      sample_organs::implicitSurface(projectLibrary(), "heart", "surf outer");
  for (std::size_t i = 1; i < heart.surfaces.size(); ++i)
    EXPECT_LT(wall(heart.surfaces[i].mesh->points.row(0)), 0) << heart.surfaces[i].name;
}

TEST(SampleOrgans, OfTheDigestiveSystemLieBesideEachOther) {
  Progress progress;
  const sample_organs::SampleOrgan system =
      sample_organs::sampleOrgan(projectLibrary(), "digestive_system", kMedium, progress);
  const auto& [bowel, liver, pancreas] = std::tie(system.surfaces[0], system.surfaces[1], system.surfaces[2]);
  EXPECT_EQ(bowel.organ, "Stomach and bowel");
  EXPECT_EQ(liver.organ, "Liver");
  EXPECT_EQ(pancreas.organ, "Pancreas");
  EXPECT_FALSE(surfacesMeet(*bowel.mesh, *liver.mesh));
  EXPECT_FALSE(surfacesMeet(*bowel.mesh, *pancreas.mesh));
}

TEST(SampleOrgans, DoNotDependOnTheNumberOfThreads) {
  Progress progress;
  const auto with = [&](int threads) {
    return sample_organs::sampleOrgan(projectLibrary(), "stomach", kLow, progress, Threads{threads});
  };
  const auto one = with(1).surfaces.front().mesh;
  for (const int threads : {2, 5}) {
    const auto several = with(threads).surfaces.front().mesh;
    EXPECT_TRUE(several->points == one->points) << threads << " threads";
    EXPECT_TRUE(several->triangles == one->triangles) << threads << " threads";
    EXPECT_TRUE(several->colors == one->colors) << threads << " threads";
  }
}

TEST(SampleOrgans, HaveTheirCheckSurfacesOnlyByName) {
  Progress progress;
  const sample_organs::SampleSurface chambers =
      sample_organs::sampleSurface(projectLibrary(), "heart", "chambers", kLow, progress);
  const geometry::SurfaceReport report = geometry::checkSurface(*chambers.mesh);
  EXPECT_TRUE(report.outward());
  EXPECT_NEAR(report.volumeMm3 / kMm3PerMl, 655, 15);
}

TEST(SampleOrgans, LeftVentriclesMuscleWeighsAsMuchAsInHealthyAdults) {
  constexpr double kGramsPerMl = 1.05;
  Progress progress;
  const auto volumeMl = [&](const char* name) {
    const auto surface = sample_organs::sampleSurface(projectLibrary(), "heart", name, kLow, progress);
    return geometry::checkSurface(*surface.mesh).volumeMm3 / kMm3PerMl;
  };
  const double grams = kGramsPerMl * (volumeMl("lv_wall") - volumeMl("lv"));
  EXPECT_GT(grams, 105);
  EXPECT_LT(grams, 130);
}

/// 3 to 4 mm in healthy adults, less than any vessel of the kidney.
TEST(SampleOrgans, UretersAreFourMillimetresWide) {
  Progress progress;
  for (const char* name : {"kidney_left", "kidney_right"}) {
    const auto kidney = sample_organs::sampleSurface(projectLibrary(), name, "outer", kMedium, progress);
    double low = 1e9, high = -1e9;
    for (const auto& point : kidney.mesh->points.rowwise())
      if (point.z() > -76 && point.z() < -68) {
        low = std::min(low, point.x());
        high = std::max(high, point.x());
      }
    EXPECT_NEAR(high - low, 4, 0.8) << name;
  }
}

/// The lowest height, mm, that a surface reaches below the anterior margin of the liver's right lobe.
double lowestAtTheMargin(const sample_organs::ImplicitSurface& surface) {
  for (double z = -90; z < 0; z += 0.5)
    for (double x = -42; x <= -18; x += 2)
      for (double y = -72; y <= -40; y += 2)
        if (surface({x, y, z}) < 0)
          return z;
  return 0;
}

/// A fundus that hangs far below the margin is a hydrops.
TEST(SampleOrgans, TheGallbladderJustProjectsBelowTheMarginOfTheLiver) {
  const auto surfaceOf = [](const char* node) {
    return sample_organs::implicitSurface(projectLibrary(), "liver", node);
  };
  const double projects =
      lowestAtTheMargin(surfaceOf("parenchyma")) - lowestAtTheMargin(surfaceOf("gallbladder"));
  EXPECT_GT(projects, 4);
  EXPECT_LT(projects, 16);
}

/// The falciform ligament is thin, in front of the liver, and has the round one in its edge.
TEST(SampleOrgans, TheLiverHasItsLigamentsInFrontOfIt) {
  const auto surfaceOf = [](const char* node) {
    return sample_organs::implicitSurface(projectLibrary(), "liver", node);
  };
  const sample_organs::ImplicitSurface ligaments = surfaceOf("ligaments"), liver = surfaceOf("parenchyma");
  int inFront = 0;
  double thickest = 0;
  for (double z = -40; z <= 40; z += 4)
    for (double y = -80; y <= -55; y += 1) {
      double thickness = 0;
      for (double x = 0; x <= 30; x += 0.5)
        if (ligaments({x, y, z}) < 0 && liver({x, y, z}) > 0)
          thickness += 0.5;
      inFront += thickness > 0;
      if (z > -25) // The round ligament, a cord, leaves the liver below.
        thickest = std::max(thickest, thickness);
    }
  EXPECT_GT(inFront, 60);
  EXPECT_GT(thickest, 1);
  EXPECT_LT(thickest, 8);
  EXPECT_LT(ligaments({18, -74, -60}), 0) << "the cord goes on towards the navel";
}

TEST(SampleOrgans, ReportProgressUpToTheEnd) {
  double last = -1;
  bool backwards = false;
  Progress progress([&](double fraction, const Text&) {
    backwards = backwards || fraction < last - 0.05; // blocks of samples may end in another order
    last = fraction;
  });
  sample_organs::sampleOrgan(projectLibrary(), "kidney_left", kLow, progress);
  EXPECT_EQ(last, 1);
  EXPECT_FALSE(backwards);
}

TEST(SampleOrgans, CanBeCancelledWhileTheyAreMade) {
  Progress* job = nullptr;
  Progress progress([&](double fraction, const Text&) {
    if (fraction > 0.2)
      job->cancel();
  });
  job = &progress;
  EXPECT_THROW(sample_organs::sampleOrgan(projectLibrary(), "kidney_left", kLow, progress), Cancelled);
}

} // namespace viscera::tests
