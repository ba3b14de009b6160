#pragma once

#include <filesystem>

#include "viscera/core/progress.h"
#include "viscera/medical_io/label_map.h"

namespace viscera::medical_io {

/// As `readLabelMap`, for one file, but with only the names and colours that the file itself has, and without
/// segments when no voxel has a label.
LabelMap readLabelFile(const std::filesystem::path& file, Progress& progress);

struct RawLabels;
struct FileBytes;
/// Makes a label map of what a reader found: checks grid and values, numbers labels, counts their voxels.
LabelMap labelMapOf(RawLabels&& raw, const FileBytes& file, Progress& progress);

/// Takes names and colours from a table beside `file` where the file itself has none.
void nameByTable(LabelMap& map, const std::filesystem::path& file);

} // namespace viscera::medical_io
