#include "file_signature.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "dicom/dicom_mark.h"
#include "dicom/dicom_start.h"
#include "image_formats/analyze_header.h"
#include "image_formats/image_marks.h"
#include "image_formats/unpack.h"
#include "text_scanner.h"
#include "unread_images.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

/// A format, told by its bytes, by its ending or by both.
struct Format {
  Signature signature;      ///< Or `unknown`: it has no mark.
  FileKind kind;            ///< Or `unknown`: Viscera does not read it.
  std::string_view name;    ///< The same in every language.
  std::string_view endings; ///< With blanks between; the usual one is the first.
  bool written;
};
constexpr std::array kRead = std::to_array<Format>({
    {Signature::stl, FileKind::surface, "STL", ".stl", true},
    {Signature::obj, FileKind::surface, "OBJ", ".obj", true},
    {Signature::ply, FileKind::surface, "PLY", ".ply", true},
    {Signature::off, FileKind::surface, "OFF", ".off", true},
    {Signature::legacyVtk, FileKind::surface, "VTK", ".vtk", true},
    {Signature::vtp, FileKind::surface, "VTP", ".vtp", true},
    {Signature::vtm, FileKind::surface, "VTM", ".vtm .vtmb", false},
    {Signature::glb, FileKind::surface, "GLB", ".glb", true},
    {Signature::gltf, FileKind::surface, "glTF", ".gltf", false},
    {Signature::threeMf, FileKind::surface, "3MF", ".3mf", true},
    {Signature::gifti, FileKind::surface, "GIFTI", ".gii", false},
    {Signature::freeSurfer, FileKind::surface, "FreeSurfer", ".white .pial .asc", false},
    {Signature::carto, FileKind::surface, "CARTO", ".mesh", false},
    {Signature::vtu, FileKind::surface, "VTU", ".vtu", false},
    {Signature::gmsh, FileKind::surface, "gmsh", ".msh", false},
    {Signature::medit, FileKind::surface, "medit", ".mesh .meshb", false},
    {Signature::openCarp, FileKind::surface, "openCARP", ".elem .pts .surf", false},
    {Signature::nifti, FileKind::labelMap, "NIfTI", ".nii .nii.gz .hdr .hdr.gz .img .img.gz", true},
    {Signature::nrrd, FileKind::labelMap, "NRRD", ".nrrd .seg.nrrd .nhdr .seg.nhdr .nrrd.gz .seg.nrrd.gz",
     true},
    {Signature::metaImage, FileKind::labelMap, "MetaImage", ".mha .mhd .mha.gz", true},
    {Signature::mgh, FileKind::labelMap, "FreeSurfer", ".mgz .mgh .mgh.gz", false},
    {Signature::gipl, FileKind::labelMap, "GIPL", ".gipl .gipl.gz", false},
    {Signature::dicom, FileKind::labelMap, "DICOM", ".dcm .ima", false},
    {Signature::markups, FileKind::handles, "3D Slicer markups", ".mrk.json", true},
    {Signature::fcsv, FileKind::handles, "3D Slicer fiducials", ".fcsv", true},
    {Signature::sequence, FileKind::sequence, "Viscera sequence", ".sequence.json", true},
    {Signature::session, FileKind::session, "Viscera session", ".viscera", true},
});

