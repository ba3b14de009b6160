#include "dicom/dicom_mark.h"

#include <array>
#include <fstream>
#include <optional>

#include "dicom/dicom_folder.h"
#include "dicom/dicom_start.h"

namespace viscera::medical_io {
namespace {

/// The beginning of a DICOM file; nothing for any other.
std::optional<DicomStart> startOf(const std::filesystem::path& file) {
  std::array<char, kDicomStartBytes> bytes = {};
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    return std::nullopt;
  const std::uint64_t length = std::filesystem::file_size(file, error);
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), bytes.size());
  return dicomStart({bytes.data(), static_cast<std::size_t>(stream.gcount())}, error ? 0 : length);
}

} // namespace

DicomKind dicomKind(const std::filesystem::path& file) {
  const auto start = startOf(file);
  return start ? kindOfDicomClass(start->classUid) : DicomKind::none;
}

std::string dicomClass(const std::filesystem::path& file) {
  const auto start = startOf(file);
  return start ? start->classUid : std::string();
}

bool hasDicomImages(const std::filesystem::path& folder) {
  bool found = false;
  visitFiles(folder, [&](const std::filesystem::path& file) {
    found = dicomKind(file) == DicomKind::image;
    return !found;
  });
  return found;
}

bool isDicomPlace(const std::filesystem::path& fileOrFolder) {
  std::error_code error;
  return std::filesystem::is_directory(fileOrFolder, error) || dicomKind(fileOrFolder) != DicomKind::none;
}

} // namespace viscera::medical_io
