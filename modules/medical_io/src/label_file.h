#pragma once

#include <filesystem>

#include "viscera/core/progress.h"
#include "viscera/medical_io/label_map.h"

namespace viscera::medical_io {

/// As `readLabelMap`, for one file, but with only the names and colours that the file itself has, and without
/// segments when no voxel has a label.
LabelMap readLabelFile(const std::filesystem::path& file, Progress& progress);

} // namespace viscera::medical_io
