#pragma once

#include <malloc.h>

namespace viscera::app {

/// Limits the allocator to two heaps. By default glibc makes up to eight for each processor, and each keeps
/// what its threads once took: a beating heart with comparisons and movies grew from 540 to 571 MB in a
/// quarter of an hour. Two heaps are as fast. Call it before the first thread starts.
inline void useFewHeaps() {
  constexpr int kHeaps = 2;
  mallopt(M_ARENA_MAX, kHeaps);
}

/// Returns to the system the pages that the allocator keeps for later, which it does not do by itself for
/// those that lie between others. For the end of something large, such as a second view or a recording; takes
/// milliseconds. Thread-safe.
inline void returnFreedMemory() {
  malloc_trim(0);
}

} // namespace viscera::app
