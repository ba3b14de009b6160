#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "mesh_checks.h"
#include "mesh_files.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/deformation/witness_mesh.h"
#include "viscera/medical_io/cell_file.h"
#include "viscera/medical_io/file_kind.h"

/// Meshes of cells open as the surface around them, and their hollows as cavities.
namespace viscera::medical_io {
namespace {

using test::warnsOf;
using testing::AllOf;
using testing::HasSubstr;
using tests::CellsOfTest;
using tests::hollowBox;
using tests::Split;
using tests::TemporaryFolder;

constexpr std::array<Split, 4> kSplits = {Split::hexahedra, Split::tetrahedra, Split::wedges,
                                          Split::pyramids};

/// The file is a hollow box: 26 ml of cells in 27 ml.
void expectHollowBox(const std::filesystem::path& file, const std::string& regions) {
  SCOPED_TRACE(file);
  EXPECT_EQ(fileKind(file), FileKind::surface);
  const SurfaceFile whole = readSurface(file);
  EXPECT_TRUE(whole.report.closed() && whole.report.manifold() && whole.report.outward());
  EXPECT_NEAR(whole.report.volumeMm3, 26000, 1e-3);
  EXPECT_TRUE(warnsOf(whole, "1 cavity"));
  EXPECT_TRUE(warnsOf(whole, regions));
  EXPECT_FALSE(warnsOf(whole, "without a triangle")) << "points inside are no loss";

  const std::vector<SurfacePart> parts = readSurfaces(file);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_NEAR(parts[0].surface.report.volumeMm3, 27000, 1e-3);
  EXPECT_EQ(parts[0].cavityOf, -1);
  EXPECT_TRUE(warnsOf(parts[0].surface, regions));
  const Bounds box = boundsOf(parts[0].surface.mesh.points);
  EXPECT_TRUE(box.low.isApprox(Vec3(0, 0, 0)) && box.high.isApprox(Vec3(30, 30, 30)));
  EXPECT_NEAR(parts[1].surface.report.volumeMm3, 1000, 1e-3) << "a cavity faces outward, as any organ";
  EXPECT_EQ(parts[1].cavityOf, 0);
  EXPECT_EQ(parts[1].surface.name, "Cavity");
  for (const SurfacePart& part : parts)
    EXPECT_TRUE(part.surface.report.closed() && part.surface.report.manifold());
}

/// The tetrahedra of a hollow box that has no corner inside.
TEST(CellMeshes, WithoutACornerInsideHaveNoWitnessPoints) {
  const TemporaryFolder folder;
  EXPECT_FALSE(
      readCells(folder.put("a.msh", tests::GmshFile(hollowBox(Split::hexahedra), 2.2, false).text())));
  EXPECT_FALSE(readCells(folder.put("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")));
}

/// A box of 4 x 4 x 4 cells, of which 27 corners are inside.
CellsOfTest fullBox(bool turned) {
  CellsOfTest mesh;
  const auto corner = [](int i, int j, int k) { return i + 5 * j + 25 * k; };
  for (int k = 0; k < 5; ++k)
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 5; ++i)
        mesh.points.emplace_back(10 * i, 10 * j, 10 * k);
  for (int k = 0; k < 4; ++k)
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) {
        const int up = turned ? k + 1 : k, down = turned ? k : k + 1;
        mesh.cells.push_back(
            {12,
             {corner(i, j, up), corner(i + 1, j, up), corner(i + 1, j + 1, up), corner(i, j + 1, up),
              corner(i, j, down), corner(i + 1, j, down), corner(i + 1, j + 1, down), corner(i, j + 1, down)},
             1});
      }
  return mesh;
}

TEST(CellMeshes, KeepTheirCellsAsTetrahedraThatFitTogether) {
  const TemporaryFolder folder;
  for (const bool turned : {false, true}) {
    const auto cells = readCells(folder.put("a.msh", tests::GmshFile(fullBox(turned), 4.1, true).text()));
    ASSERT_TRUE(cells);
    EXPECT_NO_THROW(deformation::requireUsable(*cells, "a.msh"));
    EXPECT_EQ(cells->witnesses, 27);
    EXPECT_EQ(cells->points.rows(), 125);
    EXPECT_GE(cells->points.topRows(27).minCoeff(), 10);
    EXPECT_LE(cells->points.topRows(27).maxCoeff(), 30);
    EXPECT_NEAR(deformation::tetrahedronVolumes(cells->points, cells->tetrahedra).sum(), 64000, 1e-6);
    EXPECT_EQ(deformation::skinOf(cells->tetrahedra).rows(), 6 * 16 * 2) << "no face inside is left single";
  }
}

