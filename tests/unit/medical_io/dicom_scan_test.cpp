#include <algorithm>
#include <cstdlib>
#include <functional>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "dicom_slices.h"
#include "packed_dicom.h"
#include "phantom_scan.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/scan.h"

namespace viscera::medical_io {
namespace {

using testing::HasSubstr;
using tests::DicomElements;
using tests::LabelImage;
using Kind = ScanFinding::Kind;
using Change = std::function<void(DicomElements&, int k)>;

/// The phantom, looked at from the feet, ten slices of 4 mm.
LabelImage smallPhantom() {
  LabelImage image = tests::orientedPhantomGrid(0, {0, 1, 2});
  tests::fillPhantom(image);
  return image;
}

class DicomScan : public testing::Test {
protected:
  /// Writes the image's slices but for those `left`, each changed by `change`.
  void write(const LabelImage& image, const std::vector<int>& left = {}, const Change& change = {},
             const std::string& series = "1.2.3.4", const std::string& prefix = "slice") {
    for (int k = 0; k < image.size[2]; ++k) {
      if (std::find(left.begin(), left.end(), k) != left.end())
        continue;
      DicomElements elements = tests::dicomSlice(image, k, series);
      if (change)
        change(elements, k);
      folder_.put(prefix + std::to_string(k + 1) + ".dcm", tests::dicomBytes(elements));
    }
  }
  Scan read(const ScanOptions& options = {}) { return readScan(folder_.path(), options, progress_); }

  static int count(const Scan& scan, Kind kind) {
    return int(std::count_if(scan.findings.begin(), scan.findings.end(),
                             [&](const ScanFinding& f) { return f.kind == kind; }));
  }
  static std::string sentences(const Scan& scan) {
    std::string all;
    for (const ScanFinding& finding : scan.findings)
      all += finding.sentence.english() + '\n';
    return all;
  }

