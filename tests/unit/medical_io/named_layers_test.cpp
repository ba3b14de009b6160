#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "beating_labels.h"
#include "label_files.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/image_file.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_series.h"

/// What the axis of an image counts that is not of space: layers with names, or times.
namespace viscera::medical_io {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using tests::LabelImage;

std::string changed(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, text.npos) << what;
  return text.replace(at, what.size(), by);
}

class NamedLayers : public testing::Test {
protected:
  static LabelImage phaseOf(int phase) {
    LabelImage image = tests::emptyLabels({8, 8, 6});
    image.fill({1, 1, 1}, {3 + phase, 3, 3}, 1);
    image.fill({5, 5, 5}, {6, 6, 5}, 2);
    return image;
  }
  static std::vector<LabelImage> phases(int count) {
    std::vector<LabelImage> list;
    for (int phase = 0; phase < count; ++phase)
      list.push_back(phaseOf(phase));
    return list;
  }

  std::string problem(const std::filesystem::path& file) {
    try {
      readLabelMap(file, progress_);
    } catch (const DataError& error) {
      return error.what();
    }
    return "it was read";
  }

  void expectSeries(const std::filesystem::path& file) {
    SCOPED_TRACE(file);
    const std::string said = problem(file);
    EXPECT_THAT(said, HasSubstr("4 label maps over time"));
    EXPECT_THAT(said, HasSubstr("viscera track " + file.filename().string()));
    EXPECT_THAT(said, HasSubstr("from 0 to 3"));
    EXPECT_THROW(readScanOrLabels(file, {}, progress_), DataError);
    EXPECT_EQ(volumesIn(file), 4U);
    const LabelMap map = readLabelMap(file, progress_, 2);
    EXPECT_EQ(map.layers.size(), 1U);
    ASSERT_EQ(map.segments.size(), 2U);
    EXPECT_EQ(map.segments[0].voxels, 5 * 9);
    EXPECT_EQ(map.phase, 2);
    EXPECT_EQ(map.phaseTimesMs.size(), 4U);
    EXPECT_THROW(readLabelMap(file, progress_, 4), UsageError);
    std::size_t count = 0;
    readLabelSeries(file, progress_, [&](std::size_t phase, LabelMap&& one) {
      EXPECT_EQ(one.segments.at(0).voxels, (3 + int(phase)) * 9);
      ++count;
    });
    EXPECT_EQ(count, 4U);
  }

  tests::TemporaryFolder folder_;
  Progress progress_;
};

TEST_F(NamedLayers, AreNotThePhasesOfASeries) {
  const std::string keys =
      "axis 0 index type:=numeric\naxis 0 index unit:=ms\naxis 0 index values:=0 40 80 120\n"
      "DataNodeClassName:=vtkMRMLLabelMapVolumeNode\n";
  const auto first = folder_.put("a.seq.nrrd", tests::sequenceNrrd(phases(4), keys));
  expectSeries(first);
  EXPECT_THAT(problem(first), HasSubstr("(at 0, 40, 80, 120 ms)"));
  EXPECT_THAT(readLabelMap(first, progress_, 0).phaseTimesMs, ElementsAre(0, 40, 80, 120));
  expectSeries(folder_.put("plain.nrrd", tests::sequenceNrrd(phases(4), keys)));
  expectSeries(folder_.put("name.seq.nrrd", tests::sequenceNrrd(phases(4), "")));
  expectSeries(folder_.put("list.nrrd", tests::sequenceNrrd(phases(4), "")));
  expectSeries(
      folder_.put("kind.nrrd", changed(tests::sequenceNrrd(phases(4), ""), "kinds: list", "kinds: time")));
  expectSeries(folder_.put(
      "volume.nrrd", tests::sequenceNrrd(phases(4), "MultiVolume.FrameLabels:=0,40,80,120\n"
                                                    "MultiVolume.FrameIdentifyingDICOMTagUnits:=ms\n")));
  // Names of segments do not turn phases into layers.
  expectSeries(folder_.put("named.seq.nrrd", tests::sequenceNrrd(phases(4), keys + tests::kHeartKeys)));
  expectSeries(folder_.put("a.nii", tests::nifti4d(phases(4), 40, 16)));
}

