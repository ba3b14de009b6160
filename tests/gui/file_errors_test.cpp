// What is wrong with a file is said in the language of the window, whatever format it has.
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
#include "window/file_actions.h"
#include "window/language.h"
#include "window/phrase_translator.h"
#include "window_test.h"

namespace viscera::tests {
namespace {

using app::InstalledLanguage;

/// A damaged file and what the window says of it.
struct BrokenFile {
  const char* name;
  std::string bytes;
  const char* german;
};

const std::vector<BrokenFile>& brokenSurfaces() {
  static const std::string vtk = "# vtk DataFile Version 4.2\ntitle\nASCII\nDATASET POLYDATA\n";
  static const std::vector<BrokenFile> all = {
      {"a.stl", std::string(80, 'x') + std::string("\5\0\0\0", 4),
       "Die Datei ist abgeschnitten oder keine STL-Datei: ihr Kopf verspricht 5 Dreiecke (334 Bytes), sie "
       "hat "
       "aber 84 Bytes"},
      {"b.stl", "solid\nfacet normal 0 0 1\nouter lup\nendsolid\n",
       "Zeile 3: „lup“ ist kein Wort einer STL-Datei"},
      {"a.obj", "v 0 0 0\nv 1 0 point\n", "Zeile 2: eine Koordinate erwartet, aber „point“ gefunden"},
      {"b.obj", "v 0 0 0\nf 1 2\n", "Zeile 2: eine Fläche hat weniger als drei Ecken"},
      {"a.ply", "ply\nformat ascii 1.0\nfaces 3\nend_header\n",
       "Zeile 3: „faces“ ist kein Wort eines PLY-Kopfes"},
      {"b.ply", "ply\nformat ascii 1.0\nelement vertex 5000000000\nproperty float x\nend_header\n1\n",
       "Die Datei ist abgeschnitten: ihr Kopf verspricht 5000000000 von „vertex“, mehr als in die übrigen 3 "
       "Bytes passt"},
      {"a.vtk", vtk + "POINTS -1 float\n", "Zeile 5: die Zahl der Punkte ist negativ"},
      {"b.vtk", vtk + "POINTS 5 float\n0 0 0\n",
       "Zeile 5: die Datei ist abgeschnitten: 15 Zahlen sollten folgen, aber nur 7 Bytes sind übrig"},
      {"a.vtp", "<?xml version=\"1.0\"?><VTKFile type=\"ImageData\"></VTKFile>",
       "Die Datei heißt .vtp, sieht aber aus wie eine VTK-XML-Datei ohne Oberfläche"},
      {"a.glb", std::string("glTF\2\0\0\0\1\0\0", 11),
       "Die Datei ist abgeschnitten: der Kopf sollte 4 Bytes haben, aber nur 3 sind übrig"},
      {"a.gltf", R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [7]}], "nodes": [{}]})",
       "Sie verweist auf Nummer 7 von „nodes“, es gibt aber 1 (von 0 an gezählt)"}};
  return all;
}

const std::vector<BrokenFile>& brokenLabelMaps() {
  static const std::vector<BrokenFile> all = {
      {"a.nrrd", "NRRD0004\ntype: short\ndimension 3\n",
       "Zeile 3: das ist keine Zeile eines NRRD-Kopfes: „dimension 3“"},
      {"b.nrrd", "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 2\n\n",
       "Ihr Kopf ist beschädigt: er hat 2 Größen für 3 Dimensionen"},
      {"a.mha", "NDims = 3\nDimSize = 2 2\nElementType = MET_CHAR\nElementDataFile = LOCAL\n",
       "Ihr Kopf ist beschädigt: DimSize hat nicht drei Zahlen"},
      {"a.nii", std::string("\x5c\1\0\0", 4),
       "Die Datei ist abgeschnitten: sie hat 4 Bytes, ein NIfTI-Kopf allein hat 348"}};
  return all;
}

/// What the window says of what `read` throws, without the file's place.
std::string germanOf(const std::function<void()>& read) {
  const InstalledLanguage german(QStringLiteral("de"));
  try {
    read();
  } catch (const Error& error) {
    return app::messageInWords(error.problem()).toStdString();
  }
  return "nothing was thrown";
}

TEST(FileErrors, OfEverySurfaceFormatAreSaidInGerman) {
  const TemporaryFolder folder;
  for (const BrokenFile& broken : brokenSurfaces()) {
    const auto file = folder.put(broken.name, broken.bytes);
    EXPECT_EQ(germanOf([&] { medical_io::readSurface(file); }), broken.german) << broken.name;
  }
}

TEST(FileErrors, OfEveryLabelMapFormatAreSaidInGerman) {
  const TemporaryFolder folder;
  Progress progress;
  for (const BrokenFile& broken : brokenLabelMaps()) {
    const auto file = folder.put(broken.name, broken.bytes);
    EXPECT_EQ(germanOf([&] { medical_io::readLabelMap(file, progress); }), broken.german) << broken.name;
  }
}

TEST(FileErrors, OfADamagedDicomHeaderAreSaidInGerman) {
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
  EXPECT_EQ(said(0x00281053, "DS0"),
            "Ihr Kopf ist beschädigt: die Reskalierungssteigung (Rescale Slope) ist 0");
  EXPECT_EQ(said(0x00200037, "DS1\\0\\0\\1\\0\\0"),
            "Ihr Kopf ist beschädigt: die Richtungen ihrer Zeilen und Spalten stehen nicht rechtwinklig");
  EXPECT_EQ(said(0x00280010, us(0)), "Ihr Kopf ist beschädigt: die Größe entlang einer Spalte ist 0");
  EXPECT_EQ(said(0x00280004, "CSRGB"), "Es gibt keine Schichten eines Scans: „slice.dcm“ ist ein Farbbild");
}

TEST(FileErrors, OfWritingAreSaidInGerman) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "a.stl");
  EXPECT_EQ(germanOf([&] { medical_io::writeSurface(folder / "a.stl", sphere(1)); }),
            "Die Datei kann nicht geschrieben werden: es ist ein Ordner");
}

TEST(FileErrors, QuoteAWordOfTheFileAsItIs) {
  const InstalledLanguage german(QStringLiteral("de"));
  EXPECT_EQ(app::messageInWords("the format \"Heart\" is not known"),
            QStringLiteral("das Format „Heart“ ist nicht bekannt"));
}

class GermanFiles : public WindowTest {
  InstalledLanguage german_{QStringLiteral("de")};
};

TEST_F(GermanFiles, ThatAreBrokenAreRefusedInGermanAloneAndAmongOthers) {
  QFile file(path(QStringLiteral("bauch.ply")));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("ply\nformat ascii 1.0\nfaces 3\nend_header\n");
  file.close();
  const auto refused = QStringLiteral("bauch.ply: Zeile 3: „faces“ ist kein Wort eines PLY-Kopfes. "
                                      "Exportieren oder kopieren Sie die Datei neu.");
  open(file.fileName());
  EXPECT_TRUE(message().contains(refused)) << message().toStdString();
  window().files().open({sphereFile(), file.fileName()});
  settle();
  EXPECT_FALSE(document().organs().empty());
  EXPECT_TRUE(message().contains(refused)) << message().toStdString();
}

} // namespace
} // namespace viscera::tests
