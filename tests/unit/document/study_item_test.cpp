#include "viscera/document/study_item.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "beating_labels.h"
#include "cine_pictures.h"
#include "session_scene.h"
#include "viscera/core/error.h"
#include "viscera/document/scan_item.h"

namespace viscera::document {
namespace {

using testing::HasSubstr;
using viscera::tests::TemporaryFolder;

/// Writes two slices of the short axis, which make a stack, and a plane with two chambers.
void writeStudy(const TemporaryFolder& folder, const std::string& inside, double secondIntervalMs = 975) {
  std::filesystem::create_directories(folder / inside);
  for (tests::CinePicture picture :
       {tests::shortAxisPicture(3, 0, 860), tests::shortAxisPicture(4, 17.7, 829),
        tests::longAxisPicture(8, 3, secondIntervalMs)})
    for (picture.phase = 0; picture.phase < picture.phases; ++picture.phase)
      folder.put(inside + "/" + tests::cineFileName(picture),
                 tests::dicomBytes(tests::cineElements(picture)));
}

StudyItem studyIn(const std::filesystem::path& place) {
  Progress progress;
  return readStudy(place, progress);
}

TEST(StudyItem, ListsItsSeries) {
  const TemporaryFolder folder;
  writeStudy(folder, "heart");
  const StudyItem item = studyIn(folder / "heart");
  EXPECT_EQ(item.name, "MR, heart");
  const std::vector<StudySeries> series = seriesOf(*item.study);
  ASSERT_EQ(series.size(), 3u);
  EXPECT_EQ(series[0].number, 3);
  EXPECT_EQ(series[0].description, "cine");
  EXPECT_EQ(series[0].plane, medical_io::CinePlane::shortAxis);
  EXPECT_EQ(series[2].plane, medical_io::CinePlane::twoChamber);
  EXPECT_EQ(series[2].phases, 12u);
  EXPECT_EQ(series[2].phasesInCycle, 12u);
  EXPECT_NEAR(series[2].intervalSeconds, 0.975, 1e-6);
  EXPECT_EQ(series[2].spacingMm, 2);
  EXPECT_EQ(series[2].thicknessMm, 6);
}

TEST(StudyItem, IsLookedForInFoldersWithTwoSeriesOrMore) {
  const TemporaryFolder folder;
  writeStudy(folder, "heart");
  Progress progress;
  const auto found = findStudy(folder / "heart", progress);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->hash, studyHash(*found->study));
  std::filesystem::create_directories(folder / "other");
  EXPECT_FALSE(findStudy(folder.put("other/a.txt", "no picture").parent_path(), progress));
  EXPECT_FALSE(findStudy(folder.path() / "heart" / "0_3_0_0.dcm", progress)) << "a file is no folder";
}

/// Five layers of grey values in four phases, as a file of volumes over time; `low` is the darkest, negative
/// so that they are no labels.
std::string greyOverTime(const Eigen::Affine3d& indexToLps, int low) {
  std::vector<tests::LabelImage> phases;
  for (int phase = 0; phase < 4; ++phase) {
    tests::LabelImage& image = phases.emplace_back(tests::emptyLabels({12, 10, 5}));
    image.indexToLps = indexToLps;
    for (std::size_t v = 0; v < image.voxels.size(); ++v)
      image.voxels[v] = static_cast<std::int16_t>(low + phase + static_cast<int>(37 * v % 1021));
  }
  return tests::nifti4d(phases, 0.2, 8);
}

TEST(StudyItem, IsLookedForInFilesOfVolumesInPlanesOfTheirOwn) {
  const TemporaryFolder folder;
  Progress progress;
  const auto find = [&](const char* name, const Eigen::Affine3d& indexToLps, int low) {
    return findStudy(folder.put(name, greyOverTime(indexToLps, low)), progress);
  };
  const Eigen::Affine3d thick(Eigen::Scaling(1.5, 1.5, 9.0)), cubes(Eigen::Scaling(2.0, 2.0, 2.0));
  const Eigen::Affine3d tilted(Eigen::AngleAxisd(0.6, Vec3(1, 0.5, 0).normalized()));
  const auto oblique = find("oblique.nii", tilted * thick, -20);
  ASSERT_TRUE(oblique);
  EXPECT_EQ(oblique->study->slices.size(), 5u);
  EXPECT_EQ(oblique->study->stacks.size(), 1u);
  EXPECT_EQ(seriesOf(*oblique->study).size(), 1u);
  EXPECT_EQ(seriesOf(*oblique->study)[0].phases, 4u);
  EXPECT_TRUE(identical(std::make_shared<const StudyItem>(readStudy(folder / "oblique.nii", progress)),
                        std::make_shared<const StudyItem>(*oblique)))
      << "as a session reads it";
  EXPECT_TRUE(find("thick.nii", thick, -20));
  EXPECT_FALSE(find("cubes.nii", cubes, -20));
  EXPECT_FALSE(find("ct.nii", thick, -1024)) << "on the patient's axes it is seen well";
  EXPECT_FALSE(findStudy(folder / "absent.nii", progress));
}

TEST(StudyItem, IsLookedForInAFolderWithOneSeriesOfObliqueSlices) {
  const TemporaryFolder folder;
  for (const char* inside : {"oblique", "even"})
    std::filesystem::create_directories(folder / inside);
  for (const bool isOblique : {true, false})
    for (int slice = 0; slice < 3; ++slice) {
      tests::CinePicture picture = tests::shortAxisPicture(3, 9.0 * slice, 860);
      if (!isOblique) {
        picture.row = Vec3::UnitX();
        picture.column = Vec3::UnitY();
        picture.corner = Vec3(0, 0, 3.0 * slice);
        picture.thickness = 3;
      }
      picture.slice = slice;
      for (picture.phase = 0; picture.phase < picture.phases; ++picture.phase)
        folder.put((isOblique ? "oblique/" : "even/") + tests::cineFileName(picture),
                   tests::dicomBytes(tests::cineElements(picture)));
    }
  Progress progress;
  const auto found = findStudy(folder / "oblique", progress);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->study->slices.size(), 3u);
  EXPECT_EQ(seriesOf(*found->study).size(), 1u);
  EXPECT_FALSE(findStudy(folder / "even", progress)) << "a scan with phases";
}

