#pragma once

#include <optional>
#include <string>

#include "file_bytes.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {

/// A kind of image that Viscera names, but does not read.
struct UnreadImage {
  std::string name; ///< The format's, the same in every language: "MINC".
  Text wayOut;
};

/// The kind of an image of a format that Viscera does not read, which the first bytes tell, or else the
/// ending: MINC, HDF5, NumPy, MATLAB, TIFF, AmiraMesh, Interfile, AFNI, MRtrix, ECAT and others, also packed
/// by gzip. None for any other file. `file` holds at least the beginning.
std::optional<UnreadImage> unreadImage(const FileBytes& file);

} // namespace viscera::medical_io
