#include <array>
#include <cstdio>
#include <fstream>
#include <memory>
#include <string>

#include <benchmark/benchmark.h>

#include "build_paths.h"

/// The main program of all benchmarks: notes in the output what was measured, and on what.
namespace {

/// The first line that `command` prints; empty when it fails.
std::string firstLine(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen((command + " 2>/dev/null").c_str(), "r"), pclose);
  std::array<char, 256> buffer{};
  if (!pipe || !std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe.get()))
    return {};
  std::string line = buffer.data();
  while (!line.empty() && line.back() == '\n')
    line.pop_back();
  return line;
}

std::string commit() {
  const std::string git = "git -C '" VISCERA_SOURCE_DIR "' ";
  const std::string head = firstLine(git + "rev-parse HEAD");
  if (head.empty())
    return "unknown";
  return firstLine(git + "status --porcelain --untracked-files=no").empty() ? head : head + " with changes";
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos)
      return line.substr(line.find(": ") + 2);
  return "unknown";
}

} // namespace

int main(int argc, char** argv) {
  benchmark::AddCustomContext("commit", commit());
  benchmark::AddCustomContext("processor", processor());
  benchmark::AddCustomContext("compiler", VISCERA_COMPILER);
  benchmark::AddCustomContext("build_type", VISCERA_BUILD_TYPE);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv))
    return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
