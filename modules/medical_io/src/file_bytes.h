#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "viscera/core/phrase.h"

namespace viscera::medical_io {

/// What to try for a damaged file.
inline constexpr const char* kUsualAdvice = "export or copy the file again";

/// A file in memory, or its beginning. Readers compare every size that a header states with the actual size
/// before they allocate memory for it.
struct FileBytes {
  std::filesystem::path file;
  std::string bytes;
  std::uint64_t length = 0; ///< Of the whole file, as it was read.
  bool unpacked = false;    ///< `bytes` are all that the file holds, unpacked from it.

  std::string_view view() const { return bytes; }
  std::string name() const { return file.string(); }
  /// Throws `DataError` for this file.
  [[noreturn]] void fail(const Text& problem, const Text& tryThis = kUsualAdvice) const;
};

/// Reads a regular file. Throws `NoInputError` when it is missing, a folder or not readable, `DataError` when
/// it is empty or does not fit into memory.
FileBytes readWholeFile(const std::filesystem::path& file);

/// Reads at most the first `most` bytes of a regular file. Throws as `readWholeFile`.
FileBytes readBeginOfFile(const std::filesystem::path& file, std::size_t most);

/// The whole file whose beginning is in memory: reads only what is missing. Throws as `readWholeFile`.
FileBytes readRestOfFile(const FileBytes& begin);

/// Enough for the header of any file: headers in words may name hundreds of segments.
inline constexpr std::size_t kMostHeaderBytes = std::size_t{1} << 22U;

/// Lower-case ASCII copy.
std::string lowered(std::string_view text);

/// The extension in lower case with its dot; ".mrk.json", ".nii.gz", ".img.gz", ".nrrd.gz", ".seg.nrrd" and
/// ".sequence.json" count as one, and so do other packed forms of images.
std::string extensionOf(const std::filesystem::path& file);

/// The same without the ".gz" of a compressed file: ".stl" for organ.stl.gz.
std::string extensionWithin(const std::filesystem::path& file);

/// The file's name without that extension and without ".gz".
std::string stemOf(const std::filesystem::path& file);

/// The bytes that base64 `text` stands for; white space is skipped. Nothing when a character does not belong
/// there or the text ends within a group.
std::optional<std::string> decodeBase64(std::string_view text);

/// `count * size` without overflow: the largest number when it would.
inline std::uint64_t saturatedProduct(std::uint64_t count, std::uint64_t size) {
  return size != 0 && count > UINT64_MAX / size ? UINT64_MAX : count * size;
}

/// `a + b`, or the largest number when that is too large.
inline std::uint64_t saturatedSum(std::uint64_t a, std::uint64_t b) {
  return a > UINT64_MAX - b ? UINT64_MAX : a + b;
}

/// One value of type T at `data`, which may be unaligned, in the byte order given.
template <typename T>
T loadValue(const char* data, std::endian order) {
  unsigned char raw[sizeof(T)];
  std::memcpy(raw, data, sizeof(T));
  if (order != std::endian::native)
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i)
      std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  T value;
  std::memcpy(&value, raw, sizeof(T));
  return value;
}

/// Appends a value in little-endian order.
template <typename T>
void appendValue(std::string& out, T value) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if constexpr (std::endian::native == std::endian::big)
    for (std::size_t i = 0; i < sizeof(T) / 2; ++i)
      std::swap(raw[i], raw[sizeof(T) - 1 - i]);
  out.append(raw, sizeof(T));
}

} // namespace viscera::medical_io
