#include <gtest/gtest.h>

#include "beating_labels.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/label_series.h"
#include "viscera/medical_io/surface_series_file.h"

namespace viscera::medical_io {
namespace {

std::vector<tests::LabelImage> phases(std::size_t count) {
  std::vector<tests::LabelImage> list;
  for (std::size_t phase = 0; phase < count; ++phase)
    list.push_back(tests::beatingLabels(double(phase) / double(count), Vec3(5, 5, 8)));
  return list;
}

struct ReadSeries {
  std::vector<LabelMap> maps;
  SeriesTimes times;
};

ReadSeries readSeries(const std::filesystem::path& file) {
  ReadSeries result;
  Progress progress;
  result.times = readLabelSeries(file, progress,
                                 [&](std::size_t, LabelMap&& map) { result.maps.push_back(std::move(map)); });
  return result;
}

void expectPhases(const ReadSeries& found, const std::vector<tests::LabelImage>& written) {
  ASSERT_EQ(found.maps.size(), written.size());
  for (std::size_t phase = 0; phase < written.size(); ++phase) {
    const LabelMap& map = found.maps[phase];
    ASSERT_EQ(map.segments.size(), 3U);
    EXPECT_LT((map.indexToLps.matrix() - written[phase].indexToLps.matrix()).cwiseAbs().maxCoeff(), 1e-5);
    for (std::size_t v = 0; v < map.voxelCount(); ++v)
      ASSERT_EQ(map.layers[0][v] == 0 ? 0 : map.segments[map.layers[0][v] - 1U].label,
                written[phase].voxels[v])
          << "phase " << phase;
  }
}

TEST(LabelSeries, ReadsNiftiWithTimeLastInItsUnit) {
  tests::TemporaryFolder folder;
  const auto written = phases(12);
  // Single precision: 66.6667 ms become 0.0666667 s only nearly.
  const ReadSeries found = readSeries(folder.put("cine.nii", tests::nifti4d(written, 66.6667, 16)));
  expectPhases(found, written);
  ASSERT_TRUE(found.times.periodSeconds);
  EXPECT_NEAR(*found.times.periodSeconds, 0.8, 1e-5);
  EXPECT_NEAR(found.times.seconds[3], 0.2, 1e-5);
  EXPECT_EQ(volumesIn(folder.put("cine.nii", tests::nifti4d(written, 66.6667, 16))), 12U);
}

TEST(LabelSeries, TakesSecondsAndMicrosecondsToo) {
  tests::TemporaryFolder folder;
  EXPECT_NEAR(*readSeries(folder.put("s.nii", tests::nifti4d(phases(5), 0.2, 8))).times.periodSeconds, 1,
              1e-6);
  EXPECT_NEAR(*readSeries(folder.put("u.nii", tests::nifti4d(phases(5), 200000, 24))).times.periodSeconds, 1,
              1e-6);
}

TEST(LabelSeries, AsksForThePeriodWhereStepOrUnitSayNothing) {
  tests::TemporaryFolder folder;
  EXPECT_FALSE(readSeries(folder.put("none.nii", tests::nifti4d(phases(5), 0, 8))).times.periodSeconds);
  EXPECT_FALSE(readSeries(folder.put("unit.nii", tests::nifti4d(phases(5), 40, 0))).times.periodSeconds);
  // A step of 1 s would be five seconds a beat and more.
  EXPECT_FALSE(readSeries(folder.put("one.nii", tests::nifti4d(phases(6), 1, 8))).times.periodSeconds);
}

TEST(LabelSeries, ReadsTheSequencesOfSlicerWithTimeFirst) {
  tests::TemporaryFolder folder;
  const auto written = phases(5);
  const ReadSeries found = readSeries(folder.put(
      "cine.seq.nrrd", tests::sequenceNrrd(written, "labels: \"time\" \"\" \"\" \"\"\n"
                                                    "axis 0 index type:=numeric\n"
                                                    "axis 0 index unit:=ms\n"
                                                    "axis 0 index values:=10 210 400 610 810\n"
                                                    "DataNodeClassName:=vtkMRMLLabelMapVolumeNode\n")));
  expectPhases(found, written);
  ASSERT_TRUE(found.times.periodSeconds);
  EXPECT_NEAR(*found.times.periodSeconds, 1, 1e-12);
  EXPECT_NEAR(found.times.seconds[2], 0.39, 1e-12);
  EXPECT_TRUE(found.times.doubt.empty());
}

TEST(LabelSeries, SaysWhatItTakesTimesWithoutAUnitFor) {
  tests::TemporaryFolder folder;
  const ReadSeries found = readSeries(
      folder.put("cine.seq.nrrd", tests::sequenceNrrd(phases(4), "axis 0 index values:=0 250 500 750\n")));
  EXPECT_NEAR(found.times.periodSeconds.value_or(0), 1, 1e-12);
  EXPECT_NE(found.times.doubt.english().find("taken as milliseconds"), std::string::npos);
  EXPECT_FALSE(readSeries(folder.put("frames.seq.nrrd",
                                     tests::sequenceNrrd(phases(4), "axis 0 index values:=0 1 2 3\n")))
                   .times.periodSeconds);
}

TEST(LabelSeries, IsCutOffOrNot) {
  tests::TemporaryFolder folder;
  std::string bytes = tests::nifti4d(phases(5), 100, 16);
  bytes.resize(bytes.size() - 100);
  EXPECT_THROW(readSeries(folder.put("cut.nii", bytes)), DataError);
  EXPECT_THROW(readSeries(folder.put("ball.obj", "v 0 0 0\n")), DataError);
}

TEST(DicomTimes, ComeFromTriggerTimesAndTheNominalInterval) {
  std::vector<DicomPhase> list(25);
  for (std::size_t phase = 0; phase < 25; ++phase) {
    list[phase].triggerMs = 33.16 * double(phase);
    list[phase].nominalIntervalMs = 829;
  }
  SeriesTimes times = timesOf(list);
  EXPECT_NEAR(*times.periodSeconds, 0.829, 1e-12);
  EXPECT_NEAR(times.seconds.back(), 0.79584, 1e-12);
  for (DicomPhase& phase : list)
    phase.nominalIntervalMs.reset();
  EXPECT_NEAR(*timesOf(list).periodSeconds, 0.829, 1e-9) << "as many steps as there are phases";
  for (std::size_t phase = 0; phase < 25; ++phase)
    list[phase] = {std::nullopt, 1000, 4.0 * double(phase)};
  times = timesOf(list);
  EXPECT_NEAR(times.seconds[10], 0.4, 1e-12);
  list[3].percent.reset();
  EXPECT_TRUE(timesOf(list).seconds.empty());
}

TEST(SurfaceSeriesFile, KeepsPointsThatReadingOneFileWouldMerge) {
  tests::TemporaryFolder folder;
  const std::string faces = "f 1 2 3\nf 4 6 5\nf 3 4 7 8\n";
  const auto first = folder.put(
      "a_0.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 0\nv 1 0 0\nv 0 0 1\nv 5 5 5\nv 6 6 7\n" + faces);
  const auto second = folder.put(
      "a_1.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nv 0 0 2\nv 1 0 2\nv 0 0 1\nv 5 5 6\nv 6 6 8\n" + faces);
  Progress progress;
  const SurfaceSeriesFile series = readSurfaceSeries({first, second}, progress);
  EXPECT_TRUE(series.correspond);
  ASSERT_EQ(series.phases.size(), 2U);
  EXPECT_EQ(series.phases[0].rows(), 8);
  EXPECT_EQ(series.triangles.rows(), 4);
  EXPECT_DOUBLE_EQ(series.phases[1](3, 2), 2);
  const auto other = folder.put("a_2.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nf 1 2 3\n");
  const SurfaceSeriesFile differs = readSurfaceSeries({first, second, other}, progress);
  EXPECT_FALSE(differs.correspond);
  EXPECT_EQ(differs.differs, 2U);
}

} // namespace
} // namespace viscera::medical_io