/// A kind of file that Viscera names, but does not read.
struct Unread {
  Signature signature;
  std::string_view description;
  std::string_view endings;
  const char* wayOut;
};
constexpr const char* kExportASurface = "export it as STL, OBJ, PLY or GLB";
constexpr std::array kUnread = std::to_array<Unread>({
    {Signature::gzip, "a gzip-compressed file", ".gz", "unpack it first"},
    {Signature::zip, "a ZIP archive", ".zip", "unpack it first"},
    {Signature::unknown, "an archive", ".tar .tgz .7z .rar .xz .zst", "unpack it first"},
    {Signature::picture, "a picture", ".png .jpg .jpeg .gif .bmp",
     "open the images that it was made from: a DICOM series, NIfTI, NRRD or MetaImage"},
    {Signature::otherVtkXml, "a VTK XML file that holds no surface", ".vti .vtr .vts",
     "save its surface as .vtp, or its image as .mha, in ParaView or 3D Slicer"},
    {Signature::otherJson, "a JSON file", ".json", "open a file of organs, handles or a sequence"},
    {Signature::unknown, "a CAD model", ".stp .step .igs .iges .brep .sldprt .x_t", kExportASurface},
    {Signature::unknown, "a scene of a 3D program",
     ".fbx .dae .blend .3ds .max .ma .mb .c4d .wrl .vrml .x3d .usd .usdz .u3d", kExportASurface},
    {Signature::unknown, "a scene of 3D Slicer", ".mrb .mrml",
     "save its segmentation and its models in 3D Slicer, and open these"},
    {Signature::unknown, "a document", ".pdf .doc .docx .odt .txt .rtf .html .htm",
     "open the files of the organs"},
    {Signature::unknown, "a table", ".csv .tsv .xls .xlsx .ods", "open the files of the organs"},
});

constexpr std::size_t kSignatureBytes = 4096;

/// Whether a table's list of endings has this one.
bool listsEnding(std::string_view endings, std::string_view ending) {
  while (!ending.empty() && !endings.empty())
    if (takeWord(endings) == ending)
      return true;
  return false;
}

/// The row of a table for what bytes say, or else an ending.
template <class Rows>
auto rowOf(const Rows& rows, Signature found, std::string_view ending) -> decltype(rows.data()) {
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& one) {
    return found != Signature::unknown ? one.signature == found : listsEnding(one.endings, ending);
  });
  return row == rows.end() ? nullptr : &*row;
}

/// What a table says of a file; empty for a kind that none of them knows.
struct Known {
  Text description;
  std::string_view ending; ///< The usual one.
  Text wayOut;             ///< Of a kind that Viscera does not read.
};

Known knownAs(Signature found, std::string_view ending) {
  if (const Format* format = rowOf(kRead, found, ending)) {
    std::string_view endings = format->endings;
    return {std::string(format->name), takeWord(endings), {}};
  }
  if (const Unread* unread = rowOf(kUnread, found, ending))
    return {named(unread->description), {}, unread->wayOut};
  return {};
}

Text refusalOf(FileKind wanted) {
  switch (wanted) {
  case FileKind::surface:
    return "It is not a surface";
  case FileKind::handles:
    return "It is not a handle file";
  case FileKind::labelMap:
    return "It is not a label map";
  case FileKind::scan:
    return "It is not a scan in a known format";
  default:
    return "This kind of file is not supported";
  }
}

/// The endings of the formats of that kind; for `unknown` of all that a document is made of.
std::string usualEndings(FileKind wanted) {
  const FileKind kind = wanted == FileKind::scan ? FileKind::labelMap : wanted;
  std::vector<FileKind> kinds = {kind};
  if (kind == FileKind::unknown)
    kinds = {FileKind::surface, FileKind::labelMap, FileKind::handles};
  std::string list;
  for (const FileKind one : kinds)
    for (const std::string& ending : endingsOf(one))
      list += (list.empty() ? "" : ", ") + ending;
  return list;
}

bool isBinaryStl(const FileBytes& file) {
  const std::uint64_t length = std::max<std::uint64_t>(file.length, file.bytes.size());
  if (file.bytes.size() < 84)
    return false;
  const std::uint64_t count = loadValue<std::uint32_t>(file.bytes.data() + 80, std::endian::little);
  return count > 0 && 84 + 50 * count == length;
}

/// One in either order of bytes, the version, then the section of the dimension.
bool isMeditBinary(std::string_view begin) {
  constexpr std::int32_t kDimensionSection = 3;
  if (begin.size() < 12)
    return false;
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const auto word = [&](std::size_t at) { return loadValue<std::int32_t>(begin.data() + at, order); };
    if (word(0) == 1 && word(4) >= 1 && word(4) <= 4 && word(8) == kDimensionSection)
      return true;
  }
  return false;
}

