#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "identified_slices.h"
#include "run_process.h"
#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/clinic/dicom_objects.h"
#include "viscera/clinic/measurement_report.h"
#include "viscera/core/error.h"
#include "viscera/geometry/volume.h"
#include "viscera/medical_io/image_beside.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/surface_file.h"

/// What goes back to an archive is read again as what it was.
namespace viscera::clinic {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Does dicom3tools find an error? Skipped by name where it is absent.
void expectNoError(const std::filesystem::path& file) {
  const std::string program = "/usr/bin/dciodvfy";
  if (!std::filesystem::exists(program)) {
    std::cout << "skipped: there is no dciodvfy (dicom3tools)\n";
    return;
  }
  const test::ProcessResult found = test::runProcess({program, file.string()});
  EXPECT_THAT(found.err + found.out, Not(HasSubstr("Error - "))) << file;
}

/// Prints what pydicom reads of the objects in a folder: milliliters of each segment, how far the contours'
/// points are from the spheres that they are of (mm, on average), numbers of the report.
constexpr const char* kReadByPydicom = R"(
import sys, numpy, pydicom
folder, spheres = sys.argv[1], {'Liver': (-20, 5, 3, 40), 'Left kidney': (50, 10, -8, 18)}
seg = pydicom.dcmread(folder + '/seg.dcm')
measures = seg.SharedFunctionalGroupsSequence[0].PixelMeasuresSequence[0]
voxel = float(numpy.prod(measures.PixelSpacing)) * float(measures.SpacingBetweenSlices) / 1000
of = [f.SegmentIdentificationSequence[0].ReferencedSegmentNumber for f in seg.PerFrameFunctionalGroupsSequence]
for one in seg.SegmentSequence:
    frames = seg.pixel_array[[n == one.SegmentNumber for n in of]]
    print(one.SegmentLabel + '=' + str(frames.sum() * voxel))
contours = pydicom.dcmread(folder + '/rs.dcm')
for roi, drawn in zip(contours.StructureSetROISequence, contours.ROIContourSequence):
    x, y, z, radius = spheres[roi.ROIName]
    points = numpy.concatenate([numpy.reshape(c.ContourData, (-1, 3)) for c in drawn.ContourSequence]).astype(float)
    print(roi.ROIName + ' mm=' + str(numpy.abs(numpy.linalg.norm(points - (x, y, z), axis=1) - radius).mean()))
def numbers(items):
    for item in items:
        for value in getattr(item, 'MeasuredValueSequence', []):
            print(item.ConceptNameCodeSequence[0].CodeMeaning + '=' + str(value.NumericValue))
        numbers(getattr(item, 'ContentSequence', []))
numbers(pydicom.dcmread(folder + '/sr.dcm').ContentSequence)
)";

std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

class ObjectsOut : public testing::Test {
protected:
  /// 48 slices of 96 x 96 pixels, 2 x 2 x 2.5 mm, of Jane Doe.
  void SetUp() override {
    tests::LabelImage image = tests::emptyLabels({96, 96, 48});
    image.indexToLps.linear() = Vec3(2, 2, 2.5).asDiagonal();
    image.indexToLps.translation() = Vec3(-96, -96, -60);
    std::filesystem::create_directories(folder_ / "ct");
    std::vector<std::filesystem::path> files;
    for (int k = 0; k < image.size[2]; ++k) {
      files.push_back(
          folder_.put("ct/" + std::to_string(k), tests::dicomBytes(tests::identifiedSlice(image, k))));
    }
    identity_ = readStudyIdentity(files, progress_);
    liver_ = tests::sphere(5, 40, {-20, 5, 3});
    kidney_ = tests::sphere(5, 18, {50, 10, -8});
    organs_ = {{"Liver", {0.6, 0.3, 0.2}, &liver_}, {"Left kidney", {0.7, 0.2, 0.3}, &kidney_}};
  }
  ObjectSeries series(const char* description) const {
    return {newUid(), 901, description, "20241129101500", 1, newUid(), "at rest"};
  }
  static double ml(const geometry::TriangleMesh& mesh) {
    return geometry::volume(mesh.points, mesh.triangles) / 1000;
  }
  tests::TemporaryFolder folder_;
  Progress progress_;
  StudyIdentity identity_;
  geometry::TriangleMesh liver_, kidney_;
  std::vector<WrittenOrgan> organs_;
};

