#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_checks.h"
#include "mesh_files.h"
#include "packed_bytes.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/file_kind.h"

/// Surfaces of GIFTI, FreeSurfer and CARTO, and compressed files of every kind.
namespace viscera::medical_io {
namespace {

using test::warnsOf;
using testing::AllOf;
using testing::HasSubstr;
using tests::freeSurferFile;
using tests::GiftiForm;
using tests::TemporaryFolder;
using tests::valueBytes;

/// 100 mm x 80 mm x 60 mm from (10, 20, 30) on.
geometry::TriangleMesh brick() {
  geometry::TriangleMesh mesh = tests::box(100, 80, 60);
  mesh.points.rowwise() += Vec3(10, 20, 30).transpose();
  return mesh;
}

/// The brick, read as RAS and moved by `offset` of RAS.
void expectBrick(const SurfaceFile& read, const Vec3& offset = Vec3::Zero(), double tolerance = 1e-4) {
  EXPECT_EQ(read.space, Space::ras);
  EXPECT_TRUE(read.report.closed() && read.report.manifold());
  EXPECT_NEAR(read.report.volumeMm3, 480000, 1);
  const Bounds box = boundsOf(read.mesh.points);
  const Vec3 low = Vec3(10, 20, 30) + offset, high = low + Vec3(100, 80, 60);
  EXPECT_LT((box.low - Vec3(-high.x(), -high.y(), low.z())).norm(), tolerance);
  EXPECT_LT((box.high - Vec3(-low.x(), -low.y(), high.z())).norm(), tolerance);
}

std::string problemOfBrain(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  try {
    readSurface(folder.put(name, bytes));
  } catch (const DataError& error) {
    return error.what();
  }
  ADD_FAILURE() << name << " was read";
  return {};
}

// ---- GIFTI ------------------------------------------------------------------------------------------------

std::string gifti(const GiftiForm& form) {
  return tests::giftiFile(brick(), form, tests::zlibPacked);
}

TEST(Gifti, OpensInEveryEncodingOrderAndType) {
  const TemporaryFolder folder;
  for (const char* encoding : {"ASCII", "Base64Binary", "GZipBase64Binary"})
    for (const std::endian order : {std::endian::little, std::endian::big})
      for (const bool columns : {false, true})
        for (const bool doubles : {false, true}) {
          const auto file = folder.put(
              "lh.pial.surf.gii",
              gifti({.encoding = encoding, .order = order, .columns = columns, .doubles = doubles}));
          EXPECT_EQ(fileKind(file), FileKind::surface);
          const SurfaceFile read = readSurface(file);
          expectBrick(read);
          EXPECT_EQ(read.name, "lh.pial");
        }
}

std::string transform(const std::string& from, const std::string& to, const std::string& matrix) {
  return "<CoordinateSystemTransformMatrix><DataSpace><![CDATA[" + from +
         "]]></DataSpace><TransformedSpace><![CDATA[" + to + "]]></TransformedSpace><MatrixData>" + matrix +
         "</MatrixData></CoordinateSystemTransformMatrix>";
}

TEST(Gifti, OnlyTheMatrixToTheScanIsApplied) {
  const TemporaryFolder folder;
  const std::string shift = "1 0 0 5\n0 1 0 -6\n0 0 1 7\n0 0 0 1";
  const std::string none = "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1";
  const auto read = [&](const std::string& element) {
    return readSurface(folder.put("a.gii", gifti({.transform = element})));
  };
  const SurfaceFile moved = read(transform("NIFTI_XFORM_UNKNOWN", "NIFTI_XFORM_SCANNER_ANAT", shift));
  expectBrick(moved, Vec3(5, -6, 7));
  EXPECT_TRUE(warnsOf(moved, "moved to the scan"));
  const SurfaceFile standard = read(transform("NIFTI_XFORM_SCANNER_ANAT", "NIFTI_XFORM_TALAIRACH", shift));
  expectBrick(standard);
  EXPECT_TRUE(warnsOf(standard, "NIFTI_XFORM_TALAIRACH was not applied"));
  const SurfaceFile same = read(transform("NIFTI_XFORM_TALAIRACH", "NIFTI_XFORM_TALAIRACH", none));
  expectBrick(same);
  EXPECT_FALSE(warnsOf(same, "matrix"));
  EXPECT_THAT(problemOfBrain("a.gii", gifti({.transform = transform("", "", "1 2 3")})),
              HasSubstr("16 numbers"));
}

TEST(Gifti, OtherContentsAreNamed) {
  std::string external = gifti({.encoding = "Base64Binary"});
  const std::string encoding = "Encoding=\"Base64Binary\"";
  external.replace(external.find(encoding), encoding.size(), "Encoding=\"ExternalFileBinary\"");
  external.replace(external.find("ExternalFileName=\"\""), 19, "ExternalFileName=\"points.bin\"");
  EXPECT_THAT(problemOfBrain("a.gii", external),
              AllOf(HasSubstr("points.bin"), HasSubstr("GZipBase64Binary")));
  std::string values = gifti({});
  values.replace(values.find("NIFTI_INTENT_POINTSET"), 21, "NIFTI_INTENT_SHAPE");
  EXPECT_THAT(problemOfBrain("a.gii", values), HasSubstr("NIFTI_INTENT_SHAPE"));
  std::string more = gifti({});
  more.replace(more.find("Dim0=\"8\""), 8, "Dim0=\"9\"");
  EXPECT_THAT(problemOfBrain("a.gii", more), HasSubstr("27 values"));
  std::string fewer = gifti({});
  fewer.replace(fewer.find("Dim0=\"8\""), 8, "Dim0=\"7\"");
  EXPECT_THAT(problemOfBrain("a.gii", fewer), HasSubstr("21 values"));
}

// ---- FreeSurfer -------------------------------------------------------------------------------------------

/// The lines that say where the scan is.
std::string footer(const std::string& cras,
                   const std::string& axes = "xras   = -1 0 0\nyras   = 0 0 -1\n"
                                             "zras   = 0 1 0\n",
                   int inScanner = 0, int valid = 1) {
  const auto big = std::endian::big;
  return valueBytes(std::int32_t{2}, big) + valueBytes(std::int32_t{inScanner}, big) +
         valueBytes(std::int32_t{20}, big) + "valid = " + std::to_string(valid) +
         "  # volume info valid\nfilename = orig.mgz\nvolume = 256 256 256\nvoxelsize = 1 1 1\n" + axes +
         "cras   = " + cras + "\n";
}

TEST(FreeSurfer, TrianglesOpenUnderAnyNameAtThePlaceOfTheirScan) {
  const TemporaryFolder folder;
  for (const char* name : {"lh.white", "rh.pial", "lh.inflated", "surface"}) {
    const auto file = folder.put(name, freeSurferFile(brick(), footer("5 -6 7")));
    EXPECT_EQ(fileKind(file), FileKind::surface);
    const SurfaceFile read = readSurface(file);
    expectBrick(read, Vec3(5, -6, 7));
    EXPECT_EQ(read.name, name);
    EXPECT_TRUE(warnsOf(read, "moved from FreeSurfer"));
    EXPECT_EQ(readSurfaces(file).size(), 1U);
  }
}

TEST(FreeSurfer, WithoutAPlaceThePointsStayAndThisIsSaid) {
  const TemporaryFolder folder;
  const std::string axes = "xras   = -1 0 0\nyras   = 0 0 -1\nzras   = 0 1 0\n";
  for (const std::string& end : {std::string(), footer("5 6 7", axes, 0, 0)}) {
    const SurfaceFile read = readSurface(folder.put("lh.white", freeSurferFile(brick(), end)));
    expectBrick(read);
    EXPECT_TRUE(warnsOf(read, "does not say where its scan is"));
  }
  const SurfaceFile placed =
      readSurface(folder.put("lh.white", freeSurferFile(brick(), footer("5 6 7", axes, 1))));
  expectBrick(placed);
  EXPECT_FALSE(warnsOf(placed, "FreeSurfer"));
}

TEST(FreeSurfer, ATurnedScanTurnsThePoints) {
  const TemporaryFolder folder;
  // A quarter turn around the axis from foot to head: the scan's left is behind.
  const SurfaceFile read = readSurface(folder.put(
      "lh.white", freeSurferFile(brick(), footer("0 0 0", "xras = 0 1 0\nyras = 0 0 -1\nzras = 1 0 0\n"))));
  const Bounds box = boundsOf(read.mesh.points);
  EXPECT_LT((box.low - Vec3(-100, 10, 30)).norm(), 1e-4);
  EXPECT_LT((box.high - Vec3(-20, 110, 90)).norm(), 1e-4);
}

TEST(FreeSurfer, TextOpens) {
  const TemporaryFolder folder;
  const SurfaceFile read = readSurface(folder.put("lh.white.asc", tests::freeSurferText(brick())));
  expectBrick(read);
  EXPECT_EQ(read.name, "lh.white");
}

std::string threeBytes(int value) {
  return valueBytes(std::int32_t{value}, std::endian::big).substr(1);
}

TEST(FreeSurfer, OldQuadrilateralsOpenInBothPrecisions) {
  const TemporaryFolder folder;
  const geometry::TriangleMesh mesh = brick();
  const std::vector<std::vector<int>> quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                               {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const bool inHundredths : {true, false}) {
    std::string bytes = (inHundredths ? "\xff\xff\xff" : "\xff\xff\xfd") + threeBytes(8) + threeBytes(6);
    for (Eigen::Index v = 0; v < 8; ++v)
      for (int axis = 0; axis < 3; ++axis)
        bytes += inHundredths
                     ? valueBytes(static_cast<std::int16_t>(100 * mesh.points(v, axis)), std::endian::big)
                     : valueBytes(static_cast<float>(mesh.points(v, axis)), std::endian::big);
    for (const auto& quad : quads)
      for (const int corner : quad)
        bytes += threeBytes(corner);
    expectBrick(readSurface(folder.put("lh.orig", bytes)));
  }
}

TEST(FreeSurfer, FilesOfCurvatureAreNamed) {
  std::string bytes = "\xff\xff\xff" + valueBytes(std::int32_t{8}, std::endian::big) +
                      valueBytes(std::int32_t{12}, std::endian::big) +
                      valueBytes(std::int32_t{1}, std::endian::big) + std::string(32, '\0');
  EXPECT_THAT(problemOfBrain("lh.curv", bytes), AllOf(HasSubstr("curvature"), HasSubstr("lh.white")));
  EXPECT_THAT(problemOfBrain("lh.white", freeSurferFile(brick()).substr(0, 200)),
              HasSubstr("more than the 64 bytes that are left"));
}

// ---- CARTO ------------------------------------------------------------------------------------------------

TEST(Carto, MapsOpenWithoutWhatWasCutAway) {
  const TemporaryFolder folder;
  const auto file = folder.put("1-LA.mesh", tests::cartoText(brick(), 3));
  EXPECT_EQ(fileKind(file), FileKind::surface);
  const SurfaceFile read = readSurface(file);
  EXPECT_NEAR(read.report.volumeMm3, 480000, 1e-3);
  EXPECT_EQ(read.name, "1-LA");
  EXPECT_TRUE(warnsOf(read, "3 triangles"));
  EXPECT_FALSE(read.spaceStated);
  std::string dos;
  for (const char c : tests::cartoText(brick()))
    dos += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_NEAR(readSurface(folder.put("dos.mesh", dos)).report.volumeMm3, 480000, 1e-3);
}

TEST(Carto, FilesThatAreCutOffAreRefused) {
  const std::string text = tests::cartoText(brick());
  EXPECT_THAT(problemOfBrain("a.mesh", text.substr(0, text.find("9 ="))), HasSubstr("cut off"));
}

// ---- compressed files -------------------------------------------------------------------------------------

TEST(CompressedSurface, OpensAsWhatItIsUncompressed) {
  const TemporaryFolder folder;
  for (const std::string extension : {".stl", ".obj", ".ply", ".off", ".vtk", ".vtp", ".glb"}) {
    writeSurface(folder / ("organ" + extension), brick());
    const auto file = folder.put("Liver left" + extension + ".gz",
                                 tests::gzipped(tests::contentsOf(folder / ("organ" + extension))));
    EXPECT_EQ(fileKind(file), FileKind::surface) << extension;
    const SurfaceFile read = readSurface(file);
    EXPECT_NEAR(read.report.volumeMm3, 480000, 1) << extension;
    if (extension == ".stl") {
      EXPECT_EQ(read.name, "Liver left");
    }
  }
  const auto mesh = tests::hollowBox(tests::Split::tetrahedra);
  EXPECT_EQ(
      readSurfaces(folder.put("a.msh.gz", tests::gzipped(tests::GmshFile(mesh, 4.1, true).text()))).size(),
      2U);
  expectBrick(readSurface(folder.put("lh.pial.surf.gii.gz", tests::gzipped(gifti({})))));
  expectBrick(readSurface(folder.put("lh.white.gz", tests::gzipped(freeSurferFile(brick())))));
  folder.put("heart.pts", tests::carpPoints(mesh));
  EXPECT_NEAR(readSurface(folder.put("heart.elem.gz", tests::gzipped(tests::carpElements(mesh, true))))
                  .report.volumeMm3,
              26000, 1e-3);
}

TEST(CompressedSurface, ThatIsBrokenOrOfAnotherKindIsNamed) {
  const TemporaryFolder folder;
  const std::string packed = tests::gzipped(tests::freeSurferText(brick()));
  EXPECT_THAT(problemOfBrain("a.asc.gz", packed.substr(0, packed.size() / 2)), HasSubstr("cut off"));
  EXPECT_THAT(problemOfBrain("a.stl.gz", tests::gzipped("NRRD0004\ntype: short\n")), HasSubstr("NRRD"));
  EXPECT_THROW(writeSurface(folder / "a.stl.gz", brick()), CannotCreateError);
}

} // namespace
} // namespace viscera::medical_io
