#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bzipped.h"
#include "label_files.h"
#include "packed_bytes.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/medical_io/label_map.h"

namespace viscera::medical_io {
namespace {

using testing::Contains;
using testing::HasSubstr;
using tests::bzipped;
using tests::gzipped;
using tests::LabelImage;
using tests::TemporaryFolder;

LabelMap readLabels(const std::filesystem::path& file) {
  Progress progress;
  return readLabelMap(file, progress);
}

std::string problemOfLabels(const std::filesystem::path& file) {
  try {
    readLabels(file);
  } catch (const DataError& error) {
    return error.what();
  }
  ADD_FAILURE() << file << " was read";
  return {};
}

/// Two boxes, labels 5 and 300.
LabelImage twoPlainOrgans() {
  LabelImage image = tests::emptyLabels();
  image.fill({2, 3, 4}, {6, 8, 9}, 5);
  image.fill({12, 3, 4}, {14, 5, 6}, 300);
  return image;
}

/// The two organs of `twoPlainOrgans`, whatever they are called.
void expectTwoOrgans(const LabelMap& map) {
  ASSERT_EQ(map.segments.size(), 2U);
  EXPECT_EQ(map.segments[0].label, 5);
  EXPECT_EQ(map.segments[0].voxels, 5 * 6 * 6);
  EXPECT_EQ(map.segments[0].low, (std::array<int, 3>{2, 3, 4}));
  EXPECT_EQ(map.segments[0].high, (std::array<int, 3>{6, 8, 9}));
  EXPECT_EQ(map.segments[1].label, 300);
  EXPECT_EQ(map.segments[1].voxels, 27);
  EXPECT_EQ(map.layers.at(0).at(map.indexOf(13, 4, 5)), 2);
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, text.npos) << what;
  return text.replace(at, what.size(), by);
}

class LabelFormats : public testing::Test {
protected:
  TemporaryFolder folder_;
};

TEST_F(LabelFormats, GiveEveryLabelItsVoxelsAndItsBox) {
  expectTwoOrgans(readLabels(folder_.put("a.nii", tests::niftiFile(twoPlainOrgans()))));
  expectTwoOrgans(readLabels(folder_.put("a.nrrd", tests::nrrdFile(twoPlainOrgans()))));
  expectTwoOrgans(readLabels(folder_.put("a.mha", tests::metaImageFile(twoPlainOrgans()))));
}

TEST_F(LabelFormats, AreReadPacked) {
  const LabelImage image = twoPlainOrgans();
  expectTwoOrgans(readLabels(folder_.put("a.nii.gz", gzipped(tests::niftiFile(image)))));
  const std::string voxels = tests::voxelBytes(image.voxels);
  std::string nrrd = replaced(tests::nrrdFile(image), "encoding: raw", "encoding: gzip");
  nrrd.resize(nrrd.size() - voxels.size());
  expectTwoOrgans(readLabels(folder_.put("a.nrrd", nrrd + gzipped(voxels))));
  for (const char* name : {"bzip2", "bz2"})
    expectTwoOrgans(readLabels(folder_.put(
        "b.nrrd", replaced(nrrd, "encoding: gzip", "encoding: " + std::string(name)) + bzipped(voxels))));
  const std::string header =
      replaced(tests::metaImageHeader(image, "LOCAL"), "CompressedData = False", "CompressedData = True");
  expectTwoOrgans(readLabels(folder_.put("a.mha", header + tests::zlibPacked(voxels))));
}

/// Several streams one behind the other are one file; parallel bzip2 programs write nothing else.
TEST_F(LabelFormats, AreReadPackedInSeveralParts) {
  const std::string voxels = tests::voxelBytes(twoPlainOrgans().voxels);
  std::string nrrd = replaced(tests::nrrdFile(twoPlainOrgans()), "encoding: raw", "encoding: bzip2");
  nrrd.resize(nrrd.size() - voxels.size());
  expectTwoOrgans(readLabels(
      folder_.put("a.nrrd", nrrd + bzipped(voxels.substr(0, 1000)) + bzipped(voxels.substr(1000)))));
  const std::string bytes = tests::niftiFile(twoPlainOrgans());
  expectTwoOrgans(
      readLabels(folder_.put("a.nii.gz", gzipped(bytes.substr(0, 1000)) + gzipped(bytes.substr(1000)))));
}

TEST_F(LabelFormats, AreReadInBothByteOrders) {
  const LabelImage image = twoPlainOrgans();
  std::string voxels = tests::voxelBytes(image.voxels);
  for (std::size_t i = 0; i < voxels.size(); i += 2)
    std::swap(voxels[i], voxels[i + 1]);
  std::string nrrd = replaced(tests::nrrdFile(image), "endian: little", "endian: big");
  nrrd.resize(nrrd.size() - voxels.size());
  expectTwoOrgans(readLabels(folder_.put("a.nrrd", nrrd + voxels)));
  const std::string header =
      replaced(tests::metaImageHeader(image, "LOCAL"), "ByteOrderMSB = False", "ByteOrderMSB = True");
  expectTwoOrgans(readLabels(folder_.put("a.mha", header + voxels)));
}

TEST_F(LabelFormats, AreReadWithTheirVoxelsInAFileBeside) {
  const LabelImage image = twoPlainOrgans();
  folder_.put("voxels.raw", tests::voxelBytes(image.voxels));
  expectTwoOrgans(readLabels(folder_.put("a.mhd", tests::metaImageHeader(image, "voxels.raw"))));
  std::string nrrd = replaced(tests::nrrdFile(image), "endian:", "data file: voxels.raw\nendian:");
  nrrd.resize(nrrd.size() - tests::voxelBytes(image.voxels).size());
  expectTwoOrgans(readLabels(folder_.put("a.nhdr", nrrd)));
}

TEST_F(LabelFormats, WithoutTheFileBesideAreRefused) {
  EXPECT_THROW(readLabels(folder_.put("a.mhd", tests::metaImageHeader(twoPlainOrgans(), "gone.raw"))),
               NoInputError);
  EXPECT_THAT(problemOfLabels(folder_.put("b.mhd", tests::metaImageHeader(twoPlainOrgans(), "/etc/passwd"))),
              HasSubstr("another folder"));
}

TEST_F(LabelFormats, OfNiftiInTwoFilesAreReadByEitherName) {
  const tests::NiftiHalves halves = tests::niftiHalves(twoPlainOrgans());
  folder_.put("a 50%.hdr", halves.header);
  folder_.put("a 50%.img", halves.voxels);
  folder_.put("b.HDR", halves.header);
  folder_.put("b.IMG", halves.voxels);
  folder_.put("c.hdr.gz", gzipped(halves.header));
  folder_.put("c.img.gz", gzipped(halves.voxels));
  folder_.put("d.hdr", halves.header);
  folder_.put("d.img.gz", gzipped(halves.voxels));
  for (const char* name :
       {"a 50%.hdr", "a 50%.img", "b.HDR", "b.IMG", "c.hdr.gz", "c.img.gz", "d.hdr", "d.img.gz"}) {
    SCOPED_TRACE(name);
    EXPECT_EQ(fileKind(folder_ / name), FileKind::labelMap);
    EXPECT_TRUE(isLabelMap(folder_ / name));
    expectTwoOrgans(readLabels(folder_ / name));
  }
}

TEST_F(LabelFormats, OfNiftiInTwoFilesMayBeginBehindOtherBytesAndHaveATableOfNames) {
  tests::NiftiHalves halves =
      tests::niftiHalves(twoPlainOrgans(), tests::NiftiForm::sform,
                         "<E><LabelTable><Label Key=\"5\">liver</Label></LabelTable></E>");
  tests::putBytes<float>(halves.header, 108, 16.0F);
  folder_.put("a.img", std::string(16, 'x') + halves.voxels);
  for (const bool packed : {false, true}) {
    const LabelMap map = packed ? readLabels(folder_.put("a.hdr.gz", gzipped(halves.header)))
                                : readLabels(folder_.put("a.hdr", halves.header));
    expectTwoOrgans(map);
    EXPECT_EQ(map.segments[0].name, "liver");
    std::filesystem::remove(folder_ / "a.hdr");
  }
}

TEST_F(LabelFormats, OfNiftiInTwoFilesWithoutTheOtherHalfSayWhichIsMissing) {
  const tests::NiftiHalves halves = tests::niftiHalves(twoPlainOrgans());
  const auto missing = [&](const std::filesystem::path& file) {
    try {
      readLabels(file);
    } catch (const NoInputError& error) {
      return std::string(error.what());
    }
    return std::string("it was read");
  };
  EXPECT_THAT(missing(folder_.put("a.hdr", halves.header)), HasSubstr("\"a.img\", is not beside it"));
  EXPECT_THAT(missing(folder_.put("b.img", halves.voxels)), HasSubstr("\"b.hdr\", is not beside it"));
  folder_.put("a.img", halves.voxels.substr(1));
  EXPECT_THAT(problemOfLabels(folder_ / "a.hdr"),
              HasSubstr("\"a.img\", cannot be read: The file is cut off"));
  EXPECT_THAT(problemOfLabels(folder_ / "a.img"), HasSubstr("cut off"));
}

TEST_F(LabelFormats, AreReadAsText) {
  const LabelImage image = twoPlainOrgans();
  std::string text;
  for (const std::int16_t v : image.voxels)
    text += std::to_string(v) + " ";
  std::string nrrd = replaced(tests::nrrdFile(image), "encoding: raw", "encoding: ascii");
  nrrd.resize(nrrd.size() - tests::voxelBytes(image.voxels).size());
  expectTwoOrgans(readLabels(folder_.put("a.nrrd", nrrd + text)));
}

TEST_F(LabelFormats, ApplyTheScaleOfNifti) {
  LabelImage image = twoPlainOrgans();
  for (std::int16_t& v : image.voxels)
    v = static_cast<std::int16_t>(v == 0 ? -10 : v == 5 ? 0 : 590);
  std::string bytes = tests::niftiFile(image);
  tests::putBytes<float>(bytes, 112, 0.5F);
  tests::putBytes<float>(bytes, 116, 5.0F);
  expectTwoOrgans(readLabels(folder_.put("a.nii", bytes)));
}

/// As 3D Slicer writes it when segments overlap: a list axis first, one label in two layers.
TEST_F(LabelFormats, OfSlicerGiveOverlappingSegmentsNamesAndColours) {
  LabelImage image = tests::emptyLabels({10, 9, 8});
  image.indexToLps = Eigen::Scaling(-1.0, -1.0, 1.0) * Eigen::Translation3d(1, 2, 3);
  image.voxels.assign(2 * 10 * 9 * 8, 0);
  const auto set = [&](int layer, int i, int j, int k, std::int16_t label) {
    image.voxels[std::size_t(((k * 9 + j) * 10 + i) * 2 + layer)] = label;
  };
  for (int i = 2; i < 8; ++i)
    set(0, i, 4, 4, 1);
  set(0, 1, 1, 1, 2);
  for (int j = 3; j < 6; ++j)
    set(1, 5, j, 4, 1);
  const LabelMap map = readLabels(folder_.put(
      "a.seg.nrrd",
      tests::nrrdFile(
          image, "left-posterior-superior",
          "Segmentation_MasterRepresentation:=Binary labelmap\n"
          "Segment0_ID:=Segment_1\nSegment0_Name:=left kidney\nSegment0_Color:=0.25 0.5 1\n"
          "Segment0_LabelValue:=1\nSegment0_Layer:=0\nSegment0_Extent:=2 7 4 4 4 4\n"
          "Segment1_ID:=Segment_2\nSegment1_Name:=cyst\nSegment1_Color:=1 0 0\n"
          "Segment1_LabelValue:=1\nSegment1_Layer:=1\n"
          "Segment2_ID:=Segment_3\nSegment2_Name:=stone\nSegment2_LabelValue:=2\nSegment2_Layer:=0\n"
          "Segment3_ID:=Segment_4\nSegment3_Name:=nothing\nSegment3_LabelValue:=3\nSegment3_Layer:=0\n",
          2)));
  ASSERT_EQ(map.layers.size(), 2U);
  ASSERT_EQ(map.segments.size(), 3U);
  EXPECT_EQ(map.segments[0].name, "left kidney");
  EXPECT_TRUE(map.segments[0].color.isApprox(Vec3(0.25, 0.5, 1)));
  EXPECT_EQ(map.segments[0].voxels, 6);
  EXPECT_EQ(map.segments[1].name, "stone");
  EXPECT_FALSE(map.segments[1].colored);
  EXPECT_EQ(map.segments[2].name, "cyst");
  EXPECT_EQ(map.segments[2].label, 1);
  EXPECT_EQ(map.segments[2].layer, 1);
  EXPECT_EQ(map.segments[2].voxels, 3);
  // In voxel (5, 4, 4) both are.
  EXPECT_EQ(map.layers[0][map.indexOf(5, 4, 4)], 1);
  EXPECT_EQ(map.layers[1][map.indexOf(5, 4, 4)], 3);
  EXPECT_THAT(inEnglish(map.warnings), Contains(HasSubstr("nothing")));
}

TEST_F(LabelFormats, OfSlicerGiveNamesInUtf8) {
  const LabelMap map =
      readLabels(folder_.put("a.seg.nrrd", tests::nrrdFile(twoPlainOrgans(), "left-posterior-superior",
                                                           "Segment0_ID:=s\nSegment0_Name:=f\xEDgado\n"
                                                           "Segment0_LabelValue:=5\n")));
  EXPECT_EQ(map.segments[0].name, "f\xC3\xADgado");
}

TEST_F(LabelFormats, OfTotalSegmentatorGiveTheNamesOfTheirTable) {
  const std::string xml =
      R"(<?xml version="1.0" encoding="UTF-8"?><CaretExtension><VolumeInformation Index="0"><LabelTable>)"
      R"(<Label Key="5" Red="0.2" Green="0.4" Blue="0.6" Alpha="1">liver</Label>)"
      R"(<Label Key="300" Red="1" Green="1" Blue="0">kidney_right</Label>)"
      R"(<Label Key="6" Red="1" Green="0" Blue="0">stomach</Label>)"
      R"(</LabelTable><StudyMetaDataLinkSet/><VolumeType>Label</VolumeType></VolumeInformation></CaretExtension>)";
  const std::string bytes = tests::niftiFile(twoPlainOrgans(), tests::NiftiForm::sform, xml);
  for (const char* name : {"a.nii", "a.nii.gz"}) {
    const LabelMap map = readLabels(folder_.put(name, name[5] == '\0' ? bytes : gzipped(bytes)));
    expectTwoOrgans(map);
    EXPECT_EQ(map.segments[0].name, "liver");
    EXPECT_TRUE(map.segments[0].color.isApprox(Vec3(0.2, 0.4, 0.6)));
    EXPECT_EQ(map.segments[1].name, "kidney_right");
    EXPECT_EQ(inEnglish(map.warnings), std::vector<std::string>{});
  }
}

TEST_F(LabelFormats, TakeTheNamesOfATableBeside) {
  const std::string bytes = tests::nrrdFile(twoPlainOrgans());
  struct Table {
    const char* name;
    const char* contents;
  };
  for (const Table& table :
       {Table{"p_seg.ctbl", "# a table\n5 spleen 255 0 51 255\n300 left_kidney 1 2 3 255\n"},
        Table{"p_colors.ctbl", "5 spleen 255 0 51 255\n300 left_kidney 1 2 3 255\n"},
        Table{"p_seg.txt", "5 255 0 51 1 1 1 \"spleen\"\n300 1 2 3 1 1 1 \"left kidney\"\n"},
        Table{"p_seg.json", R"({"5": "spleen", "300": "left kidney"})"},
        Table{"dataset.json", R"({"labels": {"spleen": 5, "left kidney": 300}})"}}) {
    SCOPED_TRACE(table.name);
    const TemporaryFolder folder;
    folder.put(table.name, table.contents);
    const LabelMap map = readLabels(folder.put("p_seg.nrrd", bytes));
    ASSERT_EQ(map.segments.size(), 2U);
    EXPECT_EQ(map.segments[0].name, "spleen");
    EXPECT_EQ(map.segments[1].name, "left kidney");
    if (map.segments[0].colored) {
      EXPECT_TRUE(map.segments[0].color.isApprox(Vec3(1, 0, 0.2)));
    }
    EXPECT_THAT(inEnglish(map.warnings), Contains(HasSubstr(table.name)));
  }
}

TEST_F(LabelFormats, WithoutNamesAreNumberedAndCannotBeConfused) {
  const LabelMap map = readLabels(folder_.put("a.mha", tests::metaImageFile(twoPlainOrgans())));
  EXPECT_EQ(map.segments[0].name, "label 5");
  EXPECT_FALSE(map.segments[0].named);
  EXPECT_FALSE(map.segments[0].color.isApprox(map.segments[1].color, 0.05));
  folder_.put("a.json", R"({"5": "kidney", "300": "kidney"})");
  const LabelMap twins = readLabels(folder_.put("a.mha", tests::metaImageFile(twoPlainOrgans())));
  EXPECT_EQ(twins.segments[0].name, "kidney");
  EXPECT_EQ(twins.segments[1].name, "kidney 2");
}

TEST_F(LabelFormats, OfImagesAreNoLabelMaps) {
  LabelImage image = twoPlainOrgans();
  image.at(0, 0, 0) = -1000;
  EXPECT_THAT(problemOfLabels(folder_.put("a.nrrd", tests::nrrdFile(image))),
              HasSubstr("an image, not labels"));
  LabelImage gradient = tests::emptyLabels();
  for (std::size_t v = 0; v < gradient.voxels.size(); ++v)
    gradient.voxels[v] = static_cast<std::int16_t>(v);
  EXPECT_THAT(problemOfLabels(folder_.put("a.nrrd", tests::nrrdFile(gradient))),
              HasSubstr("different values"));
  std::string fractions = tests::niftiFile(twoPlainOrgans());
  tests::putBytes<float>(fractions, 112, 0.1F);
  EXPECT_THAT(problemOfLabels(folder_.put("a.nii", fractions)), HasSubstr("an image, not labels"));
  EXPECT_THAT(problemOfLabels(folder_.put("a.mha", tests::metaImageFile(tests::emptyLabels()))),
              HasSubstr("no labelled voxel"));
}

TEST_F(LabelFormats, ThatPromiseMoreThanTheyHaveAreRefusedBeforeMemoryIsTaken) {
  std::string nifti = tests::niftiFile(twoPlainOrgans());
  for (std::size_t d = 0; d < 3; ++d)
    tests::putBytes<std::int16_t>(nifti, 42 + 2 * d, 32767);
  EXPECT_THAT(problemOfLabels(folder_.put("a.nii", nifti)), HasSubstr("cut off"));
  EXPECT_THAT(problemOfLabels(folder_.put("a.nii.gz", gzipped(nifti))), HasSubstr("cut off"));
  const std::string voxels = tests::voxelBytes(twoPlainOrgans().voxels);
  folder_.put("b.img.gz", gzipped(voxels));
  tests::NiftiHalves halves = tests::niftiHalves(twoPlainOrgans());
  for (std::size_t d = 0; d < 3; ++d)
    tests::putBytes<std::int16_t>(halves.header, 42 + 2 * d, 32767);
  EXPECT_THAT(problemOfLabels(folder_.put("b.hdr", halves.header)), HasSubstr("cut off"));
  std::string bzip2 = replaced(tests::nrrdFile(twoPlainOrgans()), "24 20 16", "60000 60000 60000");
  bzip2 = replaced(bzip2, "encoding: raw", "encoding: bzip2");
  bzip2.resize(bzip2.size() - voxels.size());
  EXPECT_THAT(problemOfLabels(folder_.put("b.nrrd", bzip2 + bzipped(voxels))), HasSubstr("cut off"));
  for (const char* sizes : {"60000 60000 60000", "24 20 17"})
    EXPECT_THAT(problemOfLabels(
                    folder_.put("a.nrrd", replaced(tests::nrrdFile(twoPlainOrgans()), "24 20 16", sizes))),
                HasSubstr("cut off"));
  EXPECT_THAT(problemOfLabels(folder_.put(
                  "a.mha", replaced(tests::metaImageFile(twoPlainOrgans()), "24 20 16", "9999 9999 9999"))),
              HasSubstr("cut off"));
}

TEST_F(LabelFormats, UnderAnotherNameSayWhatTheyAre) {
  EXPECT_THAT(problemOfLabels(folder_.put("a.nii", tests::nrrdFile(twoPlainOrgans()))),
              HasSubstr("looks like NRRD"));
  EXPECT_THAT(problemOfLabels(folder_.put("a.nrrd", tests::niftiFile(twoPlainOrgans()))),
              HasSubstr("looks like NIfTI"));
  EXPECT_THAT(problemOfLabels(folder_.put("a.stl", tests::niftiFile(twoPlainOrgans()))),
              HasSubstr("It is named .stl but looks like NIfTI"));
}

class LabelFolder : public testing::Test {
protected:
  void put(const std::string& name, const Eigen::Vector3i& low, const Eigen::Vector3i& high) {
    LabelImage mask = tests::emptyLabels();
    if (low.x() >= 0)
      mask.fill(low, high, 1);
    folder_.put(name, gzipped(tests::niftiFile(mask)));
  }
  TemporaryFolder folder_;
};

TEST_F(LabelFolder, OfMasksIsOnePatient) {
  put("liver.nii.gz", {2, 2, 2}, {9, 9, 9});
  put("liver_vessels.nii.gz", {4, 4, 4}, {5, 5, 5});
  put("heart.nii.gz", {14, 2, 2}, {16, 4, 4});
  put("spleen.nii.gz", {-1, -1, -1}, {0, 0, 0});
  folder_.put("statistics.json", "{}");
  EXPECT_TRUE(isLabelMap(folder_.path()));
  const LabelMap map = readLabels(folder_.path());
  ASSERT_EQ(map.segments.size(), 3U);
  EXPECT_EQ(map.segments[0].name, "heart");
  EXPECT_EQ(map.segments[1].name, "liver");
  EXPECT_EQ(map.segments[1].voxels, 512);
  EXPECT_EQ(map.segments[2].name, "liver_vessels");
  EXPECT_EQ(map.segments[2].voxels, 8);
  EXPECT_EQ(map.segments[2].layer, 1) << "the vessels lie within the liver";
  EXPECT_EQ(map.layers.size(), 2U);
  EXPECT_THAT(inEnglish(map.warnings), Contains(HasSubstr("spleen")));
}

TEST_F(LabelFolder, TakesAMaskFromTheLayerThatItIsIn) {
  LabelImage image = tests::emptyLabels();
  const std::size_t voxels = image.voxels.size();
  image.fill({2, 2, 2}, {9, 9, 9}, 1);
  std::vector<std::int16_t> layers(2 * voxels, 0); // The first one is empty.
  for (std::size_t v = 0; v < voxels; ++v)
    layers[2 * v + 1] = image.voxels[v];
  image.voxels = layers;
  folder_.put("liver.seg.nrrd", tests::nrrdFile(image, "left-posterior-superior",
                                                "Segment0_ID:=Segment_1\nSegment0_Name:=other\n"
                                                "Segment0_LabelValue:=1\nSegment0_Layer:=1\n",
                                                2));
  put("heart.nii.gz", {14, 2, 2}, {16, 4, 4});
  const LabelMap map = readLabels(folder_.path());
  ASSERT_EQ(map.segments.size(), 2U);
  EXPECT_EQ(map.segments[1].name, "liver");
  EXPECT_EQ(map.volumeMl(map.segments[1]), 0.512);
  EXPECT_EQ(map.layers.at(std::size_t(map.segments[1].layer)).at(map.indexOf(5, 5, 5)), 2);
}

TEST_F(LabelFolder, NamesItsMasksInUtf8) {
  put("f\xEF\xAC\x81gado.nii.gz", {2, 2, 2}, {9, 9, 9});
  put("p\xE2ncreas.nii.gz", {14, 2, 2}, {16, 4, 4}); // Latin-1.
  const LabelMap map = readLabels(folder_.path());
  ASSERT_EQ(map.segments.size(), 2U);
  EXPECT_EQ(map.segments[0].name, "f\xEF\xAC\x81gado");
  EXPECT_EQ(map.segments[1].name, "p\xC3\xA2ncreas");
}

TEST_F(LabelFolder, OfMasksInTwoFilesHasEachOnce) {
  LabelImage mask = tests::emptyLabels();
  mask.fill({2, 2, 2}, {9, 9, 9}, 1);
  const tests::NiftiHalves halves = tests::niftiHalves(mask);
  for (const char* name : {"liver", "spleen"}) {
    folder_.put(name + std::string(".hdr"), halves.header);
    folder_.put(name + std::string(".img"), halves.voxels);
  }
  const LabelMap map = readLabels(folder_.path());
  ASSERT_EQ(map.segments.size(), 2U);
  EXPECT_EQ(map.segments[0].name, "liver");
  EXPECT_EQ(map.segments[1].name, "spleen");
}

TEST_F(LabelFolder, WithMasksOfTwoImagesIsRefused) {
  put("liver.nii.gz", {2, 2, 2}, {9, 9, 9});
  LabelImage other = tests::emptyLabels();
  other.indexToLps.translation() = Vec3(0, 0, 3);
  other.fill({1, 1, 1}, {3, 3, 3}, 1);
  folder_.put("spleen.nii.gz", gzipped(tests::niftiFile(other)));
  EXPECT_THAT(problemOfLabels(folder_.path()),
              testing::AllOf(HasSubstr("spleen.nii.gz"), HasSubstr("elsewhere")));
}

TEST_F(LabelFolder, WithoutMasksOrWithALabelMapIsRefused) {
  EXPECT_FALSE(isLabelMap(folder_.path()));
  EXPECT_THAT(problemOfLabels(folder_.path()), HasSubstr("holds no label map"));
  folder_.put("all.nii", tests::niftiFile(twoPlainOrgans()));
  EXPECT_THAT(problemOfLabels(folder_.path()), HasSubstr("2 labels"));
}

TEST(LabelMapReading, CanBeCancelled) {
  const TemporaryFolder folder;
  const auto file = folder.put("a.nii", tests::niftiFile(twoPlainOrgans()));
  Progress progress;
  progress.cancel();
  EXPECT_THROW(readLabelMap(file, progress), Cancelled);
  EXPECT_THROW(readLabelFolder(folder.path(), progress), Cancelled);
}

TEST(LabelMapBounds, GoAroundWholeVoxels) {
  const TemporaryFolder folder;
  LabelImage image = twoPlainOrgans();
  image.indexToLps = Eigen::Translation3d(10, 20, 30) * Eigen::Scaling(2.0, -1.0, 3.0);
  const LabelMap map = readLabels(folder.put("a.nrrd", tests::nrrdFile(image)));
  EXPECT_TRUE(map.bounds().low.isApprox(Vec3(9, 20.5 - 20, 28.5)));
  EXPECT_TRUE(map.bounds().high.isApprox(Vec3(57, 20.5, 76.5)));
  EXPECT_NEAR(map.volumeMl(map.segments[1]), 27 * 6 / 1000.0, 1e-12);
}

} // namespace
} // namespace viscera::medical_io