std::string problemOfCells(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  try {
    readSurface(folder.put(name, bytes));
  } catch (const DataError& error) {
    return error.what();
  }
  ADD_FAILURE() << name << " was read";
  return {};
}

// ---- VTK --------------------------------------------------------------------------------------------------

vtkSmartPointer<vtkUnstructuredGrid> gridOfCells(const CellsOfTest& mesh, bool shared = true) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIntArray> regions;
  regions->SetName("elemTag");
  vtkNew<vtkFloatArray> stress;
  stress->SetName("stress");
  for (const Vec3& point : mesh.points)
    if (shared)
      points->InsertNextPoint(point.data());
  for (const CellsOfTest::Cell& cell : mesh.cells) {
    std::vector<vtkIdType> ids;
    for (const int point : cell.points)
      ids.push_back(shared ? point : points->InsertNextPoint(mesh.points[std::size_t(point)].data()));
    grid->InsertNextCell(cell.type, static_cast<vtkIdType>(ids.size()), ids.data());
    regions->InsertNextValue(cell.region);
    stress->InsertNextValue(0.5F);
  }
  grid->SetPoints(points);
  grid->GetCellData()->AddArray(stress);
  grid->GetCellData()->AddArray(regions);
  return grid;
}

TEST(CellMesh, VtkXmlGridsOpenInEveryWayThatVtkWritesThem) {
  const TemporaryFolder folder;
  struct Way {
    int mode;
    bool encoded;
    int compressor;
    bool bigEndian;
  };
  for (const Way& way : {Way{vtkXMLWriter::Ascii, true, vtkXMLWriter::NONE, false},
                         Way{vtkXMLWriter::Binary, true, vtkXMLWriter::ZLIB, false},
                         Way{vtkXMLWriter::Binary, true, vtkXMLWriter::NONE, true},
                         Way{vtkXMLWriter::Appended, true, vtkXMLWriter::LZ4, false},
                         Way{vtkXMLWriter::Appended, false, vtkXMLWriter::LZMA, true}})
    for (const Split split : kSplits) {
      vtkNew<vtkXMLUnstructuredGridWriter> writer;
      writer->SetInputData(gridOfCells(hollowBox(split)));
      writer->SetDataMode(way.mode);
      writer->SetEncodeAppendedData(way.encoded);
      writer->SetCompressorType(way.compressor);
      writer->SetByteOrder(way.bigEndian ? vtkXMLWriter::BigEndian : vtkXMLWriter::LittleEndian);
      writer->SetFileName((folder / "a.vtu").c_str());
      ASSERT_EQ(writer->Write(), 1);
      expectHollowBox(folder / "a.vtu", "2 regions (1, 2)");
    }
}

TEST(CellMesh, LegacyGridsOpenInBothVersionsAndForms) {
  const TemporaryFolder folder;
  for (const bool binary : {false, true})
    for (const int version : {42, 51})
      for (const Split split : kSplits) {
        vtkNew<vtkUnstructuredGridWriter> writer;
        writer->SetInputData(gridOfCells(hollowBox(split)));
        writer->SetFileType(binary ? VTK_BINARY : VTK_ASCII);
        writer->SetFileVersion(version);
        writer->SetFileName((folder / "a.vtk").c_str());
        ASSERT_EQ(writer->Write(), 1);
        expectHollowBox(folder / "a.vtk", "2 regions (1, 2)");
      }
}

TEST(CellMesh, CellsWithPointsOfTheirOwnAndRepeatedCellsAreJoined) {
  const TemporaryFolder folder;
  CellsOfTest mesh = hollowBox(Split::tetrahedra);
  mesh.cells.push_back(mesh.cells.front());
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  writer->SetInputData(gridOfCells(mesh, false));
  writer->SetFileName((folder / "a.vtu").c_str());
  ASSERT_EQ(writer->Write(), 1);
  expectHollowBox(folder / "a.vtu", "1 cell that repeats another");
}

/// A grid of one cell as text.
std::string gridText(const std::string& points, int type, const std::string& cell) {
  const auto count = std::count(cell.begin(), cell.end(), ' ') + 1;
  return "# vtk DataFile Version 2.0\nSPACE=RAS\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
         std::to_string(std::count(points.begin(), points.end(), '\n')) + " float\n" + points + "CELLS 1 " +
         std::to_string(count + 1) + "\n" + std::to_string(count) + " " + cell + "\nCELL_TYPES 1\n" +
         std::to_string(type) + "\n";
}

