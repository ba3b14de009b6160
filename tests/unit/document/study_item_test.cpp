#include "viscera/document/study_item.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
