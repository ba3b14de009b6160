#include "viscera/document/scan_item.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "beating_labels.h"
#include "label_files.h"
#include "phantom_scan.h"
#include "session_scene.h"
#include "viscera/core/error.h"
#include "viscera/document/open_files.h"
#include "viscera/document/scan_fit.h"
#include "viscera/medical_io/archive_origin.h"
#include "viscera/medical_io/image_file.h"

namespace viscera::document {
namespace {

using testing::HasSubstr;
using viscera::tests::contentsOf;
using viscera::tests::TemporaryFolder;

/// A ball of 100 in a noisy ground below zero, as a NIfTI file.
std::string scanFile() {
  tests::LabelImage image = tests::emptyLabels();
  for (std::size_t v = 0; v < image.voxels.size(); ++v)
    image.voxels[v] = static_cast<std::int16_t>(-100 + static_cast<int>(v * 2654435761u >> 27 & 15));
  tests::addBall(image, Vec3(12, 10, 8), 6, 100);
  return tests::niftiFile(image);
}

/// The same ball as a label.
std::string labelFile() {
  tests::LabelImage image = tests::emptyLabels();
  tests::addBall(image, Vec3(12, 10, 8), 6, 3);
  return tests::niftiFile(image);
}

TEST(ScanItem, IsOpenedBesideTheOrgansOfTheOtherFiles) {
  TemporaryFolder folder;
  const auto ct = folder.put("ct.nii", scanFile()), labels = folder.put("labels.nii", labelFile());
  const auto ball = tests::ballFile(folder, "ball.stl");
  Progress progress;
  const OpenedFiles opened = openPatient({ball, labels, ct}, progress);
  ASSERT_TRUE(opened.scan);
  EXPECT_EQ(opened.scan->name, "ct.nii");
  EXPECT_EQ(opened.scan->scan->value(12, 10, 8), 100);
  EXPECT_EQ(opened.scan->hash, scanHash(*opened.scan->scan));
  EXPECT_EQ(opened.organs.size(), 2u);
  EXPECT_EQ(opened.name.english(), "Open 2 files");
  EXPECT_FALSE(openPatient({ball, labels}, progress).scan);
  EXPECT_FALSE(openImage(ball, progress)) << "no image at all";
}

/// Volumes of the ball, larger from phase to phase; as values of a scan where the label is 0.
std::string overTime(std::int16_t label) {
  std::vector<tests::LabelImage> phases;
  for (int phase = 0; phase < 3; ++phase) {
    tests::LabelImage& image = phases.emplace_back(tests::emptyLabels());
    for (std::size_t v = 0; v < image.voxels.size() && label == 0; ++v)
      image.voxels[v] = static_cast<std::int16_t>(-100 + static_cast<int>(v * 2654435761u >> 27 & 15));
    tests::addBall(image, Vec3(12, 10, 8), 4 + phase, label == 0 ? std::int16_t{100} : label);
  }
  return tests::nifti4d(phases, 40, 16);
}

TEST(ScanItem, OverTimeChoosesThePhaseOfItsLabels) {
  TemporaryFolder folder;
  const auto ct = folder.put("ct.nii", overTime(0)), labels = folder.put("labels.nii", overTime(3));
  Progress progress;
  EXPECT_THROW(openPatient({labels}, progress), DataError);
  const auto radiusOf = [](const OpenedFiles& opened) {
    return opened.organs.size() == 1
               ? boundsOf(opened.organs[0].organ.mesh->points).diagonal() / (2 * std::sqrt(3.0))
               : 0;
  };
  for (int phase = 0; phase < 3; ++phase) {
    auto scan = std::make_shared<const ScanItem>(openScanFile(ct, {"", phase}, progress));
    EXPECT_EQ(phaseOfLabels(labels, scan.get(), progress), phase);
    EXPECT_NEAR(radiusOf(openPatient({labels}, progress, {}, Sessions::alone, scan)), 4 + phase, 0.8)
        << phase;
  }
  EXPECT_NEAR(radiusOf(openPatient({ct, labels}, progress)), 4, 0.8) << "of the scan that is opened with it";
  const auto other =
      std::make_shared<const ScanItem>(openScanFile(folder.put("b.nii", scanFile()), {}, progress));
  EXPECT_FALSE(phaseOfLabels(labels, other.get(), progress)) << "one without phases";
  EXPECT_FALSE(phaseOfLabels(labels, nullptr, progress));
}

TEST(ScanItem, OverTimeHasAllPhasesAndComesBackWithThem) {
  TemporaryFolder folder;
  const auto ct = folder.put("ct.nii", overTime(0));
  Progress progress;
  const OpenedFiles dropped = openPatient({ct}, progress);
  ASSERT_TRUE(dropped.scan && dropped.scan->time) << "also dropped on the window";
  EXPECT_EQ(dropped.scan->name, "ct.nii");
  const ScanItem item = openScanFile(ct, {"", 1}, progress);
  ASSERT_TRUE(item.time);
  EXPECT_EQ(item.phase, 1);
  EXPECT_NEAR(fractionOf(item), 1.0 / 3, 1e-9);
  EXPECT_EQ(scanAt(item, 0.34), item.scan);
  EXPECT_EQ(scanAt(item, 0.7)->phase, 2);
  EXPECT_EQ(scanAt(item, 0.95)->phase, 0) << "around the end of the cycle";
  Document document;
  UndoStack undo(document);
  undo.perform(openScan(item));
  EXPECT_TRUE(hasImagesOverTime(document.state()));
  SessionContents contents;
  contents.state = document.state();
  undo.undo();
  EXPECT_FALSE(hasImagesOverTime(document.state()));
  tests::write(folder / "s.viscera", contents);
  const OpenedSession back = tests::readBack(folder / "s.viscera");
  EXPECT_TRUE(back.warnings.empty());
  EXPECT_TRUE(identical(back.contents.state.scan, contents.state.scan));
  ASSERT_TRUE(back.contents.state.scan->time);
  EXPECT_EQ(back.contents.state.scan->scan->phase, 1);
  EXPECT_EQ(scanAt(*back.contents.state.scan, 0.7)->phase, 2);
}

TEST(ScanItem, OverTimeSaysWhenItsPhasesHaveChanged) {
  TemporaryFolder folder;
  const auto ct = folder.put("ct.nii", overTime(0));
  Progress progress;
  SessionContents contents;
  contents.state.scan = std::make_shared<const ScanItem>(openScanFile(ct, {}, progress));
  tests::write(folder / "s.viscera", contents);
  std::filesystem::resize_file(ct, std::filesystem::file_size(ct) - 8);
  const OpenedSession back = tests::readBack(folder / "s.viscera");
  ASSERT_TRUE(back.contents.state.scan && back.contents.state.scan->time);
  EXPECT_EQ(back.contents.state.scan->time->missing.size(), 1U);
  ASSERT_EQ(back.warnings.size(), 1U);
  EXPECT_THAT(back.warnings[0].english(), HasSubstr("has changed since the session was saved"));
  EXPECT_FALSE(scanAt(*back.contents.state.scan, 0.7)) << "nothing is made up for a damaged phase";
}

/// The bytes that this process has read from files so far; empty where the system does not count them.
std::optional<std::uintmax_t> bytesRead() {
  std::ifstream counts("/proc/self/io");
  std::string name;
  std::uintmax_t bytes = 0;
  while (counts >> name >> bytes)
    if (name == "rchar:")
      return bytes;
  return std::nullopt;
}

TEST(ScanItem, AndLabelMapsAreReadOnceFromTheirFiles) {
  if (!bytesRead())
    GTEST_SKIP() << "this system does not count the bytes that a process reads";
  TemporaryFolder folder;
  tests::LabelImage labels = tests::emptyLabels({100, 100, 100}), values = labels;
  tests::addBall(labels, Vec3(30, 40, 50), 20, 3);
  for (std::size_t v = 0; v < values.voxels.size(); ++v)
    values.voxels[v] = static_cast<std::int16_t>(v * 2654435761u >> 24);
  for (const tests::LabelImage* image : {&labels, &values}) {
    const auto file = folder.put("image.nii", tests::niftiFile(*image));
    const auto size = static_cast<double>(std::filesystem::file_size(file));
    Progress progress;
    const auto before = *bytesRead();
    const OpenedFiles opened = openPatient({file}, progress);
    const auto read = static_cast<double>(*bytesRead() - before);
    EXPECT_EQ(opened.scan != nullptr, image == &values);
    EXPECT_GE(read, size);
    EXPECT_LT(read, 1.1 * size);
  }
}

TEST(ScanItem, WithNoiseInItIsNoLabelMapEvenWithoutNegativeValues) {
  const auto noise = [](const Vec3& p) { return 40.0 + int(p.x() * 7 + p.y() * 5 + p.z() * 3) % 11; };
  tests::LabelImage image = tests::emptyLabels({12, 12, 12});
  for (int k = 0; k < 12; ++k)
    for (int j = 0; j < 12; ++j)
      for (int i = 0; i < 12; ++i)
        image.at(i, j, k) = static_cast<std::int16_t>(noise(Vec3(i, j, k)));
  TemporaryFolder folder;
  Progress progress;
  const auto contents = [&] {
    return medical_io::imageContents(folder.put("a.nii", tests::niftiFile(image)), progress);
  };
  EXPECT_EQ(contents(), medical_io::ImageContents::values);
  image.voxels.assign(image.voxels.size(), 4);
  EXPECT_EQ(contents(), medical_io::ImageContents::labels);
}

TEST(ScanItem, IsOneStepOfTheDocument) {
  tests::Session s;
  s.undo.perform(
      openScan(scanItem(tests::phantomScan({4, 4, 4}, Vec3::Ones(), Vec3::Zero(), tests::slope), {})));
  ASSERT_TRUE(s.document.state().scan);
  EXPECT_EQ(s.document.state().scan->name, "CT");
  s.undo.perform(closeScan());
  EXPECT_FALSE(s.document.state().scan);
  s.undo.undo();
  EXPECT_TRUE(s.document.state().scan);
  s.undo.undo();
  EXPECT_FALSE(s.document.state().scan);
  EXPECT_THROW(s.undo.perform(closeScan()), UsageError);
}

TEST(ScanItem, ComesBackWithASessionThatHasMovedAlongWithIt) {
  TemporaryFolder folder;
  std::filesystem::create_directories(folder / "a");
  const auto ct = folder.put("a/ct.nii", scanFile());
  Progress progress;
  SessionContents contents;
  contents.state.scan = std::make_shared<const ScanItem>(openScanFile(ct, {}, progress));
  tests::write(folder / "a/s.viscera", contents);
  EXPECT_TRUE(identical(tests::readBack(folder / "a/s.viscera").contents.state, contents.state));
  std::filesystem::rename(folder / "a", folder / "b");
  const OpenedSession moved = tests::readBack(folder / "b/s.viscera");
  ASSERT_TRUE(moved.contents.state.scan);
  EXPECT_TRUE(moved.warnings.empty());
  EXPECT_EQ(moved.contents.state.scan->file, folder / "b/ct.nii");
}

/// A document with an organ, its scan of every kind of fact, and the file that the scan came from.
SessionContents patient(const TemporaryFolder& folder) {
  SessionContents contents = tests::fullContents(folder);
  Progress progress;
  medical_io::Scan scan = medical_io::readScan(folder.put("ct.nii", scanFile()), {}, progress);
  scan.indexToLps = Eigen::AngleAxisd(0.1, Vec3(1, 2, 3).normalized()) * scan.indexToLps;
  scan.slope = 1.0 / 3;
  scan.padding = -101;
  scan.modality = "CT";
  scan.unit = "HU";
  scan.description = "Abdomen \"5.0\"";
  scan.phaseTimesMs = {0, 0.1};
  scan.phase = 1;
  scan.window = medical_io::ValueWindow{60, 160};
  scan.findings = {{medical_io::ScanFinding::Kind::tilt, "The gantry is tilted by 3 degrees"}};
  contents.state.scan = std::make_shared<const ScanItem>(scanItem(std::move(scan), folder / "ct.nii"));
  contents.embedSurfaces = contents.embedScan = true;
  return contents;
}

TEST(ScanItem, LiesWithTheOrgansInsideASessionToTheLastBit) {
  TemporaryFolder folder;
  const SessionContents contents = patient(folder);
  tests::write(folder / "s.viscera", contents);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    if (entry.path().extension() != ".viscera")
      std::filesystem::remove(entry.path());
  const OpenedSession again = tests::readBack(folder / "s.viscera");
  EXPECT_TRUE(again.warnings.empty());
  EXPECT_EQ(again.contents.state.organs->size(), contents.state.organs->size());
  ASSERT_TRUE(again.contents.state.scan);
  EXPECT_TRUE(identical(again.contents.state.scan, contents.state.scan));
  const medical_io::Scan &was = *contents.state.scan->scan, &is = *again.contents.state.scan->scan;
  EXPECT_EQ(is.padding, was.padding);
  EXPECT_EQ(is.unit, was.unit);
  EXPECT_EQ(is.description, was.description);
  EXPECT_EQ(is.phaseTimesMs, was.phaseTimesMs);
  EXPECT_EQ(is.phase, was.phase);
  EXPECT_EQ(is.window->width, was.window->width);
  ASSERT_EQ(is.findings.size(), 1u);
  EXPECT_EQ(is.findings[0].kind, was.findings[0].kind);
  EXPECT_EQ(is.findings[0].sentence.english(), was.findings[0].sentence.english());
  tests::write(folder / "again.viscera", again.contents);
  const auto record = [&](const char* name) {
    return nlohmann::ordered_json::parse(contentsOf(folder / name)).at("scan").dump();
  };
  EXPECT_EQ(record("again.viscera"), record("s.viscera"));
}

TEST(ScanItem, InsideASessionNamesNoFolder) {
  TemporaryFolder folder;
  const SessionContents contents = patient(folder);
  std::filesystem::create_directory(folder / "sent");
  tests::write(folder / "sent" / "s.viscera", contents);
  EXPECT_EQ(contentsOf(folder / "sent" / "s.viscera").find(folder.path().string()), std::string::npos);
  const OpenedSession again = tests::readBack(folder / "sent" / "s.viscera");
  EXPECT_TRUE(again.warnings.empty());
  ASSERT_TRUE(again.contents.state.scan);
  EXPECT_EQ(again.contents.state.scan->file, folder / "sent" / "ct.nii");
}

TEST(ScanItem, ThatIsInNoFileIsKeptInsideOfALinkedSession) {
  TemporaryFolder folder;
  SessionContents contents;
  contents.state.scan = std::make_shared<const ScanItem>(
      scanItem(tests::phantomScan({4, 4, 4}, Vec3::Ones(), Vec3::Zero(), tests::slope), {}));
  tests::write(folder / "s.viscera", contents);
  const OpenedSession again = tests::readBack(folder / "s.viscera");
  EXPECT_TRUE(identical(again.contents.state.scan, contents.state.scan));
  EXPECT_FALSE(again.contents.embedScan);
}

TEST(ScanItem, InsideASessionIsRefusedWhereItIsDamaged) {
  TemporaryFolder folder;
  tests::write(folder / "s.viscera", patient(folder));
  const auto whole = nlohmann::ordered_json::parse(contentsOf(folder / "s.viscera"));
  const auto refusal = [&](const auto& damage) -> std::string {
    auto json = whole;
    damage(json["scan"]["image"]);
    folder.put("damaged.viscera", json.dump());
    try {
      tests::readBack(folder / "damaged.viscera");
    } catch (const DataError& error) {
      return error.where().english() + ": " + error.what();
    }
    return "none";
  };
  using Json = nlohmann::ordered_json;
  EXPECT_THAT(refusal([](Json& image) {
                image["size"] = {1000000, 1000000, 1000000};
              }),
              HasSubstr("holds less than 1000000000000000000 voxels"));
  EXPECT_THAT(refusal([](Json& image) { image["size"][0] = 25; }), HasSubstr("does not hold"));
  EXPECT_THAT(refusal([](Json& image) { image["size"][0] = 0; }), HasSubstr("scan.image.size"));
  EXPECT_THAT(refusal([](Json& image) { image["type"] = "int12"; }), HasSubstr("int12"));
  EXPECT_THAT(refusal([](Json& image) { image["indexToLps"][2] = image["indexToLps"][1]; }),
              HasSubstr("one plane"));
  EXPECT_THAT(refusal([](Json& image) { image["samples"] = "****"; }), HasSubstr("base64"));
  EXPECT_THAT(refusal([](Json& image) { image["window"]["width"] = -1; }), HasSubstr("positive"));
  EXPECT_EQ(refusal([](Json&) {}), "none");
}

TEST(ScanItem, ThatIsGoneIsNamedAndStaysInTheSession) {
  TemporaryFolder folder;
  const auto ct = folder.put("ct.nii", scanFile());
  Progress progress;
  SessionContents contents;
  contents.state.scan = std::make_shared<const ScanItem>(openScanFile(ct, {}, progress));
  tests::write(folder / "s.viscera", contents);
  std::filesystem::remove(ct);
  OpenedSession without = tests::readBack(folder / "s.viscera");
  EXPECT_FALSE(without.contents.state.scan);
  ASSERT_EQ(without.warnings.size(), 1u);
  EXPECT_THAT(without.warnings.front().english(), HasSubstr("ct.nii"));
  tests::write(folder / "again.viscera", without.contents);
  EXPECT_EQ(contentsOf(folder / "again.viscera"), contentsOf(folder / "s.viscera"));
  folder.put("ct.nii", "no scan at all");
  EXPECT_THAT(tests::readBack(folder / "s.viscera").warnings.front().english(),
              HasSubstr("cannot be opened"));
}

TEST(ScanItem, FromAnArchiveNamesItAndIsFoundWhereItIsFetchedAgain) {
  TemporaryFolder folder;
  std::filesystem::create_directories(folder / "fetched");
  folder.put("fetched/ct.nii", scanFile());
  medical_io::writeArchiveOrigin(folder / "fetched", {"Ward", "1.2.3", "1.2.3.4"});
  Progress progress;
  SessionContents contents;
  contents.state.scan =
      std::make_shared<const ScanItem>(openScanFile(folder / "fetched/ct.nii", {}, progress));
  tests::write(folder / "s.viscera", contents);
  std::filesystem::rename(folder / "fetched", folder / "again");
  OpenedSession without = tests::readBack(folder / "s.viscera");
  ASSERT_EQ(without.warnings.size(), 1u);
  EXPECT_THAT(without.warnings.front().english(), HasSubstr("the archive Ward has them"));
  const auto origin = archiveOriginOf(without.contents.missingScan);
  ASSERT_TRUE(origin);
  EXPECT_EQ(origin->archive, "Ward");
  EXPECT_EQ(origin->studyUid, "1.2.3");
  EXPECT_EQ(origin->seriesUid, "1.2.3.4");
  const OpenedSession opened =
      readSession(folder / "s.viscera", sample_organs::standardLibrary(), progress, {folder / "again"});
  EXPECT_TRUE(opened.contents.state.scan);
  EXPECT_TRUE(opened.warnings.empty());
  contents.state.scan = opened.contents.state.scan;
  contents.embedSurfaces = contents.embedScan = true;
  tests::write(folder / "inside.viscera", contents);
  EXPECT_THAT(contentsOf(folder / "inside.viscera"), testing::Not(HasSubstr("1.2.3.4")))
      << "Its UIDs lead to the patient.";
}

TEST(ScanItem, IsLookedForInOtherFoldersAndMayBeOneOfThem) {
  TemporaryFolder folder, other;
  const auto ct = folder.put("ct.nii", scanFile());
  Progress progress;
  SessionContents contents;
  contents.state.scan = std::make_shared<const ScanItem>(openScanFile(ct, {}, progress));
  tests::write(folder / "s.viscera", contents);
  std::filesystem::rename(ct, other / "ct.nii");
  EXPECT_FALSE(tests::readBack(folder / "s.viscera").contents.state.scan);
  for (const std::filesystem::path& also : {other.path(), other / "ct.nii"}) {
    const OpenedSession opened =
        readSession(folder / "s.viscera", sample_organs::standardLibrary(), progress, {also});
    ASSERT_TRUE(opened.contents.state.scan) << also;
    EXPECT_EQ(opened.contents.state.scan->file, other / "ct.nii");
    EXPECT_TRUE(opened.contents.missingScan.empty());
    EXPECT_TRUE(opened.warnings.empty()) << also;
  }
}

TEST(ScanItem, WhoseFileHasChangedIsTakenAndNamed) {
  TemporaryFolder folder;
  const auto ct = folder.put("ct.nii", scanFile());
  Progress progress;
  SessionContents contents;
  contents.state.scan = std::make_shared<const ScanItem>(openScanFile(ct, {}, progress));
  tests::write(folder / "s.viscera", contents);
  EXPECT_TRUE(tests::readBack(folder / "s.viscera").warnings.empty());
  std::string other = scanFile();
  other[other.size() - 3] ^= 1; // Of a voxel.
  folder.put("ct.nii", other);
  OpenedSession opened = tests::readBack(folder / "s.viscera");
  ASSERT_EQ(opened.warnings.size(), 1u);
  EXPECT_THAT(opened.warnings.front().english(), HasSubstr("ct.nii has changed since the session was saved"));
  ASSERT_TRUE(opened.contents.state.scan);
  tests::write(folder / "s.viscera", opened.contents);
  EXPECT_TRUE(tests::readBack(folder / "s.viscera").warnings.empty()) << "the new one is meant now";
}

TEST(ScanItem, FromInsideASessionIsComparedWithItsFileWhenOnlyThatIsNamed) {
  TemporaryFolder folder;
  Progress progress;
  SessionContents contents;
  contents.state.scan =
      std::make_shared<const ScanItem>(openScanFile(folder.put("ct.nii", scanFile()), {}, progress));
  contents.embedScan = true;
  tests::write(folder / "inside.viscera", contents);
  SessionContents opened = tests::readBack(folder / "inside.viscera").contents;
  EXPECT_EQ(opened.state.scan->hash, contents.state.scan->hash);
  opened.embedScan = false;
  tests::write(folder / "named.viscera", opened);
  EXPECT_TRUE(tests::readBack(folder / "named.viscera").warnings.empty());
  std::string other = scanFile();
  other[other.size() - 3] ^= 1; // Of a voxel.
  folder.put("ct.nii", other);
  EXPECT_EQ(tests::readBack(folder / "named.viscera").warnings.size(), 1u);
}

TEST(ScanItem, ThatIsDamagedAndCannotBeALabelMapIsRefusedWithTheReason) {
  TemporaryFolder folder;
  const auto damaged = folder.put("slice.dcm", std::string(128, '\0') + "DICM" + std::string(60, 'x'));
  Progress progress;
  EXPECT_THROW(openImage(damaged, progress), DataError);
  EXPECT_THROW(openPatient({damaged}, progress), DataError);
  try {
    openFiles({damaged}, progress);
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("It is a scan, not an organ"));
    EXPECT_THAT(error.what(), HasSubstr("Open a scan"));
  }
}

TEST(ScanFit, SaysWhenLabelMapAndScanHaveOtherGridsOrPlaces) {
  TemporaryFolder folder;
  tests::Session s;
  EXPECT_TRUE(scanFit(s.document.state()).empty()) << "there is no scan";
  Progress progress;
  const auto labels = folder.put("labels.nii", labelFile());
  s.undo.perform(openFiles({labels}, progress).command());
  const medical_io::ScanSeries grid = medical_io::listScans(labels, progress).front();
  const auto onGrid = [&](const Eigen::Affine3d& indexToLps, std::optional<std::array<int, 3>> size = {}) {
    medical_io::Scan scan =
        tests::phantomScan(size.value_or(grid.size), Vec3::Ones(), Vec3::Zero(), tests::slope);
    scan.indexToLps = indexToLps;
    s.undo.perform(openScan(scanItem(std::move(scan), {})));
    return scanFit(s.document.state());
  };
  s.undo.perform(removeOrgans({s.organ(0)}));
  EXPECT_TRUE(onGrid(grid.indexToLps).empty());
  // The same voxels, told from the other end of an axis, and with two axes exchanged.
  Eigen::Affine3d flipped = grid.indexToLps * Eigen::Translation3d(0, grid.size[1] - 1, 0);
  flipped.linear().col(1) *= -1;
  EXPECT_TRUE(onGrid(flipped).empty());
  Eigen::Affine3d exchanged = flipped;
  exchanged.linear().col(0).swap(exchanged.linear().col(1));
  EXPECT_TRUE(onGrid(exchanged, std::array{grid.size[1], grid.size[0], grid.size[2]}).empty());
  EXPECT_EQ(onGrid(exchanged).size(), 1u) << "axes of other lengths";
  Eigen::Affine3d finer = grid.indexToLps;
  finer.linear() *= 0.9;
  std::vector<std::string> odd = inEnglish(onGrid(finer));
  ASSERT_EQ(odd.size(), 1u);
  EXPECT_THAT(odd[0], HasSubstr("has another grid"));
  EXPECT_THAT(odd[0], HasSubstr("nothing is resampled"));
  odd = inEnglish(onGrid(Eigen::Translation3d(0, 0, 400) * grid.indexToLps));
  ASSERT_EQ(odd.size(), 2u);
  EXPECT_THAT(odd[1], HasSubstr("lies outside of the scan"));
}

} // namespace
} // namespace viscera::document
