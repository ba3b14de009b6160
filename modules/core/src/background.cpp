#include "viscera/core/background.h"

#include <algorithm>
#include <exception>
#include <thread>

#if defined(__linux__)
#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>
#endif

namespace viscera {
namespace {

/// Each thread of Linux has a priority of its own, which those that it starts take over. It cannot be raised
/// again without privileges: hence the new thread.
void lowerOwnPriority() {
#if defined(__linux__)
  // A tenth of the usual share: little beside a picture, and not nothing on a machine that others keep busy.
  constexpr int kNiceness = 10;
  // Whatever forbids it, the work is done all the same.
  const auto own = static_cast<id_t>(syscall(SYS_gettid));
  static_cast<void>(setpriority(PRIO_PROCESS, own, std::max(kNiceness, getpriority(PRIO_PROCESS, own))));
#endif
}

} // namespace

void inBackground(const std::function<void()>& work) {
  std::exception_ptr problem;
  std::thread worker([&] {
    try {
      lowerOwnPriority();
      work();
    } catch (...) {
      problem = std::current_exception();
    }
  });
  worker.join();
  if (problem)
    std::rethrow_exception(problem);
}

} // namespace viscera
