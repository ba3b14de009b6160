#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <malloc.h>

namespace viscera::tests {

/// Memory, descriptors and threads of this process at a moment, as reported by Linux.
struct ProcessUse {
  double residentMb = 0;
  double ownMb = 0;       ///< Resident without files, whose pages the system loads and drops at any time.
  double allocatedMb = 0; ///< By malloc and new, and not yet freed.
  int descriptors = 0;    ///< Open files, sockets and pipes.
  int threads = 0;
};

inline ProcessUse processUse() {
  ProcessUse use;
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word == "VmRSS:") {
      status >> use.residentMb;
      use.residentMb /= 1024;
    } else if (word == "RssAnon:") {
      status >> use.ownMb;
      use.ownMb /= 1024;
    } else if (word == "Threads:") {
      status >> use.threads;
    }
  }
  const struct mallinfo2 heap = mallinfo2();
  use.allocatedMb = static_cast<double>(heap.uordblks + heap.hblkhd) / (1 << 20);
  const std::filesystem::directory_iterator open("/proc/self/fd");
  use.descriptors = static_cast<int>(std::distance(begin(open), end(open))) - 1; // Without the look itself.
  return use;
}

} // namespace viscera::tests