  tests::TemporaryFolder folder_;
  Progress progress_;
};

/// Every marker at its place, and the ramp between voxels.
void expectPhantom(const Scan& scan, const LabelImage& image) {
  int seen = 0;
  for (const tests::ScanMarker& marker : tests::scanMarkers()) {
    const Vec3 index = (image.indexToLps.inverse() * marker.lps).array().round();
    const Vec3 center = image.indexToLps * index;
    ASSERT_TRUE(scan.at(center).has_value());
    EXPECT_NEAR(*scan.at(center), marker.value, 0.1);
    ++seen;
  }
  EXPECT_EQ(seen, 4);
  for (const Vec3& lps : {Vec3(-9.5, 3.25, -14), Vec3(10.125, -20.5, -6.75)})
    EXPECT_NEAR(scan.at(lps).value_or(-1e9), tests::phantomValue(lps), 0.55);
  EXPECT_FALSE(scan.at(Vec3(0, 0, 400)).has_value());
}

TEST_F(DicomScan, ReadsThePhantomInAllOrientations) {
  for (const auto& [name, image] : tests::orientedPhantoms()) {
    SCOPED_TRACE(name);
    write(image);
    const Scan scan = read();
    expectPhantom(scan, image);
    EXPECT_EQ(count(scan, Kind::order) + int(scan.findings.size()), 0) << sentences(scan);
    for (int k = 0; k < image.size[2]; ++k)
      std::filesystem::remove(folder_ / ("slice" + std::to_string(k + 1) + ".dcm"));
  }
}

TEST_F(DicomScan, SaysWhoseItIsAndOfWhenWhereTheFilesDo) {
  write(smallPhantom(), {}, [](DicomElements& elements, int) { elements.erase(0x00100010); });
  EXPECT_EQ(read().patientName + read().studyDate, "");
  for (const auto& [written, name] : {std::pair("PNDoe^Jane^Mary^Dr", "Doe, Jane Mary Dr"),
                                      std::pair("PNDoe", "Doe"), std::pair("PNDoe^^^Dr=x^y", "Doe, Dr")}) {
    write(smallPhantom(), {}, [&who = written](DicomElements& elements, int) {
      elements[0x00100010] = who;
      elements[0x00080020] = "DA20240301";
    });
    const Scan scan = read();
    EXPECT_EQ(scan.patientName, name);
    EXPECT_EQ(scan.studyDate, "20240301");
  }
}

TEST_F(DicomScan, SaysWhatTheHeadersSay) {
  write(smallPhantom());
  const Scan scan = read();
  EXPECT_EQ(scan.modality, "CT");
  EXPECT_EQ(scan.unit, "HU");
  EXPECT_EQ(scan.description, "Abdomen 5.0");
  EXPECT_EQ(scan.slope, 1);
  EXPECT_EQ(scan.intercept, -1024);
  ASSERT_TRUE(scan.window.has_value());
  EXPECT_EQ(scan.window->level, 40);
  EXPECT_EQ(scan.window->width, 400);
  EXPECT_NEAR(scan.spacing().z(), 4, 1e-9) << "by positions, not by the thickness of 99 mm";
  EXPECT_TRUE(isScan(folder_.path()));
  EXPECT_TRUE(isScan(folder_ / "slice3.dcm"));
  EXPECT_FALSE(isLabelMap(folder_ / "slice3.dcm"));
  EXPECT_EQ(fileKind(folder_ / "slice3.dcm"), FileKind::scan);
  EXPECT_EQ(readScan(folder_ / "slice3.dcm", {}, progress_).size, scan.size);
}

TEST_F(DicomScan, OrdersShuffledFilesByPosition) {
  const LabelImage image = smallPhantom();
  std::mt19937 random(7);
  std::vector<int> names(std::size_t(image.size[2]));
  for (std::size_t i = 0; i < names.size(); ++i)
    names[i] = int(i);
  std::shuffle(names.begin(), names.end(), random);
  for (int k = 0; k < image.size[2]; ++k) {
    DicomElements elements = tests::dicomSlice(image, k);
    elements[0x00200013] = "IS" + std::to_string(names[std::size_t(k)]); // The numbers lie, too.
    folder_.put("im" + std::to_string(names[std::size_t(k)]), tests::dicomBytes(elements));
  }
  const Scan scan = read();
  expectPhantom(scan, image);
  EXPECT_EQ(count(scan, Kind::order), 1);
}

TEST_F(DicomScan, NamesMissingSlicesAndTakesTheLongestEvenPart) {
  write(smallPhantom(), {11, 12});
  const Scan scan = read();
  ASSERT_EQ(count(scan, Kind::missingSlice), 1) << sentences(scan);
  EXPECT_THAT(sentences(scan),
              HasSubstr("2 slices are missing between slice 11 (z = 4 mm) and the next, which "
                        "are 12 mm apart in place of 4 mm"));
  EXPECT_THAT(scan.findings.front().sentence.english(),
              HasSubstr("11 of 15 slices were read, slices 1 to 11"));
  EXPECT_EQ(scan.findings.front().kind, Kind::partRead);
  EXPECT_EQ(scan.size[2], 11);
  EXPECT_NEAR(scan.at(Vec3(-9.5, 3.25, -14)).value_or(0), tests::phantomValue({-9.5, 3.25, -14}), 0.55);
  EXPECT_FALSE(scan.at(Vec3(0, 0, 20)).has_value()) << "nothing is stretched";
}

/// As many head CTs are: fine slices at the base of the skull, coarse ones above.
TEST_F(DicomScan, ReadsEachEvenPartOrAllSlicesResampled) {
  const LabelImage image = smallPhantom();
  const double fine = 4.22, coarse = 7.38;
  std::vector<double> heights;
  for (int k = 0; k < image.size[2]; ++k)
    heights.push_back(-36 + (k < 9 ? fine * k : fine * 8 + coarse * (k - 8)));
  write(image, {}, [&](DicomElements& elements, int k) {
    elements[0x00200032] = "DS" + tests::decimals(Vec3(-21, -36, heights[std::size_t(k)]));
  });
  const auto depth = [&](const std::string& series) { return read({series, 0}).size[2]; };
  const Scan first = read();
  EXPECT_EQ(first.findings.front().sentence.english().find("9 of 17 slices"), 0U) << sentences(first);
  EXPECT_EQ(first.size[2], 9);
  EXPECT_EQ(depth("@2"), 9) << "the parts share the slice at which they meet";
  const std::vector<ScanSeries> list = listScans(folder_.path(), progress_);
  ASSERT_EQ(list.size(), 3U);
  EXPECT_EQ(list[1].id, "1.2.3.4@2");
  EXPECT_EQ(list[1].slices.first, 9);
  EXPECT_EQ(list[1].slices.all, 17);
  EXPECT_NEAR(list[1].spacing.z(), coarse, 1e-6);
  EXPECT_TRUE(list[2].slices.resampled);
  EXPECT_THROW(read({"@3", 0}), UsageError);
  const Scan all = read({"@all", 0});
  EXPECT_EQ(all.findings.front().kind, Kind::resampled);
  EXPECT_NEAR(all.spacing().z(), fine, 1e-6);
  EXPECT_EQ(all.size, list[2].size);
  const double top = all.indexToLps.translation().z() + fine * (all.size[2] - 1);
  EXPECT_NEAR(top, heights.back(), fine / 2 + 1e-6) << "it reaches as far as the slices";
  // Measured slices stay as they are; between coarse ones, values are mixed by the distance.
  for (int k = 0; k < 9; ++k)
    EXPECT_EQ(all.value(7, 5, k), first.value(7, 5, k)) << k;
  for (int k = 9; k < all.size[2]; ++k) {
    const double z = std::min(-36 + fine * k, heights.back());
    const auto above = std::upper_bound(heights.begin(), heights.end() - 1, z);
    const auto slice = std::size_t(above - heights.begin());
    const double part = (z - heights[slice - 1]) / (heights[slice] - heights[slice - 1]);
    const auto at = [&](std::size_t s) { return double(image.voxels[first.indexOf(7, 5, 0) + s * 21 * 23]); };
    EXPECT_NEAR(all.value(7, 5, k), (1 - part) * at(slice - 1) + part * at(slice), 0.51) << k;
  }
}

TEST_F(DicomScan, DoesNotResampleSlicesThatAreShiftedSideways) {
  write(smallPhantom(), {}, [](DicomElements& elements, int k) {
    elements[0x00200032] = "DS" + tests::decimals(Vec3(-21 + (k > 8 ? 5 : 0), -36, -36 + 4 * k));
  });
  const std::vector<ScanSeries> list = listScans(folder_.path(), progress_);
  EXPECT_EQ(list.size(), 2U) << "two even parts, and no grid of both";
  EXPECT_FALSE(list.back().slices.resampled);
}

TEST_F(DicomScan, SaysWhatIsTakenForASizeOfPixelsThatIsNotThere) {
  const LabelImage image = smallPhantom();
  write(image, {}, [](DicomElements& e, int) {
    e.erase(0x00280030);
    e[0x00181100] = "DS92";
  });
  const Scan scan = read();
  EXPECT_NEAR(scan.spacing().x(), 4, 1e-9) << "92 mm on 23 pixels";
  EXPECT_THAT(sentences(scan), HasSubstr("does not say how large its pixels are; 4 mm"));
}

TEST_F(DicomScan, NamesUnevenSpacingAboveOnePercent) {
  const auto shifted = [](double mm) {
    return [mm](DicomElements& elements, int k) {
      if (k >= 10)
        elements[0x00200032] = "DS" + tests::decimals(Vec3(-21, -36, -36 + 4 * k + mm));
    };
  };
  write(smallPhantom(), {}, shifted(0.03));
  EXPECT_EQ(count(read(), Kind::unevenSpacing), 0);
  write(smallPhantom(), {}, shifted(0.5));
  const Scan scan = read();
  ASSERT_EQ(count(scan, Kind::unevenSpacing), 1);
  EXPECT_THAT(sentences(scan), HasSubstr("4.5 mm apart in place of 4 mm (12.5 %)"));
  EXPECT_EQ(scan.size[2], 10);
}

TEST_F(DicomScan, NamesDoubledSlicesAndCopies) {
  const LabelImage image = smallPhantom();
  write(image);
  DicomElements again = tests::dicomSlice(image, 4);
  folder_.put("copy.dcm", tests::dicomBytes(again));
  again[0x00080018] = "UI1.2.3.4.99";
  again[0x00200013] = "IS99";
  again[0x7FE00010] = "OW" + std::string(again[0x7FE00010].size() - 2, '\0');
  folder_.put("double.dcm", tests::dicomBytes(again));
  const Scan scan = read();
  expectPhantom(scan, image);
  EXPECT_EQ(count(scan, Kind::doubledSlice), 2) << sentences(scan);
  EXPECT_THAT(sentences(scan), HasSubstr("z = -20 mm"));
  EXPECT_THAT(sentences(scan), HasSubstr("1 file is a copy"));
}

TEST_F(DicomScan, KeepsAGantrysTiltAsShear) {
  LabelImage image = smallPhantom();
  const double degrees = 15;
  image.indexToLps.linear().col(2) += Vec3(0, 4 * std::tan(degrees * M_PI / 180), 0);
  tests::fillPhantom(image);
  write(image);
  const Scan scan = read();
  expectPhantom(scan, image);
  ASSERT_EQ(count(scan, Kind::tilt), 1);
  EXPECT_THAT(sentences(scan), HasSubstr("tilted by 15 degrees"));
  EXPECT_LT((scan.indexToLps.matrix() - image.indexToLps.matrix()).norm(), 1e-6);
}

TEST_F(DicomScan, ListsSeveralSeriesAndReadsTheLargest) {
  const LabelImage image = smallPhantom();
  write(image);
  LabelImage localizer = tests::orientedPhantomGrid(0, {1, 2, 0});
  localizer.size[2] = 2;
  localizer.voxels.assign(std::size_t(23 * 17 * 2), 5);
  write(
      localizer, {}, [](DicomElements& e, int) { e[0x0008103E] = "LOTopogram"; }, "1.2.3.5", "topo");
  const std::vector<ScanSeries> list = listScans(folder_.path(), progress_);
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0].id, "1.2.3.4");
  EXPECT_EQ(list[0].size, image.size);
  EXPECT_EQ(list[0].files.size(), 17U);
  EXPECT_EQ(list[1].description, "Topogram");
  EXPECT_EQ(list[1].size[2], 2);
  EXPECT_EQ(read().size, image.size);
  EXPECT_EQ(read({"1.2.3.5", 0}).description, "Topogram");
  EXPECT_EQ(readScan(folder_ / "topo1.dcm", {}, progress_).description, "Topogram");
  EXPECT_THROW(read({"9.9", 0}), UsageError);
  EXPECT_THROW(read({"", 1}), UsageError);
}

