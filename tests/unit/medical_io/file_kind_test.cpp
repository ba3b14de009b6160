#include "viscera/medical_io/file_kind.h"

#include <gtest/gtest.h>

#include "mesh_checks.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/handle_file.h"

namespace viscera::medical_io {
namespace {

using tests::TemporaryFolder;

TEST(FileKind, SurfacesAndHandlesThatVisceraWritesAreKnownUnderAnyName) {
  const TemporaryFolder folder;
  for (const std::string extension : {".stl", ".obj", ".ply", ".off", ".vtk", ".vtp", ".glb"}) {
    writeSurface(folder / ("organ" + extension), test::organ());
    EXPECT_EQ(fileKind(folder / ("organ" + extension)), FileKind::surface) << extension;
    std::filesystem::rename(folder / ("organ" + extension), folder / "nameless");
    EXPECT_EQ(fileKind(folder / "nameless"), FileKind::surface) << extension;
  }
  HandleFile rig;
  rig.groups.push_back({"A", {1, 0, 0}, {{"A-1", {1, 2, 3}, "", false, true}}});
  writeHandles(folder / "rig.json", rig);
  EXPECT_EQ(fileKind(folder / "rig.json"), FileKind::handles);
}

TEST(FileKind, EndingsDecideWhereBytesDoNot) {
  const TemporaryFolder folder;
  EXPECT_EQ(fileKind(folder.put("beat.sequence.json", "{}")), FileKind::sequence);
  EXPECT_EQ(fileKind(folder.put("case.viscera", "{}")), FileKind::session);
  EXPECT_EQ(fileKind(folder.put("ct.nii.gz", "\x1f\x8b\x08")), FileKind::labelMap);
  EXPECT_EQ(fileKind(folder.put("points.fcsv", "a,1,2,3\n")), FileKind::handles);
  EXPECT_EQ(fileKind(folder.put("broken.stl", "nothing")), FileKind::surface);
  EXPECT_EQ(fileKind(folder.put("empty.vtp", "")), FileKind::surface);
  EXPECT_EQ(fileKind(folder.put("notes.txt", "nothing")), FileKind::unknown);
}

TEST(FileKind, BytesWithoutANameHaveAUsualEnding) {
  const TemporaryFolder folder;
  for (const std::string extension : {".stl", ".obj", ".ply", ".off", ".vtk", ".vtp", ".glb"}) {
    writeSurface(folder / ("organ" + extension), test::organ());
    std::filesystem::rename(folder / ("organ" + extension), folder / "nameless");
    EXPECT_EQ(usualEnding(folder / "nameless"), extension);
  }
  HandleFile rig;
  rig.groups.push_back({"A", {1, 0, 0}, {{"A-1", {1, 2, 3}, "", false, true}}});
  writeHandles(folder / "rig.json", rig);
  EXPECT_EQ(usualEnding(folder / "rig.json"), ".mrk.json");
  EXPECT_EQ(usualEnding(folder.put("packed", "\x1f\x8b\x08")), ".nii.gz");
  EXPECT_EQ(usualEnding(folder.put("image", "NRRD0004\n")), ".nrrd");
  EXPECT_EQ(usualEnding(folder.put("notes", "nothing")), "");
  EXPECT_THROW(usualEnding(folder.put("empty", "")), DataError);
  EXPECT_THROW(usualEnding(folder / "missing"), NoInputError);
}

TEST(FileKind, BytesWinOverEndings) {
  const TemporaryFolder folder;
  EXPECT_EQ(fileKind(folder.put("a.stl", "NRRD0005\n# label map\n")), FileKind::labelMap);
  EXPECT_EQ(fileKind(folder.put("a.nrrd", "OFF\n1 0 0\n0 0 0\n")), FileKind::surface);
  EXPECT_EQ(fileKind(folder.put("a.json", R"({"markups": [{"controlPoints": []}]})")), FileKind::handles);
}

TEST(FileKind, NamesAreThoseOfTheCommandLine) {
  EXPECT_EQ(nameOf(FileKind::labelMap), "label map");
  EXPECT_EQ(nameOf(FileKind::handles), "handles");
  EXPECT_EQ(nameOf(FileKind::unknown), "unknown");
}

TEST(FileKind, MissingFilesAreNoInput) {
  const TemporaryFolder folder;
  EXPECT_THROW(fileKind(folder / "none"), NoInputError);
}

} // namespace
} // namespace viscera::medical_io
