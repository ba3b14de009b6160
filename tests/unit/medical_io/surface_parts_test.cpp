#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_checks.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/volume.h"
#include "viscera/medical_io/surface_file.h"
#include "viscera/medical_io/surface_series_file.h"

/// Files of several named parts: which are organs, with which names and looks.
namespace viscera::medical_io {
namespace {

using test::warnsOf;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using tests::TemporaryFolder;

/// The points and faces of a mesh in OBJ; `before` counts the points before it.
std::string objOf(const geometry::TriangleMesh& mesh, int before = 0) {
  std::string text;
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    text += "v " + std::to_string(mesh.points(v, 0)) + " " + std::to_string(mesh.points(v, 1)) + " " +
            std::to_string(mesh.points(v, 2)) + "\n";
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    text += "f";
    for (int k = 0; k < 3; ++k)
      text += " " + std::to_string(mesh.triangles(t, k) + 1 + before);
    text += "\n";
  }
  return text;
}

geometry::TriangleMesh boxAt(double size, double at) {
  geometry::TriangleMesh mesh = tests::box(size, size, size);
  mesh.points.array() += at;
  return mesh;
}

/// Two boxes of 8 and 1 ml, each behind its statements; the second is inside the first or beside it.
std::string twoBoxes(const std::string& first, const std::string& second, bool nested = false) {
  return first + "\n" + objOf(boxAt(20, 0)) + second + "\n" + objOf(boxAt(10, nested ? 5 : 50), 8);
}

std::vector<std::string> namesOf(const std::vector<SurfacePart>& parts) {
  std::vector<std::string> names;
  for (const SurfacePart& part : parts)
    names.push_back(part.surface.name);
  return names;
}

std::string stlOf(const std::string& name, const geometry::TriangleMesh& mesh, Eigen::Index from = 0,
                  Eigen::Index to = -1) {
  std::string text = "solid " + name + "\n";
  for (Eigen::Index t = from; t < (to < 0 ? mesh.triangles.rows() : to); ++t) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (int k = 0; k < 3; ++k) {
      text += "vertex";
      for (int axis = 0; axis < 3; ++axis)
        text += " " + std::to_string(mesh.points(mesh.triangles(t, k), axis));
      text += "\n";
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid " + name + "\n";
}

TEST(ObjParts, ObjectsElseGroupsElseMaterialsAreOrgans) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> forms = {
      {"o Liver", "o Spleen"},
      {"g Liver", "g Spleen"},
      {"o all\ng Liver", "g Spleen"},
      {"usemtl Liver", "usemtl Spleen"},
      {"o all\ng all\nusemtl Liver", "usemtl Spleen"},
      {"o Liver\ng one\nusemtl red", "o Spleen\ng one\nusemtl red"},
      {"g grp1\nusemtl Liver", "g grp2\nusemtl Spleen"}, // 3D Slicer and VTK.
  };
  for (const auto& [first, second] : forms) {
    const std::vector<SurfacePart> parts = readSurfaces(folder.put("a.obj", twoBoxes(first, second)));
    EXPECT_THAT(namesOf(parts), ElementsAre("Liver", "Spleen")) << first;
    EXPECT_NEAR(parts[0].surface.report.volumeMm3, 8000, 1e-6);
    EXPECT_NEAR(parts[1].surface.report.volumeMm3, 1000, 1e-6);
    EXPECT_EQ(parts[1].surface.mesh.points.rows(), 8);
    EXPECT_EQ(boundsOf(parts[1].surface.mesh.points).low, Vec3(50, 50, 50));
  }
}

TEST(ObjParts, ColoursComeFromTheMaterialFileBesideTheFile) {
  const TemporaryFolder folder;
  folder.put("two organs.mtl", "# colours\nnewmtl m1\nKa 0 0 0\nKd 1 0.5 0\nd 0.25\n"
                               "newmtl m2\nKd 0,1 0,2 0,3\nTr 0.5\n");
  const std::string text = "mtllib ./two organs.mtl\n" + twoBoxes("g a\nusemtl m1", "g b\nusemtl m2");
  const std::vector<SurfacePart> parts = readSurfaces(folder.put("a.obj", text));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].color, Vec3(1, 0.5, 0));
  EXPECT_EQ(parts[0].opacity, 0.25);
  EXPECT_EQ(parts[1].color, Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(parts[1].opacity, 0.5);
  folder.put("vtk.mtl",
             "# wavefront mtl file written by the visualization toolkit\nnewmtl m1\nKd 1 0 0\nTr 0.8\n");
  const std::string byVtk = "mtllib vtk.mtl\n" + twoBoxes("g grp1\nusemtl m1", "g grp2\nusemtl m2");
  EXPECT_EQ(readSurfaces(folder.put("vtk.obj", byVtk)).front().opacity, 0.8) << "VTK's Tr is the opacity";
  const std::vector<SurfacePart> without =
      readSurfaces(folder.put("b.obj", "mtllib none.mtl\n" + twoBoxes("g a\nusemtl m1", "g b\nusemtl m2")));
  ASSERT_EQ(without.size(), 2u);
  EXPECT_TRUE(warnsOf(without[0].surface, "none.mtl"));
  EXPECT_FALSE(without[0].color.has_value());
}