TEST_F(DicomScan, NamesPicturesOfAnotherSizeInASeries) {
  const LabelImage image = smallPhantom();
  write(image);
  LabelImage other = tests::orientedPhantomGrid(0, {1, 0, 2});
  tests::fillPhantom(other);
  other.size[2] = 1;
  write(
      other, {}, [](DicomElements& e, int) { e[0x00080018] = "UI1.2.3.4.77"; }, "1.2.3.4", "other");
  const Scan scan = read();
  expectPhantom(scan, image);
  ASSERT_EQ(count(scan, Kind::mixedSizes), 1);
  EXPECT_THAT(sentences(scan), HasSubstr("1 image of 23 x 21 left out, those of 21 x 23 read"));
  EXPECT_EQ(listScans(folder_.path(), progress_)[1].id, "1.2.3.4#2");
}

TEST_F(DicomScan, TellsPhasesByPositionTriggerOrTime) {
  const LabelImage image = smallPhantom();
  const auto phase = [&](std::uint32_t tag, const std::string& first, const std::string& second) {
    for (int p = 0; p < 2; ++p)
      write(
          image, {},
          [&](DicomElements& e, int k) {
            e[tag] = p == 0 ? first : second;
            e[0x00080018] = "UI1.2.3.4." + std::to_string(100 * p + k);
            e[0x00281052] = "DS" + tests::decimal(-1024 + 500 * p);
          },
          "1.2.3.4", p == 0 ? "early" : "late");
    const Scan early = read(), late = read({"", 1});
    EXPECT_EQ(early.phaseTimesMs.size(), 2U);
    EXPECT_EQ(late.phase, 1);
    EXPECT_EQ(late.size, image.size);
    EXPECT_NEAR(late.at(Vec3(0, 0, 0)).value_or(0) - early.at(Vec3(0, 0, 0)).value_or(0), 500, 1e-9);
    EXPECT_EQ(listScans(folder_.path(), progress_)[0].phases, 2);
    return early.phaseTimesMs.back();
  };
  EXPECT_EQ(phase(0x00200100, "IS1", "IS2"), 1) << "numbered";
  EXPECT_EQ(phase(0x00181060, "DS10", "DS410"), 400) << "by the trigger, ms";
  EXPECT_EQ(phase(0x00080032, "TM120000.500", "TM120002"), 1500) << "by the time of acquisition";
}