TEST(StudyItem, IsOneStepOfTheDocumentAndTakesThePlaceOfTheScan) {
  const TemporaryFolder folder;
  writeStudy(folder, "heart");
  tests::Session s;
  medical_io::Scan scan;
  scan.size = {2, 2, 2};
  scan.samples = std::vector<std::int16_t>(8);
  s.undo.perform(openScan(scanItem(std::move(scan), {})));
  s.undo.perform(openStudy(studyIn(folder / "heart")));
  ASSERT_TRUE(s.document.state().study);
  EXPECT_FALSE(s.document.state().scan);
  s.undo.undo();
  EXPECT_TRUE(s.document.state().scan);
  EXPECT_FALSE(s.document.state().study);
  s.undo.redo();
  s.undo.perform(closeStudy());
  EXPECT_FALSE(s.document.state().study);
  EXPECT_THROW(s.undo.perform(closeStudy()), UsageError);
}

TEST(StudyItem, ComesBackWithASessionThatHasMovedAlongWithIt) {
  const TemporaryFolder folder;
  writeStudy(folder, "a/heart");
  SessionContents contents;
  contents.state.study = std::make_shared<const StudyItem>(studyIn(folder / "a/heart"));
  tests::write(folder / "a/s.viscera", contents);
  EXPECT_TRUE(identical(tests::readBack(folder / "a/s.viscera").contents.state, contents.state));
  std::filesystem::rename(folder / "a", folder / "b");
  const OpenedSession moved = tests::readBack(folder / "b/s.viscera");
  ASSERT_TRUE(moved.contents.state.study);
  EXPECT_TRUE(moved.warnings.empty());
  EXPECT_EQ(moved.contents.state.study->place, folder / "b/heart");
}

TEST(StudyItem, ThatIsGoneOrAnotherIsNamed) {
  const TemporaryFolder folder;
  writeStudy(folder, "heart");
  SessionContents contents;
  contents.state.study = std::make_shared<const StudyItem>(studyIn(folder / "heart"));
  tests::write(folder / "s.viscera", contents);
  std::filesystem::rename(folder / "heart", folder / "away");
  OpenedSession opened = tests::readBack(folder / "s.viscera");
  EXPECT_FALSE(opened.contents.state.study);
  ASSERT_EQ(opened.warnings.size(), 1u);
  EXPECT_THAT(opened.warnings[0].english(), HasSubstr("is not there any more"));
  tests::write(folder / "t.viscera", opened.contents);
  writeStudy(folder, "heart", 800);
  opened = tests::readBack(folder / "t.viscera");
  EXPECT_TRUE(opened.contents.state.study) << "its record was kept";
  ASSERT_EQ(opened.warnings.size(), 1u);
  EXPECT_THAT(opened.warnings[0].english(), HasSubstr("has changed since"));
}

TEST(StudyItem, OfASessionForOthersNamesNoFolder) {
  const TemporaryFolder folder;
  writeStudy(folder, "heart");
  SessionContents contents;
  contents.state.study = std::make_shared<const StudyItem>(studyIn(folder / "heart"));
  contents.embedSurfaces = contents.embedScan = true;
  tests::write(folder / "s.viscera", contents);
  EXPECT_EQ(tests::contentsOf(folder / "s.viscera").find(folder.path().string()), std::string::npos);
  EXPECT_TRUE(tests::readBack(folder / "s.viscera").contents.state.study) << "beside the session";
}

} // namespace
} // namespace viscera::document
