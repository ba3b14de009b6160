#pragma once

namespace viscera::medical_io {

/// The axes in which a file's coordinates are written.
enum class Space { lps, ras };

} // namespace viscera::medical_io
