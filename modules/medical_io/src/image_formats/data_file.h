#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "image_formats/raw_image.h"
#include "image_formats/unpack.h"

/// Reads the voxels of NRRD, MetaImage and NIfTI, which lie behind the header or in another file.
namespace viscera::medical_io {

/// How the voxels are stored, as stated in the header.
struct StoredValues {
  std::size_t headerEnd = 0;         ///< Where voxels in the same file begin.
  std::optional<std::string> beside; ///< The name of the file that they are in.
  std::vector<std::string> parts;    ///< The names of several files, each with an equal part of them.
  Packing packing = Packing::none;
  bool text = false;              ///< Numbers in words.
  bool atEnd = false;             ///< The last bytes of the file, whatever is before them.
  std::uint64_t skippedBytes = 0; ///< Of what is unpacked.
  std::uint64_t skippedLines = 0; ///< Before anything is unpacked.

  std::optional<Scalar> maybeWider; ///< The type of the values where there are bytes enough for it.

  bool elsewhere() const { return beside.has_value() || !parts.empty(); }
};

/// The header of an image file. There is one reader for each format, for label maps and scans.
struct ImageHeader {
  RawImage image; ///< Without values.
  StoredValues stored;
};

/// The readers. `file` has the file's beginning at least, with the whole header; for the half of a NIfTI or
/// Analyze image that has the voxels it is replaced by that of the header. The file may be packed by gzip as
/// a whole.
ImageHeader niftiHeader(FileBytes& file); ///< NIfTI and Analyze 7.5.
ImageHeader nrrdHeader(FileBytes& file);
ImageHeader metaImageHeader(FileBytes& file);
ImageHeader mghHeader(FileBytes& file);
ImageHeader giplHeader(FileBytes& file);

/// What `read` makes of the header of a file that may be packed by gzip as a whole. Where the voxels cannot
/// be unpacked block by block behind it, `file` is replaced by all that it holds.
ImageHeader headerBehindGzip(FileBytes& file, ImageHeader (*read)(const FileBytes&));

/// Whether the file has room for all values of `raw` as wide as `scalar`. Reads a packed file to its end.
bool holdsValuesOf(const FileBytes& file, const StoredValues& stored, const RawImage& raw, Scalar scalar);

/// The values of a file to visit.
struct ValueRange {
  std::uint64_t first = 0;
  std::uint64_t count = 0;
};

/// Passes the values to `visit`, block by block in their order, each block with its number of values and
/// aligned for them, so that only one block is in memory beside what `visit` keeps. What `file` holds of its
/// bytes is not read again. `visit` throws no `DataError`. `raw.scalar` and `raw.order` may be set anew
/// before the first call. `prepare` is called before with the number of values, if the files are long enough
/// for them. Throws `DataError` naming `file` when there are fewer values than `raw`'s grid promises,
/// `NoInputError` for a file beside it that is missing, `Cancelled`.
void visitValues(const FileBytes& file, const StoredValues& stored, RawImage& raw, const ValueRange& range,
                 Progress& progress, const std::function<void(std::uint64_t most)>& prepare,
                 const std::function<void(const char* bytes, std::size_t count)>& visit);

} // namespace viscera::medical_io
