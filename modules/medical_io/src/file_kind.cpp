#include "viscera/medical_io/file_kind.h"

#include <algorithm>
#include <array>

#include "file_bytes.h"
#include "file_signature.h"
#include "viscera/core/error.h"

namespace viscera::medical_io {
namespace {

FileKind kindOfSignature(Signature signature) {
  switch (signature) {
  case Signature::stl:
  case Signature::obj:
  case Signature::ply:
  case Signature::off:
  case Signature::legacyVtk:
  case Signature::vtp:
  case Signature::glb:
  case Signature::gltf:
    return FileKind::surface;
  case Signature::markups:
  case Signature::fcsv:
    return FileKind::handles;
  case Signature::nifti:
  case Signature::nrrd:
  case Signature::metaImage:
  case Signature::dicom:
    return FileKind::labelMap;
  default:
    return FileKind::unknown;
  }
}

struct Ending {
  std::string_view extension;
  FileKind kind;
};
constexpr std::array<Ending, 26> kEndings = {{{".stl", FileKind::surface},
                                              {".obj", FileKind::surface},
                                              {".ply", FileKind::surface},
                                              {".off", FileKind::surface},
                                              {".vtk", FileKind::surface},
                                              {".vtp", FileKind::surface},
                                              {".glb", FileKind::surface},
                                              {".gltf", FileKind::surface},
                                              {".mrk.json", FileKind::handles},
                                              {".fcsv", FileKind::handles},
                                              {".sequence.json", FileKind::sequence},
                                              {".viscera", FileKind::session},
                                              {".nii", FileKind::labelMap},
                                              {".nii.gz", FileKind::labelMap},
                                              {".hdr", FileKind::labelMap},
                                              {".hdr.gz", FileKind::labelMap},
                                              {".img", FileKind::labelMap},
                                              {".img.gz", FileKind::labelMap},
                                              {".nrrd", FileKind::labelMap},
                                              {".seg.nrrd", FileKind::labelMap},
                                              {".nhdr", FileKind::labelMap},
                                              {".seg.nhdr", FileKind::labelMap},
                                              {".mha", FileKind::labelMap},
                                              {".mhd", FileKind::labelMap},
                                              {".dcm", FileKind::labelMap},
                                              {".ima", FileKind::labelMap}}};

FileKind kindOfEnding(const std::filesystem::path& file) {
  const std::string extension = extensionOf(file);
  const auto found = std::find_if(kEndings.begin(), kEndings.end(),
                                  [&](const Ending& e) { return e.extension == extension; });
  return found == kEndings.end() ? FileKind::unknown : found->kind;
}

} // namespace

FileKind fileKind(const std::filesystem::path& file) {
  const FileKind byName = kindOfEnding(file);
  try {
    const FileKind byContents = kindOfSignature(signatureOf(readWholeFile(file)));
    return byContents == FileKind::unknown ? byName : byContents;
  } catch (const DataError&) {
    // Empty, or too large for memory: the name is all there is.
    return byName;
  }
}

std::string_view nameOf(FileKind kind) {
  switch (kind) {
  case FileKind::surface:
    return "surface";
  case FileKind::handles:
    return "handles";
  case FileKind::sequence:
    return "sequence";
  case FileKind::session:
    return "session";
  case FileKind::labelMap:
    return "label map";
  case FileKind::unknown:
    break;
  }
  return "unknown";
}

} // namespace viscera::medical_io
