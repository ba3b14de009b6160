#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "build_paths.h"

/// Reads the project's own sources, for tests of their style.
namespace viscera::house {

/// Every `.h` and `.cpp` file under a folder of the project, sorted; none when there is no such folder.
inline std::vector<std::filesystem::path> sourcesUnder(const std::string& folder) {
  std::vector<std::filesystem::path> sources;
  const std::filesystem::path root = std::filesystem::path(VISCERA_SOURCE_DIR) / folder;
  if (!std::filesystem::exists(root))
    return sources;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root))
    if (entry.path().extension() == ".h" || entry.path().extension() == ".cpp")
      sources.push_back(entry.path());
  std::sort(sources.begin(), sources.end());
  return sources;
}

/// The lines of a file.
inline std::vector<std::string> linesOf(const std::filesystem::path& file) {
  std::vector<std::string> lines;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(line);
  return lines;
}

/// A file's name as seen from the project's top, for messages.
inline std::string shortName(const std::filesystem::path& file) {
  return file.lexically_relative(VISCERA_SOURCE_DIR).string();
}

} // namespace viscera::house
