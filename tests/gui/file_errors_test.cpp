// What is wrong with a file is said in the language of the window, whatever format it has; of a damaged file,
// the detail stays in English.
#include <QFile>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dicom_slices.h"
#include "phantom_scan.h"
#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/scan.h"
#include "viscera/medical_io/surface_file.h"
#include "window/import/file_actions.h"
#include "window/style/language.h"
#include "window_test.h"

namespace viscera::tests {
namespace {

using app::InstalledLanguage;

/// What the window says first of a file that is damaged; the detail stays in English.
constexpr const char* kUnreadable = "Die Datei kann nicht gelesen werden: ";

/// A damaged file and the detail in what the window says of it.
struct BrokenFile {
  const char* name;
  std::string bytes;
  const char* detail;
};

const std::vector<BrokenFile>& brokenSurfaces() {
  static const std::string vtk = "# vtk DataFile Version 4.2\ntitle\nASCII\nDATASET POLYDATA\n";
  static const std::vector<BrokenFile> all = {
      {"a.stl", std::string(80, 'x') + std::string("\5\0\0\0", 4),
       "the file is cut off, or is not an STL file: its header promises 5 triangles (334 bytes), but it has "
       "84 "
       "bytes"},
      {"b.stl", "solid\nfacet normal 0 0 1\nouter lup\nendsolid\n",
       "line 3: \"lup\" is not a word of an STL file"},
      {"a.obj", "v 0 0 0\nv 1 0 point\n", "line 2: expected a coordinate, found \"point\""},
      {"b.obj", "v 0 0 0\nf 1 1 x\n", "line 2: expected a point's number, found \"x\""},
      {"a.ply", "ply\nformat ascii 1.0\nfaces 3\nend_header\n",
       "line 3: \"faces\" is not a word of a PLY header"},
      {"b.ply", "ply\nformat ascii 1.0\nelement vertex 5000000000\nproperty float x\nend_header\n1\n",
       "the file is cut off: its header promises 5000000000 of \"vertex\", more than the 3 bytes that are "
       "left "
       "can hold"},
      {"a.vtk", vtk + "POINTS -1 float\n", "line 5: the number of points is negative"},
      {"b.vtk", vtk + "POINTS 5 float\n0 0 0\n",
       "line 5: the file is cut off: 15 numbers should follow, but only 7 bytes are left"},
      {"a.glb", std::string("glTF\2\0\0\0\1\0\0", 11),
       "the file is cut off: the header should have 4 bytes, but only 3 are left"},
      {"a.gltf", R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [7]}], "nodes": [{}]})",
       "It refers to number 7 of \"nodes\", but there are 1 (counted from 0)"}};
  return all;
}

const std::vector<BrokenFile>& brokenLabelMaps() {
  static const std::vector<BrokenFile> all = {
      {"a.nrrd", "NRRD0004\ntype: short\ndimension 3\n",
       "line 3: this is not a line of an NRRD header: \"dimension 3\""},
      {"b.nrrd", "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2\n\n",
       "its header is damaged: it has 2 sizes for 3 dimensions"},
      {"a.mha", "NDims = 3\nDimSize = 2 2\nElementType = MET_CHAR\nElementDataFile = LOCAL\n",
       "its header is damaged: DimSize has not three numbers"},
      {"a.nii", std::string("\x5c\1\0\0", 4),
       "the file is cut off: it has 4 bytes, a NIfTI header alone has 348"}};
  return all;
}

/// What the window says of what `read` throws, without the file's place.
std::string germanOf(const std::function<void()>& read) {
  const InstalledLanguage german(QStringLiteral("de"));
  try {
    read();
  } catch (const Error& error) {
    return app::inWords(error.problem()).toStdString();
  }
  return "nothing was thrown";
}