TEST_F(ObjectsOut, KnowWhoseTheyAreFromTheImages) {
  EXPECT_EQ(identity_.patientName, "Doe^Jane");
  EXPECT_EQ(identity_.patientId, "PID0815");
  EXPECT_EQ(identity_.frameOfReference, "1.2.840.4711.9");
  ASSERT_EQ(identity_.images.size(), 48U);
  EXPECT_LT(identity_.images.front().position.z(), identity_.images.back().position.z());
  EXPECT_EQ(identifyingElements(identity_).front().value, "Doe^Jane");
  EXPECT_THROW(readStudyIdentity({folder_.put("a.txt", "no image")}, progress_), DataError);
}

TEST_F(ObjectsOut, AsSegmentationComeBackWithVolumesNamesColoursAndTheirScan) {
  const auto file = folder_ / "seg.dcm";
  const WrittenObject written =
      writeSegmentation(file, identity_, series("Organs"), gridOfImages(identity_), organs_, progress_);
  EXPECT_EQ(written.segments, (std::vector<std::string>{"Liver", "Left kidney"}));
  expectNoError(file);
  const medical_io::LabelMap map = medical_io::readLabelMap(file, progress_);
  ASSERT_EQ(map.segments.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(map.segments[i].name, organs_[i].name);
    EXPECT_LT((map.segments[i].color - organs_[i].color).cwiseAbs().maxCoeff(), 0.004);
    EXPECT_NEAR(map.volumeMl(map.segments[i]), ml(*organs_[i].surface), 0.01 * ml(*organs_[i].surface));
  }
  EXPECT_EQ(medical_io::imageBeside(file, medical_io::ImageContents::values, progress_), folder_ / "ct");
  EXPECT_NE(bytesOf(file).find("10200004"), std::string::npos) << "SNOMED CT: liver structure";
}

TEST_F(ObjectsOut, AsSegmentationOfFineVoxelsKeepTheVolume) {
  const auto file = folder_ / "seg.dcm";
  writeSegmentation(file, identity_, series("Organs"), gridAround(organs_, 0.6), organs_, progress_);
  expectNoError(file);
  const medical_io::LabelMap map = medical_io::readLabelMap(file, progress_);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(map.volumeMl(map.segments[i]), ml(*organs_[i].surface), 0.001 * ml(*organs_[i].surface));
}

TEST_F(ObjectsOut, AsContoursComeBackWithinAQuarterOfAPixel) {
  const auto file = folder_ / "rs.dcm";
  writeStructureSet(file, identity_, series("Contours"), organs_, progress_);
  expectNoError(file);
  const medical_io::LabelMap map = medical_io::readLabelMap(file, progress_);
  ASSERT_EQ(map.segments.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const double volume = ml(*organs_[i].surface);
    EXPECT_EQ(map.segments[i].name, organs_[i].name);
    EXPECT_NEAR(map.volumeMl(map.segments[i]), volume, 0.01 * volume);
    EXPECT_LT((map.segments[i].color - organs_[i].color).cwiseAbs().maxCoeff(), 0.003);
  }
  EXPECT_EQ(medical_io::imageBeside(file, medical_io::ImageContents::values, progress_), folder_ / "ct");
}

TEST_F(ObjectsOut, AsSurfaceComeBackToSinglePrecision) {
  const auto file = folder_ / "liver.dcm";
  writeSurfaceObject(file, identity_, series("Surface"), organs_[0]);
  expectNoError(file);
  const medical_io::SurfaceFile read = medical_io::readSurface(file);
  EXPECT_EQ(read.name, "Liver");
  EXPECT_NEAR(geometry::volume(read.mesh.points, read.mesh.triangles) / 1000, ml(liver_), 1e-4 * ml(liver_));
}

