#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "file_bytes.h"

namespace viscera::medical_io {

/// Unpacks bzip2 data (all streams, one behind the other), at most `most` bytes of it; what lies behind is
/// left. Memory is taken for what comes out. `file` is named in the `DataError` for data that are damaged or
/// end too early.
std::string unpackedBzip2(const FileBytes& file, std::string_view packed, std::uint64_t most);

} // namespace viscera::medical_io
