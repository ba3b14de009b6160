#pragma once

#include <filesystem>
#include <optional>

#include "viscera/medical_io/image_file.h"

namespace viscera::medical_io {

/// Finds the scan from which a label map was made, or the label map of a scan. That is a file or folder (a
/// DICOM series, a folder of masks) in the same folder as `image` with as many voxels of the same size, whose
/// contents are as `wanted`; of several the one whose name begins most alike. Looks at the headers of the
/// `kMostBeside` images whose names begin most alike, and reads those whose voxels agree. None when there is
/// none, and for an image that cannot be read. Throws `Cancelled`.
std::optional<std::filesystem::path> imageBeside(const std::filesystem::path& image, ImageContents wanted,
                                                 Progress& progress);

/// See `imageBeside`.
inline constexpr std::size_t kMostBeside = 40;

} // namespace viscera::medical_io
