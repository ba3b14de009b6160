#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dicom_slices.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/scan.h"
#include "viscera/medical_io/surface_file.h"

/// DICOM files that are neither scans nor segmentations.
namespace viscera::medical_io {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using tests::DicomElements;
using tests::littleEndian;

const std::string kStorage = "UI1.2.840.10008.5.1.4.1.1.";

template <class Real>
std::string bytesOf(Real value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// A tetrahedron of 20 mm along the axes, 1.333 ml, as binary STL.
std::string tetrahedronStl(const std::string& header = "") {
  const float p[4][3] = {{0, 0, 0}, {20, 0, 0}, {0, 20, 0}, {0, 0, 20}};
  const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  std::string bytes = header + std::string(80 - header.size(), '\0') + littleEndian(4, 4);
  for (const auto& face : faces) {
    bytes += std::string(12, '\0');
    for (const int corner : face)
      for (const float coordinate : p[corner])
        bytes += bytesOf(coordinate);
    bytes += std::string(2, '\0');
  }
  return bytes;
}

constexpr const char* kTetrahedronObj = "v 0 0 0\nv 20 0 0\nv 0 20 0\nv 0 0 20\n"
                                        "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

DicomElements encapsulated(const std::string& document, const std::string& title,
                           const char* kind = "104.3") {
  DicomElements e = {{0x00080016, kStorage + kind}, {0x00080018, "UI1.2.3.4"}, {0x00080060, "CSM3D"},
                     {0x0020000D, "UI1.2.3"},       {0x0020000E, "UI1.2.3.5"}, {0x00200052, "UI1.2.9"},
                     {0x00420011, "OB" + document}};
  if (!title.empty())
    e[0x00420010] = "ST" + title;
  return e;
}

class DicomObjects : public testing::Test {
protected:
  SurfaceFile surface(const DicomElements& e, const char* name = "a.dcm") {
    return readSurface(folder_.put(name, tests::dicomBytes(e)));
  }
  /// What the error of each reader says of an object of that class, which must be the same.
  std::string refusal(const std::string& kind, const char* name = "a.dcm") {
    const auto file = folder_.put(
        name, tests::dicomBytes({{0x00080016, kind}, {0x00080018, "UI1.2.3.4"}, {0x00080060, "CSOT"}}));
    Progress progress;
    const std::string said = messageOf([&] { readSurface(file); });
    EXPECT_EQ(messageOf([&] { readLabelMap(file, progress); }), said);
    EXPECT_EQ(messageOf([&] { readScan(file, {}, progress); }), said);
    EXPECT_EQ(messageOf([&] { refuse(file); }), said);
    EXPECT_THAT(said, Not(HasSubstr("end in")));
    EXPECT_EQ(fileKind(file), FileKind::unknown);
    EXPECT_FALSE(isScan(file));
    EXPECT_FALSE(isLabelMap(file));
    return said;
  }
  template <class Read>
  static std::string messageOf(const Read& read) {
    try {
      read();
    } catch (const DataError& error) {
      return error.what();
    }
    ADD_FAILURE() << "not refused";
    return {};
  }
  tests::TemporaryFolder folder_;
};

TEST_F(DicomObjects, WithAnStlOrObjSurfaceOpenUnderItsTitle) {
  const SurfaceFile read = surface(encapsulated(tetrahedronStl(), "Liver"));
  EXPECT_EQ(read.name, "Liver");
  EXPECT_NEAR(read.report.volumeMm3, 8000.0 / 6, 1e-6);
  EXPECT_TRUE(read.spaceStated) << "the axes are those of the patient";
  EXPECT_LT((boundsOf(read.mesh.points).high - Vec3(20, 20, 20)).norm(), 1e-9);
  EXPECT_EQ(fileKind(folder_ / "a.dcm"), FileKind::surface);
  EXPECT_FALSE(isLabelMap(folder_ / "a.dcm"));
  EXPECT_FALSE(isScan(folder_ / "a.dcm"));
  EXPECT_EQ(surface(encapsulated(tetrahedronStl(), "Liver"), "M3D.1.2.3").name, "Liver") << "under any name";
  const SurfaceFile obj = surface(encapsulated(kTetrahedronObj, "Spleen", "104.4"));
  EXPECT_EQ(obj.name, "Spleen");
  EXPECT_NEAR(obj.report.volumeMm3, 8000.0 / 6, 1e-6);
}

TEST_F(DicomObjects, WithASurfaceHaveItsNameUnitAxesAndColour) {
  DicomElements e = encapsulated(tetrahedronStl("SPACE=RAS"), "");
  e[0x0040A043] = "SQ" + tests::dicomItem({{0x00080104, "LOKidney"}});
  e[0x004008EA] = "SQ" + tests::dicomItem({{0x00080100, "SHcm"}});
  e[0x0062000D] = tests::us(34885) + littleEndian(53485, 2) + littleEndian(50171, 2); // Red.
  const SurfaceFile read = surface(e);
  EXPECT_EQ(read.name, "Kidney");
  EXPECT_NEAR(read.report.volumeMm3, 8e6 / 6, 1e-3);
  EXPECT_NEAR(boundsOf(read.mesh.points).low.x(), -200, 1e-9) << "RAS is turned";
  ASSERT_EQ(read.mesh.colors.rows(), 4);
  EXPECT_GT(read.mesh.colors(0, 0), 240);
  EXPECT_LT(read.mesh.colors(0, 1), 20);
  e = encapsulated(tetrahedronStl(), "");
  e[0x0008103E] = "LOTumour";
  EXPECT_EQ(surface(e).name, "Tumour");
  EXPECT_EQ(surface(encapsulated(tetrahedronStl(), ""), "left.dcm").name, "left");
}

TEST_F(DicomObjects, WithADamagedSurfaceAreRefused) {
  const std::string stl = tetrahedronStl();
  EXPECT_THROW(surface(encapsulated(stl.substr(0, 150), "Liver")), DataError);
  EXPECT_THROW(surface(encapsulated("", "Liver")), DataError);
  const std::string whole = tests::dicomBytes(encapsulated(stl, "Liver"));
  EXPECT_THROW(readSurface(folder_.put("a.dcm", whole.substr(0, whole.size() - 30))), DataError);
}

TEST_F(DicomObjects, OfOtherKindsAreNamedWithTheWayOut) {
  EXPECT_THAT(refusal(kStorage + "481.5"), HasSubstr("RT Plan"));
  EXPECT_THAT(refusal(kStorage + "88.33"), HasSubstr("Structured Report"));
  EXPECT_THAT(refusal(kStorage + "88.59"), HasSubstr("Key Object Selection"));
  EXPECT_THAT(refusal(kStorage + "11.1"), HasSubstr("Presentation State"));
  EXPECT_THAT(refusal(kStorage + "9.1.1"), HasSubstr("ECG Waveform"));
  EXPECT_THAT(refusal(kStorage + "9.2.1"), HasSubstr("Waveform"));
  EXPECT_THAT(refusal(kStorage + "104.1"), HasSubstr("Encapsulated PDF"));
  EXPECT_THAT(refusal(kStorage + "66.1"), HasSubstr("Spatial Registration"));
  EXPECT_THAT(refusal(kStorage + "66.5"),
              AllOf(HasSubstr("Surface Segmentation"), HasSubstr("convert it to a segmentation"),
                    HasSubstr("3D Slicer")));
  EXPECT_THAT(refusal(kStorage + "66.6"), HasSubstr("Tractography"));
  EXPECT_THAT(refusal(kStorage + "66"), HasSubstr("Raw Data"));
  EXPECT_THAT(refusal(kStorage + "77.1.6"), HasSubstr("Whole Slide"));
  EXPECT_THAT(refusal(kStorage + "481.5", "RP.1.2.3"), HasSubstr("RTPLAN")) << "without an ending";
  EXPECT_THAT(refusal("UI1.2.840.10008.1.3.10", "DICOMDIR"),
              AllOf(HasSubstr("DICOMDIR"), HasSubstr(folder_.path().string())));
}

TEST_F(DicomObjects, InAFolderWithoutImagesAreNamed) {
  folder_.put("a.dcm", tests::dicomBytes({{0x00080016, kStorage + "481.3"}, {0x00080018, "UI1.2.3.4"}}));
  Progress progress;
  EXPECT_THAT(messageOf([&] { readScan(folder_.path(), {}, progress); }), HasSubstr("RTSTRUCT"));
}

/// A picture of a screen has pixels, but no place.
TEST_F(DicomObjects, WithPicturesAreNamed) {
  tests::LabelImage image = tests::emptyLabels({4, 4, 1});
  DicomElements e = tests::dicomSlice(image, 0);
  e[0x00080016] = kStorage + "7";
  e.erase(0x00200032);
  const auto file = folder_.put("a.dcm", tests::dicomBytes(e));
  Progress progress;
  EXPECT_THAT(messageOf([&] { readScan(file, {}, progress); }),
              AllOf(HasSubstr("Secondary Capture"), HasSubstr("where in the patient")));
}

} // namespace
} // namespace viscera::medical_io
