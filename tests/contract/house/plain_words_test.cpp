#include <cctype>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "source_files.h"

namespace viscera::house {
namespace {

/// Words that make a riddle of who does what. Name the part, the caller or the user instead.
const std::vector<std::string> kRiddles = {"nobody",      "somebody",  "everybody", "whoever",
                                           "on the desk", "the house", "hears",     "wishes"};

/// Places where such a word means what it says: the file, and a piece of the line.
const std::set<std::pair<std::string, std::string>> kExcused = {};

bool partOfWord(const std::string& text, std::size_t at) {
  return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at]));
}

/// The riddles that begin in `line`; one of several words may go on in the line that follows.
std::vector<std::string> riddlesIn(const std::string& line, const std::string& following = {}) {
  std::string text = line + ' ' + following;
  for (char& c : text)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  std::vector<std::string> found;
  for (const std::string& riddle : kRiddles)
    for (std::size_t at = text.find(riddle); at < line.size(); at = text.find(riddle, at + 1))
      if ((at == 0 || !partOfWord(text, at - 1)) && !partOfWord(text, at + riddle.size()))
        found.push_back(riddle);
  return found;
}

/// The comment of a line of C++; empty for none.
std::string commentOf(const std::string& line) {
  const std::size_t slashes = line.find("//");
  const std::size_t text = slashes == std::string::npos ? slashes : line.find_first_not_of("/< ", slashes);
  return text == std::string::npos ? std::string() : line.substr(text);
}

/// Of each line, what stands in `<source>` of a file of translations: the window's own text. `inside` says
/// whether it goes on from the line before.
std::string sourceText(const std::string& line, bool& inside) {
  const std::size_t begin = line.find("<source>"), end = line.find("</source>");
  const bool within = inside || begin != std::string::npos;
  inside = within && end == std::string::npos;
  const std::size_t from = begin == std::string::npos ? 0 : begin + 8;
  return within ? line.substr(from, end == std::string::npos ? end : end - from) : std::string();
}

/// What a reader reads of a file, line by line: comments of a header, texts of the window, all of a page.
std::vector<std::string> readable(const std::filesystem::path& file) {
  std::vector<std::string> lines = linesOf(file);
  bool inside = false;
  for (std::string& line : lines)
    if (file.extension() == ".h")
      line = commentOf(line);
    else if (file.extension() == ".ts")
      line = sourceText(line, inside);
  return lines;
}

/// The headers, the pages, and one language's translations, which have every text of the window.
std::vector<std::filesystem::path> readFiles() {
  const std::filesystem::path root = VISCERA_SOURCE_DIR;
  std::vector<std::filesystem::path> files{root / "README.md", root / "resources/translations/viscera_de.ts",
                                           root / "resources/translations/names_de.ts"};
  for (const std::string folder : {"app", "modules"})
    for (const std::filesystem::path& file : sourcesUnder(folder))
      if (file.extension() == ".h")
        files.push_back(file);
  for (const auto& entry : std::filesystem::directory_iterator(root / "docs"))
    if (entry.path().extension() == ".md")
      files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

/// Whether the line is excused, which is noted.
bool excused(const std::string& file, const std::string& line,
             std::set<std::pair<std::string, std::string>>& used) {
  for (const auto& excuse : kExcused)
    if (excuse.first == file && line.find(excuse.second) != std::string::npos) {
      used.insert(excuse);
      return true;
    }
  return false;
}

} // namespace

TEST(PlainWords, AreUsedInHeadersPagesAndTheWindow) {
  std::set<std::pair<std::string, std::string>> used;
  std::ostringstream left;
  int count = 0;
  for (const std::filesystem::path& file : readFiles()) {
    const std::vector<std::string> lines = readable(file);
    ASSERT_FALSE(lines.empty()) << shortName(file);
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const std::string& riddle : riddlesIn(lines[i], i + 1 < lines.size() ? lines[i + 1] : ""))
        if (!excused(shortName(file), lines[i], used)) {
          ++count;
          left << shortName(file) << ':' << i + 1 << ": " << riddle << ": " << lines[i] << '\n';
        }
  }
  EXPECT_EQ(count, 0) << left.str();
  EXPECT_EQ(used, kExcused) << "an excuse that is no longer needed goes from the list";
}

TEST(PlainWords, AreToldFromRiddles) {
  EXPECT_EQ(riddlesIn("Whoever hears it"), (std::vector<std::string>{"whoever", "hears"}));
  EXPECT_EQ(riddlesIn("Nobody's cavity"), std::vector<std::string>{"nobody"});
  EXPECT_EQ(riddlesIn("outside the", "house"), std::vector<std::string>{"the house"});
  EXPECT_TRUE(riddlesIn("an observer that listens", "nobody").empty()) << "it is the next line's";
  EXPECT_TRUE(riddlesIn("the households, and nobodyElse").empty());
  EXPECT_EQ(commentOf("std::optional<int> everybody; ///< Both sexes."), "Both sexes.");
  EXPECT_EQ(commentOf("int everybody = 0;"), "");
  bool inside = false;
  EXPECT_EQ(sourceText("<source>Nobody</source>", inside), "Nobody");
  EXPECT_EQ(sourceText("<translation>Niemand</translation>", inside), "");
  EXPECT_EQ(sourceText("  <source>Some", inside), "Some");
  EXPECT_EQ(sourceText("body</source>", inside), "body");
  EXPECT_FALSE(inside);
}

} // namespace viscera::house
