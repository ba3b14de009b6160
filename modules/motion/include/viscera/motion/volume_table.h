#pragma once

#include <filesystem>

#include "viscera/motion/volume_record.h"

namespace viscera::motion {

/// Writes a record as comma-separated values: `time_s`, then one column `<name>_ml` a surface, numbers with
/// six decimals, one row an instant. Names that hold commas or quotes are quoted. A reader sees the old file
/// or the whole new one. Throws `CannotCreateError`.
void writeVolumeTable(const std::filesystem::path& file, const VolumeRecord& volumes);

} // namespace viscera::motion
