#include <cmath>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "beating_labels.h"
#include "beating_shell.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/geometry/volume.h"
#include "viscera/live/measured_record.h"
#include "viscera/live/patient_motion.h"

namespace viscera::live {
namespace {

using nlohmann::ordered_json;

/// The shell whose motion is known, as surfaces.
MotionSeries shellSeries(std::size_t phases) {
  MotionSeries series;
  series.names = {"outer", "cavity"};
  series.corresponding = tests::beatingShell(phases);
  series.times = tracking::PhaseTimes::even(phases, 0.9);
  for (std::size_t phase = 0; phase < phases; ++phase) {
    std::vector<double>& volumes = series.volumesMl.emplace_back();
    for (const auto& surface : series.corresponding)
      volumes.push_back(geometry::volume(surface.phases[phase], surface.triangles) / 1000);
  }
  return series;
}

TEST(PatientMotion, OfSurfacesHasTheirVolumesAtItsKeys) {
  const MotionSeries series = shellSeries(8);
  Progress progress;
  const PatientMotion found = trackMotion(series, {}, progress);
  ASSERT_EQ(found.phases.size(), 8U);
  EXPECT_EQ(found.sequence.track.keys.size(), 8U);
  EXPECT_EQ(found.sequence.track.restHandles.rows(), 120);
  EXPECT_EQ(found.worst(), tracking::FitLight::good);
  EXPECT_EQ(found.indices.count("outer"), 0U);
  const double expected = 1 - 0.7 * 0.7 * 0.9;
  EXPECT_NEAR(found.indices.at("cavity").ejectionFraction, expected, 1e-6);
  for (const TrackedPhase& phase : found.phases) {
    EXPECT_LT(phase.quality.meanMm, 0.5);
    EXPECT_EQ(phase.quality.folded, 0);
    for (const tracking::SurfaceQuality& surface : phase.quality.surfaces) {
      EXPECT_NEAR(surface.fittedMl, surface.measuredMl, 1e-5);
      EXPECT_EQ(surface.flipped, 0);
    }
  }
  EXPECT_EQ(found.tissueMl.size(), 8U);
  // Handles in groups: the box, the outside, the cavity.
  ASSERT_EQ(found.sequence.track.groups.size(), 3U);
  EXPECT_EQ(found.sequence.track.groups[2].name, "cavity");
}

/// Its own fault: one phase of which half the cavity's points lie elsewhere.
TEST(PatientMotion, NamesAPhaseThatFitsMuchWorseThanItsNeighbours) {
  MotionSeries series = shellSeries(8);
  Points& spoilt = series.corresponding[1].phases[3];
  for (Eigen::Index v = 0; v < spoilt.rows(); v += 2)
    spoilt.row(v) *= 0.6;
  Progress progress;
  TrackOptions options;
  options.keepVolumes = false;
  const PatientMotion found = trackMotion(series, options, progress);
  EXPECT_EQ(found.outliers, std::vector<std::size_t>{3});
  EXPECT_NE(found.worst(), tracking::FitLight::good);
  ASSERT_FALSE(found.warnings.empty());
  EXPECT_NE(found.warnings.back().english().find("phase 4 fits much worse than its neighbours"),
            std::string::npos)
      << found.warnings.back();
}

TEST(PatientMotion, IsTheSameWhateverTheNumberOfThreads) {
  const MotionSeries series = shellSeries(5);
  Progress progress;
  const PatientMotion one = trackMotion(series, {}, progress, Threads{1});
  const PatientMotion three = trackMotion(series, {}, progress, Threads{3});
  for (std::size_t key = 0; key < 5; ++key)
    EXPECT_EQ(one.sequence.track.keys[key].pose, three.sequence.track.keys[key].pose);
}

TEST(PatientMotion, TakesAGivenRig) {
  const MotionSeries series = shellSeries(5);
  Progress progress;
  TrackOptions options;
  options.rig.handles = 60;
  const PatientMotion made = trackMotion(series, options, progress);
  options.handles = medical_io::HandleFile{};
  auto& group = options.handles->groups.emplace_back();
  group.name = "Mine";
  for (Eigen::Index i = 0; i < made.sequence.track.restHandles.rows(); ++i)
    group.handles.push_back(
        {"P" + std::to_string(i), made.sequence.track.restHandles.row(i).transpose(), {}, false, true});
  const PatientMotion given = trackMotion(series, options, progress);
  EXPECT_EQ(given.sequence.track.restHandles, made.sequence.track.restHandles);
  EXPECT_EQ(given.sequence.labels.front(), "P0");
  EXPECT_EQ(given.sequence.track.groups.front().name, "Mine");
  EXPECT_LT(given.phases[2].quality.meanMm, 0.7);
  // Handles that do not surround the organ are of no use.
  for (auto& handle : group.handles)
    handle.position *= 0.3;
  EXPECT_THROW(trackMotion(series, options, progress), DataError);
}

TEST(PatientMotion, OfLabelMapsWithThickSlicesHasTheVolumesOfTheirVoxels) {
  tests::TemporaryFolder folder;
  std::vector<tests::LabelImage> phases;
  for (int phase = 0; phase < 6; ++phase)
    phases.push_back(tests::beatingLabels(phase / 6.0, Vec3(2, 2, 8)));
  SeriesRequest request;
  request.inputs = {folder.put("cine.nii", tests::nifti4d(phases, 150, 16))};
  request.surfaces = {{"LV", {"1"}}, {"RV", {"2"}}, {"EPI", {"1", "2", "3"}}};
  Progress progress;
  TrackOptions options;
  options.triangles = 1500;
  options.rig.handles = 80;
  options.witnesses = 1000;
  const PatientMotion found = trackMotion(readMotionSeries(request, progress), options, progress);
  EXPECT_FALSE(found.corresponding);
  for (const TrackedPhase& phase : found.phases) {
    EXPECT_LT(phase.quality.meanMm, 0.8);
    EXPECT_GT(phase.quality.dice.value_or(0), 0.94);
    EXPECT_LE(phase.quality.folded, 3) << "of a thousand: the septum is two voxels thin";
    for (const tracking::SurfaceQuality& surface : phase.quality.surfaces)
      EXPECT_NEAR(surface.fittedMl / surface.measuredMl, 1, 1e-6);
  }
  EXPECT_EQ(found.indices.size(), 2U);
}

TEST(PatientMotion, ComesBackFromItsFileWithItsOrgans) {
  const MotionSeries series = shellSeries(4);
  Progress progress;
  TrackOptions options;
  options.rig.handles = 40;
  const PatientMotion found = trackMotion(series, options, progress);
  tests::TemporaryFolder folder;
  const auto file = folder.path() / "beat.sequence.json";
  writeSequence(file, found.sequence);
  const SequenceFile back = readSequence(file);
  ASSERT_EQ(back.organs.size(), 2U);
  EXPECT_EQ(back.organs[1].name, "cavity");
  EXPECT_EQ(back.organs[1].mesh->points, found.sequence.organs[1].mesh->points);
  EXPECT_EQ(back.organs[1].mesh->triangles, found.sequence.organs[1].mesh->triangles);
  for (std::size_t key = 0; key < 4; ++key)
    EXPECT_EQ(back.track.keys[key].pose, found.sequence.track.keys[key].pose);
}

TEST(MeasuredRecord, ComesBackWithItsNumbersAndRefusesOtherJson) {
  const MotionSeries series = shellSeries(4);
  Progress progress;
  TrackOptions options;
  options.rig.handles = 40;
  const PatientMotion found = trackMotion(series, options, progress);
  const ordered_json written = toJson({{{7}, {9}}, series, found});
  const MeasuredRecord back = measuredRecordFrom(written);
  EXPECT_EQ(back.organs, (std::vector<document::OrganId>{{7}, {9}}));
  EXPECT_EQ(back.series.names, series.names);
  EXPECT_EQ(back.series.volumesMl, series.volumesMl);
  EXPECT_EQ(back.series.times.seconds, series.times.seconds);
  EXPECT_EQ(back.motion.tissueMl, found.tissueMl);
  EXPECT_EQ(back.motion.indices.at("cavity").ejectionFraction, found.indices.at("cavity").ejectionFraction);
  EXPECT_TRUE(back.motion.corresponding);
  for (std::size_t phase = 0; phase < 4; ++phase) {
    EXPECT_EQ(back.motion.phases[phase].quality.p95Mm, found.phases[phase].quality.p95Mm);
    EXPECT_EQ(back.motion.phases[phase].quality.surfaces[1].freeMl,
              found.phases[phase].quality.surfaces[1].freeMl);
    EXPECT_EQ(back.motion.phases[phase].verdict.reasons, found.phases[phase].verdict.reasons);
  }
  EXPECT_EQ(toJson(back), written);
  ordered_json cut = written;
  cut["phases"][2].erase("surfaces");
  for (const ordered_json& other : {ordered_json::object(), ordered_json("nothing"), ordered_json(), cut})
    EXPECT_THROW(measuredRecordFrom(other), DataError) << other;
}

TEST(PatientMotion, CanBeCancelled) {
  const MotionSeries series = shellSeries(4);
  Progress progress;
  progress.cancel();
  EXPECT_THROW(trackMotion(series, {}, progress), Cancelled);
}

} // namespace
} // namespace viscera::live
