#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "label_formats/raw_labels.h"
#include "label_formats/unpack.h"

/// What NRRD, MetaImage and NIfTI in two files share: voxels behind the header or in a file beside it.
namespace viscera::medical_io {

/// How a header says that its voxels are stored.
struct StoredValues {
  std::size_t headerEnd = 0;         ///< Where voxels in the same file begin.
  std::optional<std::string> beside; ///< The name of the file that they are in.
  bool pattern = true;               ///< A per cent sign in that name stands for numbers of several files.
  Packing packing = Packing::none;
  bool text = false;              ///< Numbers in words.
  bool atEnd = false;             ///< The last bytes of the file, whatever is before them.
  std::uint64_t skippedBytes = 0; ///< Of what is unpacked.
  std::uint64_t skippedLines = 0; ///< Before anything is unpacked.
};

/// Fills `raw.storage` and `raw.offset` with all values that `raw`'s grid promises, whose size and scalar are
/// set. Takes the bytes of `file`. Throws `DataError` naming `file` when there are fewer, `NoInputError` for
/// a file beside it that is missing.
void takeValues(FileBytes& file, const StoredValues& stored, RawLabels& raw);

} // namespace viscera::medical_io
