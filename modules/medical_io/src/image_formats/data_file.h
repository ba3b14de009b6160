#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "image_formats/raw_image.h"
#include "image_formats/unpack.h"

/// Reads the voxels of NRRD, MetaImage and NIfTI, which lie behind the header or in another file.
namespace viscera::medical_io {

/// How the voxels are stored, as stated in the header.
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

/// The header of an image file. There is one reader for each format, for label maps and scans.
struct ImageHeader {
  RawImage image; ///< Without values.
  StoredValues stored;
};

/// The readers. `file` has the file's beginning at least, with the whole header; for the half of a NIfTI
/// image that has the voxels it is replaced by that of the header.
ImageHeader niftiHeader(FileBytes& file);
/// The same for a file with several phases: they are the layers.
ImageHeader niftiSeriesHeader(FileBytes& file);
ImageHeader nrrdHeader(FileBytes& file);
ImageHeader metaImageHeader(FileBytes& file);

/// Fills `raw.storage` and `raw.offset` with all values that `raw`'s grid promises, whose size and scalar are
/// set. Takes the bytes of `file`. Throws `DataError` naming `file` when there are fewer, `NoInputError` for
/// a file beside it that is missing.
void takeValues(FileBytes& file, const StoredValues& stored, RawImage& raw);

/// A header with its values.
template <auto readHeader>
RawImage readImage(FileBytes& file) {
  ImageHeader header = readHeader(file);
  takeValues(file, header.stored, header.image);
  return std::move(header.image);
}

/// Which of a file's values to visit.
struct ValueRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};

/// Passes the values to `visit`, block by block in their order, each block with its number of values and
/// aligned for them, so that only one block is in memory beside what `visit` keeps. What `file` holds of its
/// bytes is not read again. `visit` throws no `DataError`. `raw.scalar` and `raw.order` may be set anew
/// before the first call. `prepare` is called before with the number of values, if the file is long enough
/// for them. Throws as `takeValues`, `Cancelled`.
void visitValues(const FileBytes& file, const StoredValues& stored, RawImage& raw, const ValueRange& range,
                 Progress& progress, const std::function<void(std::uint64_t most)>& prepare,
                 const std::function<void(const char* bytes, std::size_t count)>& visit);

} // namespace viscera::medical_io