TEST(ObjParts, AGreyThatAllPartsHaveIsNoColour) {
  const TemporaryFolder folder;
  folder.put("a.mtl", "newmtl m\nKd 0.8 0.8 0.8\n");
  const auto parts =
      readSurfaces(folder.put("a.obj", "mtllib a.mtl\nusemtl m\n" + twoBoxes("o Liver", "o Spleen")));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_FALSE(parts[0].color.has_value());
}

TEST(ObjParts, ANameThatComesBackContinuesItsPart) {
  const TemporaryFolder folder;
  const geometry::TriangleMesh box = boxAt(20, 0);
  const std::string whole = objOf(box);
  const std::size_t half = whole.find("f 1 2"); // Some face in the middle.
  ASSERT_NE(half, whole.npos);
  const std::string text = "g Liver\n" + whole.substr(0, half) + "g Spleen\n" + objOf(boxAt(10, 50), 8) +
                           "g Liver\n" + whole.substr(half);
  // The first faces count their points from the file's beginning, so that only their order is changed.
  const std::vector<SurfacePart> parts = readSurfaces(folder.put("a.obj", text));
  EXPECT_THAT(namesOf(parts), ElementsAre("Liver", "Spleen"));
  EXPECT_NEAR(parts[0].surface.report.volumeMm3, 8000, 1e-6);
}

TEST(ObjParts, AnOrganThatIsPaintedInPatchesStaysOneAndKeepsItsPaint) {
  const TemporaryFolder folder;
  folder.put("a.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
  std::string text = objOf(boxAt(20, 0));
  text.insert(text.find("f "), "usemtl red\n");
  text.insert(text.rfind("f "), "usemtl blue\n");
  const auto parts = readSurfaces(folder.put("heart.obj", "mtllib a.mtl\no Heart\n" + text));
  ASSERT_EQ(parts.size(), 1u);
  EXPECT_EQ(parts[0].surface.name, "Heart");
  EXPECT_TRUE(parts[0].surface.report.outward());
  ASSERT_EQ(parts[0].surface.mesh.colors.rows(), 8);
  EXPECT_EQ(parts[0].surface.mesh.colors(0, 0), 255);
  EXPECT_EQ(readSurface(folder / "heart.obj").mesh.triangles.rows(), 12);
}

TEST(ObjParts, OpenPartsThatShareNothingAreOrgansOfTheirOwn) {
  const TemporaryFolder folder;
  std::string text = twoBoxes("g wall", "g flap");
  text.erase(text.rfind("f ")); // The second is open now.
  const auto parts = readSurfaces(folder.put("a.obj", text));
  EXPECT_THAT(namesOf(parts), ElementsAre("wall", "flap"));
  EXPECT_FALSE(parts[1].surface.report.closed());
}

TEST(SurfaceParts, OneOrganOfSeveralIsNeverASum) {
  const TemporaryFolder folder;
  const auto file = folder.put("groups.obj", twoBoxes("g Left_kidney", "g Spleen"));
  try {
    readSurface(file);
    FAIL() << "it was read";
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("2 organs: Left_kidney, Spleen"), HasSubstr("groups.obj/Left_kidney")));
  }
  EXPECT_NEAR(readSurfacePart(file, "left kidney").surface.report.volumeMm3, 8000, 1e-6);
  EXPECT_NEAR(readSurfacePart(file, "2").surface.report.volumeMm3, 1000, 1e-6);
  EXPECT_THROW(readSurfacePart(file, "Heart"), UsageError);
  EXPECT_EQ(readSurface(file, SeveralOrgans::join).mesh.triangles.rows(), 24);
  Progress progress;
  EXPECT_THROW(readSurfaceSeries({file, file}, progress), UsageError);
  const auto one = folder.put("one.obj", "g Liver\n" + objOf(boxAt(20, 0)));
  EXPECT_EQ(readSurfaceSeries({one, one}, progress).triangles.rows(), 12);
}

