#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "file_bytes.h"

namespace viscera::medical_io {

/// A method of compression.
enum class Packing { none, zlib, bzip2 }; ///< zlib: or gzip.

/// Unpacks all gzip members or bzip2 streams, one behind the other, or zlib data, block by block.
class Unpacker {
public:
  /// `file` is named in the `DataError` for data that are damaged or end too early; it and the bytes of
  /// `packed` outlive the unpacker. `packing` is not `none`.
  Unpacker(const FileBytes& file, std::string_view packed, Packing packing);
  ~Unpacker();
  Unpacker(const Unpacker&) = delete;
  Unpacker& operator=(const Unpacker&) = delete;

  /// Fills `out` with the next `count` bytes, fewer at the end only; gives how many.
  std::size_t read(char* out, std::size_t count);

private:
  class Library;
  template <class Kind>
  class LibraryOf;
  std::unique_ptr<Library> library_;
};

/// Unpacks at most `most` bytes; what lies behind is left. Allocates memory only for what is unpacked. Throws
/// as `Unpacker`.
std::string unpacked(const FileBytes& file, std::string_view packed, Packing packing, std::uint64_t most);

} // namespace viscera::medical_io
