#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <zlib.h>

#include "packed_bytes.h"

/// Makes ZIP archives as other programs write them.
namespace viscera::tests {

/// A part of an archive.
struct ZipPart {
  std::string name;
  std::string bytes;
  bool deflated = true;
  std::uint16_t flags = 0;
  std::uint16_t method = 0;      ///< Stated in place of the true one when it is not 0.
  std::uint64_t statedBytes = 0; ///< In place of the true size when it is not 0.
};

/// An archive of these parts, with their true checksums and a remark at its end.
inline std::string zipFile(const std::vector<ZipPart>& parts, const std::string& remark = {}) {
  const auto number = [](std::uint64_t value, int bytes) {
    std::string out;
    for (int i = 0; i < bytes; ++i, value >>= 8)
      out += static_cast<char>(value);
    return out;
  };
  std::string file, list;
  for (const ZipPart& part : parts) {
    const std::string packed = part.deflated ? packedBytes(part.bytes, -MAX_WBITS) : part.bytes;
    const auto checksum =
        crc32(0, reinterpret_cast<const Bytef*>(part.bytes.data()), static_cast<uInt>(part.bytes.size()));
    const int method = part.method != 0 ? part.method : part.deflated ? 8 : 0;
    const std::string fields = number(20, 2) + number(part.flags, 2) +
                               number(static_cast<std::uint64_t>(method), 2) + number(0, 4) +
                               number(checksum, 4) + number(packed.size(), 4) +
                               number(part.statedBytes != 0 ? part.statedBytes : part.bytes.size(), 4) +
                               number(part.name.size(), 2) + number(0, 2);
    list += "PK\x01\x02" + number(20, 2) + fields + number(0, 10) + number(file.size(), 4) + part.name;
    file += "PK\x03\x04" + fields + part.name + packed;
  }
  return file + list + "PK\x05\x06" + number(0, 4) + number(parts.size(), 2) + number(parts.size(), 2) +
         number(list.size(), 4) + number(file.size(), 4) + number(remark.size(), 2) + remark;
}

} // namespace viscera::tests
