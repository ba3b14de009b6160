#include <string>

#include <gtest/gtest.h>

#include "source_files.h"

namespace viscera::house {
namespace {
constexpr std::size_t kMostLines = 600;
}

TEST(SourceFiles, AreShortEnoughToRead) {
  for (const std::string folder : {"app", "modules", "tests"})
    for (const std::filesystem::path& file : sourcesUnder(folder))
      EXPECT_LE(linesOf(file).size(), kMostLines) << shortName(file) << " should be split";
}

TEST(SourceFiles, HeadersAreIncludedOnce) {
  for (const std::string folder : {"app", "modules", "tests"})
    for (const std::filesystem::path& file : sourcesUnder(folder)) {
      if (file.extension() != ".h")
        continue;
      const auto lines = linesOf(file);
      EXPECT_NE(std::find(lines.begin(), lines.end(), "#pragma once"), lines.end()) << shortName(file);
    }
}

} // namespace viscera::house
