#pragma once

#include <filesystem>

namespace viscera::medical_io {

/// Rejects a deflated DICOM file that would unpack to far more than the size of a scan, because DCMTK
/// allocates memory for everything that is unpacked. Call it before DCMTK loads a file; if the file is not
/// deflated, only its header is read. Takes 100 kB and the time to unpack once. Throws `DataError`. For any
/// thread.
void requireBoundedInflation(const std::filesystem::path& file);

} // namespace viscera::medical_io
