#include <gtest/gtest.h>

#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/image_file.h"

namespace viscera::medical_io {
namespace {

constexpr double kStepMs = 40;

std::vector<Scan> scansOverTime() {
  std::vector<Scan> scans;
  for (int phase = 0; phase < 3; ++phase) {
    Scan scan;
    scan.size = {3, 4, 5};
    scan.indexToLps = Eigen::Translation3d(-7, 8, 9) * Eigen::Scaling(2.0, 3.0, 4.0);
    std::vector<std::int16_t> samples;
    for (int v = 0; v < 60; ++v)
      samples.push_back(static_cast<std::int16_t>(100 * phase - v));
    scan.samples = std::move(samples);
    scans.push_back(std::move(scan));
  }
  return scans;
}

std::vector<LabelMap> labelsOverTime() {
  std::vector<LabelMap> maps;
  for (int phase = 0; phase < 3; ++phase) {
    LabelMap map;
    map.size = {3, 4, 5};
    map.indexToLps = Eigen::Translation3d(-7, 8, 9) * Eigen::Scaling(2.0, 3.0, 4.0);
    std::vector<std::uint8_t> labels(60, 0);
    for (int v = 20; v < 40 + 4 * phase; ++v)
      labels[static_cast<std::size_t>(v)] = v % 2 == 0 ? 1 : 2;
    map.layers.emplace_back(labels);
    map.segments.push_back({.label = 1, .name = "Wall", .named = true});
    map.segments.push_back({.label = 2, .name = "Cavity", .named = true});
    maps.push_back(std::move(map));
  }
  return maps;
}

TEST(ImageSeries, ScansOverTimeAreReadBackEqual) {
  const tests::TemporaryFolder folder;
  const std::vector<Scan> written = scansOverTime();
  Progress progress;
  for (const char* name : {"a.nii", "a.nii.gz", "a.seq.nrrd"}) {
    writeScanSeries(folder / name, written, kStepMs);
    for (int phase = 0; phase < 3; ++phase) {
      const Scan read = readScan(folder / name, {"", phase}, progress);
      EXPECT_EQ(read.samples, written[static_cast<std::size_t>(phase)].samples) << name << ' ' << phase;
      EXPECT_TRUE(read.indexToLps.isApprox(written[0].indexToLps, 1e-6)) << name;
      ASSERT_EQ(read.phaseTimesMs.size(), 3U) << name;
    }
  }
}

TEST(ImageSeries, LabelsOverTimeAreReadBackEqual) {
  const tests::TemporaryFolder folder;
  const std::vector<LabelMap> written = labelsOverTime();
  Progress progress;
  for (const char* name : {"b.nii.gz", "b.seq.nrrd"}) {
    writeLabelSeries(folder / name, written, kStepMs);
    for (int phase = 0; phase < 3; ++phase) {
      const LabelMap read = readLabelMap(folder / name, progress, phase);
      const LabelMap& map = written[static_cast<std::size_t>(phase)];
      for (std::size_t v = 0; v < 60; ++v) {
        const std::uint16_t was = map.layers[0][v], is = read.layers[0][v];
        const std::int64_t label = is > 0 ? read.segments[is - 1U].label : 0;
        ASSERT_EQ(label, was > 0 ? map.segments[was - 1U].label : 0) << name << ' ' << phase << ' ' << v;
      }
    }
  }
}

TEST(ImageSeries, OfDifferentGridsIsRefused) {
  const tests::TemporaryFolder folder;
  std::vector<Scan> scans = scansOverTime();
  scans[1].size = {5, 4, 3};
  EXPECT_THROW(writeScanSeries(folder / "a.nii", scans, kStepMs), DataError);
  EXPECT_THROW(writeScanSeries(folder / "a.nii", std::vector<Scan>(), kStepMs), DataError);
  EXPECT_THROW(writeScanSeries(folder / "a.mha", scansOverTime(), kStepMs), CannotCreateError);
}

} // namespace
} // namespace viscera::medical_io
