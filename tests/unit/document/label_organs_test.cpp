#include "viscera/document/open_files.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "beating_labels.h"
#include "clouds.h"
#include "label_files.h"
#include "session_scene.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/document/undo_stack.h"

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
  EXPECT_THAT(inEnglish(organs[0].warnings), Contains(HasSubstr("not life-sized")));
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

/// A heart with two chambers and, apart from it, a label with that name.
std::filesystem::path heartFile(const TemporaryFolder& folder, const std::string& apart = "aorta") {
  LabelImage image = viscera::tests::beatingLabels(0, Vec3(3, 3, 3));
  image.fill({1, 1, 1}, {5, 5, 20}, 4);
  return folder.put("heart.seg.nrrd", viscera::tests::nrrdFile(image, "right-anterior-superior",
                                                               std::string(viscera::tests::kHeartKeys) +
                                                                   "Segment3_ID:=S4\nSegment3_Name:=" +
                                                                   apart + "\nSegment3_LabelValue:=4\n"));
}

TEST(LabelOrgans, StayApartWhereTwoOfThemAreTheSameChamber) {
  const TemporaryFolder folder;
  Progress progress;
  const OpenedFiles opened = openFiles({heartFile(folder, "LV")}, progress);
  ASSERT_EQ(opened.organs.size(), 4U) << "no heart is made of two left ventricles";
  for (const NewOrgan& item : opened.organs)
    EXPECT_EQ(item.parentInBatch, -1) << item.organ.name;
}

TEST(LabelOrgans, OfTwoHeartsStayWithTheirOwnWhateverTheyAreCalled) {
  const TemporaryFolder folder;
  Progress progress;
  Document document;
  UndoStack undo(document);
  undo.perform(openFiles({heartFile(folder)}, progress).command());
  undo.perform(renameOrgan(document.organs()[1]->id, "Cavity"));
  undo.perform(renameOrgan(document.organs()[0]->id, "Patient A"));
  undo.perform(openFiles({heartFile(folder)}, progress).command());
  const OrganList& organs = document.organs();
  ASSERT_EQ(organs.size(), 8U);
  for (const std::size_t heart : {0U, 4U}) {
    EXPECT_FALSE(organs[heart]->parent);
    for (const std::size_t chamber : {heart + 1, heart + 2})
      EXPECT_EQ(organs[chamber]->parent, organs[heart]->id) << organs[chamber]->name;
    EXPECT_FALSE(organs[heart + 3]->parent) << organs[heart + 3]->name;
  }
  undo.perform(removeOrgans({organs[4]->id}));
  EXPECT_EQ(document.organs().size(), 5U) << "the second heart went with its own chambers";
}

/// What `openCommand` tells of one opening.
struct Told {
  int changes = 0;
  std::vector<std::string> steps;
  std::size_t handles = 0;
};

Told open(Document& document, UndoStack& undo, const std::filesystem::path& file, bool replacing) {
  Progress progress;
  Told told;
  const Subscription subscription = document.onChange([&told](const Change&) { ++told.changes; });
  const auto place = [](const Organ& organ, const OrganList& organs) {
    EXPECT_EQ(organ.id, organs.front()->id) << "the first new one of all";
    return replaceRig(rigAt(viscera::tests::onSphere(12, 200)));
  };
  undo.perform(openCommand("Open it", openFiles({file}, progress), replacing, place));
  told.steps = inEnglish(undo.names());
  told.handles = document.rig().handles.size();
  return told;
}

TEST(OpenCommand, IsOneStepAndOneChangeForASurfaceAFileOfLabelsAndAHeart) {
  const TemporaryFolder folder;
  const auto ball = viscera::tests::ballFile(folder, "ball.stl");
  for (const auto& [file, organs] :
       {std::pair(ball, 1U), {segmentation(folder), 2U}, {heartFile(folder), 4U}}) {
    Document document;
    UndoStack undo(document);
    const Told first = open(document, undo, file, true);
    EXPECT_EQ(first.changes, 1) << file;
    EXPECT_EQ(first.steps, std::vector<std::string>{"Open it"});
    EXPECT_EQ(first.handles, 12U);
    const Told again = open(document, undo, file, true);
    EXPECT_EQ(again.changes, 1) << "in place of others";
    EXPECT_EQ(document.organs().size(), organs);
    const Told beside = open(document, undo, file, false);
    EXPECT_EQ(beside.changes, 1) << "beside others, whose handles stay";
    EXPECT_EQ(document.organs().size(), 2 * organs);
    EXPECT_EQ(beside.steps.size(), 3U);
    undo.goTo(0);
    EXPECT_TRUE(document.organs().empty());
  }
}

TEST(LabelOrgans, AreOpenedLikeOtherFiles) {
  const TemporaryFolder folder;
  Progress progress;
  const OpenedFiles opened = openFiles({segmentation(folder)}, progress);
  EXPECT_EQ(opened.organs.size(), 2U);
  EXPECT_THAT(inEnglish(opened.warnings), Contains(HasSubstr("a.seg.nrrd: liver: a liver of")));
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