const std::string kTetrahedronPoints = "0 0 0\n60 0 0\n0 60 0\n0 0 60\n";

TEST(CellMesh, CurvedInvertedAndOddlyNumberedCellsFaceOutward) {
  const TemporaryFolder folder;
  const std::string eight = "0 0 0\n60 0 0\n0 60 0\n60 60 0\n0 0 60\n60 0 60\n0 60 60\n60 60 60\n";
  const SurfaceFile voxel = readSurface(folder.put("a.vtk", gridText(eight, 11, "0 1 2 3 4 5 6 7")));
  EXPECT_NEAR(voxel.report.volumeMm3, 216000, 1e-6);
  EXPECT_EQ(voxel.space, Space::ras);
  EXPECT_LT(boundsOf(voxel.mesh.points).low.x(), -50);
  const SurfaceFile inverted = readSurface(folder.put("b.vtk", gridText(kTetrahedronPoints, 10, "0 2 1 3")));
  EXPECT_NEAR(inverted.report.volumeMm3, 36000, 1e-6);
  const SurfaceFile curved =
      readSurface(folder.put("c.vtk", gridText(kTetrahedronPoints, 24, "0 1 2 3 0 0 0 0 0 0")));
  EXPECT_NEAR(curved.report.volumeMm3, 36000, 1e-6);
  EXPECT_TRUE(warnsOf(curved, "1 curved cell"));
  // A hexahedron collapsed to a wedge, as some programs write wedges.
  const SurfaceFile collapsed = readSurface(folder.put("d.vtk", gridText(eight, 12, "0 1 3 3 4 5 7 7")));
  EXPECT_NEAR(collapsed.report.volumeMm3, 108000, 1e-6);
  EXPECT_TRUE(collapsed.report.closed());
}

TEST(CellMesh, FlatCellsAreTheSurfaceOnlyWhereNoCellHasAVolume) {
  const TemporaryFolder folder;
  const std::string head =
      "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 float\n" +
      kTetrahedronPoints + "90 90 90\n";
  const SurfaceFile flat = readSurface(folder.put(
      "a.vtk", head + "CELLS 5 19\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n2 0 1\nCELL_TYPES 5\n5 5 5 5 3\n"));
  EXPECT_NEAR(flat.report.volumeMm3, 36000, 1e-6);
  EXPECT_TRUE(warnsOf(flat, "1 line or point cell ignored"));
  const SurfaceFile both = readSurface(
      folder.put("b.vtk", head + "CELLS 3 13\n4 0 1 2 3\n3 0 1 2\n3 0 1 4\nCELL_TYPES 3\n10 5 5\n"));
  EXPECT_NEAR(both.report.volumeMm3, 36000, 1e-6);
  EXPECT_TRUE(warnsOf(both, "1 flat cell that bounds no cell"));
}

TEST(CellMesh, WhatIsNotReadIsNamed) {
  EXPECT_THAT(problemOfCells("a.vtk", gridText(kTetrahedronPoints, 42, "0 1 2 3")),
              AllOf(HasSubstr("type 42"), HasSubstr("tetrahedra")));
  EXPECT_THAT(problemOfCells("a.vtk", gridText(kTetrahedronPoints, 10, "0 1 2 9")), HasSubstr("point 9"));
  EXPECT_THAT(problemOfCells("a.vtk", gridText(kTetrahedronPoints, 10, "0 1 2")), HasSubstr("3 points"));
  EXPECT_THAT(problemOfCells("a.vtk", gridText("nan 0 0\n60 0 0\n0 60 0\n0 0 60\n", 10, "0 1 2 3")),
              HasSubstr("not a finite number"));
}

// ---- gmsh -------------------------------------------------------------------------------------------------

TEST(CellMesh, GmshMeshesOpenInEveryVersionAndForm) {
  const TemporaryFolder folder;
  for (const double version : {2.2, 4.0, 4.1})
    for (const Split split : kSplits) {
      const CellsOfTest mesh = hollowBox(split);
      const auto text = folder.put("a.msh", tests::GmshFile(mesh, version, false).text());
      expectHollowBox(text, "2 regions (muscle, blood pool)");
      for (const std::endian order : {std::endian::little, std::endian::big})
        expectHollowBox(folder.put("b.msh", tests::GmshFile(mesh, version, true, order).text()),
                        "2 regions (muscle, blood pool)");
    }
}

