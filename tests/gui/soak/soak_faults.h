#pragma once

#include <string>
#include <vector>

#include "machine_watch.h"
#include "process_use.h"

namespace viscera::tests {

/// One second of a soak.
struct SoakSample {
  double seconds = 0; ///< Since the soak began.
  ProcessUse use;
  int frames = 0;         ///< Drawn in the first view.
  double longestMs = 0;   ///< Between two frames that followed each other while the heart played.
  MachineUse machine;     ///< What the machine did during that.
  std::string occupation; ///< The activity beside the beating: `kPlaying` for none.
};

inline const std::string kPlaying = "playing";

/// What a soak is judged by.
struct SoakRules {
  double warmUp = 0.1;            ///< The share of the soak in which caches fill and nothing is judged.
  bool lateFramesAllowed = false; ///< For a soak that shares its processors, or draws with one thread.
};

/// The faults of a soak, a line each; empty when memory, descriptors and threads stayed and no frame came
/// late while nothing went on but the beating. The time that the machine itself stood still, or was slower
/// than usual in this soak, does not count. Each worker of a queue of jobs keeps OpenMP's threads from its
/// first parallel loop on, and chance decides which worker takes a job; therefore only the second half may
/// have no more threads than the first had.
std::vector<std::string> soakFaults(const std::vector<SoakSample>& samples, const SoakRules& rules = {});

} // namespace viscera::tests
