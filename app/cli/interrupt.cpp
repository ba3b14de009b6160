#include "cli/interrupt.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

namespace viscera::app::cli {
namespace {

sigset_t endingSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (int number : {SIGINT, SIGTERM, SIGHUP})
    sigaddset(&signals, number);
  return signals;
}

} // namespace

Interrupt::Interrupt(Progress& progress) {
  const sigset_t signals = endingSignals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  signals_ = ::signalfd(-1, &signals, SFD_CLOEXEC);
  stop_ = ::eventfd(0, EFD_CLOEXEC);
  thread_ = std::thread([this, &progress] { wait(progress); });
}

Interrupt::~Interrupt() {
  const std::uint64_t one = 1;
  while (::write(stop_, &one, sizeof one) < 0 && errno == EINTR) {
  }
  thread_.join();
  ::close(signals_);
  ::close(stop_);
  const sigset_t signals = endingSignals();
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

void Interrupt::wait(Progress& progress) const {
  std::array<pollfd, 2> sources{pollfd{signals_, POLLIN, 0}, pollfd{stop_, POLLIN, 0}};
  for (;;) {
    if (::poll(sources.data(), sources.size(), -1) < 0 && errno != EINTR)
      return;
    if (sources[1].revents != 0)
      return;
    signalfd_siginfo info{};
    if (sources[0].revents == 0 || ::read(signals_, &info, sizeof info) != sizeof info)
      continue;
    if (progress.cancelled()) {
      constexpr int kKilledBySignal = 128; // As shells report it.
      _exit(kKilledBySignal + static_cast<int>(info.ssi_signo));
    }
    progress.cancel();
  }
}

} // namespace viscera::app::cli
