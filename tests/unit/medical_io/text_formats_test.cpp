#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_checks.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/surface_file.h"

/// STL, OBJ, PLY and OFF as other programs write them.
namespace viscera::medical_io {
namespace {

using test::warnsOf;
using testing::HasSubstr;
using tests::TemporaryFolder;

const std::string kFacets =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 0 100 0\nvertex 100 0 0\nendloop\n"
    "endfacet\nFACET NORMAL 0 0 0\n OUTER LOOP\n VERTEX 0 0 0\n VERTEX 1e2 0 0\n"
    " VERTEX 0 0 +100.0\n ENDLOOP\n ENDFACET\n";
const std::string kMoreFacets =
    "facet normal nan nan nan\nouter loop\nvertex 0 0 0\nvertex 0 0 100\nvertex 0 100 0\n"
    "endloop\nendfacet\nfacet normal 1 1 1\nouter loop\nvertex 100 0 0\n"
    "vertex 0 100 0\nvertex 0 0 100\nendloop\nendfacet\n";

void expectTetrahedron(const SurfaceFile& read) {
  const geometry::SurfaceReport report = geometry::checkSurface(read.mesh);
  EXPECT_EQ(read.mesh.points.rows(), 4);
  EXPECT_EQ(read.mesh.triangles.rows(), 4);
  EXPECT_TRUE(report.outward());
  EXPECT_NEAR(report.volumeMm3, 1e6 / 6, 1e-6);
}

SurfaceFile readText(const std::string& name, const std::string& text) {
  const TemporaryFolder folder;
  return readSurface(folder.put(name, text));
}

std::string problemOf(const std::string& name, const std::string& text) {
  try {
    readText(name, text);
  } catch (const DataError& error) {
    return error.problem().english();
  }
  ADD_FAILURE() << text << " was read";
  return {};
}

TEST(Stl, TextInAnyCaseWithSeveralSolids) {
  const SurfaceFile read =
      readText("a.stl", "solid lower part\n" + kFacets + "endsolid lower part\r\n\nSOLID\n" + kMoreFacets +
                            "ENDSOLID\n");
  expectTetrahedron(read);
  EXPECT_EQ(read.name, "lower part");
  EXPECT_TRUE(warnsOf(read, "2 open parts that share points were joined to one organ: lower part"));
}

TEST(Stl, TextWithTheAxesOfSlicer) {
  const SurfaceFile read =
      readText("a.stl", "solid 3D Slicer output. SPACE=RAS\n" + kFacets + kMoreFacets + "endsolid\n");
  EXPECT_EQ(read.space, Space::ras);
  EXPECT_EQ(boundsOf(read.mesh.points).low, Vec3(-100, -100, 0));
  EXPECT_EQ(read.name, "a");
}

TEST(Stl, TextThatEndsEarlyIsRefused) {
  EXPECT_THAT(problemOf("a.stl", "solid\n" + kFacets), HasSubstr("cut off"));
  EXPECT_THAT(problemOf("a.stl", "solid\n" + kFacets.substr(0, 60)), HasSubstr("cut off"));
  EXPECT_THAT(problemOf("a.stl", "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 zero 0\n"),
              HasSubstr("Line 4"));
}

TEST(Stl, BinaryWhoseHeaderBeginsWithSolidIsBinary) {
  const TemporaryFolder folder;
  writeSurface(folder / "a.stl", test::organ());
  std::string bytes = tests::contentsOf(folder / "a.stl");
  bytes.replace(0, 12, "solid facet ");
  const SurfaceFile read = readSurface(folder.put("b.stl", bytes));
  EXPECT_EQ(read.mesh.triangles, readSurface(folder / "a.stl").mesh.triangles);
}

TEST(Stl, BinaryCountHasToFitTheSize) {
  const TemporaryFolder folder;
  writeSurface(folder / "a.stl", test::organ());
  const std::string bytes = tests::contentsOf(folder / "a.stl");
  EXPECT_THAT(problemOf("b.stl", bytes.substr(0, bytes.size() - 1)), HasSubstr("promises 128 triangles"));
  EXPECT_THAT(problemOf("b.stl", bytes + std::string(50, '\0')), HasSubstr("room for 129"));
  EXPECT_TRUE(warnsOf(readText("b.stl", bytes + "\n"), "1 byte after the last triangle"));
  std::string huge = bytes;
  huge.replace(80, 4, "\xff\xff\xff\xff");
  EXPECT_THAT(problemOf("b.stl", huge), HasSubstr("4294967295 triangles"));
}

TEST(Obj, CornersWithTexturesAndNormalsStayJoined) {
  const SurfaceFile read =
      readText("a.obj", "\xef\xbb\xbf# made by hand\r\nmtllib a.mtl\r\no Liver\r\n"
                        "v 0 0 0\nv 100 0 0\nv 0 100 0\nv 0 0 100\nvt 0 0\nvt 1 1\nvn 0 0 1\n"
                        "usemtl red\ns off\nf 1/1/1 3/2/1 2//1\nf 1/2 2/1 4/1\n"
                        "f -4 -1 -2\nf 2 \\\n 3 4 # the last\n");
  expectTetrahedron(read);
  EXPECT_EQ(read.name, "Liver");
}

TEST(Obj, ObjectsThatShareAnOrganBecomeOneSurface) {
  const SurfaceFile read = readText("two.obj", "o a\nv 0 0 0\nv 100 0 0\nv 0 100 0\nf 1 3 2\nl 1 2\n"
                                               "o b\nv 0 0 100\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  expectTetrahedron(read);
  EXPECT_EQ(read.name, "two");
  EXPECT_TRUE(warnsOf(read, "joined to one organ: a, b"));
  EXPECT_TRUE(warnsOf(read, "1 line with points, curves"));
}

TEST(Obj, ColoursBehindPointsGoToOneOrTo255) {
  const std::string faces = "f 1 2 3\n";
  const SurfaceFile one = readText("a.obj", "v 0 0 0 0 0.5 1\nv 90 0 0 1 1 1\nv 0 90 0 0 0 0.2\n" + faces);
  EXPECT_EQ(one.mesh.colors.row(0), (Eigen::Matrix<std::uint8_t, 1, 3>(0, 128, 255)));
  const SurfaceFile bytes = readText("a.obj", "v 0 0 0 0 128 255\nv 90 0 0 1 1 1\nv 0 90 0 0 0 51\n" + faces);
  EXPECT_EQ(bytes.mesh.colors.row(0), one.mesh.colors.row(0));
  const SurfaceFile partly = readText("a.obj", "v 0 0 0 0 0.5 1\nv 90 0 0\nv 0 90 0\n" + faces);
  EXPECT_EQ(partly.mesh.colors.rows(), 0);
}

TEST(Obj, FaultsAreNamedByLine) {
  EXPECT_THAT(problemOf("a.obj", "v 0 0 0\nv 1 0\n"), HasSubstr("Line 2"));
  EXPECT_THAT(problemOf("a.obj", "v 0 0 0\nv 1 0 x\n"), HasSubstr("Line 2"));
  EXPECT_THAT(problemOf("a.obj", "v 0 0 0\nf\n"), HasSubstr("Line 2"));
  EXPECT_THAT(problemOf("a.obj", "v 0 0 0\nf 1 0 1\n"), HasSubstr("Line 2"));
  EXPECT_THAT(problemOf("a.obj", "v 0 0 0\n"), HasSubstr("no triangles, only points"));
}

const std::string kPlyPoints = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";

TEST(Ply, TextWithCommentsListsAndUnknownElements) {
  const SurfaceFile read = readText(
      "a.ply",
      "ply\nformat ascii 1.0\ncomment SPACE=LPS\nobj_info made by hand\n" + kPlyPoints +
          "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty list uchar float extra\n"
          "element material 1\nproperty int shininess\n"
          "element face 3\nproperty list uchar int vertex_indices\nproperty float quality\nend_header\n"
          "0 0 0 1 2 3 0\n100 0 0 4 5 6 2 0.5 0.5\n0 100 0 7 8 9 0\n0 0 100 10 11 12 1 7\n99\n"
          "3 0 2 1 0.1\n3 0 1 3 0.2\n4 0 3 2 0 0.3\n");
  EXPECT_EQ(read.mesh.triangles.rows(), 3);
  EXPECT_TRUE(read.spaceStated);
  EXPECT_EQ(read.mesh.colors.row(3), (Eigen::Matrix<std::uint8_t, 1, 3>(10, 11, 12)));
}

TEST(Ply, TriangleStripsEndAtMinusOne) {
  const SurfaceFile read = readText("a.ply", "ply\nformat ascii 1.0\n" + kPlyPoints +
                                                 "element tristrips 1\nproperty list int int vertex_indices\n"
                                                 "end_header\n0 0 0\n100 0 0\n0 100 0\n0 0 100\n"
                                                 "10 0 2 1 3 -1 0 3 2 -1 -1 \n");
  EXPECT_EQ(read.mesh.triangles.rows(), 3);
  EXPECT_EQ(geometry::checkSurface(read.mesh).misorientedEdges, 0);
}

TEST(Ply, BigEndianDoublesAndFractionColours) {
  std::string bytes =
      "ply\r\nformat binary_big_endian 1.0\r\nelement vertex 3\r\nproperty double x\r\n"
      "property double y\r\nproperty double z\r\nproperty float red\r\nproperty float green\r\n"
      "property float blue\r\nelement face 1\r\nproperty list ushort uint vertex_index\r\n"
      "end_header\r\n";
  const std::string zero8(8, '\0');
  const std::string hundred8("\x40\x59\0\0\0\0\0\0", 8);         // 100
  const std::string color("\x3f\x80\0\0\x3f\0\0\0\0\0\0\0", 12); // 1, 0.5, 0
  bytes +=
      zero8 + zero8 + zero8 + color + hundred8 + zero8 + zero8 + color + zero8 + hundred8 + zero8 + color;
  bytes += std::string("\0\x03\0\0\0\0\0\0\0\x01\0\0\0\x02", 14);
  const SurfaceFile read = readText("a.ply", bytes);
  EXPECT_EQ(read.mesh.points.row(1).transpose(), Vec3(100, 0, 0));
  EXPECT_EQ(read.mesh.colors.row(2), (Eigen::Matrix<std::uint8_t, 1, 3>(255, 128, 0)));
}

TEST(Ply, HeadersThatPromiseMoreThanThereIsAreRefused) {
  const std::string head = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  const std::string tail = "\nproperty float x\nproperty float y\nproperty float z\n"
                           "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
  EXPECT_THAT(problemOf("a.ply", head + "9000000000000000000" + tail), HasSubstr("cut off"));
  EXPECT_THAT(problemOf("a.ply", head + "99999999999999999999999" + tail), HasSubstr("Line 3"));
  EXPECT_THAT(problemOf("a.ply", head + "-3" + tail), HasSubstr("Line 3"));
  EXPECT_THAT(problemOf("a.ply", head + "1" + tail), HasSubstr("cut off"));
  EXPECT_THAT(problemOf("a.ply", head + "0" + tail + "\xff"), HasSubstr("list"));
}

TEST(Ply, ACloudOfPointsIsNoSurface) {
  EXPECT_THAT(problemOf("a.ply",
                        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                        "property float z\nend_header\n0 0 0\n"),
              HasSubstr("no faces"));
}

TEST(Off, CommentsNormalsColoursAndCountsInTheFirstLine) {
  const SurfaceFile read =
      readText("a.off", "CNOFF 4 4 6 # SPACE=RAS\n# points\n0 0 0 0 0 1 0.0 0.5 1.0 1.0\n\n"
                        "100 0 0 0 0 1 0 0 0 1.\n0 100 0 0 0 1 0 0 0 1.\n0 0 100 0 0 1 1. 1 1 1\n"
                        "3 0 2 1 255 0 0\n3 0 1 3\n3 0 3 2 # red\n3 1 2 3 0.5 0.5 0.5\n");
  EXPECT_EQ(read.space, Space::ras);
  EXPECT_EQ(boundsOf(read.mesh.points).low, Vec3(-100, -100, 0));
  EXPECT_TRUE(geometry::checkSurface(read.mesh).outward());
  EXPECT_EQ(read.mesh.colors.row(0), (Eigen::Matrix<std::uint8_t, 1, 3>(0, 128, 255)));
}

TEST(Off, OtherKindsAreRefusedByName) {
  EXPECT_THAT(problemOf("a.off", "4OFF\n1 0 0\n0 0 0 0\n"), HasSubstr("more than three dimensions"));
  EXPECT_THAT(problemOf("a.off", "OFF BINARY\n\1\2"), HasSubstr("binary OFF"));
  EXPECT_THAT(problemOf("a.off", "PUFF\n1 0 0\n"), HasSubstr("not an OFF file"));
  EXPECT_THAT(problemOf("a.off", "OFF\n1000000000000 1 0\n0 0 0\n"), HasSubstr("Line 2"));
  EXPECT_THAT(problemOf("a.off", "OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), HasSubstr("cut off"));
  EXPECT_THAT(problemOf("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n"), HasSubstr("fewer corners"));
}

} // namespace
} // namespace viscera::medical_io
