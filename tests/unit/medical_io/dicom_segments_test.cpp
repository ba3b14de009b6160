#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dicom_segments.h"
#include "packed_dicom.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_series.h"

/// Segmentations as programs other than DCMTK write them.
namespace viscera::medical_io {
namespace {

using tests::LabelImage;
using tests::SegmentWriting;

constexpr double kVoxelMl = 2.0 * 3.0 * 4.0 / 1000;

/// Two organs of 160 and 60 voxels.
LabelImage liverAndTumour(int liver = 1, int tumour = 2) {
  LabelImage image = tests::emptyLabels({11, 9, 7}); // 99 pixels: frames do not end at a byte.
  image.indexToLps.linear() = Vec3(3, 2, 4).asDiagonal();
  image.indexToLps.translation() = Vec3(-50, -40, 100);
  image.fill({1, 1, 1}, {8, 5, 4}, static_cast<std::int16_t>(liver));
  image.fill({2, 6, 2}, {6, 7, 5}, static_cast<std::int16_t>(tumour));
  return image;
}

std::int64_t voxelsOf(const LabelImage& image, int label) {
  return std::count(image.voxels.begin(), image.voxels.end(), label);
}

class DicomSegments : public testing::Test {
protected:
  LabelMap read(const std::string& bytes) {
    Progress progress;
    return readLabelMap(folder_.put("a.dcm", bytes), progress);
  }
  /// Both organs with their numbers of voxels and names.
  static void expectOrgans(const LabelMap& map, const LabelImage& image) {
    ASSERT_EQ(map.segments.size(), 2U);
    for (const Segment& segment : map.segments) {
      EXPECT_EQ(segment.voxels, voxelsOf(image, int(segment.label))) << segment.name;
      EXPECT_NEAR(map.volumeMl(segment), double(segment.voxels) * kVoxelMl, 1e-6);
    }
    EXPECT_EQ(map.segments[0].name, "Liver");
    EXPECT_EQ(map.segments[1].name, "Tumour");
    EXPECT_EQ(map.segments[0].low, (std::array<int, 3>{1, 1, 1}));
    EXPECT_LT((map.indexToLps.translation() - Vec3(-50, -40, 100)).norm(), 1e-9);
  }
  tests::TemporaryFolder folder_;
};

TEST_F(DicomSegments, AreReadFromLabelMapsOfBothWidthsAndEveryPacking) {
  for (const int bits : {8, 16}) {
    const LabelImage image = bits == 8 ? liverAndTumour(3, 200) : liverAndTumour(7, 300);
    const std::map<int, std::string> names = bits == 8
                                                 ? std::map<int, std::string>{{3, "Liver"}, {200, "Tumour"}}
                                                 : std::map<int, std::string>{{7, "Liver"}, {300, "Tumour"}};
    const std::string plain = tests::dicomBytes(
        tests::segmentationElements(image, {.type = "LABELMAP", .bits = bits, .names = names}));
    expectOrgans(read(plain), image);
    EXPECT_TRUE(isLabelMap(folder_ / "a.dcm"));
    for (const char* packing : {"rle", "jpeg-ls", "jpeg-lossless", "deflated"}) {
      SCOPED_TRACE(packing + std::string(" ") + std::to_string(bits));
      expectOrgans(read(tests::packedDicom(plain, packing)), image);
    }
  }
}

/// One mask of all phases would be too large an organ.
TEST_F(DicomSegments, OverTimeAreRefusedWithASentence) {
  for (const char* type : {"BINARY", "LABELMAP"})
    for (const int phases : {1, 3}) {
      SCOPED_TRACE(type);
      const int bits = std::string(type) == "LABELMAP" ? 8 : 1;
      const std::string bytes = tests::dicomBytes(tests::segmentationElements(
          liverAndTumour(),
          {.type = type, .bits = bits, .names = {{1, "Liver"}, {2, "Tumour"}}, .phases = phases}));
      if (phases == 1) {
        expectOrgans(read(bytes), liverAndTumour());
        continue;
      }
      try {
        read(bytes);
        ADD_FAILURE() << "phases were joined";
      } catch (const DataError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("over time"));
      }
    }
}

/// Three phases: as at first, with a larger liver, and with nothing.
TEST_F(DicomSegments, OverTimeAreASeriesOfLabelMapsWithTheirSeconds) {
  LabelImage larger = liverAndTumour(), nothing = liverAndTumour();
  larger.fill({1, 1, 5}, {8, 5, 5}, 1);
  std::fill(nothing.voxels.begin(), nothing.voxels.end(), std::int16_t(0));
  for (const char* type : {"BINARY", "LABELMAP"})
    for (const double step : {0.0, 0.25}) {
      SCOPED_TRACE(type);
      const auto file =
          folder_.put("a.dcm", tests::dicomBytes(tests::segmentationElements(
                                   liverAndTumour(), {.type = type,
                                                      .bits = std::string(type) == "LABELMAP" ? 8 : 1,
                                                      .names = {{1, "Liver"}, {2, "Tumour"}},
                                                      .phases = 3,
                                                      .later = {larger, nothing},
                                                      .stepSeconds = step})));
      std::vector<LabelMap> maps;
      Progress progress;
      const SeriesTimes times = readLabelSeries(file, progress, [&](std::size_t phase, LabelMap&& map) {
        EXPECT_EQ(phase, maps.size());
        maps.push_back(std::move(map));
      });
      ASSERT_EQ(maps.size(), 3U);
      expectOrgans(maps[0], liverAndTumour());
      expectOrgans(maps[1], larger);
      EXPECT_TRUE(maps[2].segments.empty());
      EXPECT_EQ(maps[2].size, maps[0].size);
      EXPECT_EQ(times.seconds, step > 0 ? (std::vector<double>{0, 0.25, 0.5}) : std::vector<double>());
      EXPECT_EQ(times.periodSeconds.has_value(), step > 0);
      EXPECT_NEAR(times.periodSeconds.value_or(0.75), 0.75, 1e-9);
    }
}

TEST_F(DicomSegments, OfOneInstantAreNoSeries) {
  const auto file = folder_.put("a.dcm", tests::dicomBytes(tests::segmentationElements(
                                             liverAndTumour(), {.names = {{1, "Liver"}, {2, "Tumour"}}})));
  Progress progress;
  EXPECT_THROW(readLabelSeries(file, progress, [](std::size_t, LabelMap&&) {}), DataError);
}

TEST_F(DicomSegments, AreReadFromALabelMapWhoseBackgroundIsItsPadding) {
  const LabelImage image = liverAndTumour();
  const std::string bytes = tests::dicomBytes(tests::segmentationElements(
      image, {.type = "LABELMAP", .bits = 8, .background = 255, .names = {{1, "Liver"}, {2, "Tumour"}}}));
  expectOrgans(read(bytes), image);
}

TEST_F(DicomSegments, AreReadFromPackedMasks) {
  const LabelImage image = liverAndTumour();
  const SegmentWriting writing{.names = {{1, "Liver"}, {2, "Tumour"}}};
  for (const bool byteEach : {false, true})
    expectOrgans(read(tests::rleBits(image, writing, byteEach)), image);
  for (const int inside : {1, 255}) {
    SegmentWriting fractional = writing;
    fractional.type = "FRACTIONAL";
    fractional.bits = 8;
    fractional.inside = inside;
    const std::string plain = tests::dicomBytes(tests::segmentationElements(image, fractional));
    const LabelMap map = read(tests::packedDicom(plain, "rle"));
    expectOrgans(map, image);
    EXPECT_EQ(map.warnings.size(), inside == 1 ? 1U : 0U) << "ones of 255 are masks";
  }
  SegmentWriting bytes = writing; // As a library for browsers writes them.
  bytes.bits = 8;
  expectOrgans(read(tests::packedDicom(tests::dicomBytes(tests::segmentationElements(image, bytes)), "rle")),
               image);
}

TEST_F(DicomSegments, WithDamagedPacksAreRefused) {
  const LabelImage image = liverAndTumour();
  std::string bytes = tests::rleBits(image, {.names = {{1, "Liver"}, {2, "Tumour"}}}, false);
  bytes.resize(bytes.size() - 40);
  EXPECT_THROW(read(bytes), DataError);
  bytes = tests::rleBits(image, {.names = {{1, "Liver"}}}, false);
  const std::size_t frame = bytes.rfind(tests::littleEndian(1, 4) + tests::littleEndian(64, 4));
  bytes[frame + 64] = '\x7F'; // The length of a run.
  EXPECT_THROW(read(bytes), DataError);
}

TEST_F(DicomSegments, HaveNamesOfEveryCharacterSet) {
  const auto nameIn = [&](const std::string& set, const std::string& name) {
    return read(tests::dicomBytes(tests::segmentationElements(
                    liverAndTumour(), {.names = {{1, name}, {2, "Tumour"}}, .characterSet = set})))
        .segments.at(0)
        .name;
  };
  EXPECT_EQ(nameIn("\\ISO 2022 IR 87", "\x1B$B4NB!\x1B(B"), "肝臓");
  EXPECT_EQ(nameIn("ISO 2022 IR 87", "\x1B$B4NB!\x1B(B"), "肝臓") << "without the set to begin with";
  EXPECT_EQ(nameIn("", "\x1B$B?UB!\x1B(B"), "腎臓") << "said by its escape sequences alone";
  EXPECT_EQ(nameIn("ISO 2022 IR 13\\ISO 2022 IR 87", "\xB6\xDD \x1B$B4N\x1B(J"), "ｶﾝ 肝");
  EXPECT_EQ(nameIn("ISO_IR 13", "\xB6\xDD"), "ｶﾝ");
  EXPECT_EQ(nameIn("\\ISO 2022 IR 149", "\x1B$)C\xB0\xA3"), "간");
  EXPECT_EQ(nameIn("ISO 2022 IR 149", "\xB0\xA3"), "간") << "without its escape sequence";
  EXPECT_EQ(nameIn("\\ISO 2022 IR 58", "\x1B$)A\xB8\xCE\xD4\xE0"), "肝脏");
  EXPECT_EQ(nameIn("GB18030", "\xB8\xCE\xD4\xE0"), "肝脏");
  EXPECT_EQ(nameIn("ISO_IR 100", "h\xEDgado"), "hígado");
  EXPECT_EQ(nameIn("ISO_IR 192", "肝臓"), "肝臓");
  EXPECT_EQ(nameIn("", "肝臓"), "肝臓") << "it is UTF-8, and says nothing";
  EXPECT_EQ(nameIn("", "Li\x1B[31mver\x07"), "Li31mver") << "commands of a terminal";
  EXPECT_EQ(nameIn("ISO_IR 192", "Li\xC2\x9Bver"), "Liver") << "C1";
}

} // namespace
} // namespace viscera::medical_io