TEST_F(DicomScan, MasksAndSignExtendsStoredBits) {
  // 12 bits with a sign, their upper four bits full of rubbish.
  LabelImage image = smallPhantom();
  for (std::int16_t& voxel : image.voxels)
    voxel = std::clamp<std::int16_t>(voxel, -2000, 2004);
  write(image, {}, [&](DicomElements& e, int k) {
    std::string pixels = "OW";
    const std::size_t slice = std::size_t(image.size[0] * image.size[1]);
    for (std::size_t p = 0; p < slice; ++p)
      pixels += tests::littleEndian((std::uint64_t(image.voxels[std::size_t(k) * slice + p]) & 0xFFFU) |
                                        std::uint64_t(p % 16) << 12U,
                                    2);
    e[0x7FE00010] = pixels;
    e[0x00280101] = tests::us(12);
    e[0x00280102] = tests::us(11);
    e[0x00280103] = tests::us(1);
    e[0x00281052] = "DS0";
  });
  const Scan scan = read();
  expectPhantom(scan, image);
  EXPECT_TRUE(std::holds_alternative<std::vector<std::int16_t>>(scan.samples));
}

TEST_F(DicomScan, KeepsPaddingOutOfValues) {
  LabelImage image = smallPhantom();
  image.at(3, 3, 3) = std::int16_t(-1024 + 7); // Stored as 7.
  write(image, {}, [](DicomElements& e, int) { e[0x00280120] = tests::us(7); });
  const Scan scan = read();
  ASSERT_EQ(scan.padding, 7.0);
  EXPECT_FALSE(scan.at(image.indexToLps * Vec3(3, 3, 3)).has_value());
  EXPECT_TRUE(scan.at(image.indexToLps * Vec3(3, 3, 4)).has_value());
  EXPECT_GT(scan.range()[0], -1000);
}

