#include <algorithm>

#include "fuzz_target.h"
#include "good_files.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/medical_io/surface_file.h"

/// Files of surfaces and of handles.
namespace viscera::fuzz {
namespace {

const std::vector<std::string> kHandleEndings = {".mrk.json", ".fcsv"};

/// The files of the broken-file tests that end so.
std::vector<std::string> goodFilesEnding(const std::vector<std::string>& endings, tests::FileUse use) {
  std::vector<std::string> out;
  for (const tests::GoodFile& file : tests::goodFiles())
    for (std::size_t kind = 0; kind < endings.size(); ++kind)
      if (file.use == use && file.name.ends_with(endings[kind]))
        out.push_back(chosen(kind, file.bytes));
  return out;
}

/// Writes what the good files have beside them.
bool placeHalves() {
  for (const tests::GoodFile& file : tests::goodFiles())
    if (file.use == tests::FileUse::surface && !file.besideName.empty())
      scratchFile(file.besideName,
                  {reinterpret_cast<const std::uint8_t*>(file.besideBytes.data()), file.besideBytes.size()});
  return true;
}

void readAnySurface(Bytes bytes) {
  static const bool placed = placeHalves();
  require(placed, "The blocks are beside the file.");
  const auto& endings = medical_io::endingsOf(medical_io::FileKind::surface);
  const Choice choice = choose(bytes, endings.size());
  for (const medical_io::SurfacePart& part :
       medical_io::readSurfaces(scratchFile("a" + endings[choice.kind], choice.rest))) {
    const geometry::TriangleMesh& mesh = part.surface.mesh;
    geometry::requireValid(mesh, "what was read");
    require(mesh.triangles.rows() > 0, "A surface that was read has triangles.");
    require(mesh.points.cwiseAbs().maxCoeff() <= 1e9, "Coordinates are at most 1000 km.");
    require(!part.surface.name.empty(), "An organ has a name.");
    geometry::checkSurface(mesh);
  }
}

void readAnyHandles(Bytes bytes) {
  const Choice choice = choose(bytes, kHandleEndings.size());
  const medical_io::HandleFile read =
      medical_io::readHandles(scratchFile("a" + kHandleEndings[choice.kind], choice.rest));
  require(read.count() > 0, "A file of handles that was read has some.");
  require(read.positions().allFinite(), "Handles have places.");
  const auto written = scratchFolder() / "b.mrk.json";
  medical_io::writeHandles(written, read);
  const medical_io::HandleFile again = medical_io::readHandles(written);
  require(again.positions() == read.positions(), "Handles that are written and read have the same places.");
}

} // namespace

Target surfaceFileTarget() {
  return {"surfaces", readAnySurface, [] {
            return goodFilesEnding(medical_io::endingsOf(medical_io::FileKind::surface),
                                   tests::FileUse::surface);
          }};
}

Target handleFileTarget() {
  return {"handles", readAnyHandles, [] { return goodFilesEnding(kHandleEndings, tests::FileUse::handles); }};
}

} // namespace viscera::fuzz
