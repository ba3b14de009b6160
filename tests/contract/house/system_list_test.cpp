#include <cctype>
#include <map>
#include <regex>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "source_files.h"

/// A coordinate system is one file and one line of a list: the rest is made from that line.
namespace viscera::house {
namespace {

const std::string kSystems = "modules/coordinates/";

/// "celestial/s_celestial.cpp" -> "sCelestial".
std::string makerOf(const std::string& file) {
  std::string maker;
  bool capital = false;
  for (const char letter : std::filesystem::path(file).stem().string()) {
    if (letter != '_')
      maker += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
    capital = letter == '_';
  }
  return maker;
}

/// The list in the module's CMakeLists.txt, with the makers that CMake calls.
std::map<std::string, std::string> listed() {
  std::map<std::string, std::string> systems;
  bool inside = false;
  for (const std::string& line :
       linesOf(std::filesystem::path(VISCERA_SOURCE_DIR) / kSystems / "CMakeLists.txt")) {
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      const bool last = inside && word.ends_with(')');
      if (last)
        word.pop_back();
      if (inside)
        systems[word] = makerOf(word);
      inside = (inside || word == "set(systems") && !last;
    }
  }
  return systems;
}

/// The files of the module that define a maker, with its name.
std::map<std::string, std::string> defined() {
  static const std::regex maker(R"(^std::shared_ptr<const CoordinateSystem> (\w+)\(\) \{$)");
  std::map<std::string, std::string> systems;
  const auto folder = std::filesystem::path(VISCERA_SOURCE_DIR) / kSystems / "src";
  for (const auto& file : sourcesUnder(kSystems + "src"))
    for (const std::string& line : linesOf(file))
      if (std::smatch match; std::regex_match(line, match, maker))
        systems[file.lexically_relative(folder).string()] = match[1];
  return systems;
}

} // namespace

TEST(SystemList, HoldsEveryFileWithAMakerAndNoOther) {
  EXPECT_GE(listed().size(), 20u) << "the list was not found";
  EXPECT_EQ(listed(), defined());
}

} // namespace viscera::house
