#pragma once

#include <cstddef>
#include <memory>

namespace viscera::coordinates {

/// The deleter that frees memory of `allocateZeroed`.
struct FreeZeroed {
  std::size_t bytes = 0;
  void operator()(double* memory) const;
};

using ZeroedMemory = std::unique_ptr<double, FreeZeroed>;

/// `count` zeros at a multiple of a cache line, in pages that are allocated on first access. Large blocks
/// request huge pages from the system: a matrix of coordinates is read from end to end for every frame, and
/// allocating it in pages of 4 KiB took a third of the time to compute it. Throws `std::bad_alloc`.
ZeroedMemory allocateZeroed(std::size_t count);

} // namespace viscera::coordinates
