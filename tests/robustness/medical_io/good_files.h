#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace viscera::tests {

/// Which reader a file is for.
enum class FileUse { surface, handles, labels };

/// A valid file, which tests damage in every way.
struct GoodFile {
  std::string name; ///< Says the way it is stored and ends in its extension.
  std::string bytes;
  FileUse use = FileUse::surface;
  /// A part of it can look like a whole: formats that say nowhere how long they are.
  bool partsLookWhole = false;
  std::string besideName = {}; ///< Of the other half, which stays as it is; empty for a file that is whole.
  std::string besideBytes = {};
};

/// One small file of every format that Viscera reads, in the ways that programs store it.
std::vector<GoodFile> goodFiles();

} // namespace viscera::tests
