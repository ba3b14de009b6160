#include "viscera/medical_io/surface_file.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_checks.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/volume.h"
#include "viscera/medical_io/file_kind.h"

namespace viscera::medical_io {
namespace {

using test::organ;
using test::warnsOf;
using testing::HasSubstr;
using tests::contentsOf;
using tests::TemporaryFolder;

std::string problemOfSurface(const std::filesystem::path& file) {
  try {
    readSurface(file);
  } catch (const DataError& error) {
    EXPECT_THAT(error.what(), HasSubstr(file.string()));
    return error.problem().english() + " (" + error.tryThis().english() + ")";
  }
  ADD_FAILURE() << file << " was read";
  return {};
}

/// A tetrahedron of 100 mm in OBJ, with statements before and after.
std::string tetrahedronObj(const std::string& before = {}, const std::string& after = {}) {
  return before + "v 0 0 0\nv 100 0 0\nv 0 100 0\nv 0 0 100\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n" + after;
}

TEST(ReadSurface, MissingFilesAndFoldersAreNoInput) {
  const TemporaryFolder folder;
  EXPECT_THROW(readSurface(folder / "none.stl"), NoInputError);
  EXPECT_THROW(readSurface(folder.path()), NoInputError);
  EXPECT_THROW(readSurface("/dev/null"), NoInputError);
}

TEST(ReadSurface, EmptyFilesAreSaidToBeEmpty) {
  const TemporaryFolder folder;
  for (const std::string& extension : endingsOf(FileKind::surface))
    EXPECT_THAT(problemOfSurface(folder.put("empty" + extension, "")), HasSubstr("empty")) << extension;
}

TEST(ReadSurface, BytesTellAFileOfAnUnknownEnding) {
  const TemporaryFolder folder;
  EXPECT_EQ(readSurface(folder.put("organ.xyz", tetrahedronObj())).mesh.triangles.rows(), 4);
  EXPECT_EQ(readSurface(folder.put("organ", tetrahedronObj())).mesh.triangles.rows(), 4);
  EXPECT_THAT(problemOfSurface(folder.put("organ.xyz", "\x01\x02 nothing known")),
              testing::AllOf(HasSubstr("It is not a surface"), HasSubstr(".stl"), HasSubstr(".vtp")));
}

TEST(ReadSurface, WhatIsNotReadIsNamedWithAWayOut) {
  const TemporaryFolder folder;
  const auto problem = [&](const char* name) {
    return problemOfSurface(folder.put(name, "ISO-10303-21;\nHEADER;\n"));
  };
  EXPECT_THAT(problem("heart.step"), testing::AllOf(HasSubstr("a CAD model"), HasSubstr("export it as STL")));
  EXPECT_THAT(problem("case.mrb"), testing::AllOf(HasSubstr("a scene of 3D Slicer"), HasSubstr("save")));
  EXPECT_THAT(problemOfSurface(folder.put("a.seg.nrrd", "NRRD0004\ntype: short\n")),
              testing::AllOf(HasSubstr("It is not a surface"), HasSubstr("looks like NRRD")));
}

TEST(ReadSurface, AWronglyNamedFileIsNamedAsWhatItIs) {
  const TemporaryFolder folder;
  const geometry::TriangleMesh mesh = organ();
  const std::vector<std::pair<std::string, std::string>> kinds = {
      {".stl", "STL"}, {".obj", "OBJ"}, {".ply", "PLY"}, {".off", "OFF"},
      {".vtk", "VTK"}, {".vtp", "VTP"}, {".glb", "GLB"}};
  for (const auto& [real, description] : kinds)
    for (const auto& [claimed, other] : kinds) {
      if (real == claimed)
        continue;
      writeSurface(folder / ("right" + real), mesh);
      const auto file = folder.put("wrong" + claimed, contentsOf(folder / ("right" + real)));
      EXPECT_THAT(problemOfSurface(file), testing::AllOf(HasSubstr("looks like " + description + " "),
                                                         HasSubstr("rename it"), HasSubstr(real)));
    }
}

TEST(ReadSurface, ImagesAndArchivesAreNamed) {
  const TemporaryFolder folder;
  EXPECT_THAT(problemOfSurface(folder.put("a.stl", "NRRD0004\ntype: short\n")), HasSubstr("NRRD"));
  EXPECT_THAT(problemOfSurface(folder.put("a.obj", "\x1f\x8b\x08 packed")),
              HasSubstr("packed data are damaged"));
  EXPECT_THAT(problemOfSurface(folder.put("a.ply", "PK\x03\x04 packed")), HasSubstr("ZIP"));
  EXPECT_THAT(problemOfSurface(folder.put("a.vtk", "\x89PNG\r\n")), HasSubstr("picture"));
}

TEST(ReadSurface, EqualPointsAreMergedAndUnusedOnesDropped) {
  const TemporaryFolder folder;
  const auto file = folder.put("a.obj", "v 5 5 5\nv 0 0 0\nv 100 0 0\nv 0 100 0\nv 0 0 100\nv -0.0 0 0\n"
                                        "f 6 4 3\nf 2 3 5\nf 2 5 4\nf 3 4 5\n");
  const SurfaceFile read = readSurface(file);
  EXPECT_EQ(read.mesh.points.rows(), 4);
  EXPECT_TRUE(geometry::checkSurface(read.mesh).closed()) << "0 and -0 are the same place";
  EXPECT_TRUE(warnsOf(read, "1 point that repeats another merged"));
  EXPECT_TRUE(warnsOf(read, "1 point without a triangle dropped"));
}

TEST(ReadSurface, TrianglesWithARepeatedCornerAreDroppedOthersKept) {
  const TemporaryFolder folder;
  const SurfaceFile read = readSurface(folder.put("a.obj", tetrahedronObj("", "f 1 1 2\nf 3 2 3\n")));
  EXPECT_EQ(read.mesh.triangles.rows(), 4);
  EXPECT_TRUE(warnsOf(read, "2 triangles with a repeated corner dropped"));
}

TEST(ReadSurface, ATriangleWithoutAreaStaysBecauseItClosesTheSurface) {
  const TemporaryFolder folder;
  // The edge 1-2 is split at its middle, 5, on one side only; the flat triangle 1 5 2 joins the two sides.
  const SurfaceFile read =
      readSurface(folder.put("a.obj", "v 0 0 0\nv 100 0 0\nv 0 100 0\nv 0 0 100\nv 50 0 0\n"
                                      "f 1 3 5\nf 5 3 2\nf 1 5 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"));
  EXPECT_EQ(read.mesh.triangles.rows(), 6);
  EXPECT_EQ(geometry::checkSurface(read.mesh).boundaryEdges, 0);
  EXPECT_TRUE(warnsOf(read, "no area"));
}

TEST(ReadSurface, PointsThatAreNotFiniteAreNamedUnlessUnused) {
  const TemporaryFolder folder;
  for (const char* bad : {"nan", "inf", "-inf", "1e999", "1e300"})
    EXPECT_THAT(
        problemOfSurface(folder.put("a.obj", std::string("v 1 2 3\nv 0 ") + bad + " 0\nv 0 1 0\nf 1 2 3\n")),
        HasSubstr("Point 1 "))
        << bad;
  EXPECT_EQ(readSurface(folder.put("b.obj", tetrahedronObj("", "v nan 0 0\n"))).mesh.points.rows(), 4);
}

TEST(ReadSurface, IndicesOutOfRangeAreNamed) {
  const TemporaryFolder folder;
  EXPECT_THAT(problemOfSurface(folder.put("a.obj", tetrahedronObj("", "f 1 2 5\n"))), HasSubstr("point 4"));
  EXPECT_THAT(problemOfSurface(folder.put("b.obj", "v 0 0 0\nf -1 -2 -1\n")), HasSubstr("Line 2"));
  EXPECT_THAT(problemOfSurface(folder.put("c.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n")),
              HasSubstr("point 3"));
  EXPECT_THAT(problemOfSurface(folder.put("d.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n")),
              HasSubstr("point -1"));
}

TEST(ReadSurface, PolygonsThatAreNotConvexAreCutRight) {
  const TemporaryFolder folder;
  // An L of area 3, and a dart of area 0.75 whose shorter diagonal lies outside.
  const SurfaceFile ell = readSurface(folder.put(
      "ell.obj", "v 1 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nf 2 3 4 5 6 7 1\n"));
  EXPECT_NEAR(geometry::area(ell.mesh.points, ell.mesh.triangles), 3, 1e-12);
  EXPECT_EQ(ell.mesh.triangles.rows(), 5);
  const SurfaceFile dart =
      readSurface(folder.put("dart.obj", "v 0 0 0\nv 2 -0.5 0\nv 1.5 0 0\nv 2 0.5 0\nf 1 2 3 4\n"));
  EXPECT_NEAR(geometry::area(dart.mesh.points, dart.mesh.triangles), 0.75, 1e-12);
}

TEST(ReadSurface, SizesThatNoOrganHasAreQuestionedWithTheLikelyUnit) {
  const TemporaryFolder folder;
  const auto warningAt = [&](double scale, const std::string& unit) {
    geometry::TriangleMesh mesh = organ();
    mesh.points *= scale;
    writeSurface(folder / "a.ply", mesh);
    const SurfaceFile read = readSurface(folder / "a.ply");
    return unit.empty() ? !warnsOf(read, "implausible") : warnsOf(read, "implausible") && warnsOf(read, unit);
  };
  EXPECT_TRUE(warningAt(1, ""));
  EXPECT_TRUE(warningAt(1e-3, "metres"));
  EXPECT_TRUE(warningAt(1 / 25.4, "inches"));
  EXPECT_TRUE(warningAt(1e-1, "centimetres"));
  EXPECT_TRUE(warningAt(1e-6, "kilometres"));
  EXPECT_TRUE(warningAt(1e3, "micrometres"));
  EXPECT_TRUE(warningAt(1e-9, "implausible"));
}

TEST(ReadSurface, VolumeFarFromTheNamedOrganIsQuestioned) {
  const TemporaryFolder folder;
  // A ball of 60 mm radius has 905 ml.
  geometry::TriangleMesh ball = organ(3);
  ball.points *= 1.2;
  writeSurface(folder / "a.ply", ball, {Space::lps, "Kidney_left"});
  EXPECT_TRUE(warnsOf(readSurface(folder / "a.ply"), "kidney"));
  writeSurface(folder / "a.ply", ball, {Space::lps, "liver 1"});
  EXPECT_FALSE(warnsOf(readSurface(folder / "a.ply"), "liver")) << "a small liver is one";
  writeSurface(folder / "a.ply", ball, {Space::lps, "kidney tumour"});
  EXPECT_FALSE(warnsOf(readSurface(folder / "a.ply"), "kidney"));
}

TEST(ReadSurface, OpenAndInsideOutSurfacesAreReported) {
  const TemporaryFolder folder;
  geometry::TriangleMesh mesh = organ();
  mesh.triangles.col(0).swap(mesh.triangles.col(1));
  writeSurface(folder / "a.stl", mesh);
  EXPECT_TRUE(warnsOf(readSurface(folder / "a.stl"), "inside out"));
  mesh.triangles.conservativeResize(mesh.triangles.rows() - 1, 3);
  writeSurface(folder / "a.stl", mesh);
  EXPECT_TRUE(warnsOf(readSurface(folder / "a.stl"), "3 boundary edges"));
}

TEST(ReadSurface, UnknownAxesAreReportedAndTakenAsLps) {
  const TemporaryFolder folder;
  const SurfaceFile read = readSurface(folder.put("a.obj", tetrahedronObj("# SPACE=LAS\n")));
  EXPECT_FALSE(read.spaceStated);
  EXPECT_TRUE(warnsOf(read, "LAS"));
  EXPECT_EQ(boundsOf(read.mesh.points).high, Vec3(100, 100, 100));
}

} // namespace
} // namespace viscera::medical_io
