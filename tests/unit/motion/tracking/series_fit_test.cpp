#include <cmath>
#include <filesystem>

#include <gtest/gtest.h>

#include "beating_shell.h"
#include "build_paths.h"
#include "shared_organs.h"
#include "viscera/core/error.h"
#include "viscera/geometry/volume.h"
#include "viscera/tracking/fit_quality.h"
#include "viscera/tracking/series_fit.h"

namespace viscera::tracking {
namespace {

/// A rig on the first phase of a series.
MotionRig rigOn(const std::vector<SurfaceSeries>& series, const RigOptions& options = {}) {
  std::vector<geometry::TriangleMesh> rest;
  for (const SurfaceSeries& one : series)
    rest.push_back(one.at(0));
  const RigHandles handles = placeMotionHandles(rest, outerOf(rest), options);
  Progress progress;
  return MotionRig(rest, handles.rest, options.locality, softnessFor(handles.rest, 8, options.softness),
                   progress);
}

/// The area-weighted mean distance of one surface over all phases.
double meanDistance(const MotionRig& rig, const MotionFit& fit, const std::vector<SurfaceSeries>& series,
                    std::size_t surface) {
  double sum = 0;
  for (std::size_t phase = 0; phase < fit.poses.size(); ++phase) {
    const Points& wanted = series[surface].phases[phase];
    const Points found = rig.vertices(fit.poses[phase], surface);
    sum += spreadOf((found - wanted).rowwise().norm(), vertexAreas(wanted, series[surface].triangles)).mean;
  }
  return sum / static_cast<double>(fit.poses.size());
}

TEST(FitSeries, OneRigHoldsTheOutsideAndTheCavity) {
  const auto series = tests::beatingShell(10);
  const MotionRig rig = rigOn(series);
  Progress progress;
  const MotionFit fit = fitSeries(rig, series, PhaseTimes::even(10, 1), {}, progress);
  EXPECT_LT(meanDistance(rig, fit, series, 0), 0.3);
  EXPECT_LT(meanDistance(rig, fit, series, 1), 0.3);
  for (std::size_t phase = 0; phase < 10; ++phase) {
    const Values volumes = rig.volumesMl(rig.vertices(fit.poses[phase]));
    for (std::size_t i = 0; i < 2; ++i) {
      const geometry::TriangleMesh measured = series[i].at(phase);
      const double wanted = geometry::volume(measured.points, measured.triangles) / 1000;
      EXPECT_NEAR(volumes[static_cast<Eigen::Index>(i)], wanted, 1e-5);
      EXPECT_EQ(opposedTriangles(measured.triangles, rig.vertices(fit.poses[phase], i), measured.points), 0);
    }
    EXPECT_TRUE(fit.volumes[phase].met);
    EXPECT_LE(fit.volumes[phase].steps, 4);
  }
  const TissueWitnesses tissue(rig, 0, 1500, progress);
  for (const Points& pose : fit.poses)
    EXPECT_EQ(tissue.foldedAt(pose), 0);
}

TEST(FitSeries, HandlesOutsideAloneCannotMoveTheCavity) {
  const auto series = tests::beatingShell(4);
  RigHandles outside = placeMotionHandles({series[0].at(0)}, 0, {.handles = 120});
  Progress progress;
  const MotionRig rig({series[0].at(0), series[1].at(0)}, outside.rest, 3, softnessFor(outside.rest, 8, 1.5),
                      progress);
  const MotionFit fit = fitSeries(rig, series, PhaseTimes::even(4, 1), {}, progress);
  const MotionRig inside = rigOn(series);
  const MotionFit better = fitSeries(inside, series, PhaseTimes::even(4, 1), {}, progress);
  EXPECT_GT(meanDistance(rig, fit, series, 1), 2 * meanDistance(inside, better, series, 1));
}

TEST(FitSeries, LeavesVolumesToTheFitWhenItIsTold) {
  const auto series = tests::beatingShell(5);
  const MotionRig rig = rigOn(series);
  Progress progress;
  const MotionFit fit = fitSeries(rig, series, PhaseTimes::even(5, 1), {.keepVolumes = false}, progress);
  EXPECT_TRUE(fit.volumes.empty());
  for (std::size_t phase = 0; phase < 5; ++phase)
    EXPECT_EQ(fit.freeVolumesMl[phase], rig.volumesMl(rig.vertices(fit.poses[phase])));
}

TEST(FitSeries, CanBeCancelled) {
  const auto series = tests::beatingShell(4);
  const MotionRig rig = rigOn(series);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(fitSeries(rig, series, PhaseTimes::even(4, 1), {}, progress), Cancelled);
}

TEST(Spread, CountsByWeight) {
  Values values(4), weights(4);
  values << 4, 1, 3, 2;
  weights << 1, 10, 1, 8;
  const Spread spread = spreadOf(values, weights);
  EXPECT_NEAR(spread.mean, (4 + 10 + 3 + 16) / 20.0, 1e-12);
  EXPECT_DOUBLE_EQ(spread.p95, 3);
  EXPECT_DOUBLE_EQ(spread.max, 4);
}

TEST(Verdict, NamesWhatIsDoubtful) {
  PhaseQuality phase;
  SurfaceQuality good;
  good.meanMm = 0.5;
  good.p95Mm = 1;
  good.measuredMl = good.freeMl = good.fittedMl = 100;
  phase.surfaces = {good};
  EXPECT_EQ(verdictOf(phase, {"LV"}, 0).light, FitLight::good);
  phase.surfaces[0].meanMm = 1.8;
  EXPECT_EQ(verdictOf(phase, {"LV"}, 0).light, FitLight::amber);
  EXPECT_EQ(verdictOf(phase, {"LV"}, 0).reasons.front().english(), "LV is 1.8 mm away on average");
  phase.surfaces[0].meanMm = 2.6;
  EXPECT_EQ(verdictOf(phase, {"LV"}, 0).light, FitLight::red);
  phase.surfaces[0] = good;
  phase.surfaces[0].freeMl = 80;
  EXPECT_EQ(verdictOf(phase, {"LV"}, 0).reasons.front().english(),
            "LV had to be changed by 20 % to get its volume");
  phase.surfaces[0] = good;
  phase.surfaces[0].dice = 0.94;
  EXPECT_EQ(verdictOf(phase, {"LV"}, 1).light, FitLight::amber);
  EXPECT_EQ(verdictOf(phase, {"LV"}, 8).light, FitLight::good) << "slices of 8 mm cannot agree better";
  phase.volumesMet = false;
  EXPECT_EQ(verdictOf(phase, {"LV"}, 8).light, FitLight::red);
}

/// The right ventricle of one person over one beat (shared/organs/cine), read as it is stored.
SurfaceSeries rightVentricle() {
  SurfaceSeries series{"RV", {}, {}};
  for (int phase = 0; phase < 25; ++phase) {
    std::string number = std::to_string(phase);
    number.insert(0, 3 - number.size(), '0');
    const auto mesh = tests::readObj(std::filesystem::path(VISCERA_SHARED_ORGANS) / "cine" /
                                     ("patient1_RV_ENDOCARDIAL_" + number + ".obj"));
    series.triangles = mesh.triangles;
    series.phases.push_back(mesh.points);
  }
  return series;
}

TEST(FitSeries, SixtyHandlesHoldARealRightVentricle) {
  if (!std::filesystem::exists(std::filesystem::path(VISCERA_SHARED_ORGANS) / "cine"))
    GTEST_SKIP() << "shared/organs/cine is absent";
  const TidySeries tidy = tidySeries(rightVentricle());
  EXPECT_EQ(tidy.mergedPoints, 80);
  EXPECT_EQ(tidy.closedHoles, 2);
  const std::vector<SurfaceSeries> series = {tidy.series};
  const MotionRig rig = rigOn(series);
  Progress progress;
  const MotionFit fit = fitSeries(rig, series, PhaseTimes::even(25, 0.829), {}, progress);
  const double mean = meanDistance(rig, fit, series, 0);
  RecordProperty("meanMm", std::to_string(mean));
  std::printf("mean %.3f mm\n", mean);
  EXPECT_LT(mean, 0.7);
  const std::vector<double> measured = {170.1, 165.3, 154.0, 141.8, 129.0, 114.2, 101.6, 87.7,  82.7,
                                        76.7,  77.6,  78.2,  82.0,  99.3,  118.0, 122.2, 128.5, 133.0,
                                        135.3, 136.2, 142.0, 147.0, 158.2, 167.0, 167.8};
  int flipped = 0;
  for (std::size_t phase = 0; phase < 25; ++phase) {
    const geometry::TriangleMesh truth = series[0].at(phase);
    const Points vertices = rig.vertices(fit.poses[phase]);
    EXPECT_NEAR(geometry::volume(truth.points, truth.triangles) / 1000, measured[phase], 0.06);
    EXPECT_NEAR(rig.volumesMl(vertices)[0], geometry::volume(truth.points, truth.triangles) / 1000, 1e-5);
    flipped += opposedTriangles(truth.triangles, vertices, truth.points);
  }
  EXPECT_EQ(flipped, 0);
}

} // namespace
} // namespace viscera::tracking
