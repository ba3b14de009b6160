#include <gtest/gtest.h>

#include "beating_labels.h"
#include "dicom_segments.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/live/series_contents.h"

namespace viscera::live {
namespace {

/// Six phases of a small heart in one file, labels 1, 2 and 3; `table` beside it names them.
SeriesContents contentsOf(const std::string& table, int units = 16) {
  tests::TemporaryFolder folder;
  std::vector<tests::LabelImage> phases;
  for (int phase = 0; phase < 6; ++phase)
    phases.push_back(tests::beatingLabels(phase / 6.0, Vec3(4, 4, 8)));
  const auto file = folder.put("cine.nii", tests::nifti4d(phases, 150, units));
  if (!table.empty())
    folder.put("labels.txt", table);
  Progress progress;
  return lookIntoSeries({file}, progress);
}

/// Two cavities and their muscle in six phases of 0.9 s.
void expectTheHeart(const SeriesContents& contents) {
  EXPECT_TRUE(contents.labels);
  EXPECT_EQ(contents.phases, 6U);
  EXPECT_NEAR(contents.periodSeconds.value_or(0), 0.9, 1e-6);
  ASSERT_EQ(contents.items.size(), 3U);
  EXPECT_EQ(contents.items[0].part, SeriesPart::cavity);
  EXPECT_EQ(contents.items[1].part, SeriesPart::cavity);
  EXPECT_EQ(contents.items[2].part, SeriesPart::tissue);
}

TEST(LookIntoSeries, TakesTheLabelWithTheLargestBoxForTheTissue) {
  const SeriesContents contents = contentsOf({});
  expectTheHeart(contents);
  const auto surfaces = chosenSurfaces(contents, "Heart");
  ASSERT_EQ(surfaces.size(), 3U);
  EXPECT_EQ(surfaces[0].name, "Heart");
  EXPECT_EQ(surfaces[0].labels, (std::vector<std::string>{"1", "2", "3"})) << "the outer surface holds all";
  EXPECT_EQ(surfaces[1].labels, (std::vector<std::string>{"1"}));
}

TEST(LookIntoSeries, KnowsChambersByTheirNamesAndLeavesTheRestOut) {
  SeriesContents contents = contentsOf("1 heart_ventricle_left 255 0 0 255\n2 aorta 0 0 255 255\n"
                                       "3 heart_myocardium 200 100 0 255\n");
  EXPECT_EQ(contents.items[0].name, "LV");
  EXPECT_EQ(contents.items[0].part, SeriesPart::cavity);
  EXPECT_EQ(contents.items[1].part, SeriesPart::unused);
  EXPECT_EQ(contents.items[2].part, SeriesPart::tissue);
  for (SeriesItem& item : contents.items)
    item.part = SeriesPart::unused;
  EXPECT_THROW(chosenSurfaces(contents, "Heart"), UsageError);
  contents.items[0].part = SeriesPart::cavity;
  EXPECT_EQ(chosenSurfaces(contents, "Heart").size(), 1U) << "one cavity needs no outside";
}

TEST(LookIntoSeries, TakesADicomSegmentationOverTime) {
  tests::SegmentWriting writing{
      .names = {{1, "left ventricle of heart"}, {2, "right ventricle of heart"}, {3, "myocardium"}},
      .phases = 6,
      .stepSeconds = 0.15};
  for (int phase = 1; phase < writing.phases; ++phase)
    writing.later.push_back(tests::beatingLabels(phase / 6.0, Vec3(4, 4, 8)));
  tests::TemporaryFolder folder;
  const auto file = folder.put("seg.dcm", tests::dicomBytes(tests::segmentationElements(
                                              tests::beatingLabels(0, Vec3(4, 4, 8)), writing)));
  Progress progress;
  const SeriesContents contents = lookIntoSeries({file}, progress);
  expectTheHeart(contents);
}

TEST(LookIntoSeries, SaysThatAPeriodIsDoubtful) {
  const SeriesContents contents = contentsOf({}, 0);
  EXPECT_FALSE(contents.periodSeconds);
}

TEST(LookIntoPhase, ListsSurfacesOfAFolderAndLabelsOfAMap) {
  tests::TemporaryFolder folder;
  const std::string tetrahedron = "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  const auto outer = folder.put("EPI_9.obj", tetrahedron), inner = folder.put("LV_9.obj", tetrahedron);
  Progress progress;
  const SeriesContents surfaces = lookIntoPhase({9, {outer, inner}}, progress);
  EXPECT_FALSE(surfaces.labels);
  EXPECT_EQ(surfaces.phases, 1U);
  ASSERT_EQ(surfaces.items.size(), 2U);
  EXPECT_EQ(surfaces.items[0].name, "EPI");
  EXPECT_EQ(surfaces.items[1].name, "LV");
  const auto map = folder.put("ed.nii", tests::niftiFile(tests::beatingLabels(0, Vec3(4, 4, 8))));
  const SeriesContents labels = lookIntoPhase({0, {map}}, progress);
  EXPECT_TRUE(labels.labels);
  ASSERT_EQ(labels.items.size(), 3U);
  EXPECT_EQ(labels.items[2].part, SeriesPart::tissue);
  EXPECT_THROW(lookIntoPhase({0, {map, outer}}, progress), DataError) << "of two kinds";
  EXPECT_THROW(lookIntoPhase({0, {folder.path() / "none.nii"}}, progress), NoInputError);
}

TEST(ReadMotionSeries, TakesOnlyTheSurfacesThatAreChosen) {
  tests::TemporaryFolder folder;
  const std::string tetrahedron = "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  for (const char* name : {"a", "b"})
    for (int phase = 1; phase <= 4; ++phase)
      folder.put(std::string(name) + "_" + std::to_string(phase) + ".obj",
                 tetrahedron + "v 1 1 " + std::to_string(phase) + "\n");
  SeriesRequest request;
  request.inputs = {folder.path()};
  request.periodSeconds = 1;
  request.loop = false;
  request.surfaces = {{"b", {}}};
  Progress progress;
  EXPECT_EQ(readMotionSeries(request, progress).names, (std::vector<std::string>{"b"}));
  request.surfaces = {{"c", {}}};
  EXPECT_THROW(readMotionSeries(request, progress), UsageError);
}

} // namespace
} // namespace viscera::live
