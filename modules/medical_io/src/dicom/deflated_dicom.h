#pragma once

#include <filesystem>

namespace viscera::medical_io {

/// Refuses a deflated DICOM file that would unpack to far more than a scan is: DCMTK takes memory for all
/// that comes out. To be called before DCMTK loads a file; reads nothing but the header of one that is not
/// deflated. Takes 100 kB and the time to unpack once. Throws `DataError`. For any thread.
void requireBoundedInflation(const std::filesystem::path& file);

} // namespace viscera::medical_io
