#include "viscera/medical_io/file_kind.h"

#include <algorithm>
#include <array>

#include "dicom/dicom_mark.h"
#include "file_bytes.h"
#include "file_signature.h"
#include "scalar.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::medical_io {
namespace {

FileKind kindOfEnding(const std::filesystem::path& file) {
  static constexpr std::array<std::pair<std::string_view, FileKind>, 4> kEndings = {
      {{".mrk.json", FileKind::handles},
       {".fcsv", FileKind::handles},
       {".sequence.json", FileKind::sequence},
       {".viscera", FileKind::session}}};
  const std::string ending = extensionOf(file);
  const auto isOneOf = [&](const std::vector<std::string>& endings) {
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
  };
  if (isOneOf(surfaceExtensions()))
    return FileKind::surface;
  if (isOneOf(labelMapExtensions()))
    return FileKind::labelMap;
  return lookUp(kEndings, ending).value_or(FileKind::unknown);
}

} // namespace

FileKind fileKind(const std::filesystem::path& file) {
  const FileKind byName = kindOfEnding(file);
  try {
    const Signature found = signatureOf(readBeginOfFile(file, kMostHeaderBytes));
    if (found == Signature::dicom && dicomKind(file) == DicomKind::image)
      return FileKind::scan;
    const FileKind byContents = fileKind(found);
    return byContents == FileKind::unknown ? byName : byContents;
  } catch (const DataError&) {
    // Empty: the name is all there is.
    return byName;
  }
}

std::string_view nameOf(FileKind kind) {
  // In the order of the enumeration.
  static constexpr std::array<std::string_view, 7> kNames = {"unknown", "surface",   "handles", "sequence",
                                                             "session", "label map", "scan"};
  return kNames[static_cast<std::size_t>(kind)];
}

} // namespace viscera::medical_io