TEST(SurfaceParts, AnOrganInsideAnotherIsSaid) {
  const TemporaryFolder folder;
  const auto parts = readSurfaces(folder.put("a.obj", twoBoxes("g Liver", "g Tumour", true)));
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_TRUE(warnsOf(parts[1].surface, "Tumour lies inside Liver"));
  EXPECT_FALSE(warnsOf(parts[0].surface, "lies inside"));
  const auto beside = readSurfaces(folder.put("b.obj", twoBoxes("g Liver", "g Tumour")));
  EXPECT_FALSE(warnsOf(beside[1].surface, "lies inside"));
}

TEST(StlParts, EachClosedSolidIsAnOrganAlsoOfTheSameName) {
  const TemporaryFolder folder;
  const auto parts =
      readSurfaces(folder.put("a.stl", stlOf("Liver", boxAt(20, 0)) + stlOf("Spleen", boxAt(10, 50))));
  EXPECT_THAT(namesOf(parts), ElementsAre("Liver", "Spleen"));
  EXPECT_NEAR(parts[0].surface.report.volumeMm3, 8000, 1e-6);
  const auto alike = readSurfaces(folder.put("b.stl", stlOf("", boxAt(20, 0)) + stlOf("", boxAt(10, 50))));
  EXPECT_THAT(namesOf(alike), ElementsAre("b 1", "b 2"));
  const auto patches = readSurfaces(
      folder.put("vessel.stl", stlOf("inlet", boxAt(20, 0), 0, 2) + stlOf("wall", boxAt(20, 0), 2)));
  ASSERT_EQ(patches.size(), 1u);
  EXPECT_NEAR(patches[0].surface.report.volumeMm3, 8000, 1e-6);
  EXPECT_TRUE(warnsOf(patches[0].surface, "inlet, wall"));
}

