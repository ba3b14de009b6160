#pragma once

#include <dlfcn.h>
#include <zlib.h>

/// zlib that finds no memory when a test says so. Its functions take the place of the library's in the whole
/// program: for one file of a test.
namespace viscera::tests {

inline bool zlibIsStarved = false;

/// While it lives there is no memory for zlib.
struct StarvedZlib {
  StarvedZlib() { zlibIsStarved = true; }
  ~StarvedZlib() { zlibIsStarved = false; }
  StarvedZlib(const StarvedZlib&) = delete;
  StarvedZlib& operator=(const StarvedZlib&) = delete;
};

} // namespace viscera::tests

extern "C" {

[[gnu::visibility("default")]] int compress2(Bytef* packed, uLongf* packedSize, const Bytef* bytes,
                                             uLong size, int effort) {
  static const auto own = reinterpret_cast<decltype(&compress2)>(::dlsym(RTLD_NEXT, "compress2"));
  return viscera::tests::zlibIsStarved ? Z_MEM_ERROR : own(packed, packedSize, bytes, size, effort);
}

[[gnu::visibility("default")]] int deflate(z_streamp stream, int flush) {
  static const auto own = reinterpret_cast<decltype(&deflate)>(::dlsym(RTLD_NEXT, "deflate"));
  return viscera::tests::zlibIsStarved ? Z_STREAM_ERROR : own(stream, flush);
}

} // extern "C"