TEST_F(DicomScan, AppliesASlopeThatDiffersFromSliceToSlice) {
  const LabelImage image = smallPhantom();
  write(image, {}, [&](DicomElements& e, int k) {
    // Twice the slope on half the numbers.
    if (k % 2 == 0)
      return;
    std::string& pixels = e[0x7FE00010];
    for (std::size_t b = 2; b + 1 < pixels.size(); b += 2) {
      const int stored =
          int(static_cast<unsigned char>(pixels[b])) | int(static_cast<unsigned char>(pixels[b + 1])) << 8;
      const std::string half = tests::littleEndian(std::uint64_t((stored - 1024) + 2000) / 2 * 2 / 2, 2);
      pixels.replace(b, 2, half);
    }
    e[0x00281053] = "DS2";
    e[0x00281052] = "DS-2000";
  });
  const Scan scan = read();
  EXPECT_TRUE(std::holds_alternative<std::vector<float>>(scan.samples));
  for (const Vec3& lps : {Vec3(-9.5, 3.25, -14), Vec3(10.125, -20.5, -6.75)})
    EXPECT_NEAR(scan.at(lps).value_or(-1e9), tests::phantomValue(lps), 1.6);
}

TEST_F(DicomScan, ReadsEnhancedFiles) {
  const LabelImage image = smallPhantom();
  DicomElements e = tests::enhancedDicom(image);
  const auto file = folder_.put("enhanced.dcm", tests::dicomBytes(e));
  expectPhantom(readScan(file, {}, progress_), image);
  e[0x00280008] = "IS" + std::to_string(image.size[2] + 1);
  folder_.put("enhanced.dcm", tests::dicomBytes(e));
  EXPECT_THROW(readScan(file, {}, progress_), DataError);
}

class PackedDicomScan : public DicomScan, public testing::WithParamInterface<std::string> {};

