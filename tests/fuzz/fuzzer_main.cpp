#include <cstdlib>
#include <fstream>
#include <iostream>

#include "fuzz_target.h"
#include "viscera/core/error.h"

/// A program of libFuzzer for one target: VISCERA_FUZZ_TARGET of the list VISCERA_FUZZ_LIST.
namespace {

viscera::fuzz::Target findTarget() {
  for (const viscera::fuzz::Target& candidate : viscera::fuzz::VISCERA_FUZZ_LIST())
    if (candidate.name == VISCERA_FUZZ_TARGET)
      return candidate;
  std::cerr << "There is no target " << VISCERA_FUZZ_TARGET << "\n";
  std::abort();
}

const viscera::fuzz::Target& target() {
  static const viscera::fuzz::Target found = findTarget();
  return found;
}

} // namespace

/// Writes the inputs to start from where VISCERA_FUZZ_SEEDS says.
extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  const char* folder = std::getenv("VISCERA_FUZZ_SEEDS");
  if (folder == nullptr)
    return 0;
  std::filesystem::create_directories(folder);
  int number = 0;
  for (const std::string& seed : target().seeds())
    std::ofstream(std::filesystem::path(folder) / ("seed_" + std::to_string(number++)), std::ios::binary)
        << seed;
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    target().run({data, size});
  } catch (const viscera::Error&) { // Refused.
  }
  return 0;
}
