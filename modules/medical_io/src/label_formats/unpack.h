#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "file_bytes.h"

namespace viscera::medical_io {

/// How bytes are made fewer.
enum class Packing { none, zlib, bzip2 }; ///< zlib: or gzip.

/// Unpacks all gzip members or bzip2 streams, one behind the other, or zlib data, at most `most` bytes of it;
/// what lies behind is left. Memory is taken for what comes out. `file` is named in the `DataError` for data
/// that are damaged or end too early. `packing` is not `none`.
std::string unpacked(const FileBytes& file, std::string_view packed, Packing packing, std::uint64_t most);

} // namespace viscera::medical_io