TEST(FileErrors, OfEverySurfaceFormatBeginInGerman) {
  const TemporaryFolder folder;
  for (const BrokenFile& broken : brokenSurfaces()) {
    const auto file = folder.put(broken.name, broken.bytes);
    EXPECT_EQ(germanOf([&] { medical_io::readSurface(file); }), std::string(kUnreadable) + broken.detail)
        << broken.name;
  }
}

TEST(FileErrors, OfEveryLabelMapFormatBeginInGerman) {
  const TemporaryFolder folder;
  Progress progress;
  for (const BrokenFile& broken : brokenLabelMaps()) {
    const auto file = folder.put(broken.name, broken.bytes);
    EXPECT_EQ(germanOf([&] { medical_io::readLabelMap(file, progress); }),
              std::string(kUnreadable) + broken.detail)
        << broken.name;
  }
}

/// A user can do something about these without the program that wrote the file.
TEST(FileErrors, OfASoundFileAreWhollyInGerman) {
  const TemporaryFolder folder;
  const auto said = [&](const char* name, const char* bytes) {
    const auto file = folder.put(name, bytes);
    return germanOf([&] { medical_io::readSurface(file); });
  };
  EXPECT_EQ(said("a.vtp", "<?xml version=\"1.0\"?><VTKFile type=\"ImageData\"></VTKFile>"),
            "Die Datei heißt .vtp, sieht aber aus wie eine VTK-XML-Datei ohne Oberfläche");
  EXPECT_EQ(said("a.vtk", "# vtk DataFile Version 4.2\ntitle\nASCII\nDATASET Heart\n"),
            "Die Datei enthält „Heart“, nicht „POLYDATA“")
      << "a word of the file stays as it is";
}

TEST(FileErrors, OfADamagedDicomHeaderBeginInGerman) {
  const TemporaryFolder folder;
  LabelImage image = orientedPhantomGrid(0, {0, 1, 2});
  fillPhantom(image);
  const auto said = [&](std::uint32_t tag, const std::string& value) {
    DicomElements elements = dicomSlice(image, 3);
    elements[tag] = value;
    const auto file = folder.put("slice.dcm", dicomBytes(elements));
    return germanOf([&] {
      Progress progress;
      medical_io::readScan(file, {}, progress);
    });
  };
  const std::string damaged = std::string(kUnreadable) + "its header is damaged: ";
  EXPECT_EQ(said(0x00281053, "DS0"), damaged + "its rescale slope is 0");
  EXPECT_EQ(said(0x00200037, "DS1\\0\\0\\1\\0\\0"),
            damaged + "the directions of its rows and columns are not square");
  EXPECT_EQ(said(0x00280010, us(0)), damaged + "its size along a column is 0");
  EXPECT_EQ(said(0x00280004, "CSRGB"), "Es gibt keine Schichten eines Scans: „slice.dcm“ ist ein Farbbild");
}

TEST(FileErrors, OfWritingAreSaidInGerman) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "a.stl");
  EXPECT_EQ(germanOf([&] { medical_io::writeSurface(folder / "a.stl", sphere(1)); }),
            "Die Datei kann nicht geschrieben werden: es ist ein Ordner");
}

class GermanFiles : public WindowTest {
  InstalledLanguage german_{QStringLiteral("de")};
};

TEST_F(GermanFiles, ThatAreBrokenAreRefusedInGermanAloneAndAmongOthers) {
  QFile file(path(QStringLiteral("bauch.ply")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("ply\nformat ascii 1.0\nfaces 3\nend_header\n");
  file.close();
  const auto refused = QStringLiteral(
      "bauch.ply: Die Datei kann nicht gelesen werden: line 3: \"faces\" is not a word of a PLY "
      "header. Exportieren oder kopieren Sie die Datei neu.");
  open(file.fileName());
  EXPECT_TRUE(message().contains(refused)) << message().toStdString();
  window().files().open({sphereFile(), file.fileName()});
  settle();
  EXPECT_FALSE(document().organs().empty());
  EXPECT_TRUE(message().contains(refused)) << message().toStdString();
}

} // namespace
} // namespace viscera::tests
