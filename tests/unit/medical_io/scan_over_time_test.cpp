#include "viscera/medical_io/scan_over_time.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "beating_labels.h"
#include "dicom_slices.h"
#include "packed_bytes.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"

namespace viscera::medical_io {
namespace {

using testing::HasSubstr;
using tests::LabelImage;

/// Volumes whose values tell phase and voxel: 1000 times the phase, and the voxel's number.
std::vector<LabelImage> numberedPhases(int count, const std::array<int, 3>& size = {4, 3, 5}) {
  std::vector<LabelImage> phases;
  for (int phase = 0; phase < count; ++phase) {
    LabelImage image = tests::emptyLabels(size);
    for (std::size_t v = 0; v < image.voxels.size(); ++v)
      image.voxels[v] = static_cast<std::int16_t>(1000 * phase + int(v));
    phases.push_back(image);
  }
  return phases;
}

constexpr const char* kSlicerKeys =
    "axis 0 index type:=numeric\naxis 0 index values:=0 200 400 600 800\naxis 0 index unit:=ms\n";

class ScansOverTime : public testing::Test {
protected:
  std::optional<ScanOverTime> read(const std::filesystem::path& place, const ScanTimeOptions& time = {},
                                   const std::string& series = {}) {
    return readScanOverTime(place, {series, 0}, progress_, time);
  }
  static double firstValue(const ScanOverTime& time, std::size_t phase) {
    return time.volume(phase)->value(0, 0, 0);
  }
  static std::string findings(const ScanOverTime& time) {
    std::string all;
    for (const Text& finding : time.findings)
      all += finding.english() + "\n";
    return all;
  }
  /// Five phases in one second, each voxel where it belongs.
  void expectBeat(const std::filesystem::path& file) {
    SCOPED_TRACE(file.filename());
    const auto beat = read(file);
    ASSERT_TRUE(beat);
    ASSERT_EQ(beat->fractions.size(), 5U);
    EXPECT_NEAR(beat->fractions[2], 0.4, 1e-6);
    EXPECT_NEAR(beat->periodSeconds, 1, 1e-6);
    EXPECT_TRUE(beat->missing.empty());
    std::vector<LabelImage> phases = numberedPhases(5);
    for (std::size_t phase = 0; phase < 5; ++phase) {
      const auto scan = beat->volume(phase);
      EXPECT_EQ(scan->phase, int(phase));
      for (int k = 0; k < 5; ++k)
        for (int j = 0; j < 3; ++j)
          for (int i = 0; i < 4; ++i)
            ASSERT_EQ(scan->value(i, j, k), double(phases[phase].at(i, j, k)));
    }
  }
  /// A phase of a CT as files of its own, with whatever `change` adds.
  template <class Change>
  void putPhase(const LabelImage& image, const std::string& name, const std::string& series,
                const Change& change) {
    std::filesystem::create_directory(folder_ / "ct");
    for (int k = 0; k < image.size[2]; ++k) {
      tests::DicomElements elements = tests::dicomSlice(image, k, series);
      elements[0x00080018] = "UI" + series + "." + name.substr(1) + "." + std::to_string(k + 1);
      change(elements);
      folder_.put("ct/" + name + "_" + std::to_string(k) + ".dcm", tests::dicomBytes(elements));
    }
  }

