#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <vtkAppendPolyData.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataWriter.h>
#include <vtkSphereSource.h>
#include <vtkStringArray.h>
#include <vtkStripper.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>

#include "mesh_checks.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/surface_file.h"

/// Legacy VTK and VTP in every way that VTK writes them.
namespace viscera::medical_io {
namespace {

using test::warnsOf;
using testing::HasSubstr;
using tests::TemporaryFolder;

constexpr int kPoints = 62;
constexpr int kTriangles = 120;

/// A sphere of 50 mm with normals, colours and a field that says RAS; as triangles or strips.
vtkSmartPointer<vtkPolyData> sphere(bool strips = false, double x = 100) {
  vtkNew<vtkSphereSource> source;
  source->SetRadius(50);
  source->SetCenter(x, 0, 0);
  source->SetThetaResolution(10);
  source->SetPhiResolution(8);
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(source->GetOutputPort());
  stripper->Update();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->DeepCopy(strips ? stripper->GetOutput() : source->GetOutput());

  vtkNew<vtkFloatArray> pressure;
  pressure->SetName("pressure");
  pressure->SetNumberOfTuples(data->GetNumberOfPoints());
  pressure->Fill(0.5);
  data->GetPointData()->AddArray(pressure);
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetName("tissue");
  colors->SetNumberOfComponents(4);
  colors->SetNumberOfTuples(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    colors->SetTuple4(i, static_cast<double>(i), 100, 200, 255);
  data->GetPointData()->SetScalars(colors);
  vtkNew<vtkStringArray> space;
  space->SetName("SPACE");
  space->InsertNextValue("RAS");
  data->GetFieldData()->AddArray(space);
  return data;
}

void expectSphere(const SurfaceFile& read) {
  const geometry::SurfaceReport report = geometry::checkSurface(read.mesh);
  EXPECT_EQ(read.mesh.points.rows(), kPoints);
  EXPECT_EQ(read.mesh.triangles.rows(), kTriangles);
  EXPECT_TRUE(report.outward());
  EXPECT_TRUE(report.manifold());
  EXPECT_EQ(read.space, Space::ras);
  EXPECT_LT(boundsOf(read.mesh.points).high.x(), 0) << "RAS was turned into LPS";
  ASSERT_EQ(read.mesh.colors.rows(), kPoints);
  EXPECT_EQ(read.mesh.colors.row(7), (Eigen::Matrix<std::uint8_t, 1, 3>(7, 100, 200)));
}

struct LegacyWay {
  bool binary;
  int version;
  bool strips;
};

class LegacyVtk : public testing::TestWithParam<LegacyWay> {};

TEST_P(LegacyVtk, ReadsWhatVtkWrites) {
  const TemporaryFolder folder;
  vtkNew<vtkPolyDataWriter> writer;
  writer->SetInputData(sphere(GetParam().strips));
  writer->SetFileType(GetParam().binary ? VTK_BINARY : VTK_ASCII);
  writer->SetFileVersion(GetParam().version);
  writer->SetFileName((folder / "a.vtk").c_str());
  ASSERT_EQ(writer->Write(), 1);
  expectSphere(readSurface(folder / "a.vtk"));
}

INSTANTIATE_TEST_SUITE_P(Ways, LegacyVtk,
                         testing::Values(LegacyWay{true, 42, false}, LegacyWay{true, 42, true},
                                         LegacyWay{true, 51, false}, LegacyWay{true, 51, true},
                                         LegacyWay{false, 42, false}, LegacyWay{false, 42, true},
                                         LegacyWay{false, 51, false}, LegacyWay{false, 51, true}),
                         [](const auto& way) {
                           return std::string(way.param.binary ? "Binary" : "Text") +
                                  std::to_string(way.param.version) +
                                  (way.param.strips ? "Strips" : "Triangles");
                         });

const std::string kHead = "# vtk DataFile Version 2.0\nby hand\nASCII\nDATASET POLYDATA\n";
const std::string kPointsText = "POINTS 4 float\n0 0 0 100 0 0\n0 100 0 0 0 100\n";
const std::string kPolygonsText = "POLYGONS 4 16\n3 0 2 1 3 0 1 3 3 0 3 2 3 1 2 3\n";

std::string problemOfFile(const std::string& name, const std::string& text) {
  const TemporaryFolder folder;
  try {
    readSurface(folder.put(name, text));
  } catch (const DataError& error) {
    return error.problem().english();
  }
  ADD_FAILURE() << text << " was read";
  return {};
}

TEST(LegacyVtkText, ReadsLinesScalarsAndTheAxesOfTheTitle) {
  const TemporaryFolder folder;
  const auto file = folder.put(
      "a.vtk", "# vtk DataFile Version 3.0\n3D Slicer output. SPACE=RAS\nASCII\nDATASET POLYDATA\n" +
                   kPointsText + "LINES 1 3\n2 0 1\n" + kPolygonsText +
                   "CELL_DATA 5\nSCALARS label int\nLOOKUP_TABLE default\n1 1 1 1 1\n"
                   "POINT_DATA 4\nSCALARS height float 1\nLOOKUP_TABLE mine\n0 1 2 3\n"
                   "LOOKUP_TABLE mine 2\n0 0 0 1 1 1 1 1\nTEXTURE_COORDINATES t 2 float\n0 0 0 0 0 0 0 0\n"
                   "COLOR_SCALARS c 3\n0 0.5 1 0 0 0 0 0 0 1 1 1\n");
  const SurfaceFile read = readSurface(file);
  EXPECT_EQ(read.space, Space::ras);
  EXPECT_TRUE(geometry::checkSurface(read.mesh).outward());
  EXPECT_EQ(read.mesh.colors.row(0), (Eigen::Matrix<std::uint8_t, 1, 3>(0, 128, 255)));
  EXPECT_TRUE(warnsOf(read, "1 line or point cell ignored"));
}

TEST(LegacyVtkText, UnknownValuesAtTheEndAreIgnoredWithAWarning) {
  const TemporaryFolder folder;
  const SurfaceFile read = readSurface(
      folder.put("a.vtk", kHead + kPointsText + kPolygonsText + "POINT_DATA 4\nWIGGLES w 3\n1 2 3\n"));
  EXPECT_EQ(read.mesh.triangles.rows(), 4);
  EXPECT_TRUE(warnsOf(read, "WIGGLES"));
}

TEST(LegacyVtkText, LiesOfTheHeaderAreRefused) {
  EXPECT_THAT(problemOfFile("a.vtk", kHead + "POINTS 999999999999999 float\n0 0 0\n"), HasSubstr("Line 5"));
  EXPECT_THAT(problemOfFile("a.vtk", kHead + "POINTS -1 float\n0 0 0\n"), HasSubstr("negative"));
  EXPECT_THAT(problemOfFile("a.vtk", kHead + kPointsText + "POLYGONS 1 4\n9 0 1 2\n"),
              HasSubstr("claims 9 points"));
  EXPECT_THAT(problemOfFile("a.vtk", kHead + kPointsText + "POLYGONS 1 4\n-3 0 1 2\n"),
              HasSubstr("claims -3 points"));
  EXPECT_THAT(problemOfFile("a.vtk", kHead + kPointsText + "POLYGONS 2 4\n3 0 1 2\n"), HasSubstr("2 cells"));
  EXPECT_THAT(problemOfFile("a.vtk", kHead + kPointsText + "POLYGONS 1 4\n3 0 1\n"), HasSubstr("cut off"));
  EXPECT_THAT(problemOfFile("a.vtk", kHead + kPointsText + kPolygonsText + "POINT_DATA 5\n"),
              HasSubstr("5 points"));
}

TEST(LegacyVtkText, OtherDatasetsAreRefusedByName) {
  EXPECT_THAT(problemOfFile("a.vtk", "# vtk DataFile Version 2.0\nx\nASCII\nDATASET STRUCTURED_GRID\n"),
              HasSubstr("STRUCTURED_GRID"));
}

enum class Compression { none, zlib, lz4, lzma };

struct VtpWay {
  const char* name;
  int mode;
  bool encoded;
  Compression compression;
  bool longHeader;
  bool bigEndian;
  bool strips;
};

class Vtp : public testing::TestWithParam<VtpWay> {};

void setWay(vtkXMLPolyDataWriter* writer, const VtpWay& way) {
  writer->SetDataMode(way.mode);
  writer->SetEncodeAppendedData(way.encoded);
  const int compressors[] = {vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4, vtkXMLWriter::LZMA};
  writer->SetCompressorType(compressors[static_cast<int>(way.compression)]);
  writer->SetBlockSize(512);
  writer->SetHeaderType(way.longHeader ? vtkXMLWriter::UInt64 : vtkXMLWriter::UInt32);
  writer->SetByteOrder(way.bigEndian ? vtkXMLWriter::BigEndian : vtkXMLWriter::LittleEndian);
}

TEST_P(Vtp, ReadsWhatVtkWrites) {
  const TemporaryFolder folder;
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputData(sphere(GetParam().strips));
  setWay(writer, GetParam());
  writer->SetFileName((folder / "a.vtp").c_str());
  ASSERT_EQ(writer->Write(), 1);
  expectSphere(readSurface(folder / "a.vtp"));
}

INSTANTIATE_TEST_SUITE_P(
    Ways, Vtp,
    testing::Values(
        VtpWay{"Text", vtkXMLWriter::Ascii, true, Compression::none, false, false, false},
        VtpWay{"InlineZlib", vtkXMLWriter::Binary, true, Compression::zlib, false, false, true},
        VtpWay{"InlinePlain", vtkXMLWriter::Binary, true, Compression::none, false, false, false},
        VtpWay{"InlinePlainLong", vtkXMLWriter::Binary, true, Compression::none, true, true, false},
        VtpWay{"AppendedZlib", vtkXMLWriter::Appended, true, Compression::zlib, true, false, false},
        VtpWay{"AppendedPlain", vtkXMLWriter::Appended, true, Compression::none, false, false, true},
        VtpWay{"RawZlib", vtkXMLWriter::Appended, false, Compression::zlib, false, false, false},
        VtpWay{"RawPlain", vtkXMLWriter::Appended, false, Compression::none, true, false, true},
        VtpWay{"RawLz4", vtkXMLWriter::Appended, false, Compression::lz4, false, true, false},
        VtpWay{"InlineLzma", vtkXMLWriter::Binary, true, Compression::lzma, false, false, false}),
    [](const auto& way) { return std::string(way.param.name); });

TEST(VtpFile, SeveralPiecesBecomeOneSurface) {
  const TemporaryFolder folder;
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(sphere(false, 100));
  both->AddInputData(sphere(false, 300));
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(both->GetOutputPort());
  writer->SetNumberOfPieces(3);
  writer->SetFileName((folder / "a.vtp").c_str());
  ASSERT_EQ(writer->Write(), 1);
  const SurfaceFile read = readSurface(folder / "a.vtp");
  EXPECT_EQ(read.mesh.points.rows(), 2 * kPoints);
  EXPECT_EQ(geometry::checkSurface(read.mesh).components, 2);
  EXPECT_TRUE(geometry::checkSurface(read.mesh).closed());
}

std::string vtpText(const std::string& piece, const std::string& points, const std::string& polygons) {
  return R"(<?xml version="1.0"?><VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData><Piece )" +
         piece + R"(><Points><DataArray type="Float32" NumberOfComponents="3" format=)" + points +
         "</DataArray></Points><Polys>" + polygons + "</Polys></Piece></PolyData></VTKFile>";
}

TEST(VtpFile, LiesOfTheHeaderAreRefused) {
  const std::string points = R"("ascii">0 0 0 100 0 0 0 100 0)";
  const std::string polygons =
      R"(<DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray>)"
      R"(<DataArray type="Int32" Name="offsets" format="ascii">3</DataArray>)";
  const std::string good = R"(NumberOfPoints="3" NumberOfPolys="1")";
  const TemporaryFolder folder;
  EXPECT_EQ(readSurface(folder.put("a.vtp", vtpText(good, points, polygons))).mesh.triangles.rows(), 1);

  EXPECT_THAT(problemOfFile("a.vtp",
                            vtpText(R"(NumberOfPoints="9000000000000" NumberOfPolys="1")", points, polygons)),
              HasSubstr("9000000000000 points"));
  EXPECT_THAT(problemOfFile("a.vtp", vtpText(R"(NumberOfPoints="-3" NumberOfPolys="1")", points, polygons)),
              HasSubstr("NumberOfPoints"));
  // 0xffffffff bytes announced, none there.
  EXPECT_THAT(problemOfFile("a.vtp", vtpText(good, R"("binary">/////w==)", polygons)),
              HasSubstr("4294967295 bytes"));
  EXPECT_THAT(problemOfFile("a.vtp", vtpText(good, R"("binary">/////)", polygons)), HasSubstr("cut off"));
  EXPECT_THAT(problemOfFile("a.vtp", vtpText(good, R"("appended" offset="9">)", polygons)),
              HasSubstr("cut off"));
  EXPECT_THAT(problemOfFile("a.vtp", vtpText(good, points, "")), HasSubstr("connectivity"));
  const std::string wild = R"(<DataArray type="Int32" Name="connectivity" format="ascii">0 1 7</DataArray>)"
                           R"(<DataArray type="Int32" Name="offsets" format="ascii">3</DataArray>)";
  EXPECT_THAT(problemOfFile("a.vtp", vtpText(good, points, wild)), HasSubstr("point 7"));
}

TEST(VtpFile, DeepXmlIsRefused) {
  std::string deep = "<VTKFile type=\"PolyData\">";
  for (int i = 0; i < 200000; ++i)
    deep += "<a>";
  EXPECT_THAT(problemOfFile("a.vtp", deep), HasSubstr("XML"));
}

TEST(VtpFile, OtherVtkXmlIsNamed) {
  EXPECT_THAT(problemOfFile("a.vtp", R"(<VTKFile type="ImageData"><ImageData/></VTKFile>)"),
              HasSubstr("no surface"));
  EXPECT_THAT(problemOfFile("a.vtp", R"(<VTKFile type="UnstructuredGrid"><UnstructuredGrid/></VTKFile>)"),
              HasSubstr("looks like VTU"));
}

/// A tetrahedron of 100 mm in text, with these values behind it.
std::string textTetrahedron(const std::string& values, const std::string& beforeMode = {}) {
  return "# vtk DataFile Version 3.0\nmade by hand\n" + beforeMode +
         "ASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 100 0 0\n0 100 0 0 0 100\nPOLYGONS 4 16\n"
         "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n" +
         values;
}

TEST(LegacyVtk, ValuesThatAreNotTheShapeDoNotKeepItFromOpening) {
  const TemporaryFolder folder;
  const std::string scalars = "POINT_DATA 4\nSCALARS s float 1\nLOOKUP_TABLE default\n";
  for (const std::string& values : {
           scalars + "-1.#IND 1.#QNAN -1.#IND00 1.#INF\n",
           scalars + "nan(ind) -nan(ind) inf -nan\n",
           scalars + "1,5 0 2,25 1e+20\n",
           std::string("POINT_DATA 4\nSCALARS s bit 1\nLOOKUP_TABLE default\n0 1 1 0\n"),
           std::string("CELL_DATA 4\nFIELD f 2\nmask 1 4 bit\n1 0 1 0\nb 1 4 double\n1.#J 2 3 4\n"),
           std::string("POINT_DATA 4\nCOLOR_SCALARS c 3\n-1.#IND 0 1 0 0 0 1 1 1 0 0 0\n"),
       }) {
    const SurfaceFile read = readSurface(folder.put("a.vtk", textTetrahedron(values)));
    EXPECT_NEAR(read.report.volumeMm3, 1e6 / 6, 1e-6) << values;
    EXPECT_FALSE(warnsOf(read, "not understood")) << values;
  }
  EXPECT_NEAR(readSurface(folder.put("b.vtk", textTetrahedron("", "\n"))).report.volumeMm3, 1e6 / 6, 1e-6)
      << "a blank line before ASCII";
  std::string binary = "# vtk DataFile Version 3.0\nx\nBINARY\nDATASET POLYDATA\nPOINTS 3 float\n" +
                       std::string(36, '\0') + "\nPOLYGONS 1 4\n";
  const std::size_t places = binary.find("POINTS 3 float\n") + 15;
  binary.replace(places + 12, 4, std::string("\x42\xc8\0\0", 4)); // 100
  binary.replace(places + 28, 4, std::string("\x42\xc8\0\0", 4));
  for (const int corner : {3, 0, 1, 2})
    binary += std::string(3, '\0') + static_cast<char>(corner);
  binary += "\nPOINT_DATA 3\nSCALARS s bit 3\nLOOKUP_TABLE default\n\xa5\x80\nVECTORS v float\n" +
            std::string(36, '\0');
  const SurfaceFile read = readSurface(folder.put("c.vtk", binary));
  EXPECT_EQ(read.mesh.triangles.rows(), 1);
  EXPECT_FALSE(warnsOf(read, "not understood")) << "nine bits are two bytes";
}

TEST(LegacyVtk, PointsThatAreNoNumbersAreDamage) {
  const TemporaryFolder folder;
  for (const char* bad : {"-1.#IND", "nan(ind)", "inf"}) {
    std::string text = textTetrahedron("");
    text.replace(text.find("100"), 3, bad);
    EXPECT_THROW(readSurface(folder.put("a.vtk", text)), DataError) << bad;
  }
  EXPECT_THROW(readSurface(folder.put("b.vtk", textTetrahedron("POINT_DATA 4\nNORMALS n float\n1 2 x\n"))),
               DataError);
}

} // namespace
} // namespace viscera::medical_io
