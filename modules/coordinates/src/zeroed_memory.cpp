#include "viscera/coordinates/zeroed_memory.h"

#include <algorithm>
#include <cstdlib>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace viscera::coordinates {
namespace {
constexpr std::size_t kCacheLine = 64;
constexpr std::size_t kHugePage = std::size_t{1} << 21;

constexpr std::size_t roundedUp(std::size_t bytes, std::size_t unit) {
  return (bytes + unit - 1) / unit * unit;
}
} // namespace

#if defined(__linux__)

namespace {

/// Maps `bytes` (a multiple of a huge page) starting at a multiple of a huge page; null when there is no
/// room.
void* mapHuge(std::size_t bytes) {
  void* mapped = mmap(nullptr, bytes + kHugePage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED)
    return nullptr;
  char* begin = static_cast<char*>(mapped);
  std::size_t room = bytes + kHugePage;
  void* aligned = mapped;
  std::align(kHugePage, bytes, aligned, room);
  const std::size_t before = static_cast<std::size_t>(static_cast<char*>(aligned) - begin);
  if (before > 0)
    munmap(begin, before);
  if (before < kHugePage)
    munmap(static_cast<char*>(aligned) + bytes, kHugePage - before);
  madvise(aligned, bytes,
          MADV_HUGEPAGE); // Only advice: without huge pages the memory is as good, but slower.
  return aligned;
}

} // namespace

#endif

void FreeZeroed::operator()(double* memory) const {
#if defined(__linux__)
  if (bytes >= kHugePage) {
    munmap(memory, bytes);
    return;
  }
#endif
  std::free(memory);
}

ZeroedMemory allocateZeroed(std::size_t count) {
  const std::size_t wanted = std::max(count * sizeof(double), kCacheLine);
#if defined(__linux__)
  if (wanted >= kHugePage) {
    const std::size_t bytes = roundedUp(wanted, kHugePage);
    if (void* memory = mapHuge(bytes))
      return ZeroedMemory(static_cast<double*>(memory), FreeZeroed{bytes});
    throw std::bad_alloc();
  }
#endif
  const std::size_t bytes = roundedUp(wanted, kCacheLine);
  double* memory = static_cast<double*>(std::aligned_alloc(kCacheLine, bytes));
  if (!memory)
    throw std::bad_alloc();
  std::fill_n(memory, bytes / sizeof(double), 0.0);
  return ZeroedMemory(memory, FreeZeroed{0});
}

} // namespace viscera::coordinates
