#include <filesystem>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "source_files.h"

namespace viscera::house {
namespace {

/// "Suite.Name" of every test, sorted.
std::set<std::string> allTests() {
  const std::regex test("^TEST(?:_F|_P)?\\((\\w+), (\\w+)\\).*");
  std::set<std::string> names;
  for (const std::filesystem::path& file : sourcesUnder("tests"))
    for (const std::string& line : linesOf(file))
      if (std::smatch found; line.starts_with("TEST") && std::regex_match(line, found, test))
        names.insert(found[1].str() + "." + found[2].str());
  return names;
}

/// Whether one of them begins so.
bool isTested(const std::set<std::string>& tests, const std::string& begin) {
  const auto found = tests.lower_bound(begin);
  return found != tests.end() && found->starts_with(begin);
}

} // namespace

/// docs/strain.md says what holds each of its numbers: the tests that it names are there.
TEST(HeldRows, OfStrainNameTestsThatExist) {
  const std::set<std::string> tests = allTests();
  const std::regex named("`(\\w+\\.\\w*)(?:\\.\\.\\.|\\*)?`");
  bool inTable = false;
  int rows = 0;
  for (const std::string& line : linesOf(std::filesystem::path(VISCERA_SOURCE_DIR) / "docs/strain.md")) {
    inTable = line.starts_with("## ") ? line == "## How it is held" : inTable;
    if (!inTable || !line.starts_with("| ") || line.starts_with("| what"))
      continue;
    ++rows;
    for (std::sregex_iterator test(line.begin(), line.end(), named), end; test != end; ++test)
      EXPECT_TRUE(isTested(tests, (*test)[1])) << test->str() << " in: " << line;
  }
  EXPECT_GE(rows, 9);
  EXPECT_FALSE(isTested(tests, "HeldRows.OfNothing"));
}

} // namespace viscera::house