  tests::TemporaryFolder folder_;
  Progress progress_;
};

TEST_F(ScansOverTime, AreReadFromEveryKindOfFile) {
  const std::vector<LabelImage> phases = numberedPhases(5);
  expectBeat(folder_.put("s.nii", tests::nifti4d(phases, 0.2, 8)));
  expectBeat(folder_.put("ms.nii.gz", tests::gzipped(tests::nifti4d(phases, 200, 16))));
  expectBeat(folder_.put("us.nii", tests::nifti4d(phases, 200000, 24)));
  expectBeat(folder_.put("slicer.seq.nrrd", tests::sequenceNrrd(phases, kSlicerKeys)));
}

TEST_F(ScansOverTime, OfOneVolumeAreNone) {
  EXPECT_FALSE(read(folder_.put("one.nii", tests::niftiFile(numberedPhases(1)[0]))));
}

TEST_F(ScansOverTime, SayWhichUnitWasAssumed) {
  const std::vector<LabelImage> phases = numberedPhases(5);
  const auto ms = read(folder_.put("ms.nii", tests::nifti4d(phases, 200, 0)));
  EXPECT_NEAR(ms->periodSeconds, 1, 1e-6);
  EXPECT_THAT(findings(*ms), HasSubstr("taken as milliseconds"));
  const auto seconds = read(folder_.put("s.nii", tests::nifti4d(phases, 0.2, 0)));
  EXPECT_NEAR(seconds->periodSeconds, 1, 1e-6);
  EXPECT_THAT(findings(*seconds), HasSubstr("taken as seconds"));
  const auto none = read(folder_.put("none.nii", tests::nifti4d(phases, 1, 0)));
  EXPECT_EQ(none->periodSeconds, 0);
  EXPECT_NEAR(none->fractions[1], 0.2, 1e-9);
  EXPECT_THAT(findings(*none), HasSubstr("spread over one"));
}

TEST_F(ScansOverTime, NameTheDamagedPhasesAndKeepTheOthers) {
  const std::string whole = tests::nifti4d(numberedPhases(5), 0.2, 8);
  const std::size_t phaseBytes = 4 * 3 * 5 * 2;
  const auto cut = read(folder_.put("cut.nii", whole.substr(0, whole.size() - phaseBytes - 10)));
  ASSERT_TRUE(cut);
  ASSERT_EQ(cut->fractions.size(), 3U);
  EXPECT_EQ(cut->missing.size(), 2U);
  EXPECT_EQ(cut->phasesInCycle(), 5U);
  EXPECT_EQ(firstValue(*cut, 2), 2000);
  EXPECT_THAT(findings(*cut), HasSubstr("phase 3 is damaged and left out"));
  EXPECT_THAT(findings(*cut), HasSubstr("phase 4 is damaged and left out"));
  EXPECT_EQ(cut->shownAt(0.4), 2U);
  EXPECT_FALSE(cut->shownAt(0.62)) << "nothing is made up for a damaged phase";
}

TEST_F(ScansOverTime, KeepNoMoreThanTheirBytesAndReadTheOthersAgain) {
  const auto file = folder_.put("s.nii", tests::nifti4d(numberedPhases(5), 0.2, 8));
  const auto beat = read(file, {2 * 4 * 3 * 5 * 2});
  ASSERT_EQ(beat->fractions.size(), 5U);
  EXPECT_THAT(findings(*beat), HasSubstr("are kept at a time"));
  const std::weak_ptr<const Scan> first = beat->volume(0);
  for (std::size_t phase = 0; phase < 5; ++phase)
    EXPECT_EQ(firstValue(*beat, phase), 1000.0 * double(phase));
  EXPECT_TRUE(first.expired()) << "later phases took its place";
  EXPECT_EQ(beat->volume(4), beat->volume(4)) << "the last one stays";
}

TEST_F(ScansOverTime, AreKeptAsSixteenBitsWhereThirtyTwoDoNotFit) {
  std::string bytes = tests::nifti4d(numberedPhases(2), 0.2, 8);
  bytes.resize(352);
  tests::putBytes<std::int16_t>(bytes, 70, 16);
  std::vector<float> values;
  for (int v = 0; v < 120; ++v)
    values.push_back(0.25F * float(v) - 3);
  values[7] = NAN;
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
  const auto beat = read(folder_.put("f.nii", bytes), {120 * 2});
  ASSERT_EQ(beat->fractions.size(), 2U);
  EXPECT_THAT(findings(*beat), HasSubstr("16 bits"));
  const auto scan = beat->volume(1);
  EXPECT_TRUE(std::holds_alternative<std::vector<std::int16_t>>(scan->samples));
  EXPECT_NEAR(scan->value(3, 2, 4), values[119], 1e-3);
  EXPECT_NEAR(scan->value(0, 0, 0), values[60], 1e-3);
  const auto first = beat->volume(0);
  EXPECT_FALSE(first->at(first->indexToLps * Vec3(3, 1, 0))) << "what was not measured stays so";
}

TEST_F(ScansOverTime, JoinGatedSeriesOfOneStudy) {
  const std::vector<LabelImage> phases = numberedPhases(3);
  for (int p = 0; p < 3; ++p)
    putPhase(phases[std::size_t(p)], "p" + std::to_string(p), "1.2.3." + std::to_string(40 + p),
             [&](auto& e) {
               e[0x0008103E] = "LOCorCTA 0.75 B26f " + std::to_string(30 * p + 10) + "%";
               e[0x00181062] = "IS900";
             });
  putPhase(phases[0], "x9", "1.2.3.99", [](auto& e) { e[0x0008103E] = "LOOther kernel"; });
  const auto gated = read(folder_ / "ct");
  ASSERT_TRUE(gated);
  ASSERT_EQ(gated->fractions.size(), 3U);
  EXPECT_NEAR(gated->fractions[1], 0.4, 1e-9);
  EXPECT_NEAR(gated->periodSeconds, 0.9, 1e-9);
  EXPECT_EQ(firstValue(*gated, 2), 2000);
  const std::vector<ScanSeries> list = listScans(folder_ / "ct", progress_);
  ASSERT_EQ(list.size(), 2U) << "its phases are one scan";
  const auto one = std::find_if(list.begin(), list.end(), [](const ScanSeries& s) { return s.phases == 3; });
  ASSERT_NE(one, list.end());
  EXPECT_EQ(readScan(folder_ / "ct", {one->id, 1}, progress_).value(0, 0, 0), 1000);
  EXPECT_EQ(readScan(folder_ / "ct", {"1.2.3.42", 0}, progress_).value(0, 0, 0), 2000) << "one phase alone";
}

TEST_F(ScansOverTime, OfOneSeriesAreToldByTimeAlsoWhereAPhaseLacksASlice) {
  const std::vector<LabelImage> phases = numberedPhases(4);
  for (int p = 0; p < 4; ++p)
    putPhase(phases[std::size_t(p)], "p" + std::to_string(p), "1.2.3.4", [&](auto& e) {
      e[0x00181060] = "DS" + std::to_string(200 * p);
      e[0x00181062] = "IS800";
    });
  auto whole = read(folder_ / "ct");
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->fractions, (std::vector<double>{0, 0.25, 0.5, 0.75}));
  EXPECT_NEAR(whole->periodSeconds, 0.8, 1e-9);
  std::filesystem::remove(folder_ / "ct" / "p2_4.dcm");
  const auto lacking = read(folder_ / "ct");
  ASSERT_TRUE(lacking);
  EXPECT_EQ(lacking->fractions, (std::vector<double>{0, 0.25, 0.75}));
  EXPECT_EQ(lacking->missing, std::vector<double>{0.5});
  EXPECT_THAT(findings(*lacking), HasSubstr("phase 2 is damaged and left out"));
  EXPECT_EQ(firstValue(*lacking, 2), 3000);
}

TEST_F(ScansOverTime, StopWhenCancelled) {
  const auto file = folder_.put("s.nii", tests::nifti4d(numberedPhases(5), 0.2, 8));
  progress_.cancel();
  EXPECT_THROW(read(file), Cancelled);
}

} // namespace
} // namespace viscera::medical_io
