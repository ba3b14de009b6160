#include "viscera/document/open_files.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "beating_labels.h"
#include "label_files.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"

namespace viscera::document {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using viscera::tests::LabelImage;
using viscera::tests::TemporaryFolder;

/// A liver and a left kidney of Slicer, far too small.
std::filesystem::path segmentation(const TemporaryFolder& folder) {
  LabelImage image = viscera::tests::emptyLabels();
  image.fill({2, 2, 2}, {8, 9, 9}, 1);
  image.fill({12, 2, 2}, {18, 9, 9}, 2);
  return folder.put("a.seg.nrrd", viscera::tests::nrrdFile(
                                      image, "right-anterior-superior",
                                      "Segment0_ID:=S1\nSegment0_Name:=liver\nSegment0_Color:=0.5 0.25 0\n"
                                      "Segment0_LabelValue:=1\nSegment1_ID:=S2\nSegment1_Name:=left kidney\n"
                                      "Segment1_LabelValue:=2\n"));
}

TEST(LabelOrgans, AreClosedAndHaveTheirNamesColoursAndVolumes) {
  const TemporaryFolder folder;
  const auto file = segmentation(folder);
  Progress progress;
  const std::vector<Organ> organs = readLabelOrgans(file, {}, progress);
  ASSERT_EQ(organs.size(), 2U);
  EXPECT_EQ(organs[0].name, "liver");
  EXPECT_TRUE(organs[0].look.color.isApprox(Vec3(0.5, 0.25, 0)));
  EXPECT_TRUE(organs[0].closed());
  EXPECT_NEAR(organs[0].restVolumeMm3, 7 * 8 * 8, 0.01 * 7 * 8 * 8);
  EXPECT_EQ(organs[0].file, file);
  EXPECT_THAT(organs[0].warnings, Contains(HasSubstr("not life-sized")));
  EXPECT_EQ(organs[1].name, "left kidney");
}

TEST(LabelOrgans, AreThoseThatAreAskedFor) {
  const TemporaryFolder folder;
  const auto file = segmentation(folder);
  Progress progress;
  EXPECT_EQ(readLabelOrgans(file, {"Left_Kidney"}, progress).at(0).name, "left kidney");
  EXPECT_EQ(readLabelOrgans(file, {"1"}, progress).at(0).name, "liver");
  EXPECT_THROW(readLabelOrgans(file, {"spleen"}, progress), UsageError);
}

TEST(LabelOrgans, OfAFolderOfMasksAreOnePatient) {
  const TemporaryFolder folder;
  for (const int place : {2, 12}) {
    LabelImage mask = viscera::tests::emptyLabels();
    mask.fill({place, 2, 2}, {place + 6, 9, 9}, 1);
    folder.put(place == 2 ? "liver.nii" : "spleen.nii", viscera::tests::niftiFile(mask));
  }
  Progress progress;
  const std::vector<Organ> organs = readLabelOrgans(folder.path(), {}, progress);
  ASSERT_EQ(organs.size(), 2U);
  EXPECT_EQ(organs[1].name, "spleen");
}

TEST(LabelOrgans, OfAHeartAreOneOrganWithItsChambersAsCavities) {
  const TemporaryFolder folder;
  LabelImage image = viscera::tests::beatingLabels(0, Vec3(3, 3, 3));
  image.fill({1, 1, 1}, {5, 5, 20}, 4);
  const auto file = folder.put(
      "heart.seg.nrrd",
      viscera::tests::nrrdFile(image, "right-anterior-superior",
                               std::string(viscera::tests::kHeartKeys) +
                                   "Segment3_ID:=S4\nSegment3_Name:=aorta\nSegment3_LabelValue:=4\n"));
  Progress progress;
  const OpenedFiles opened = openFiles({segmentation(folder), file}, progress);
  ASSERT_EQ(opened.organs.size(), 6U);
  const auto& organs = opened.organs;
  EXPECT_EQ(organs[2].organ.name, "Heart");
  EXPECT_EQ(organs[2].parentInBatch, -1);
  EXPECT_EQ(organs[3].organ.name, "LV");
  EXPECT_EQ(organs[4].organ.name, "RV");
  for (const std::size_t cavity : {3, 4})
    EXPECT_EQ(organs[cavity].parentInBatch, 2) << "behind the organs of the file before";
  EXPECT_EQ(organs[5].organ.name, "aorta");
  EXPECT_EQ(organs[5].parentInBatch, -1) << "a vessel is no cavity of the heart";
  const auto voxels = std::count_if(image.voxels.begin(), image.voxels.end(),
                                    [](auto label) { return label >= 1 && label <= 3; });
  EXPECT_NEAR(organs[2].organ.restVolumeMm3, 27.0 * double(voxels), 0.01 * 27.0 * double(voxels))
      << "muscle and chambers";
  EXPECT_EQ(readLabelOrgans(file, {"myocardium"}, progress).at(0).name, "myocardium") << "as it is asked for";
  EXPECT_EQ(readLabelOrgans(file, {"heart"}, progress).at(0).name, "Heart");
}

TEST(LabelOrgans, AreOpenedLikeOtherFiles) {
  const TemporaryFolder folder;
  Progress progress;
  const OpenedFiles opened = openFiles({segmentation(folder)}, progress);
  EXPECT_EQ(opened.organs.size(), 2U);
  EXPECT_THAT(opened.warnings, Contains(HasSubstr("a.seg.nrrd: liver: a liver of")));
}

TEST(LabelOrgans, AreToldAsTheyArriveWithTheirColourAndThePlaceOfAll) {
  const TemporaryFolder folder;
  Progress progress;
  std::vector<ArrivingOrgan> arrived;
  const OpenedFiles opened = openFiles({segmentation(folder)}, progress,
                                       [&](ArrivingOrgan organ) { arrived.push_back(std::move(organ)); });
  ASSERT_EQ(arrived.size(), 2U);
  Bounds all = boundsOf(opened.organs.front().organ.mesh->points);
  for (const NewOrgan& item : opened.organs) {
    const auto same = [&](const ArrivingOrgan& organ) { return organ.name == item.organ.name; };
    const auto found = std::find_if(arrived.begin(), arrived.end(), same);
    ASSERT_NE(found, arrived.end()) << item.organ.name;
    EXPECT_EQ(found->mesh->points, item.organ.mesh->points);
    EXPECT_EQ(found->color, item.organ.look.color);
    const Bounds own = boundsOf(item.organ.mesh->points);
    all = {all.low.cwiseMin(own.low), all.high.cwiseMax(own.high)};
  }
  const double voxel = 1;
  EXPECT_LT((arrived.front().whole.low - all.low).norm(), 2 * voxel);
  EXPECT_LT((arrived.front().whole.high - all.high).norm(), 2 * voxel);
}

TEST(LabelOrgans, OfTwoFilesOpenedTogetherComeOnce) {
  const TemporaryFolder folder;
  LabelImage image = viscera::tests::emptyLabels();
  image.fill({2, 2, 2}, {8, 9, 9}, 1);
  const auto halves = viscera::tests::niftiHalves(image);
  const auto header = folder.put("Liver.hdr", halves.header), voxels = folder.put("Liver.img", halves.voxels);
  Progress progress;
  EXPECT_EQ(openFiles({header, voxels}, progress).organs.size(), 1U);
  EXPECT_EQ(openFiles({voxels, header}, progress).organs.size(), 1U);
  EXPECT_EQ(openFiles({voxels}, progress).organs.size(), 1U);
}

} // namespace
} // namespace viscera::document