Signature binarySignature(const FileBytes& file, std::string_view begin) {
  using namespace std::string_view_literals;
  if (begin.starts_with("glTF"))
    return Signature::glb;
  if (begin.starts_with("\x1f\x8b"))
    return Signature::gzip;
  if (isMeditBinary(begin))
    return Signature::medit;
  if (begin.starts_with("PK\x03\x04"))
    return file.view().find("3dmodel.model") != std::string_view::npos ? Signature::threeMf : Signature::zip;
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
  if (isBinaryStl(file))
    return Signature::stl;
  if (dicomStart(begin, std::max<std::uint64_t>(file.length, file.bytes.size())))
    return Signature::dicom; // Without its mark.
  if (orderOfAnalyze(begin)) // The same header without a mark.
    return Signature::nifti;
  if (hasGiplMark(begin))
    return Signature::gipl;
  if (hasMghMark(begin))
    return Signature::mgh;
  const bool freeSurfer = begin.starts_with("\xff\xff\xfe") || begin.starts_with("\xff\xff\xff") ||
                          begin.starts_with("\xff\xff\xfd");
  return freeSurfer ? Signature::freeSurfer : Signature::unknown;
}

/// Looks for names near the beginning: good enough to choose a reader, which then checks.
Signature jsonSignature(std::string_view whole) {
  const auto has = [&](std::string_view key) { return whole.find(key) != whole.npos; };
  if (has("\"viscera-session\""))
    return Signature::session;
  if (has("\"viscera-sequence\""))
    return Signature::sequence;
  if (has("\"markups\"") && has("\"controlPoints\""))
    return Signature::markups;
  if (has("\"asset\"") && (has("\"meshes\"") || has("\"nodes\"")))
    return Signature::gltf;
  return Signature::otherJson;
}

