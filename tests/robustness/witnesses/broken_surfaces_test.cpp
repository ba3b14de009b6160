#include <gtest/gtest.h>

#include "broken_surfaces.h"
#include "viscera/core/error.h"
#include "viscera/geometry/volume.h"
#include "viscera/live/witness_sampling.h"

namespace viscera::live {
namespace {

constexpr double kBall = 4.0 / 3 * M_PI * 27'000;

/// A broken surface and what has to come of it.
struct Case {
  std::string name;
  std::function<geometry::TriangleMesh()> make;
  WitnessOrigin worst = WitnessOrigin::surface;
  double volume = 0; ///< Of the filling, mm^3; 0: any.
  double tolerance = 0.03;
  std::string says = {}; ///< What a remark has to mention.
  friend std::ostream& operator<<(std::ostream& out, const Case& broken) { return out << broken.name; }
};

class BrokenSurfaces : public testing::TestWithParam<Case> {};

TEST_P(BrokenSurfaces, GiveAMapAndTheUserIsTold) {
  WitnessOptions options;
  options.wanted = 1500;
  Progress progress;
  const WitnessSample sample = sampleWitnesses(GetParam().make(), options, progress);
  EXPECT_LE(sample.origin, GetParam().worst);
  deformation::requireUsable(*sample.mesh, GetParam().name);
  EXPECT_GT(sample.mesh->tetrahedra.rows(), 100);
  EXPECT_NEAR(static_cast<double>(sample.mesh->witnesses), 1500, kWitnessCountTolerance * 1500);
  const double volume = deformation::tetrahedronVolumes(sample.mesh->points, sample.mesh->tetrahedra).sum();
  if (GetParam().volume > 0) {
    EXPECT_NEAR(volume, GetParam().volume, GetParam().tolerance * GetParam().volume);
  }
  std::string remarks;
  for (const Text& remark : sample.remarks)
    remarks += remark.english() + "\n";
  EXPECT_NE(remarks.find(GetParam().says), std::string::npos) << remarks;
}

using tests::insideOut;
using tests::joined;
using tests::sphere;
constexpr auto kRepaired = WitnessOrigin::repairedSurface;

INSTANTIATE_TEST_SUITE_P(
    , BrokenSurfaces,
    testing::Values(Case{"holes", tests::withHoles, kRepaired, kBall, 0.04, "open"},
                    Case{"self_intersections", tests::selfIntersecting, kRepaired, 0, 0, "repaired"},
                    Case{"useless_triangles", tests::withUselessTriangles, WitnessOrigin::surface, kBall,
                         0.01, "left out"},
                    Case{"flipped_patches", tests::withFlippedPatches, WitnessOrigin::surface, kBall, 0.01,
                         "turned"},
                    Case{"inside_out", [] { return insideOut(sphere(4, 30)); }, WitnessOrigin::surface, kBall,
                         0.01, "turned"},
                    Case{"shell_with_cavity", [] { return joined(sphere(4, 30), insideOut(sphere(3, 15))); },
                         WitnessOrigin::surface, kBall * 7 / 8, 0.01},
                    Case{"two_nested_shells", [] { return joined(sphere(4, 30), sphere(3, 15)); },
                         WitnessOrigin::surface, kBall, 0.01},
                    Case{"ten_triangles", tests::tenTriangles, WitnessOrigin::surface}),
    [](const auto& broken) { return broken.param.name; });

TEST(BrokenSurface, OfTwoMillionTrianglesIsThinnedOut) {
  const geometry::TriangleMesh surface = tests::twoMillionTriangles();
  ASSERT_GT(surface.triangles.rows(), 2'000'000);
  WitnessOptions options;
  options.wanted = 2000;
  Progress progress;
  const WitnessSample sample = sampleWitnesses(surface, options, progress);
  EXPECT_LE(sample.origin, kRepaired);
  EXPECT_NEAR(static_cast<double>(sample.mesh->witnesses), 2000, kWitnessCountTolerance * 2000);
  const double volume = geometry::volume(surface.points, surface.triangles);
  EXPECT_NEAR(deformation::tetrahedronVolumes(sample.mesh->points, sample.mesh->tetrahedra).sum(), volume,
              0.02 * volume);
}

/// What is said about a surface that cannot be filled at all.
std::string refusal(const geometry::TriangleMesh& surface) {
  Progress progress;
  try {
    sampleWitnesses(surface, {}, progress);
  } catch (const DataError& error) {
    return error.what();
  }
  return {};
}

TEST(BrokenSurface, ThatIsNoSurfaceIsRefusedWithAReason) {
  EXPECT_NE(refusal(tests::withNan()).find("77"), std::string::npos) << refusal(tests::withNan());
  EXPECT_NE(refusal(tests::sheet()).find("encloses nothing"), std::string::npos) << refusal(tests::sheet());
  EXPECT_NE(refusal(tests::soup()).find("encloses nothing"), std::string::npos) << refusal(tests::soup());
  EXPECT_NE(refusal({}).find("encloses nothing"), std::string::npos) << refusal({});
  geometry::TriangleMesh points = tests::sphere(2, 30), beyond = points;
  points.triangles.resize(0, 3);
  beyond.triangles(5, 1) = 4000;
  EXPECT_NE(refusal(points).find("encloses nothing"), std::string::npos) << refusal(points);
  EXPECT_FALSE(refusal(beyond).empty());
}

TEST(WitnessSampling, RefusesOptionsOutOfRange) {
  Progress progress;
  for (const int wanted : {-5, 0, 199, 200'001}) {
    WitnessOptions options;
    options.wanted = wanted;
    EXPECT_THROW(sampleWitnesses(tests::box(), options, progress), UsageError);
  }
  WitnessOptions options;
  options.radiusEdgeRatio = 1;
  EXPECT_THROW(sampleWitnesses(tests::box(), options, progress), UsageError);
  options = {};
  options.timeLimitSeconds = 0;
  EXPECT_THROW(sampleWitnesses(tests::box(), options, progress), UsageError);
}

TEST(WitnessSampling, TakesTheGridWhenThereIsNoTetGen) {
  WitnessOptions options;
  options.wanted = 1000;
  options.worker = "/nonexistent/worker";
  Progress progress;
  const WitnessSample sample = sampleWitnesses(tests::sphere(3, 30), options, progress);
  EXPECT_EQ(sample.origin, WitnessOrigin::grid);
  deformation::requireUsable(*sample.mesh, "grid");
  ASSERT_EQ(sample.remarks.size(), 1u);
  EXPECT_NE(sample.remarks.front().english().find("/nonexistent/worker"), std::string::npos);
}

TEST(WitnessSampling, StaysWithinItsLimitsAndEndsWithTheGrid) {
  const geometry::TriangleMesh surface = tests::sphere(4, 30);
  WitnessOptions slow, small;
  slow.timeLimitSeconds = 0.001;
  small.memoryLimitBytes = 4 << 20;
  Progress progress;
  for (const WitnessOptions& options : {slow, small}) {
    const WitnessSample sample = sampleWitnesses(surface, options, progress);
    EXPECT_EQ(sample.origin, WitnessOrigin::grid);
    EXPECT_NEAR(static_cast<double>(sample.mesh->witnesses), 20'000, kWitnessCountTolerance * 20'000);
    EXPECT_FALSE(sample.remarks.empty());
  }
}

TEST(WitnessSampling, EndsWhenCancelledAndChangesNothing) {
  const geometry::TriangleMesh surface = tests::withHoles(), before = surface;
  for (const double moment : {0.0, 0.2, 0.3}) {
    Progress* line = nullptr;
    Progress progress([&](double fraction, const Text&) {
      if (fraction >= moment)
        line->cancel();
    });
    line = &progress;
    EXPECT_THROW(sampleWitnesses(surface, {}, progress), Cancelled);
  }
  EXPECT_EQ(surface.points, before.points);
  EXPECT_EQ(surface.triangles, before.triangles);
}

TEST(WitnessSampling, GivesTheSamePointsForAnyNumberOfThreads) {
  WitnessOptions one, three;
  one.wanted = three.wanted = 500;
  one.threads.count = 1;
  three.threads.count = 3;
  Progress progress;
  const auto a = sampleWitnesses(tests::sphere(5, 30), one, progress);
  const auto b = sampleWitnesses(tests::sphere(5, 30), three, progress);
  EXPECT_EQ(a.mesh->points, b.mesh->points);
  EXPECT_EQ(a.mesh->tetrahedra, b.mesh->tetrahedra);
}

} // namespace
} // namespace viscera::live