TEST_F(ObjectsOut, AsDocumentCarryThePdf) {
  const auto file = folder_ / "report.dcm";
  writeDocumentObject(file, identity_, series("Report"), "Report", "%PDF-1.4\nthe end");
  expectNoError(file);
  EXPECT_NE(bytesOf(file).find("%PDF-1.4\nthe end"), std::string::npos);
  EXPECT_THROW(writeDocumentObject(file, identity_, series("Report"), "Report", "text"), DataError);
}

TEST_F(ObjectsOut, AsReportHaveTheirNumbersWithCodesUnitsAndSegments) {
  const WrittenObject segmentation = writeSegmentation(folder_ / "seg.dcm", identity_, series("Organs"),
                                                       gridOfImages(identity_), organs_, progress_);
  const std::vector<MeasuredOrgan> measured = {
      {"Liver",
       newUid(),
       1,
       "phase 1 of 25, 0 ms",
       {{quantities::kVolume, 267.5, "ml", "milliliter", "volume of the closed surface"}}},
      {"Left ventricle",
       newUid(),
       std::nullopt,
       "",
       {{quantities::kEjectionFraction, 61.25, "%", "percent", ""},
        {quantities::kLongitudinalStrain, -19.5, "%", "percent", "mean of the segments"}}}};
  const auto file = folder_ / "sr.dcm";
  writeMeasurementReport(file, identity_, series("Numbers"), segmentation, measured);
  expectNoError(file);
  const std::string bytes = bytesOf(file);
  for (const std::string& text :
       {std::string("267.5"), std::string("118565006"), std::string("61.25"), std::string("-19.5"),
        segmentation.instanceUid, std::string("phase 1 of 25")})
    EXPECT_NE(bytes.find(text), std::string::npos) << text;
  EXPECT_THROW(writeMeasurementReport(file, identity_, series("x"), std::nullopt, measured), DataError);
  EXPECT_THROW(
      writeMeasurementReport(file, identity_, series("x"), segmentation, {{"Liver", newUid(), 1, "", {}}}),
      DataError);
}

TEST_F(ObjectsOut, AreOnePatientsForOtherProgramsWhichReadTheSameNumbers) {
  const std::string entities = "/usr/bin/dcentvfy", python = "/usr/bin/python3";
  if (!std::filesystem::exists(entities) ||
      test::runProcess({python, "-c", "import pydicom, numpy"}).exitCode != 0)
    GTEST_SKIP() << "there is no dcentvfy (dicom3tools), or no python3-pydicom";
  const auto seg = folder_ / "seg.dcm", rs = folder_ / "rs.dcm", sr = folder_ / "sr.dcm",
             stl = folder_ / "stl.dcm";
  const WrittenObject segmentation =
      writeSegmentation(seg, identity_, series("Organs"), gridOfImages(identity_), organs_, progress_);
  writeStructureSet(rs, identity_, series("Contours"), organs_, progress_);
  writeSurfaceObject(stl, identity_, series("Surface"), organs_[0]);
  writeMeasurementReport(
      sr, identity_, series("Numbers"), segmentation,
      {{"Liver", newUid(), 1, "", {{quantities::kVolume, 267.5, "ml", "milliliter", ""}}}});
  const test::ProcessResult belong = test::runProcess(
      {entities, seg.string(), rs.string(), stl.string(), sr.string(), (folder_ / "ct" / "0").string()});
  EXPECT_THAT(belong.err + belong.out, Not(HasSubstr("Error"))) << "one patient, one study";

  const test::ProcessResult read = test::runProcess({python, "-c", kReadByPydicom, folder_.path().string()});
  ASSERT_EQ(read.exitCode, 0) << read.err;
  std::map<std::string, double> numbers;
  std::istringstream lines(read.out);
  for (std::string line; std::getline(lines, line);)
    numbers[line.substr(0, line.find('='))] = std::stod(line.substr(line.find('=') + 1));
  const medical_io::LabelMap map = medical_io::readLabelMap(seg, progress_);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(numbers.at(organs_[i].name), map.volumeMl(map.segments[i]), 1e-6);
    EXPECT_LT(numbers.at(organs_[i].name + " mm"), 0.5) << "a quarter of a pixel";
  }
  EXPECT_EQ(numbers.at("Volume"), 267.5) << read.out;
}

