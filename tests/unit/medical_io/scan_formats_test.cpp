#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "packed_bytes.h"
#include "phantom_scan.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/image_file.h"
#include "viscera/medical_io/scan.h"

namespace viscera::medical_io {
namespace {

using tests::LabelImage;

class ScanFormats : public testing::Test {
protected:
  Scan read(const std::string& name, const std::string& bytes, const ScanOptions& options = {}) {
    return readScan(folder_.put(name, bytes), options, progress_);
  }

  tests::TemporaryFolder folder_;
  Progress progress_;
};

/// Every voxel, every marker at its place in the patient, and values between voxels.
void expectPhantom(const Scan& scan, const LabelImage& image, const std::string& what) {
  SCOPED_TRACE(what);
  ASSERT_EQ(scan.size, image.size);
  EXPECT_LT((scan.indexToLps.matrix() - image.indexToLps.matrix()).cwiseAbs().maxCoeff(), 1e-4);
  const Vec3 size(scan.size[0], scan.size[1], scan.size[2]);
  for (const tests::ScanMarker& marker : tests::scanMarkers()) {
    const Vec3 index = (image.indexToLps.inverse() * marker.lps).array().round();
    if (((index.array() < 0) || (index.array() >= size.array())).any())
      continue;
    const Vec3 center = image.indexToLps * index;
    ASSERT_LE((center - marker.lps).norm(), 0.5 * 4 * std::sqrt(3.0));
    ASSERT_TRUE(scan.at(center).has_value());
    EXPECT_NEAR(*scan.at(center), marker.value, 1e-2);
  }
  // Two voxels from any marker the ramp is interpolated exactly but for the rounding of values.
  for (const Vec3& lps : {Vec3(-9.5, 3.25, -14), Vec3(10.125, -20.5, -6.75)})
    EXPECT_NEAR(scan.at(lps).value_or(-1e9), tests::phantomValue(lps), 0.51);
  EXPECT_FALSE(scan.at(Vec3(0, 0, 400)).has_value());
}

TEST_F(ScanFormats, ReadThePhantomInAllOrientationsFromNiftiNrrdAndMetaImage) {
  for (const auto& [name, image] : tests::orientedPhantoms()) {
    expectPhantom(read("a.nii", tests::niftiFile(image)), image, name + " as NIfTI by the sform");
    expectPhantom(read("b.nii.gz", tests::gzipped(tests::niftiFile(image, tests::NiftiForm::qform))), image,
                  name + " as packed NIfTI by the qform");
    expectPhantom(read("c.nrrd", tests::nrrdFile(image)), image, name + " as NRRD");
    expectPhantom(read("d.nrrd", tests::nrrdFile(image, "right-anterior-superior")), image,
                  name + " as NRRD in RAS");
    expectPhantom(read("e.mha", tests::metaImageFile(image)), image, name + " as MetaImage");
  }
}

/// A NIfTI file of any scalar type: the header of one of shorts, with other values behind it.
template <typename T>
std::string niftiOf(const std::vector<T>& values, std::int16_t type, std::array<int, 3> size) {
  LabelImage image = tests::emptyLabels(size);
  std::string bytes = tests::niftiFile(image);
  bytes.resize(bytes.size() - image.voxels.size() * sizeof(std::int16_t));
  tests::putBytes<std::int16_t>(bytes, 70, type);
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  return bytes;
}

TEST_F(ScanFormats, KeepAnyScalarType) {
  const auto samples = [&]<typename T>(T low, T high, std::int16_t type) {
    const Scan scan = read("a.nii", niftiOf<T>({low, 0, 1, high}, type, {2, 2, 1}));
    EXPECT_EQ(scan.value(0, 0, 0), double(low)) << type;
    EXPECT_EQ(scan.value(1, 1, 0), double(high)) << type;
    EXPECT_EQ(scan.range()[1], double(high)) << type;
    return scan;
  };
  EXPECT_TRUE(std::holds_alternative<std::vector<std::uint8_t>>(
      samples(std::uint8_t(3), std::uint8_t(255), 2).samples));
  EXPECT_TRUE(std::holds_alternative<std::vector<std::int8_t>>(
      samples(std::int8_t(-128), std::int8_t(127), 256).samples));
  EXPECT_TRUE(std::holds_alternative<std::vector<std::uint16_t>>(
      samples(std::uint16_t(9), std::uint16_t(65535), 512).samples));
  EXPECT_TRUE(std::holds_alternative<std::vector<std::int32_t>>(
      samples(std::int32_t(-70000), std::int32_t(70000), 8).samples));
  EXPECT_TRUE(std::holds_alternative<std::vector<std::uint32_t>>(samples(1U, 4000000000U, 768).samples));
  EXPECT_TRUE(std::holds_alternative<std::vector<float>>(samples(-0.5F, 1e20F, 16).samples));
  EXPECT_TRUE(std::holds_alternative<std::vector<float>>(samples(-0.5, 1024.25, 64).samples));
  EXPECT_TRUE(std::holds_alternative<std::vector<std::int32_t>>(
      samples(std::int64_t(-5), std::int64_t(99), 1024).samples));
  const Scan wide = samples(std::int64_t(0), std::int64_t(1) << 40U, 1024);
  EXPECT_TRUE(std::holds_alternative<std::vector<float>>(wide.samples));
  EXPECT_THAT(wide.findings.back().sentence.english(), testing::HasSubstr("more than 32 bits"));
}

TEST_F(ScanFormats, ApplySlopeAndIntercept) {
  std::string bytes = niftiOf<std::int16_t>({0, 10, 20, 30}, 4, {2, 2, 1});
  tests::putBytes<float>(bytes, 112, 0.5F);
  tests::putBytes<float>(bytes, 116, -7.0F);
  const Scan scan = read("a.nii", bytes);
  EXPECT_EQ(scan.value(1, 1, 0), 8);
  EXPECT_EQ(scan.range()[0], -7);
}

TEST_F(ScanFormats, TreatWhatWasNotMeasuredAsNothing) {
  Scan scan = read("a.nii", niftiOf<float>({1, NAN, 3, 5}, 16, {4, 1, 1}));
  EXPECT_EQ(scan.range()[0], 1);
  EXPECT_EQ(scan.range()[1], 5);
  const auto at = [&](double i) { return scan.at(scan.indexToLps * Vec3(i, 0, 0)); };
  EXPECT_FALSE(at(1).has_value());
  EXPECT_EQ(at(0.2), 1.0) << "of the measured neighbours alone";
  EXPECT_EQ(at(2.5), 4.0);
  EXPECT_EQ(at(3.4), 5.0) << "up to the voxel's edge";
  EXPECT_FALSE(at(3.6).has_value());
  EXPECT_FALSE(at(-0.6).has_value());
  scan.padding = 3;
  EXPECT_FALSE(at(2).has_value());
}

TEST_F(ScanFormats, ReadOnePhaseOfSeveral) {
  LabelImage image = tests::emptyLabels({2, 2, 6}); // Three volumes of two slices.
  for (std::size_t v = 0; v < image.voxels.size(); ++v)
    image.voxels[v] = std::int16_t(v);
  std::string bytes = tests::niftiFile(image);
  tests::putBytes<std::int16_t>(bytes, 40, 4);
  tests::putBytes<std::int16_t>(bytes, 46, 2);
  tests::putBytes<std::int16_t>(bytes, 48, 3);
  tests::putBytes<float>(bytes, 92, 0.25F);
  bytes[123] = 2 | 8; // mm and seconds
  const Scan last = read("a.nii.gz", tests::gzipped(bytes), {"", 2});
  EXPECT_EQ(last.size[2], 2);
  EXPECT_EQ(last.value(0, 0, 0), 16);
  EXPECT_EQ(last.value(1, 1, 1), 23);
  EXPECT_EQ(last.phase, 2);
  EXPECT_EQ(last.phaseTimesMs, (std::vector<double>{0, 250, 500}));
  EXPECT_THROW(read("a.nii", bytes, {"", 3}), UsageError);
  EXPECT_EQ(listScans(folder_ / "a.nii.gz", progress_)[0].phases, 3);
  // 3D Slicer puts the phases of a voxel beside each other.
  LabelImage slicer = tests::emptyLabels({2, 2, 2});
  slicer.voxels.assign(24, 0);
  for (std::size_t v = 0; v < 24; ++v)
    slicer.voxels[v] = std::int16_t(v);
  const Scan second = read("b.seq.nrrd", tests::nrrdFile(slicer, "left-posterior-superior", {}, 3), {"", 1});
  EXPECT_EQ(second.value(0, 0, 0), 1);
  EXPECT_EQ(second.value(1, 1, 1), 22);
}

TEST_F(ScanFormats, RefuseColoursCutFilesAndOtherThings) {
  LabelImage image = tests::emptyLabels({2, 2, 2});
  image.voxels.assign(24, 0);
  std::string colours = tests::nrrdFile(image, "left-posterior-superior", {}, 3);
  colours.replace(colours.find("kinds: list"), 11, "kinds: RGB-color");
  EXPECT_THROW(read("a.nrrd", colours), DataError);
  image.voxels.resize(8);
  const std::string whole = tests::niftiFile(image);
  EXPECT_THROW(read("a.nii", whole.substr(0, whole.size() - 1)), DataError);
  EXPECT_THROW(read("a.nii.gz", tests::gzipped(whole.substr(0, whole.size() - 1))), DataError);
  EXPECT_THROW(read("a.stl", "solid a\nfacet normal 0 0 1\nendsolid a\n"), DataError);
  EXPECT_THROW(readScan(folder_ / "none.nii", {}, progress_), NoInputError);
  EXPECT_TRUE(isScan(folder_ / "a.nii"));
  EXPECT_FALSE(isScan(folder_ / "a.stl"));
  EXPECT_FALSE(isScan(folder_ / "a.seg.nrrd"));
}

TEST_F(ScanFormats, ProposeAWindow) {
  std::vector<std::int16_t> values(100 * 100);
  for (std::size_t v = 0; v < values.size(); ++v)
    values[v] = std::int16_t(v / 10); // 0 to 999
  values[77] = 30000;
  const Scan mr = read("a.nii", niftiOf(values, 4, {100, 100, 1}));
  EXPECT_NEAR(mr.firstWindow().level, 500, 3) << "between the 1st and the 99th percentile";
  EXPECT_NEAR(mr.firstWindow().width, 980, 5);
  values[5] = -1024;
  EXPECT_EQ(read("b.nii", niftiOf(values, 4, {100, 100, 1})).firstWindow().width, 400) << "like a CT's";
  const Scan flat = read("c.nii", niftiOf(std::vector<std::int16_t>(8, 7), 4, {2, 2, 2}));
  EXPECT_EQ(flat.firstWindow().level, 7);
  EXPECT_GT(flat.firstWindow().width, 0);
}

TEST_F(ScanFormats, TellScansFromLabelMaps) {
  const auto contents = [&](const std::string& name, const std::string& bytes) {
    return imageContents(folder_.put(name, bytes), progress_);
  };
  LabelImage labels = tests::emptyLabels();
  tests::addBall(labels, {8, 8, 8}, 5, 3);
  tests::addBall(labels, {16, 12, 8}, 3, 90);
  EXPECT_EQ(contents("a.nii", tests::niftiFile(labels)), ImageContents::labels);
  LabelImage noise = tests::emptyLabels();
  for (std::size_t v = 0; v < noise.voxels.size(); ++v)
    noise.voxels[v] = std::int16_t(v * 7919 % 200);
  EXPECT_EQ(contents("b.nii", tests::niftiFile(noise)), ImageContents::values) << "an MR of few grey values";
  noise.voxels[0] = -1000;
  EXPECT_EQ(contents("c.nrrd", tests::nrrdFile(noise)), ImageContents::values);
  EXPECT_EQ(contents("d.seg.nrrd", tests::nrrdFile(noise)), ImageContents::labels) << "by its name";
}

TEST_F(ScanFormats, AreWrittenAsTheyWereRead) {
  for (const auto& [name, image] : tests::orientedPhantoms()) {
    SCOPED_TRACE(name);
    Scan scan = read("a.nrrd", tests::nrrdFile(image));
    scan.slope = 2;
    scan.intercept = -24;
    for (const char* file : {"b.nii", "b.nii.gz", "b.nrrd"}) {
      writeScan(folder_ / file, scan);
      const Scan again = readScan(folder_ / file, {}, progress_);
      ASSERT_EQ(again.size, scan.size);
      EXPECT_LT((again.indexToLps.matrix() - scan.indexToLps.matrix()).cwiseAbs().maxCoeff(), 1e-5);
      for (int i = 0; i < scan.size[0]; ++i)
        ASSERT_EQ(again.value(i, i % scan.size[1], i % scan.size[2]),
                  scan.value(i, i % scan.size[1], i % scan.size[2]));
    }
  }
  EXPECT_THROW(writeScan(folder_ / "b.mha", Scan{}), CannotCreateError);
}

} // namespace
} // namespace viscera::medical_io
