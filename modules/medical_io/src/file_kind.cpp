#include "viscera/medical_io/file_kind.h"

#include <array>
#include <utility>

#include "dicom/dicom_mark.h"
#include "file_bytes.h"
#include "file_signature.h"
#include "viscera/core/error.h"

namespace viscera::medical_io {
namespace {

/// Enough for a signature, but for the words of JSON.
constexpr std::size_t kFirstBytes = 4096;

FileBytes beginOf(const std::filesystem::path& file) {
  FileBytes begin = readBeginOfFile(file, kFirstBytes);
  const std::size_t first = begin.view().find_first_not_of(" \t\r\n\xef\xbb\xbf");
  const bool json = first != std::string_view::npos && begin.view()[first] == '{';
  return json ? readBeginOfFile(file, kMostHeaderBytes) : begin;
}

FileKind kindOfDicom(const std::filesystem::path& file) {
  switch (dicomKind(file)) {
  case DicomKind::image:
    return FileKind::scan;
  case DicomKind::segmentation:
    return FileKind::labelMap;
  case DicomKind::surface:
    return FileKind::surface;
  case DicomKind::none:
  case DicomKind::other:
    break;
  }
  return FileKind::unknown;
}

} // namespace

FileKind fileKind(const std::filesystem::path& file) {
  const FileKind byName = fileKind(signatureOfEnding(file));
  try {
    const Signature found = signatureUnpacked(beginOf(file));
    if (found == Signature::dicom)
      return kindOfDicom(file);
    const FileKind byContents = fileKind(found);
    return byContents == FileKind::unknown ? byName : byContents;
  } catch (const DataError&) {
    // Empty, or compressed and damaged: the name is all there is.
    return byName;
  }
}

void refuse(const std::filesystem::path& file, FileKind wanted) {
  refuse(beginOf(file), wanted);
}

std::string usualEnding(const std::filesystem::path& file) {
  const Signature found = signatureOf(beginOf(file));
  // NIfTI is the format that programs pack as a whole.
  return found == Signature::gzip ? ".nii.gz" : std::string(usualEnding(found));
}

std::string_view nameOf(FileKind kind) {
  // Names in the order of the enumeration.
  static constexpr std::array<std::string_view, 7> kNames = {"unknown", "surface",   "handles", "sequence",
                                                             "session", "label map", "scan"};
  return kNames[static_cast<std::size_t>(kind)];
}

} // namespace viscera::medical_io
