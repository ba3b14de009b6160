#pragma once

#include <sys/resource.h>

namespace viscera::tests {

/// The most memory that a reader may take: a few times a file's size, far below the sizes that damaged
/// headers state.
constexpr long kMostExtraKilobytes = 200 * 1024;

/// The most memory that this process has had until now.
inline long peakKilobytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss;
}

} // namespace viscera::tests
