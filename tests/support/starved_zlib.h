#pragma once

#include <dlfcn.h>
#include <zlib.h>

/// A zlib without memory, for tests of that error. Its functions replace those of the library in the whole
/// program, so include it in one file of a test only.
namespace viscera::tests {

inline bool zlibIsStarved = false;

/// While the object lives, zlib gets no memory.
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
