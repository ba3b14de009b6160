#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "source_files.h"

namespace viscera::house {
namespace {

namespace fs = std::filesystem;

/// Adds the names that `beginning` finds in a line, "Suite.Name".
void addNames(const std::string& line, const std::regex& beginning, std::set<std::string>& tests) {
  std::smatch found;
  if (std::regex_search(line, found, beginning))
    tests.insert(found[1].str() + "." + found[2].str());
}

/// "Suite.Name" of every test in the sources and in CMake's lists.
std::set<std::string> testsThereAre() {
  const std::regex inSource(R"(^(?:TYPED_)?TEST(?:_F|_P)?\((\w+), *(\w+))");
  const std::regex inCMake(R"(add_test\(NAME "?(\w+)\.(\w+))");
  std::set<std::string> tests;
  for (const fs::path& file : sourcesUnder("tests"))
    for (const std::string& line : linesOf(file))
      if (line.rfind('T', 0) == 0)
        addNames(line, inSource, tests);
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(VISCERA_SOURCE_DIR) / "tests"))
    if (entry.path().filename() == "CMakeLists.txt")
      for (const std::string& line : linesOf(entry.path()))
        addNames(line, inCMake, tests);
  return tests;
}

/// Whether a test has the name, in which a star stands for any letters.
bool isNamed(const std::string& name, const std::set<std::string>& tests) {
  if (name.find('*') == std::string::npos)
    return tests.contains(name);
  const std::regex pattern(std::regex_replace(std::regex_replace(name, std::regex(R"(\.)"), R"(\.)"),
                                              std::regex(R"(\*)"), R"(\w*)"));
  for (const std::string& test : tests)
    if (std::regex_match(test, pattern))
      return true;
  return false;
}

} // namespace

/// A page that says what holds a point is worth no more than the names in it.
TEST(NamedTests, OfEveryPageExist) {
  const std::set<std::string> tests = testsThereAre();
  ASSERT_GT(tests.size(), 2000u);
  const std::regex name(R"(`([A-Z]\w+\.[A-Z*][\w*]*)`)");
  int named = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(VISCERA_SOURCE_DIR) / "docs")) {
    if (entry.path().extension() != ".md" || entry.path().filename() == "CHANGELOG.md")
      continue;
    for (const std::string& line : linesOf(entry.path()))
      for (std::sregex_iterator found(line.begin(), line.end(), name), end; found != end; ++found) {
        ++named;
        EXPECT_TRUE(isNamed((*found)[1].str(), tests)) << shortName(entry.path()) << ": " << (*found)[1];
      }
  }
  EXPECT_GT(named, 50);
}

TEST(NamedTests, MayHaveAStar) {
  const std::set<std::string> tests = {"Suite.FirstCase", "Suite.Other"};
  EXPECT_TRUE(isNamed("Suite.*", tests));
  EXPECT_TRUE(isNamed("Suite.*Case", tests));
  EXPECT_FALSE(isNamed("Suite.*Nothing", tests));
  EXPECT_FALSE(isNamed("Suite.First", tests));
  EXPECT_FALSE(isNamed("Suit*.Firs", tests));
}

} // namespace viscera::house
