#include "dicom/dicom_mark.h"

#include <array>
#include <fstream>
#include <string>
#include <string_view>

#include "dicom/dicom_folder.h"

namespace viscera::medical_io {
namespace {

/// The group before the data set, which names the class, is a few hundred bytes long.
constexpr std::size_t kMarkWithin = 1024;
constexpr std::string_view kSegmentation = "1.2.840.10008.5.1.4.1.1.66.4";
/// Classes of storage; what else there is (a table of contents, a work list) has another beginning.
constexpr std::string_view kStorage = "1.2.840.10008.5.1.4.1.1.";
/// Classes of storage without pixels: reports, presentation states, contours, waveforms, plans.
constexpr std::array<std::string_view, 8> kWithoutPixels = {"88.", "11.",  "481.3", "481.5",
                                                            "9.",  "104.", "66",    "67"};
constexpr std::string_view kClassTag("\x02\x00\x02\x00UI", 6); // Media Storage SOP Class UID.

/// The class that the file says it is of; empty when it does not.
std::string_view classIn(std::string_view begin) {
  const std::size_t tag = begin.find(kClassTag);
  if (tag == begin.npos || tag + 8 > begin.size())
    return {};
  const std::size_t length = static_cast<unsigned char>(begin[tag + 6]) +
                             std::size_t{256} * static_cast<unsigned char>(begin[tag + 7]);
  std::string_view uid = begin.substr(tag + 8, length);
  while (!uid.empty() && (uid.back() == '\0' || uid.back() == ' '))
    uid.remove_suffix(1);
  return uid;
}

} // namespace

DicomKind dicomKind(const std::filesystem::path& file) {
  std::array<char, kMarkWithin> bytes = {};
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    return DicomKind::none;
  std::ifstream stream(file, std::ios::binary);
  stream.read(bytes.data(), bytes.size());
  const std::string_view begin(bytes.data(), static_cast<std::size_t>(stream.gcount()));
  if (begin.size() < 132 || begin.substr(128, 4) != "DICM")
    return DicomKind::none;
  const std::string_view uid = classIn(begin);
  if (uid == kSegmentation)
    return DicomKind::segmentation;
  if (uid.empty())
    return DicomKind::image; // Reading says.
  if (!uid.starts_with(kStorage))
    return DicomKind::other;
  for (const std::string_view without : kWithoutPixels)
    if (uid.substr(kStorage.size()).starts_with(without))
      return DicomKind::other;
  return DicomKind::image;
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
