#include "viscera/workbench/dicom_export.h"

#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "identified_slices.h"
#include "run_process.h"
#include "session_fixture.h"
#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/document/organ_commands.h"
#include "viscera/geometry/volume.h"
#include "viscera/medical_io/label_map.h"

/// What is open as DICOM objects in a folder.
namespace viscera::workbench {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string exportedBytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// Does dicom3tools find an error? Said by name where it is absent.
void expectValidDicom(const std::filesystem::path& file) {
  const std::string program = "/usr/bin/dciodvfy";
  if (!std::filesystem::exists(program)) {
    std::cout << "skipped: there is no dciodvfy (dicom3tools)\n";
    return;
  }
  const test::ProcessResult found = test::runProcess({program, file.string()});
  EXPECT_THAT(found.err + found.out, Not(HasSubstr("Error - "))) << file;
}

class DicomExporter : public testing::Test {
protected:
  /// A ventricle of two phases and a liver that has the patient's name, on 24 slices of Jane Doe.
  void SetUp() override {
    tests::LabelImage image = tests::emptyLabels({48, 48, 24});
    image.indexToLps.linear() = Vec3(4, 4, 5).asDiagonal();
    image.indexToLps.translation() = Vec3(-96, -96, -60);
    std::filesystem::create_directories(folder_ / "ct");
    for (int k = 0; k < image.size[2]; ++k) {
      folder_.put("ct/" + std::to_string(k), tests::dicomBytes(tests::identifiedSlice(image, k)));
    }
    what_.identity = studyIdentityOf(folder_ / "ct", {}, progress_);
    const geometry::TriangleMesh liver = tests::sphere(4, 40, {-40, 5, 3}),
                                 full = tests::sphere(4, 30, {45, 0, 0}),
                                 empty = tests::sphere(4, 20, {45, 0, 0});
    what_.organs = {
        {"Liver of JANE, PID0815", {0.6, 0.3, 0.2}, std::make_shared<geometry::TriangleMesh>(liver)},
        {"Left ventricle", {0.7, 0.2, 0.3}, std::make_shared<geometry::TriangleMesh>(full)}};
    what_.phases = {{0, {liver.points, full.points}}, {0.4, {liver.points, empty.points}}};
    what_.dateTime = "20241129101500";
    what_.kinds = {true, true, true, true, false};
  }

