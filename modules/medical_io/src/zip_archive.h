#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "file_bytes.h"

namespace viscera::medical_io {

/// A ZIP archive (PKWARE's APPNOTE 6.3, with the sizes of ZIP64): the list of its parts, which are unpacked
/// one at a time. Stored and deflated parts are read, encrypted ones are not.
class ZipArchive {
public:
  struct Part {
    std::string name; ///< As stored: "3D/3dmodel.model".
    std::uint16_t flags = 0;
    std::uint16_t method = 0;
    std::uint32_t checksum = 0; ///< CRC-32 of the unpacked bytes.
    std::uint64_t packedBytes = 0;
    std::uint64_t bytes = 0;
    std::uint64_t header = 0; ///< Where the part's own header begins.
  };

  /// Reads the list. Throws `DataError` when the file has none, as when it is cut off, or when it is damaged.
  /// `file` outlives the archive.
  explicit ZipArchive(const FileBytes& file);

  const std::vector<Part>& parts() const { return parts_; }
  /// The part whose `plainPartName` is that of `name`; null when there is none.
  const Part* find(std::string_view name) const;
  const FileBytes& file() const { return file_; }

  /// The bytes of a part as they are packed. Throws `DataError` when they are not all in the file, or packed
  /// by another method than deflation.
  std::string_view packed(const Part& part) const;

private:
  void readList(std::uint64_t begin, std::uint64_t count);

  const FileBytes& file_;
  std::vector<Part> parts_;
};

/// The name of a part without what programs write differently: capitals, backslashes, a slash before it.
std::string plainPartName(std::string_view name);

/// Unpacks a part block by block. What comes out is compared with the size and the checksum that the archive
/// states, so that a damaged part is never taken for a whole one, and a part never unpacks to more.
class ZipPartReader {
public:
  /// Throws as `ZipArchive::packed`, and for a part that unpacks to more than `mostBytes`, or to so much more
  /// than it is packed in that it was made to fill a memory.
  ZipPartReader(const ZipArchive& archive, const ZipArchive::Part& part, std::uint64_t mostBytes);
  ~ZipPartReader();
  ZipPartReader(const ZipPartReader&) = delete;
  ZipPartReader& operator=(const ZipPartReader&) = delete;

  /// Fills `out` with the next `count` bytes, fewer at the end only; gives how many. Throws `DataError`.
  std::size_t read(char* out, std::size_t count);

private:
  class Inflation;

  const FileBytes& file_;
  const ZipArchive::Part& part_;
  std::string_view packed_;
  std::unique_ptr<Inflation> inflation_; ///< Null for a stored part.
  std::uint64_t done_ = 0;
  std::uint32_t checksum_ = 0;
};

/// A ZIP archive of deflated parts with their names, in their order, dated 1980, so that equal contents are
/// equal files. Throws `CannotCreateError` for parts above 4 GB.
std::string zipped(const std::vector<std::pair<std::string, std::string>>& parts);

} // namespace viscera::medical_io