TEST_F(NamedLayers, OfAFourthDimensionOfSpaceAreTimes) {
  std::string bytes = tests::nrrdFile(phaseOf(0));
  bytes = changed(bytes, "dimension: 3\nspace: left-posterior-superior",
                  "dimension: 4\nspace: left-posterior-superior-time");
  bytes = changed(bytes, "sizes: 8 8 6", "sizes: 8 8 6 4");
  bytes = changed(bytes, "space directions: (1,0,0) (0,1,0) (0,0,1)",
                  "space directions: (1,0,0,0) (0,1,0,0) (0,0,1,0) (0,0,0,40)");
  bytes = changed(bytes, "kinds: domain domain domain", "kinds: domain domain domain domain");
  bytes = changed(bytes, "space origin: (0,0,0)", "space origin: (0,0,0,0)");
  for (int phase = 1; phase < 4; ++phase)
    bytes += tests::voxelBytes(phaseOf(phase).voxels);
  expectSeries(folder_.put("itk.nrrd", bytes));
  std::string meta = tests::metaImageHeader(phaseOf(0), "LOCAL");
  meta = changed(meta, "NDims = 3", "NDims = 4");
  meta = changed(meta, "TransformMatrix = 1 0 0 0 1 0 0 0 1",
                 "TransformMatrix = 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1");
  meta = changed(meta, "Offset = 0 0 0", "Offset = 0 0 0 0");
  meta = changed(meta, "ElementSpacing = 1 1 1", "ElementSpacing = 1 1 1 40");
  meta = changed(meta, "DimSize = 8 8 6", "DimSize = 8 8 6 4");
  for (int phase = 0; phase < 4; ++phase)
    meta += tests::voxelBytes(phaseOf(phase).voxels);
  expectSeries(folder_.put("itk.mha", meta));
}

/// Two groups with one label each, whose voxels overlap, and their numbers are the same.
std::string mitkFile(const std::string& keys, bool two = true) {
  LabelImage image = tests::emptyLabels({8, 8, 6});
  LabelImage other = image;
  image.fill({1, 1, 1}, {4, 4, 4}, 1);
  other.fill({2, 2, 2}, {3, 3, 3}, 1);
  if (!two) {
    image.fill({6, 6, 1}, {6, 6, 4}, 2);
    return tests::nrrdFile(image, "left-posterior-superior", keys);
  }
  LabelImage both = image;
  both.voxels.clear();
  for (std::size_t v = 0; v < image.voxels.size(); ++v) {
    both.voxels.push_back(image.voxels[v]);
    both.voxels.push_back(other.voxels[v]);
  }
  return changed(tests::nrrdFile(both, "left-posterior-superior", keys, 2), "kinds: list", "kinds: vector");
}

std::string mitkLabel(const std::string& name, int value, const std::string& color) {
  return R"({"color":{"type":"ColorProperty","value":[)" + color + R"(]},"locked":true,"name":")" + name +
         R"(","opacity":0.6,"value":)" + std::to_string(value) + R"(,"visible":true})";
}

TEST_F(NamedLayers, OfMitkAreItsGroups) {
  const std::string begin = "modality:=org.mitk.multilabel.segmentation\n"
                            "org.mitk.multilabel.segmentation.labelgroups:=[{\"labels\":[";
  const std::string end = "]}]\norg.mitk.multilabel.segmentation.version:=1\n"
                          "org_mitk_timegeometry_timepoints:=0 1\n";
  const auto one = folder_.put("one.nrrd", mitkFile(begin + mitkLabel("Leber", 1, "0.87,0.51,0.4") + "," +
                                                        mitkLabel("Gallenblase", 2, "0.5,0.6,0.4") + end,
                                                    false));
  const LabelMap map = readLabelMap(one, progress_);
  ASSERT_EQ(map.segments.size(), 2U);
  EXPECT_EQ(map.segments[0].name, "Leber");
  EXPECT_LT((map.segments[0].color - Vec3(0.87, 0.51, 0.4)).norm(), 1e-9);
  EXPECT_EQ(map.segments[1].name, "Gallenblase");
  const auto two =
      folder_.put("two.nrrd", mitkFile(begin + mitkLabel("Leber", 1, "0.87,0.51,0.4") + "]},{\"labels\":[" +
                                       mitkLabel("Tumor", 1, "1,0,0") + end));
  for (const LabelMap& layered :
       {readLabelMap(two, progress_), std::get<LabelMap>(readScanOrLabels(two, {}, progress_))}) {
    ASSERT_EQ(layered.layers.size(), 2U);
    ASSERT_EQ(layered.segments.size(), 2U);
    EXPECT_EQ(layered.segments[0].name, "Leber");
    EXPECT_EQ(layered.segments[0].voxels, 64);
    EXPECT_EQ(layered.segments[1].name, "Tumor");
    EXPECT_EQ(layered.segments[1].voxels, 8);
    EXPECT_EQ(layered.segments[1].layer, 1);
  }
}

