#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "viscera/core/error.h"
#include "viscera/sample_organs/sample_organ.h"

namespace viscera::sample_organs {
namespace {

namespace fs = std::filesystem;

fs::path fromEnvironment(const char* name) {
  const char* value = std::getenv(name);
  return value ? fs::path(value) : fs::path();
}

fs::path definitionsFolder() {
  if (fs::path chosen = fromEnvironment("VISCERA_SAMPLE_ORGANS"); !chosen.empty())
    return chosen;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path installed = program.parent_path() / VISCERA_ORGANS_FROM_BINDIR;
    if (fs::is_directory(installed, error))
      return installed.lexically_normal();
  }
  return VISCERA_ORGANS_SOURCE_DIR;
}

fs::path cacheFolder() {
  if (const fs::path cache = fromEnvironment("XDG_CACHE_HOME"); cache.is_absolute())
    return cache / "viscera/organs";
  if (const fs::path home = fromEnvironment("HOME"); home.is_absolute())
    return home / ".cache/viscera/organs";
  return {};
}

} // namespace

SampleLibrary standardLibrary() {
  return {definitionsFolder(), cacheFolder()};
}

std::vector<std::string> sampleNames(const SampleLibrary& library) {
  std::error_code error;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(library.definitions, error))
    if (entry.path().extension() == ".json" && entry.path().stem().extension().empty())
      names.push_back(entry.path().stem().string());
  if (error)
    throw NoInputError("the sample organs cannot be listed: " + error.message(), library.definitions.string(),
                       "set VISCERA_SAMPLE_ORGANS to the folder of the definitions");
  std::sort(names.begin(), names.end());
  return names;
}

} // namespace viscera::sample_organs