TEST(CellMesh, OtherGmshFilesAreNamed) {
  EXPECT_THAT(problemOfCells("a.msh", "$NOD\n1\n1 0 0 0\n$ENDNOD\n"), HasSubstr("gmsh's format 1"));
  EXPECT_THAT(problemOfCells("a.msh", "$MeshFormat\n3.0 0 8\n$EndMeshFormat\n"), HasSubstr("format 3"));
  const std::string head = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n1\n1 0 0 0\n$EndNodes\n";
  EXPECT_THAT(problemOfCells("a.msh", head), HasSubstr("$Elements"));
  EXPECT_THAT(problemOfCells("a.msh", head + "$Elements\n1\n1 4 2 0 1 1 1 1 5\n$EndElements\n"),
              HasSubstr("node 5"));
  EXPECT_THAT(problemOfCells("a.msh", head + "$Elements\n1\n1 99 0 1\n$EndElements\n"), HasSubstr("type 99"));
  EXPECT_THAT(problemOfCells("a.msh", head + "$Elements\n900000000\n1 4 0 1\n$EndElements\n"),
              HasSubstr("900000000"));
}

// ---- medit ------------------------------------------------------------------------------------------------

TEST(CellMesh, MeditMeshesOpenAsTextAndBinary) {
  const TemporaryFolder folder;
  for (const Split split : kSplits) {
    const CellsOfTest mesh = hollowBox(split);
    expectHollowBox(folder.put("a.mesh", tests::meditText(mesh)), "2 regions (1, 2)");
    for (const int version : {1, 2, 3, 4})
      for (const std::endian order : {std::endian::little, std::endian::big})
        expectHollowBox(folder.put("a.meshb", tests::meditBinary(mesh, version, order)), "2 regions (1, 2)");
  }
}

TEST(CellMesh, MeditFilesOfPlaneMeshesAndBrokenOnesAreNamed) {
  EXPECT_THAT(problemOfCells("a.mesh", "MeshVersionFormatted 1\nDimension 2\nVertices\n0\nEnd\n"),
              HasSubstr("plane mesh"));
  const std::string head = "MeshVersionFormatted 1\nDimension 3\nVertices\n1\n0 0 0 0\n";
  EXPECT_THAT(problemOfCells("a.mesh", head + "Tetrahedra\n1\n1 1 1 0 0\nEnd\n"), HasSubstr("point -1"));
  EXPECT_THAT(problemOfCells("a.mesh", head + "Tetrahedra\n80000000\n1 1 1 1 0\n"), HasSubstr("80000000"));
  EXPECT_THAT(problemOfCells("a.mesh", head + "End\n"), HasSubstr("no triangles"));
}

// ---- openCARP ---------------------------------------------------------------------------------------------

TEST(CellMesh, OpenCarpMeshesOpenByEitherHalfInMillimetres) {
  const TemporaryFolder folder;
  for (const Split split : kSplits)
    for (const bool ownOrder : {false, true}) {
      const CellsOfTest mesh = hollowBox(split);
      folder.put("heart.pts", tests::carpPoints(mesh));
      folder.put("heart.elem", tests::carpElements(mesh, ownOrder));
      for (const char* half : {"heart.elem", "heart.pts"}) {
        expectHollowBox(folder / half, "2 regions (1, 2)");
        EXPECT_TRUE(warnsOf(readSurface(folder / half), "micrometres"));
      }
    }
}

TEST(CellMesh, SurfacesOfOpenCarpBelongToThePointsOfTheirMesh) {
  const TemporaryFolder folder;
  folder.put("heart.pts", "4\n0 0 0\n60000 0 0\n0 60000 0\n0 0 60000\n");
  const auto file = folder.put("heart.epi.surf", "4 epi\nTr 0 2 1\nTr 0 1 3\nTr 1 2 3\nTr 0 3 2\n");
  EXPECT_NEAR(readSurface(file).report.volumeMm3, 36000, 1e-6);
  EXPECT_THAT(problemOfCells("lonely.elem", "1\nTr 0 1 2 1\n"), HasSubstr("lonely.pts"));
  folder.put("heart.elem", "1\nOc 0 1 2 3 0 1 1\n");
  EXPECT_THROW(readSurface(folder / "heart.elem"), DataError);
}

} // namespace
} // namespace viscera::medical_io
