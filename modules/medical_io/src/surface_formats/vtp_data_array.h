#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "file_bytes.h"
#include "xml_tree.h"

namespace viscera::medical_io {

/// How the arrays of one VTK XML file are stored.
struct VtpStorage {
  const FileBytes* file = nullptr;
  std::endian order = std::endian::little;
  std::size_t headerBytes = 4; ///< Of the numbers that say how many bytes follow.
  std::string compressor;      ///< VTK's class name; empty: not compressed.
  std::string_view appended;   ///< The data after the underscore of AppendedData.
  bool appendedIsBase64 = true;
};

/// The numbers of a `DataArray` element: text, base64 or appended, compressed or not. Every size is checked
/// before memory is taken. Throws `DataError`.
std::vector<double> readVtpNumbers(const VtpStorage& storage, const XmlElement& array);
/// The same for whole numbers.
std::vector<std::int64_t> readVtpIntegers(const VtpStorage& storage, const XmlElement& array);
/// The first text of an `Array` of type String.
std::string readVtpText(const VtpStorage& storage, const XmlElement& array);

} // namespace viscera::medical_io