  tests::TemporaryFolder folder_;
  Progress progress_;
  DicomExport what_;
};

TEST_F(DicomExporter, WritesEveryObjectOfEveryPhaseWithoutAnError) {
  what_.kinds.document = true;
  what_.pdf = "%PDF-1.4\nthe end";
  const std::vector<DicomFile> files = writeDicomExport(folder_ / "out", what_, progress_);
  ASSERT_EQ(files.size(), 8U) << "two segmentations and reports, two surfaces, contours, a document";
  for (const DicomFile& one : files)
    expectValidDicom(one.file);
  EXPECT_EQ(files[0].object.seriesUid, files[2].object.seriesUid) << "phases are one series";
  EXPECT_EQ(files[1].object.classUid, "1.2.840.10008.5.1.4.1.1.88.22")
      << "Enhanced SR, as docs/clinic.md says";
  EXPECT_NE(files[0].object.instanceUid, files[2].object.instanceUid);
  const medical_io::LabelMap map = medical_io::readLabelMap(files[2].file, progress_);
  ASSERT_EQ(map.segments.size(), 2U);
  EXPECT_EQ(map.segments[1].name, "Left ventricle");
  EXPECT_NEAR(map.volumeMl(map.segments[1]), 33.5, 1.0);
  const std::string report = exportedBytes(folder_ / "out/measurements_phase_01.dcm");
  EXPECT_THAT(report, HasSubstr("70822001")) << "ejection fraction";
  EXPECT_THAT(report, HasSubstr("70.3")) << "1 - 8/27 in %";
  EXPECT_THAT(report, HasSubstr("Doe^Jane"));
  EXPECT_THAT(exportedBytes(folder_ / "out/measurements_phase_02.dcm"), Not(HasSubstr("70822001")));
  EXPECT_THROW(writeDicomExport(folder_ / "out", what_, progress_), CannotCreateError)
      << "nothing is replaced";
  EXPECT_TRUE(std::filesystem::exists(files[0].file));
}

/// A wall gets thicker and thinner, and ejects nothing.
TEST_F(DicomExporter, WritesAnEjectionFractionOfCavitiesOnly) {
  for (const char* const name : {"lv_wall", "LV myocardium"}) {
    what_.organs.push_back({name, {0.7, 0.4, 0.3}, what_.organs[1].mesh});
    for (ExportedPhase& phase : what_.phases)
      phase.points.push_back(phase.points[1]);
  }
  what_.kinds = {};
  what_.kinds.measurements = true;
  writeDicomExport(folder_ / "out", what_, progress_);
  const std::string report = exportedBytes(folder_ / "out/measurements_phase_01.dcm");
  std::size_t fractions = 0;
  for (std::size_t at = report.find("70822001"); at != std::string::npos;
       at = report.find("70822001", at + 1))
    ++fractions;
  EXPECT_EQ(fractions, 1U) << "of the left ventricle";
  EXPECT_THAT(report, HasSubstr("LV myocardium")) << "its volume";
}

TEST_F(DicomExporter, WithoutIdentityLeavesNoneOfItsBytes) {
  what_.withoutIdentity = true;
  const std::vector<DicomFile> files = writeDicomExport(folder_ / "out", what_, progress_);
  for (const DicomFile& one : files) {
    expectValidDicom(one.file);
    const std::string bytes = exportedBytes(one.file);
    for (const char* const value : {"Jane", "JANE", "Doe", "PID0815", "ACC4711", "19700131", "20240301",
                                    "20241129", "Abdomen of", "1.2.840.4711."})
      EXPECT_THAT(bytes, Not(HasSubstr(value))) << one.file;
  }
  EXPECT_EQ(files[0].object.segments.front(), "Liver of");
}

TEST_F(DicomExporter, RefusesAReportThatNamesThePatient) {
  what_.withoutIdentity = true;
  what_.kinds.document = true;
  what_.pdf = "%PDF-1.4\nof jane\n";
  EXPECT_THROW(writeDicomExport(folder_ / "out", what_, progress_), DataError);
  what_.pdfIsAnonymous = true;
  EXPECT_THROW(writeDicomExport(folder_ / "out", what_, progress_), DataError) << "it says Jane";
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out")) << "nothing is left";
  what_.kinds = {};
  EXPECT_THROW(writeDicomExport(folder_ / "out", what_, progress_), UsageError);
}

TEST(DicomExportOf, OrgansWithoutAScanIsAStudyOfItsOwn) {
  Workbench bench;
  bench.perform(document::addOrgans({tests::ball("Ball", 20)}));
  std::vector<Text> warnings;
  Progress progress;
  DicomExport what = dicomExportOf(bench, {}, 0, warnings, progress);
  EXPECT_THROW(dicomExportOf(bench, {"Cube"}, 0, warnings, progress), UsageError);
  EXPECT_THROW(dicomExportOf(bench, {}, 3, warnings, progress), UsageError) << "there is no motion";
  what.kinds = {true, true, true, false, false};
  const tests::TemporaryFolder folder;
  const std::vector<DicomFile> files = writeDicomExport(folder / "out", what, progress);
  ASSERT_EQ(files.size(), 3U);
  const medical_io::LabelMap map = medical_io::readLabelMap(files[0].file, progress);
  const document::Organ& ball = *bench.state().organs->front();
  EXPECT_NEAR(map.volumeMl(map.segments[0]), ball.restVolumeMm3 / 1000, 0.01 * ball.restVolumeMm3 / 1000);
  for (const DicomFile& one : files)
    expectValidDicom(one.file);
}

TEST(PrivateWords, AreTakenOutOfTexts) {
  clinic::StudyIdentity identity;
  identity.patientName = "Li^Johanna";
  identity.patientId = "4711";
  EXPECT_EQ(withoutPrivateWords("Liver of JOHANNA Li (4711)", identity), "Liver of");
  EXPECT_EQ(withoutPrivateWords("johanna_4711", identity), "");
  EXPECT_EQ(withoutPrivateWords("Tumour Smith", identity, {"Smith, Bob"}), "Tumour");
  EXPECT_EQ(withoutPrivateWords("Left kidney", identity), "Left kidney");
  EXPECT_EQ(withoutPrivateWords("Liver of JöRG, JÖRG", identity, {"Jörg"}), "Liver of , JÖRG")
      << "only the case of A to Z does not matter";
}

} // namespace
} // namespace viscera::workbench