Signature xmlSignature(std::string_view begin) {
  const std::size_t root = begin.find("<VTKFile");
  if (root == begin.npos)
    return begin.find("<GIFTI") != begin.npos ? Signature::gifti : Signature::unknown;
  const std::string_view tag = begin.substr(root, begin.find('>', root) - root);
  if (tag.find("\"vtkMultiBlock") != tag.npos)
    return Signature::vtm;
  if (tag.find("\"UnstructuredGrid\"") != tag.npos)
    return Signature::vtu;
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

/// A number of elements, then an element of one of openCARP's types.
bool looksLikeOpenCarp(std::string_view text) {
  constexpr std::array<std::string_view, 6> kTypes = {"Tt", "Hx", "Py", "Pr", "Tr", "Qd"};
  const std::string_view count = takeWord(text);
  text.remove_prefix(std::min(text.find('\n'), text.size()));
  const std::string_view type = takeWord(text);
  return parseInteger(count) && std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end() &&
         parseInteger(takeWord(text));
}

/// A medit file may begin with comments.
bool looksLikeMedit(std::string_view text) {
  while (text.starts_with('#')) {
    text.remove_prefix(std::min(text.find('\n'), text.size()));
    text = trimmed(text);
  }
  return lowered(text.substr(0, 20)) == "meshversionformatted";
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
  if (text.starts_with("# Markups fiducial") || text.starts_with("# Fiducial List file"))
    return Signature::fcsv;
  if (text.starts_with("#TriangulatedMesh"))
    return Signature::carto;
  if (text.starts_with("#!ascii"))
    return Signature::freeSurfer;
  if (text.starts_with("$MeshFormat") || word == "$NOD")
    return Signature::gmsh;
  if (looksLikeMedit(text))
    return Signature::medit;
  if (looksLikeOpenCarp(text))
    return Signature::openCarp;
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

Signature signatureUnpacked(const FileBytes& file) {
  const Signature found = signatureOf(file);
  if (found != Signature::gzip)
    return found;
  try {
    const Signature inner =
        signatureOf({file.file, unpacked(file, file.view(), Packing::zlib, kSignatureBytes)});
    return inner == Signature::dicom ? Signature::gzip : inner; // DICOM is read as it is.
  } catch (const DataError&) {
    return Signature::gzip;
  }
}

Signature signatureOfEnding(const std::filesystem::path& file) {
  const Format* format = rowOf(kRead, Signature::unknown, extensionWithin(file));
  return format == nullptr ? Signature::unknown : format->signature;
}

FileKind fileKind(Signature signature) {
  const Format* format = signature == Signature::unknown ? nullptr : rowOf(kRead, signature, {});
  return format == nullptr ? FileKind::unknown : format->kind;
}

std::string_view usualEnding(Signature signature) {
  const Format* format = signature == Signature::unknown ? nullptr : rowOf(kRead, signature, {});
  std::string_view endings = format == nullptr ? std::string_view() : format->endings;
  return takeWord(endings);
}

const std::vector<FileFormat>& fileFormats() {
  static const std::vector<FileFormat> kFormats = [] {
    std::vector<FileFormat> list;
    for (const Format& format : kRead) {
      FileFormat& one =
          list.emplace_back(FileFormat{format.kind, std::string(format.name), {}, format.written});
      for (std::string_view rest = format.endings; !rest.empty();)
        one.endings.emplace_back(takeWord(rest));
    }
    return list;
  }();
  return kFormats;
}

const std::vector<std::string>& endingsOf(FileKind kind) {
  static const std::map<FileKind, std::vector<std::string>> kEndings = [] {
    std::map<FileKind, std::vector<std::string>> all;
    for (const FileFormat& format : fileFormats())
      for (const std::string& ending : format.endings) // Two formats may share one.
        if (auto& list = all[format.kind]; std::find(list.begin(), list.end(), ending) == list.end())
          list.push_back(ending);
    return all;
  }();
  static const std::vector<std::string> kNone;
  const auto found = kEndings.find(kind);
  return found == kEndings.end() ? kNone : found->second;
}

Signature signatureFor(const FileBytes& file, FileKind wanted) {
  const Signature found = wanted == FileKind::labelMap ? signatureUnpacked(file) : signatureOf(file);
  const Signature promised = signatureOfEnding(file.file);
  const bool packed = found == Signature::gzip || // The reader says what is wrong.
                      (found == Signature::zip && promised == Signature::threeMf);
  if (found == Signature::unknown && unreadImage(file))
    refuse(file, wanted);
  const Signature own = found == Signature::unknown || packed ? promised : found;
  const Format* format = own == Signature::unknown ? nullptr : rowOf(kRead, own, {});
  const bool fits = format != nullptr && listsEnding(format->endings, extensionWithin(file.file));
  if (promised != Signature::unknown && own != promised && !fits) {
    const Known known = knownAs(own, {});
    file.fail(phrase("It is named %1 but looks like %2", extensionWithin(file.file), known.description),
              known.wayOut.empty() ? phrase("rename it to end in %1", std::string(known.ending))
                                   : known.wayOut);
  }
  if (fileKind(own) != wanted)
    refuse(file, wanted);
  return own;
}

void refuse(const FileBytes& file, FileKind wanted) {
  const std::string dicom = dicomClass(file.file);
  if (kindOfDicomClass(dicom) == DicomKind::other)
    failAsDicomObject(file, dicom);
  const auto image = unreadImage(file);
  const Known known =
      image ? Known{image->name, {}, image->wayOut} : knownAs(signatureOf(file), extensionOf(file.file));
  const Text problem = refusalOf(known.wayOut.empty() ? wanted : FileKind::unknown);
  file.fail(known.description.empty() ? problem : phrase("%1; it looks like %2", problem, known.description),
            known.wayOut.empty() ? phrase("known endings: %1", usualEndings(wanted)) : known.wayOut);
}

} // namespace viscera::medical_io
