#include "file_signature.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "viscera/core/phrase.h"

#include "text_scanner.h"

namespace viscera::medical_io {
namespace {

struct Kind {
  Signature signature;
  FileKind kind;
  std::string_view description;
  std::string_view extension;
};
constexpr std::array<Kind, 20> kKinds = {{
    {Signature::unknown, FileKind::unknown, "a file of an unknown kind", ""},
    {Signature::stl, FileKind::surface, "an STL surface", ".stl"},
    {Signature::obj, FileKind::surface, "an OBJ surface", ".obj"},
    {Signature::ply, FileKind::surface, "a PLY surface", ".ply"},
    {Signature::off, FileKind::surface, "an OFF surface", ".off"},
    {Signature::legacyVtk, FileKind::surface, "a legacy VTK file", ".vtk"},
    {Signature::vtp, FileKind::surface, "a VTK XML surface", ".vtp"},
    {Signature::otherVtkXml, FileKind::unknown, "a VTK XML file that holds no surface", ""},
    {Signature::glb, FileKind::surface, "a binary glTF scene", ".glb"},
    {Signature::gltf, FileKind::surface, "a glTF scene", ".gltf"},
    {Signature::markups, FileKind::handles, "a 3D Slicer markups file", ".mrk.json"},
    {Signature::fcsv, FileKind::handles, "a 3D Slicer fiducial table", ".fcsv"},
    {Signature::otherJson, FileKind::unknown, "a JSON file", ".json"},
    {Signature::nifti, FileKind::labelMap, "a NIfTI image", ".nii"},
    {Signature::nrrd, FileKind::labelMap, "an NRRD image", ".nrrd"},
    {Signature::metaImage, FileKind::labelMap, "a MetaImage", ".mha"},
    {Signature::dicom, FileKind::labelMap, "a DICOM file", ".dcm"},
    {Signature::gzip, FileKind::unknown, "a gzip-compressed file", ".gz"},
    {Signature::zip, FileKind::unknown, "a ZIP archive", ".zip"},
    {Signature::picture, FileKind::unknown, "a picture", ""},
}};

constexpr std::size_t kSignatureBytes = 4096;

const Kind& kindOf(Signature signature) {
  return *std::find_if(kKinds.begin(), kKinds.end(), [&](const Kind& k) { return k.signature == signature; });
}

bool isBinaryStl(const FileBytes& file) {
  const std::uint64_t length = std::max<std::uint64_t>(file.length, file.bytes.size());
  if (file.bytes.size() < 84)
    return false;
  const std::uint64_t count = loadValue<std::uint32_t>(file.bytes.data() + 80, std::endian::little);
  return count > 0 && 84 + 50 * count == length;
}

Signature binarySignature(const FileBytes& file, std::string_view begin) {
  using namespace std::string_view_literals;
  if (begin.starts_with("glTF"))
    return Signature::glb;
  if (begin.starts_with("\x1f\x8b"))
    return Signature::gzip;
  if (begin.starts_with("PK\x03\x04"))
    return Signature::zip;
  if (begin.starts_with("NRRD00"))
    return Signature::nrrd;
  if (begin.starts_with("\x89PNG") || begin.starts_with("\xff\xd8\xff") || begin.starts_with("GIF8"))
    return Signature::picture;
  if (begin.size() >= 132 && begin.substr(128, 4) == "DICM")
    return Signature::dicom;
  if (begin.size() >= 348 && (begin.substr(344, 4) == "n+1\0"sv || begin.substr(344, 4) == "ni1\0"sv))
    return Signature::nifti;
  if (begin.size() >= 540 && (begin.substr(4, 3) == "n+2" || begin.substr(4, 3) == "ni2"))
    return Signature::nifti;
  return isBinaryStl(file) ? Signature::stl : Signature::unknown;
}

/// By the names that stand near the beginning: good enough to choose a reader, which then checks.
Signature jsonSignature(std::string_view whole) {
  const auto has = [&](std::string_view key) { return whole.find(key) != whole.npos; };
  if (has("\"markups\"") && has("\"controlPoints\""))
    return Signature::markups;
  if (has("\"asset\"") && (has("\"meshes\"") || has("\"nodes\"")))
    return Signature::gltf;
  return Signature::otherJson;
}

Signature xmlSignature(std::string_view begin) {
  const std::size_t root = begin.find("<VTKFile");
  if (root == begin.npos)
    return Signature::unknown;
  const std::string_view tag = begin.substr(root, begin.find('>', root) - root);
  return tag.find("\"PolyData\"") != tag.npos ? Signature::vtp : Signature::otherVtkXml;
}

/// An OBJ file has no mark: its first statements decide.
bool looksLikeObj(std::string_view begin) {
  int statements = 0;
  while (!begin.empty() && statements < 3) {
    const std::size_t end = std::min(begin.find('\n'), begin.size());
    std::string_view line = trimmed(begin.substr(0, end));
    begin.remove_prefix(std::min(end + 1, begin.size()));
    const std::string_view word = takeWord(line);
    if (word.empty() || word.starts_with('#'))
      continue;
    if (word == "v" || word == "vn" || word == "vt" || word == "f") {
      if (!parseNumber(takeWord(line)) && word != "f")
        return false;
      ++statements;
    } else if (word != "o" && word != "g" && word != "s" && word != "mtllib" && word != "usemtl") {
      return false;
    }
  }
  return statements > 0;
}

bool isOffWord(std::string_view word) {
  return word == "OFF" || word == "COFF" || word == "NOFF" || word == "CNOFF" || word == "STOFF" ||
         word == "NCOFF" || word == "4OFF" || word == "nOFF" || word == "4nOFF";
}

Signature textSignature(const FileBytes& file, std::string_view begin) {
  const std::string_view text = trimmed(begin.starts_with("\xef\xbb\xbf") ? begin.substr(3) : begin);
  std::string_view rest = text;
  const std::string_view word = takeWord(rest);
  if (text.starts_with("# vtk DataFile"))
    return Signature::legacyVtk;
  if (text.starts_with("# Markups fiducial"))
    return Signature::fcsv;
  if (word == "ply")
    return Signature::ply;
  if (isOffWord(word))
    return Signature::off;
  if (text.starts_with("ObjectType =") || text.starts_with("NDims ="))
    return Signature::metaImage;
  if (lowered(word) == "solid" && (rest.find("facet") != rest.npos || rest.find("endsolid") != rest.npos))
    return Signature::stl;
  if (text.starts_with('<'))
    return xmlSignature(text);
  if (text.starts_with('{'))
    return jsonSignature(file.view());
  return looksLikeObj(text) ? Signature::obj : Signature::unknown;
}

} // namespace

Signature signatureOf(const FileBytes& file) {
  const std::string_view begin = file.view().substr(0, kSignatureBytes);
  const Signature binary = binarySignature(file, begin);
  return binary != Signature::unknown ? binary : textSignature(file, begin);
}

FileKind fileKind(Signature signature) {
  return kindOf(signature).kind;
}

Text looksLike(const Text& problem, Signature found) {
  return found == Signature::unknown
             ? problem
             : phrase("%1; it looks like %2", problem, named(kindOf(found).description));
}

void failAsAnotherKind(const FileBytes& file, Signature found, const Text& otherwise) {
  const Kind& kind = kindOf(found);
  file.fail(phrase("It is named %1 but looks like %2", extensionOf(file.file), named(kind.description)),
            kind.extension.empty() ? otherwise
                                   : phrase("rename it to end in %1", std::string(kind.extension)));
}

} // namespace viscera::medical_io
