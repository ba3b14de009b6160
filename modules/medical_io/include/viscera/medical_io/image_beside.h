#pragma once

#include <filesystem>
#include <optional>

#include "viscera/medical_io/image_file.h"

namespace viscera::medical_io {

/// Finds the scan from which a label map was made, or the label map of a scan.
///
/// The scan of a DICOM segmentation is the series of DICOM images in its frame of reference whose voxels are
/// its own (it may cover some slices only) and, where it says so, to which it refers; nothing else is offered
/// for it. It is searched for in the folder of `image`, in those below it, and in those beside it.
///
/// For other formats it is a file or folder (a DICOM series, a folder of masks) in the same folder as `image`
/// on the same grid: as many voxels of the same size at the same places. Its contents are as `wanted`; of
/// several the one whose name begins most alike. Looks at the headers of the `kMostBeside` images whose names
/// begin most alike, and reads those whose voxels agree.
///
/// None when there is none, and for an image that cannot be read. Throws `Cancelled`.
std::optional<std::filesystem::path> imageBeside(const std::filesystem::path& image, ImageContents wanted,
                                                 Progress& progress);

/// See `imageBeside`.
inline constexpr std::size_t kMostBeside = 40;

} // namespace viscera::medical_io
