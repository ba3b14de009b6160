#include "window/heap.h"

#include <malloc.h>

namespace viscera::app {
namespace {

constexpr int kHeaps = 2;

} // namespace

void useFewHeaps() {
  mallopt(M_ARENA_MAX, kHeaps);
}

void returnFreedMemory() {
  malloc_trim(0);
}

} // namespace viscera::app
