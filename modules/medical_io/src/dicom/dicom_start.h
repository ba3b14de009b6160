#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace viscera::medical_io {

/// What the first bytes of a DICOM file say.
struct DicomStart {
  std::string classUid; ///< SOP class; empty: it is not stated there.
  bool marked = false;  ///< The file has a preamble and the mark "DICM".
};

/// `dicomStart` looks at so many bytes from the beginning of a file.
inline constexpr std::size_t kDicomStartBytes = 4096;

/// Recognises a DICOM file by its first bytes: by the mark behind the preamble; or, for a file without it, by
/// data elements that ascend from group 0002 or 0008, fit into the file of `length` bytes, and state a UID of
/// a class or an instance. Without parsing; cheap. Nothing for any other file.
std::optional<DicomStart> dicomStart(std::string_view begin, std::uint64_t length);

} // namespace viscera::medical_io
