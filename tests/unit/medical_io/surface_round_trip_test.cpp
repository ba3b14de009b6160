#include <filesystem>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_checks.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::medical_io {
namespace {

using test::cornerDistance;
using test::organ;
using tests::TemporaryFolder;

struct Format {
  const char* extension;
  bool single;  ///< Has single precision.
  bool colored; ///< Keeps colours.
};

void PrintTo(const Format& format, std::ostream* out) {
  *out << format.extension;
}

class RoundTrip : public testing::TestWithParam<Format> {
protected:
  std::filesystem::path file() const { return folder_ / (std::string("organ") + GetParam().extension); }
  SurfaceFile throughFile(const geometry::TriangleMesh& mesh, const WriteSurface& options = {}) const {
    writeSurface(file(), mesh, options);
    return readSurface(file());
  }
  /// Half a unit in the last place of a float of this size; nothing in double precision.
  double allowed(const geometry::TriangleMesh& mesh) const {
    const double largest = mesh.points.cwiseAbs().maxCoeff();
    return GetParam().single ? 0.5 * largest * std::numeric_limits<float>::epsilon() : 0.0;
  }

  TemporaryFolder folder_;
};

TEST_P(RoundTrip, KeepsTheShapeToTheFormatsPrecision) {
  const geometry::TriangleMesh mesh = organ();
  const SurfaceFile back = throughFile(mesh);
  EXPECT_LE(cornerDistance(mesh, back.mesh), allowed(mesh));
  EXPECT_EQ(back.mesh.points.rows(), mesh.points.rows());
  EXPECT_TRUE(geometry::checkSurface(back.mesh).outward());
  EXPECT_THAT(inEnglish(back.warnings), testing::IsEmpty());
}

TEST_P(RoundTrip, ASecondTimeIsExact) {
  const SurfaceFile once = throughFile(organ());
  const SurfaceFile twice = throughFile(once.mesh);
  EXPECT_EQ(cornerDistance(once.mesh, twice.mesh), 0.0);
  EXPECT_EQ(once.mesh.points, twice.mesh.points);
  EXPECT_EQ(once.mesh.triangles, twice.mesh.triangles);
}

TEST_P(RoundTrip, KeepsColoursWhereTheFormatHasThem) {
  const geometry::TriangleMesh mesh = organ(3);
  ASSERT_GT(mesh.colors.rows(), 256) << "every byte has to occur";
  const SurfaceFile back = throughFile(mesh);
  if (GetParam().colored)
    EXPECT_EQ(back.mesh.colors, mesh.colors);
  else
    EXPECT_EQ(back.mesh.colors.rows(), 0);
}

TEST_P(RoundTrip, WithoutColoursNoneAppear) {
  geometry::TriangleMesh mesh = organ();
  mesh.colors.resize(0, 3);
  EXPECT_EQ(throughFile(mesh).mesh.colors.rows(), 0);
}

TEST_P(RoundTrip, RasInTheFileIsLpsInside) {
  const geometry::TriangleMesh mesh = organ();
  const SurfaceFile back = throughFile(mesh, {Space::ras, "organ"});
  EXPECT_EQ(back.space, Space::ras);
  EXPECT_TRUE(back.spaceStated);
  EXPECT_LE(cornerDistance(mesh, back.mesh), allowed(mesh));
  EXPECT_GT(geometry::checkSurface(back.mesh).volumeMm3, 0) << "a turn, not a mirror image";
}

TEST_P(RoundTrip, LpsIsStated) {
  const SurfaceFile back = throughFile(organ());
  EXPECT_EQ(back.space, Space::lps);
  EXPECT_TRUE(back.spaceStated);
}

TEST_P(RoundTrip, KeepsTheName) {
  EXPECT_EQ(throughFile(organ(), {Space::lps, "Ventrículo, left; 2"}).name, "Ventrículo, left; 2");
  EXPECT_EQ(throughFile(organ()).name, "organ") << "without one it is called like the file";
}

TEST_P(RoundTrip, NamesOfSeveralLinesDoNotBreakTheFile) {
  const SurfaceFile back = throughFile(organ(), {Space::ras, "a\nf 1 2 3\nend_header\n"});
  EXPECT_EQ(back.space, Space::ras);
  EXPECT_EQ(back.mesh.triangles.rows(), organ().triangles.rows());
}

TEST_P(RoundTrip, VeryLongNamesAreCutNotTheFile) {
  const SurfaceFile back = throughFile(organ(), {Space::ras, std::string(5000, 'x')});
  EXPECT_EQ(back.space, Space::ras);
  EXPECT_EQ(back.mesh.triangles.rows(), organ().triangles.rows());
}

TEST_P(RoundTrip, WritesTheSameBytesTwice) {
  writeSurface(file(), organ());
  const std::string first = tests::contentsOf(file());
  writeSurface(file(), organ());
  EXPECT_EQ(tests::contentsOf(file()), first);
}

TEST_P(RoundTrip, FailedWritingLeavesTheOldFileAndNothingElse) {
  writeSurface(file(), organ());
  const std::string before = tests::contentsOf(file());
  geometry::TriangleMesh broken = organ();
  broken.points(3, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(writeSurface(file(), broken), DataError);
  broken = organ();
  broken.triangles(3, 1) = 100000;
  EXPECT_THROW(writeSurface(file(), broken), DataError);
  EXPECT_THROW(writeSurface(file(), geometry::TriangleMesh()), DataError);
  EXPECT_THROW(writeSurface(folder_ / "no" / file().filename().string(), organ()), CannotCreateError);
  EXPECT_EQ(tests::contentsOf(file()), before);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_.path()), {}), 1);
}

INSTANTIATE_TEST_SUITE_P(Formats, RoundTrip,
                         testing::Values(Format{".stl", true, false}, Format{".obj", false, true},
                                         Format{".ply", false, true}, Format{".off", false, true},
                                         Format{".vtk", false, true}, Format{".vtp", false, true},
                                         Format{".glb", true, true}),
                         [](const auto& way) { return std::string(way.param.extension + 1); });

TEST(WriteSurface, NamesTheEndingsThatItCanWrite) {
  const TemporaryFolder folder;
  for (const char* name : {"organ.gltf", "organ.xyz", "organ"}) {
    try {
      writeSurface(folder / name, organ());
      ADD_FAILURE() << name;
    } catch (const CannotCreateError& error) {
      EXPECT_THAT(error.tryThis().english(), testing::HasSubstr(".stl"));
      EXPECT_THAT(error.tryThis().english(), testing::Not(testing::HasSubstr(".gltf")));
    }
  }
}

TEST(WriteSurface, EndingsInCapitalsAreUnderstood) {
  const TemporaryFolder folder;
  writeSurface(folder / "ORGAN.STL", organ());
  EXPECT_EQ(readSurface(folder / "ORGAN.STL").mesh.triangles.rows(), organ().triangles.rows());
}

} // namespace
} // namespace viscera::medical_io
