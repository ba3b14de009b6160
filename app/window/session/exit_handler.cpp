#include "window/session/exit_handler.h"

#include <cstdio>
#include <cstdlib>
#include <thread>
#include <utility>

namespace viscera::app {
namespace {

/// `atexit` takes a function without arguments, so what it is to do can only be kept here.
struct LastThing {
  std::function<void()> work;
  std::thread::id thread;
  bool registered = false;
};

LastThing& lastThing() {
  static auto* const thing = new LastThing; // Never destroyed: it is used while others are.
  return *thing;
}

void doLastThing() {
  LastThing& thing = lastThing();
  if (!thing.work || thing.thread != std::this_thread::get_id())
    return;
  const std::function<void()> work = std::exchange(thing.work, {});
  try {
    work();
  } catch (...) { // The error cannot be reported any more.
  }
  std::fflush(nullptr);
  std::_Exit(ExitHandler::kExitCode);
}

} // namespace

ExitHandler::ExitHandler(std::function<void()> last) {
  LastThing& thing = lastThing();
  thing.work = std::move(last);
  thing.thread = std::this_thread::get_id();
  if (!thing.registered)
    thing.registered = std::atexit(doLastThing) == 0;
}

ExitHandler::~ExitHandler() {
  lastThing().work = {};
}

} // namespace viscera::app