TEST(VtmParts, BlocksAreTheSurfacesBesideTheFile) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "m");
  writeSurface(folder / "m/m_0.vtp", boxAt(20, 0));
  writeSurface(folder / "m/m_1.vtp", boxAt(10, 50), {Space::ras, "Spleen"});
  const std::string head = R"(<VTKFile type="vtkMultiBlockDataSet" version="1.0">)";
  const auto file = folder.put("m.vtm", head + R"(<vtkMultiBlockDataSet>
    <DataSet index="0" name="Liver" file="m/m_0.vtp"/>
    <Block index="1" name="others"><DataSet index="0" file="m/m_1.vtp"/>
    </Block><DataSet index="2"/></vtkMultiBlockDataSet></VTKFile>)");
  const auto parts = readSurfaces(file);
  EXPECT_THAT(namesOf(parts), ElementsAre("Liver", "others"));
  EXPECT_NEAR(parts[0].surface.report.volumeMm3, 8000, 1e-6);
  EXPECT_EQ(boundsOf(parts[1].surface.mesh.points).low, Vec3(50, 50, 50)) << "RAS beside LPS";
  EXPECT_TRUE(warnsOf(parts[0].surface, "1 block without a surface"));
  EXPECT_THROW(readSurfaces(folder.put("n.vtm", head + R"(<vtkMultiBlockDataSet>
    <DataSet file="m/none.vtp"/></vtkMultiBlockDataSet></VTKFile>)")),
               DataError);
  EXPECT_THROW(readSurfaces(folder.put("o.vtm", head + R"(<vtkMultiBlockDataSet>
    <DataSet file="/etc/a.vtp"/></vtkMultiBlockDataSet></VTKFile>)")),
               DataError);
  EXPECT_THROW(readSurfaces(folder.put("p.vtm", head + R"(<vtkMultiBlockDataSet>
    <DataSet file="p.vtm"/></vtkMultiBlockDataSet></VTKFile>)")),
               DataError);
}

/// The area of one polygon over these points, as it was cut.
double areaCut(const std::string& points, const std::string& face) {
  const TemporaryFolder folder;
  const SurfaceFile read = readSurface(folder.put("a.obj", points + face));
  return geometry::area(read.mesh.points, read.mesh.triangles);
}

/// A square of 10 with a square hole of 2: corners 1 to 4 outside, 5 to 8 the hole clockwise.
const std::string kWithHole = "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 4 4 0\nv 4 6 0\nv 6 6 0\nv 6 4 0\n";

TEST(Polygons, WithAKeyholeHaveTheirOwnArea) {
  EXPECT_NEAR(areaCut(kWithHole, "f 1 2 3 4 1 5 6 7 8 5\n"), 96, 1e-9);
  EXPECT_NEAR(areaCut(kWithHole, "f 5 8 7 6 5 1 4 3 2 1\n"), 96, 1e-9) << "clockwise";
  EXPECT_NEAR(areaCut(kWithHole + "v 0 0 0\nv 4 4 0\n", "f 1 2 3 4 9 5 6 7 8 10\n"), 96, 1e-9)
      << "equal points of other numbers";
  // Two holes at one bridge, and one behind the other.
  const std::string two = kWithHole + "v 1 7 0\nv 1 9 0\nv 3 9 0\nv 3 7 0\n";
  EXPECT_NEAR(areaCut(two, "f 1 2 3 4 9 10 11 12 9 4 1 5 6 7 8 5\n"), 92, 1e-9);
  EXPECT_NEAR(areaCut(two, "f 1 2 3 4 1 5 6 12 9 10 11 12 6 7 8 5\n"), 92, 1e-9);
}

TEST(Polygons, OfManyCornersInALineBentAndConcaveHaveTheirOwnArea) {
  std::string comb, face = "f";
  int corners = 0;
  const auto add = [&](double x, double y, double z) {
    comb += "v " + std::to_string(x) + " " + std::to_string(y) + " " + std::to_string(z) + "\n";
    face += " " + std::to_string(++corners);
  };
  for (int tooth = 0; tooth < 40; ++tooth) {
    add(2 * tooth, 0, 0.001 * tooth);
    add(2 * tooth + 1, 0, 0);
    add(2 * tooth + 1, 5, 0);
    add(2 * tooth + 2, 5, 0);
  }
  for (int i = 0; i <= 80; i += 5)
    add(80 - i, 10, 0);
  // 80 x 10 without 40 slots of 1 x 5.
  EXPECT_NEAR(areaCut(comb, face + "\n"), 800 - 200, 0.05);
}

TEST(Polygons, ThatCloseASurfaceWithAHoleKeepItClosed) {
  // A block of 10 x 10 x 1 with a square tunnel: two faces with keyholes and eight sides.
  std::string points = kWithHole;
  for (const char* low : {"0 0", "10 0", "10 10", "0 10", "4 4", "4 6", "6 6", "6 4"})
    points += std::string("v ") + low + " 1\n";
  const std::string faces = "f 5 8 7 6 5 1 4 3 2 1\nf 9 10 11 12 9 13 14 15 16 13\n"
                            "f 1 2 10 9\nf 2 3 11 10\nf 3 4 12 11\nf 4 1 9 12\n"
                            "f 5 6 14 13\nf 6 7 15 14\nf 7 8 16 15\nf 8 5 13 16\n";
  const TemporaryFolder folder;
  const SurfaceFile read = readSurface(folder.put("a.obj", points + faces));
  EXPECT_TRUE(read.report.closed());
  EXPECT_TRUE(read.report.manifold());
  EXPECT_NEAR(read.report.volumeMm3, 96, 1e-9);
}

TEST(Polygons, ThatCrossThemselvesAreRefusedByNumber) {
  const TemporaryFolder folder;
  try {
    readSurface(
        folder.put("a.obj", "v 0 0 0\nv 10 0 0\nv 0 10 0\nv 10 10 0\nv 5 14 0\nf 1 2 3\nf 1 2 3 4 5\n"));
    FAIL() << "it was read";
  } catch (const DataError& error) {
    EXPECT_THAT(error.problem().english(), AllOf(HasSubstr("Polygon 1 "), HasSubstr("5 corners")));
  }
}

TEST(Obj, FacesOfTwoCornersAreLeftOutAndCounted) {
  const TemporaryFolder folder;
  const SurfaceFile read = readSurface(folder.put("a.obj", objOf(boxAt(20, 0)) + "f 1 2\nf 3 4\nf 5\n"));
  EXPECT_TRUE(read.report.outward());
  EXPECT_TRUE(warnsOf(read, "3 faces of fewer than three corners left out"));
}

TEST(DecimalCommas, AreReadWhereTheyCanBeNothingElse) {
  const TemporaryFolder folder;
  const std::string faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  const auto volume = [&](const std::string& name, const std::string& text) {
    const SurfaceFile read = readSurface(folder.put(name, text));
    EXPECT_TRUE(warnsOf(read, "decimal marks")) << name;
    return read.report.volumeMm3;
  };
  const double expected = 30.5 * 30.5 * 30.5 / 6;
  const std::string points = "0,0 0,0 0,0\n30,5 0,0 0,0\n0,0 30,5 0,0\n0,0 0,0 30,5\n";
  EXPECT_NEAR(volume("a.obj", "v 0,0 0,0 0,0\nv 30,5 0,0 0,0\nv 0,0 30,5 0,0\nv 0 0 30,5\n" + faces),
              expected, 1e-9);
  EXPECT_NEAR(volume("a.obj", "v 0 0 0\nv 30,500 0,000 0\nv 0 30,500 0\nv 0 0 30,500\n" + faces), expected,
              1e-9);
  EXPECT_NEAR(volume("a.off", "OFF\n4 4 0\n" + points + "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"), expected,
              1e-9);
  EXPECT_NEAR(volume("a.ply", "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                              "property float z\nelement face 4\nproperty list uchar int vertex_indices\n"
                              "end_header\n" +
                                  points + "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"),
              expected, 1e-9);
  EXPECT_NEAR(volume("a.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n" +
                                  points + "POLYGONS 4 16\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"),
              expected, 1e-9);
  std::string stl = stlOf("a", tests::tetrahedron(30.5, 30.5, 30.5));
  std::replace(stl.begin(), stl.end(), '.', ',');
  EXPECT_NEAR(volume("a.stl", stl), expected, 1e-9);
  for (const char* other : {"v 1,500 20 3\nv 2,000 10 7\nv 1 2 3\n", "v 1,5 2.5 3\nv 1 2 3\nv 1 3 2\n",
                            "v 1,2,3 1 1\nv 1 1 0\nv 1 2 0\n", "v 1,234.5 2 3\nv 1 1 1\nv 2 1 1\n"})
    try {
      readSurface(folder.put("b.obj", other + std::string("f 1 2 3\n")));
      ADD_FAILURE() << other << " was read";
    } catch (const DataError& error) {
      EXPECT_THAT(error.problem().english(), HasSubstr("commas")) << other;
    }
}

} // namespace
} // namespace viscera::medical_io