TEST_P(PackedDicomScan, HasTheValuesOfTheUnpackedOne) {
  const LabelImage image = smallPhantom();
  for (int k = 0; k < image.size[2]; ++k) {
    DicomElements e = tests::dicomSlice(image, k);
    e[0x00280101] = tests::us(12);
    e[0x00280102] = tests::us(11);
    folder_.put(std::to_string(k), tests::packedDicom(tests::dicomBytes(e), GetParam()));
  }
  testing::internal::CaptureStderr();
  const Scan scan = read();
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  if (GetParam() != "jpeg") {
    expectPhantom(scan, image);
    return;
  }
  // With loss.
  double difference = 0;
  for (int i = 0; i < image.size[0]; ++i)
    difference += std::abs(scan.value(i, 5, 5) - image.voxels[scan.indexOf(i, 5, 5)]) / image.size[0];
  EXPECT_LT(difference, 15);
}

INSTANTIATE_TEST_SUITE_P(AsOthersPackIt, PackedDicomScan,
                         testing::Values("rle", "jpeg-lossless", "jpeg-ls", "jpeg", "jpeg-2000", "deflated",
                                         "big-endian"),
                         [](const auto& instance) {
                           std::string name = instance.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// Some writers pack 8 of 16 bits as a picture of bytes.
TEST_F(DicomScan, WidensThePackedBytesOfPixelsOfTwoBytes) {
  LabelImage image = smallPhantom();
  const std::size_t slice = std::size_t(image.size[0] * image.size[1]);
  for (std::size_t v = 0; v < image.voxels.size(); ++v)
    image.voxels[v] = std::int16_t(v * v % 251);
  const std::string eight("\x28\0\0\1US\2\0\x08", 9);
  for (int k = 0; k < image.size[2]; ++k) {
    DicomElements e = tests::dicomSlice(image, k);
    e[0x7FE00010] = "OB";
    for (std::size_t p = 0; p < slice; ++p)
      e[0x7FE00010] += char(image.voxels[std::size_t(k) * slice + p]);
    e[0x00280100] = e[0x00280101] = tests::us(8);
    e[0x00280102] = tests::us(7);
    e[0x00281052] = "DS0";
    std::string packed = tests::packedDicom(tests::dicomBytes(e), "jpeg-lossless");
    ASSERT_NE(packed.find(eight), packed.npos);
    packed[packed.find(eight) + eight.size() - 1] = 16; // Bits allocated.
    folder_.put(std::to_string(k), packed);
  }
  const Scan scan = read();
  ASSERT_EQ(scan.size, image.size);
  int wrong = 0;
  for (int k = 0; k < image.size[2]; ++k)
    for (int j = 0; j < image.size[1]; ++j)
      for (int i = 0; i < image.size[0]; ++i)
        wrong += scan.at(image.indexToLps * Vec3(i, j, k)) != double(image.at(i, j, k)) ? 1 : 0;
  EXPECT_EQ(wrong, 0);
}

/// DCMTK waits for ever at such a marker (FF 01) where it looks for the frame header.
TEST_F(DicomScan, RefusesJpegStreamsWithoutAFrameHeader) {
  const std::string begin("\xFF\xD8\xFF"), endless("\xFF\x01\0", 3);
  for (const char* packing : {"jpeg", "jpeg-lossless"}) {
    SCOPED_TRACE(packing);
    std::string packed = tests::packedDicom(tests::dicomBytes(tests::dicomSlice(smallPhantom(), 0)), packing);
    ASSERT_NE(packed.find(begin), packed.npos);
    folder_.put("0", packed.replace(packed.find(begin), endless.size(), endless));
    try {
      read();
      FAIL();
    } catch (const DataError& error) {
      EXPECT_THAT(error.what(), HasSubstr("it has no frame header"));
    }
  }
}

TEST_F(DicomScan, RefusesWhatIsNoScan) {
  EXPECT_THROW(read(), DataError) << "an empty folder";
  EXPECT_THROW(readScan(folder_ / "none", {}, progress_), NoInputError);
  write(smallPhantom(), {}, [](DicomElements& e, int) { e[0x00280004] = "CSRGB"; });
  try {
    read();
    FAIL();
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr("is a colour image"));
  }
  folder_.put("DICOMDIR", std::string(128, '\0') + "DICM");
}

TEST_F(DicomScan, RefusesMosaicsAndPixelsThatAreFractionsWithWhatToTry) {
  const auto reason = [&]() -> std::string {
    try {
      read();
    } catch (const DataError& error) {
      return error.what();
    }
    return "was read";
  };
  write(smallPhantom(), {}, [](DicomElements& e, int) { e[0x00080008] = "CSORIGINAL\\PRIMARY\\M\\MOSAIC"; });
  EXPECT_THAT(reason(), HasSubstr("is a mosaic of many slices"));
  EXPECT_THAT(reason(), HasSubstr("dcm2niix"));
  write(smallPhantom(), {}, [](DicomElements& e, int) {
    e.erase(0x7FE00010);
    e[0x7FE00008] = "UN" + std::string(std::size_t(21 * 23 * 4), '\0');
  });
  EXPECT_THAT(reason(), HasSubstr("pixels that are fractions"));
}

TEST_F(DicomScan, LeavesOutADamagedFileAndSaysSo) {
  const LabelImage image = smallPhantom();
  write(image);
  const std::string whole = tests::contentsOf(folder_ / "slice1.dcm");
  folder_.put("slice1.dcm", whole.substr(0, 700));
  const Scan scan = read();
  EXPECT_EQ(count(scan, Kind::damaged), 1) << sentences(scan);
  EXPECT_EQ(scan.size[2], image.size[2] - 1);
  folder_.put("slice1.dcm", whole.substr(0, whole.size() - 100));
  EXPECT_EQ(count(read(), Kind::damaged), 1) << "its pixels end too early";
  EXPECT_THROW(readScan(folder_ / "slice1.dcm", {}, progress_), DataError);
}

/// Lets this process open no more than `count` further files while it lives.
class FewFiles {
public:
  explicit FewFiles(int count) {
    ::getrlimit(RLIMIT_NOFILE, &before_);
    const int next = ::dup(STDERR_FILENO);
    ::close(next);
    rlimit few = before_;
    few.rlim_cur = rlim_t(next + count);
    ::setrlimit(RLIMIT_NOFILE, &few);
  }
  ~FewFiles() { ::setrlimit(RLIMIT_NOFILE, &before_); }
  FewFiles(const FewFiles&) = delete;
  FewFiles& operator=(const FewFiles&) = delete;

private:
  rlimit before_{};
};

TEST_F(DicomScan, OfAFolderThatCannotBeListedToItsEndIsRejectedInsteadOfShortened) {
  std::filesystem::create_directory(folder_ / "series");
  write(smallPhantom(), {}, {}, "1.2.3.4", "series/slice");
  {
    const FewFiles onlyTheOuterFolder(1);
    try {
      read();
      FAIL() << "the inner folder could be listed";
    } catch (const NoInputError& error) {
      EXPECT_EQ(error.where().english(), folder_.path().string());
      EXPECT_THAT(error.what(), HasSubstr("It cannot be opened"));
    }
  }
  EXPECT_EQ(read().size[2], smallPhantom().size[2]);
}

/// Another program takes away a file, or writes half of it, after all headers have been read.
TEST_F(DicomScan, NamesASliceThatVanishesOrIsCutOffBetweenItsHeaderAndItsPixels) {
  const LabelImage image = smallPhantom();
  write(image);
  const std::filesystem::path file = folder_ / "slice4.dcm";
  const std::string whole = tests::contentsOf(file);
  for (const bool vanishes : {true, false}) {
    int headers = 0;
    Progress progress([&](double, const Text& step) {
      if (step.english() != "headers" || ++headers < image.size[2])
        return;
      if (vanishes)
        std::filesystem::remove(file);
      else
        folder_.put("slice4.dcm", whole.substr(0, whole.size() / 2));
    });
    try {
      readScan(folder_.path(), {}, progress);
      FAIL() << "the scan has a hole";
    } catch (const DataError& error) {
      EXPECT_EQ(error.where().english(), file.string());
      EXPECT_THAT(error.what(),
                  testing::AllOf(HasSubstr("A slice cannot be read"), HasSubstr("take it out")));
    }
    EXPECT_EQ(headers, image.size[2]);
    folder_.put("slice4.dcm", whole);
    EXPECT_EQ(read().size[2], image.size[2]) << "the others are as they were";
  }
}

} // namespace
} // namespace viscera::medical_io