TEST_F(ObjectsOut, WithoutIdentityHoldNoneOfItsValuesAndBelongTogether) {
  const StudyIdentity clean = withoutIdentity(identity_, "secret of this export");
  EXPECT_EQ(withoutIdentity(identity_, "secret of this export").studyUid, clean.studyUid);
  EXPECT_NE(withoutIdentity(identity_, "another").studyUid, clean.studyUid);
  const auto seg = folder_ / "seg.dcm", rs = folder_ / "rs.dcm", stl = folder_ / "stl.dcm";
  writeSegmentation(seg, clean, series("Organs"), gridOfImages(clean), organs_, progress_);
  writeStructureSet(rs, clean, series("Contours"), organs_, progress_);
  writeSurfaceObject(stl, clean, series("Surface"), organs_[1]);
  for (const auto& file : {seg, rs, stl}) {
    expectNoError(file);
    const std::string bytes = bytesOf(file);
    const auto holds = [&](const std::string& text) { return bytes.find(text) != std::string::npos; };
    EXPECT_TRUE(holds(clean.studyUid));
    EXPECT_TRUE(holds(clean.frameOfReference));
    for (const IdentifyingElement& element : identifyingElements(identity_))
      if (element.value.size() > 3) { // "F" and "S1" are in every file.
        EXPECT_FALSE(holds(element.value)) << element.keyword << " in " << file;
      }
    EXPECT_FALSE(holds("Jane"));
    EXPECT_FALSE(holds("1.2.840.4711.")) << "UIDs of images";
  }
}

TEST_F(ObjectsOut, ThatCannotBeMadeAreRefused) {
  const geometry::TriangleMesh far = tests::sphere(3, 10, {900, 0, 0});
  const std::vector<WrittenOrgan> outside = {{"Far", {1, 1, 1}, &far}};
  EXPECT_THROW(writeSegmentation(folder_ / "a.dcm", identity_, series("x"), gridOfImages(identity_), outside,
                                 progress_),
               DataError);
  EXPECT_THROW(writeStructureSet(folder_ / "a.dcm", identity_, series("x"), outside, progress_), DataError);
  EXPECT_THROW(writeStructureSet(folder_ / "a.dcm", newStudyIdentity(), series("x"), organs_, progress_),
               DataError);
  EXPECT_THROW(gridOfImages(newStudyIdentity()), DataError);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "a.dcm"));
  EXPECT_THROW(writeSurfaceObject(folder_ / "none/a.dcm", identity_, series("x"), organs_[0]),
               CannotCreateError);
}

TEST(Uids, AreValidDifferentAndFollowFromTheirSecret) {
  EXPECT_NE(newUid(), newUid());
  EXPECT_EQ(uidFrom("1.2.3", "a"), uidFrom("1.2.3", "a"));
  EXPECT_NE(uidFrom("1.2.3", "a"), uidFrom("1.2.3", "b"));
  EXPECT_NE(uidFrom("b1.2.3", "a"), uidFrom("1.2.3", "ab"));
  for (const std::string& uid : {newUid(), uidFrom("1.2.3", "a")}) {
    EXPECT_LE(uid.size(), 64U);
    EXPECT_EQ(uid.find_first_not_of("0123456789."), std::string::npos) << uid;
    EXPECT_NE(uid[5], '0') << uid;
  }
}

} // namespace
} // namespace viscera::clinic
