#pragma once

#include <string>

#include <zlib.h>

/// Compresses bytes as in compressed files.
namespace viscera::tests {

/// `bytes` packed by zlib; `windowBits` as in `deflateInit2`.
inline std::string packedBytes(const std::string& bytes, int windowBits) {
  std::string out(compressBound(static_cast<uLong>(bytes.size())) + 64, '\0');
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

inline std::string gzipped(const std::string& bytes) {
  return packedBytes(bytes, MAX_WBITS + 16);
}

inline std::string zlibPacked(const std::string& bytes) {
  return packedBytes(bytes, MAX_WBITS);
}

} // namespace viscera::tests
