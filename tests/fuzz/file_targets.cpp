#include <algorithm>
#include <fstream>

#include "fuzz_target.h"
#include "good_files.h"
#include "packed_bytes.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/medical_io/surface_file.h"
#include "zip_files.h"

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

/// Puts the intact other half of a mesh that is two files.
void putOtherHalf(const std::string& ending) {
  static const tests::GoodFile kMesh = [] {
    const std::vector<tests::GoodFile> all = tests::goodFiles();
    return *std::find_if(all.begin(), all.end(),
                         [](const tests::GoodFile& file) { return file.name.ends_with(".elem"); });
  }();
  const bool points = ending == ".pts";
  std::ofstream(scratchFolder() / (points ? "a.elem" : "a.pts"), std::ios::binary)
      << (points ? kMesh.bytes : kMesh.besideBytes);
}

void readAnySurface(Bytes bytes) {
  static const bool placed = placeHalves();
  require(placed, "The blocks are beside the file.");
  const auto& endings = medical_io::endingsOf(medical_io::FileKind::surface);
  const Choice choice = choose(bytes, endings.size());
  if (const std::string& ending = endings[choice.kind];
      ending == ".elem" || ending == ".surf" || ending == ".pts")
    putOtherHalf(ending);
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

/// The good files, other halves, and a compressed one.
std::vector<std::string> surfaceSeeds() {
  const auto& endings = medical_io::endingsOf(medical_io::FileKind::surface);
  std::vector<std::string> out = goodFilesEnding(endings, tests::FileUse::surface);
  out.push_back(chosen(0, tests::gzipped(out.front().substr(1))));
  for (std::size_t kind = 0; kind < endings.size(); ++kind)
    for (const tests::GoodFile& file : tests::goodFiles())
      if (file.name.ends_with(".elem") && (endings[kind] == ".pts" || endings[kind] == ".surf"))
        out.push_back(chosen(kind, endings[kind] == ".pts" ? file.besideBytes : file.bytes));
  return out;
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

/// The bytes as the model of a 3MF package: a package that is changed fails by its checksums.
void readAnyModel(Bytes bytes) {
  const std::string package = tests::zipFile({{"3D/3dmodel.model", textOf(bytes), false}});
  const auto file =
      scratchFile("a.3mf", {reinterpret_cast<const std::uint8_t*>(package.data()), package.size()});
  for (const medical_io::SurfacePart& part : medical_io::readSurfaces(file)) {
    geometry::requireValid(part.surface.mesh, "what was read");
    require(part.surface.mesh.triangles.rows() > 0, "A part that was read has triangles.");
    require(part.opacity >= 0 && part.opacity <= 1, "An opacity is from 0 to 1.");
  }
}

/// A model with what programs use: two kinds of colours, an assembly that is turned, a unit.
std::string modelWithEverything() {
  return R"(<?xml version="1.0"?><model unit="inch" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" )"
         R"(xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02"><metadata name="Description">)"
         R"(Viscera: a; SPACE=RAS</metadata><resources><basematerials id="1"><base name="a" displaycolor="#FF8000"/>)"
         R"(</basematerials><m:colorgroup id="2"><m:color color="#00FF0080"/><m:color color="#0000FF"/></m:colorgroup>)"
         R"(<object id="3" name="Liver" type="model" pid="1" pindex="0"><mesh><vertices><vertex x="0" y="0" z="0"/>)"
         R"(<vertex x="9" y="0" z="0"/><vertex x="0" y="9" z="0"/><vertex x="0" y="0" z="9"/></vertices><triangles>)"
         R"(<triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3" pid="2" p1="0" p2="1" p3="1"/>)"
         R"(<triangle v1="0" v2="3" v3="2"/><triangle v1="1" v2="2" v3="3"/></triangles></mesh></object>)"
         R"(<object id="4" type="model"><components><component objectid="3"/>)"
         R"(<component objectid="3" transform="-1 0 0 0 2 0 0 0 1 5 6 7"/></components></object></resources>)"
         R"(<build><item objectid="4" transform="0 1 0 -1 0 0 0 0 1 0 0 0"/><item objectid="3"/></build></model>)";
}

} // namespace

Target modelTarget() {
  return {"models", readAnyModel, [] { return std::vector<std::string>{modelWithEverything()}; }};
}

Target surfaceFileTarget() {
  return {"surfaces", readAnySurface, surfaceSeeds};
}

Target handleFileTarget() {
  return {"handles", readAnyHandles, [] { return goodFilesEnding(kHandleEndings, tests::FileUse::handles); }};
}

} // namespace viscera::fuzz
