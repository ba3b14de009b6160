#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "source_files.h"

namespace viscera::house {
namespace {

/// "Suite.Name" of every test in the sources.
std::set<std::string> testsThereAre() {
  const std::regex beginning(R"(^(?:TYPED_)?TEST(?:_F|_P)?\((\w+), *(\w+))");
  std::set<std::string> tests;
  for (const std::filesystem::path& file : sourcesUnder("tests"))
    for (const std::string& line : linesOf(file)) {
      std::smatch found;
      if (line.rfind("T", 0) == 0 && std::regex_search(line, found, beginning))
        tests.insert(found[1].str() + "." + found[2].str());
    }
  return tests;
}

} // namespace

/// A table that says what holds each point is worth no more than the names in it.
TEST(WindowReview, NamesTestsThatExist) {
  const std::set<std::string> tests = testsThereAre();
  ASSERT_GT(tests.size(), 2000u);
  const std::regex name(R"(`([A-Z]\w+\.[A-Z]\w+)`)");
  int named = 0;
  for (const std::string& line : linesOf(std::filesystem::path(VISCERA_SOURCE_DIR) / "docs/window_review.md"))
    for (std::sregex_iterator found(line.begin(), line.end(), name), end; found != end; ++found) {
      ++named;
      EXPECT_EQ(tests.count((*found)[1].str()), 1u) << (*found)[1].str();
    }
  EXPECT_GT(named, 100);
}

} // namespace viscera::house