TEST_F(NamedLayers, OfOlderVersionsOfMitkAreXml) {
  const auto label = [](const char* name, int value) {
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\\n<Label>\\n    <property key=\"name\" "
           "type=\"StringProperty\">\\n"
           "<string value=\"" +
           std::string(name) +
           "\"/>\\n</property><property key=\"value\" type=\"UIntProperty\">"
           "<unsigned value=\"" +
           std::to_string(value) +
           "\"/></property><property key=\"color\" type=\"ColorProperty\">"
           "<color r=\"0.5\" g=\"0.25\" b=\"1\"/></property></Label>\\n";
  };
  const LabelMap map = readLabelMap(
      folder_.put("old.nrrd",
                  mitkFile("modality:=org.mitk.image.multilabel\nlayers:=2\nlayer_000:=2\nlayer_001:=1\n"
                           "org.mitk.label_000_00000:=" +
                           label("Exterior", 0) + "\norg.mitk.label_000_00001:=" + label("Liver", 1) +
                           "\norg.mitk.label_001_00000:=" + label("Cyst", 1) + "\n")),
      progress_);
  ASSERT_EQ(map.segments.size(), 2U);
  EXPECT_EQ(map.segments[0].name, "Liver");
  EXPECT_LT((map.segments[0].color - Vec3(0.5, 0.25, 1)).norm(), 1e-9);
  EXPECT_EQ(map.segments[1].name, "Cyst");
}

TEST_F(NamedLayers, OfADamagedTableOfMitkAreReadWithoutNames) {
  for (const char* groups :
       {"[{\"labels\":[{\"name\":3,\"value\":1,\"color\":7}]}]", "[[[", "{}", "[{\"labels\":[{}]}]"}) {
    const LabelMap map = readLabelMap(
        folder_.put(
            "a.nrrd",
            mitkFile("org.mitk.multilabel.segmentation.labelgroups:=" + std::string(groups) + "\n", false)),
        progress_);
    EXPECT_EQ(map.segments.size(), 2U) << groups;
  }
}

TEST_F(NamedLayers, AreSaidWhereSegmentsShareOne) {
  LabelImage image = tests::emptyLabels({8, 8, 6});
  image.fill({1, 1, 1}, {4, 4, 4}, 1);
  image.fill({6, 6, 1}, {6, 6, 4}, 2);
  const LabelMap map = readLabelMap(
      folder_.put("a.seg.nrrd",
                  tests::nrrdFile(
                      image, "left-posterior-superior",
                      "Segment0_ID:=a\nSegment0_Name:=liver\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n"
                      "Segment1_ID:=b\nSegment1_Name:=tumour\nSegment1_LabelValue:=1\nSegment1_Layer:=0\n"
                      "Segment2_ID:=c\nSegment2_Name:=stone\nSegment2_LabelValue:=2\nSegment2_Layer:=0\n"
                      "Segment3_ID:=d\nSegment3_Name:=cyst\nSegment3_LabelValue:=1\nSegment3_Layer:=0\n")),
      progress_);
  ASSERT_EQ(map.segments.size(), 2U);
  EXPECT_EQ(map.segments[0].name, "liver");
  EXPECT_THAT(inEnglish(map.warnings), Contains(HasSubstr("liver, tumour, cyst")));
  EXPECT_THAT(inEnglish(map.warnings), Not(Contains(HasSubstr("stone"))));
}

} // namespace
} // namespace viscera::medical_io
