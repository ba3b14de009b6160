#include <filesystem>
#include <map>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "source_files.h"

namespace viscera::house {
namespace {
constexpr std::size_t kMostLines = 600;

/// The name of the type that a line at the outer level declares; empty when it declares none.
std::string typeDeclaredBy(const std::string& line) {
  static const std::regex declaration(
      R"(^(?:struct|class|enum|enum class|using) (\w+)(?: final)?(?: : .*| =.*| \{.*)$)");
  std::smatch found;
  return std::regex_match(line, found, declaration) ? found[1].str() : std::string();
}

/// Whether a CMakeLists.txt in the file's folder or below or above it has the file's name without its ending
/// as a word.
bool namedInCMake(const std::filesystem::path& file) {
  const std::regex word("(^|[^A-Za-z0-9_])" + file.stem().string() + "($|[^A-Za-z0-9_])");
  const auto named = [&word](const std::filesystem::path& list) {
    const std::vector<std::string> lines = linesOf(list);
    return std::any_of(lines.begin(), lines.end(),
                       [&word](const std::string& line) { return std::regex_search(line, word); });
  };
  const std::filesystem::path top = VISCERA_SOURCE_DIR;
  for (std::filesystem::path folder = file.parent_path(); folder != top; folder = folder.parent_path())
    if (named(folder / "CMakeLists.txt"))
      return true;
  for (const auto& entry : std::filesystem::directory_iterator(file.parent_path()))
    if (entry.is_directory() && named(entry.path() / "CMakeLists.txt"))
      return true;
  return false;
}
} // namespace

/// A file that no target lists is neither compiled nor, where it is a test, missed.
TEST(SourceFiles, AreListedInCMake) {
  for (const std::string folder : {"app", "modules", "tests"})
    for (const std::filesystem::path& file : sourcesUnder(folder))
      EXPECT_TRUE(file.extension() != ".cpp" || namedInCMake(file)) << shortName(file) << " is in no target";
  EXPECT_FALSE(namedInCMake(std::filesystem::path(VISCERA_SOURCE_DIR) / "tests/unit/core/of_no_target.cpp"));
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

/// What a caller needs of a sequence is in the interface (`Sequence::heart`, `keys`, `course`).
TEST(SourceFiles, AskNoSequenceWhichOneItIs) {
  std::map<std::string, std::string> baseOf; // By the class.
  static const std::regex derives(R"(class (\w+)(?: final)? : public (?:\w+::)*(\w+))");
  static const std::regex casts(R"(dynamic_(?:pointer_)?cast<(?:const )?(?:\w+::)*(\w+))");
  std::vector<std::pair<std::string, std::string>> asked; // The class and the file.
  for (const std::string folder : {"app", "modules"})
    for (const std::filesystem::path& file : sourcesUnder(folder))
      for (const std::string& line : linesOf(file)) {
        std::smatch found;
        if (std::regex_search(line, found, derives))
          baseOf[found[1]] = found[2];
        if (std::regex_search(line, found, casts))
          asked.emplace_back(found[1], shortName(file));
      }
  const auto isSequence = [&baseOf](std::string type) {
    for (; type != "Sequence"; type = baseOf.at(type))
      if (!baseOf.contains(type))
        return false;
    return true;
  };
  ASSERT_TRUE(isSequence("OuterHeartbeat") && isSequence("KeyframedSequence") && !isSequence("SampleHeart"));
  ASSERT_FALSE(asked.empty()) << "widgets may be cast";
  for (const auto& [type, file] : asked)
    EXPECT_FALSE(isSequence(type)) << file << " casts to " << type;
}

/// Several files may be compiled as one. There a file's own type would hide that of core in all files after
/// it.
TEST(SourceFiles, NameNoTypeLikeOneOfCore) {
  std::map<std::string, std::string> ofCore;
  for (const std::filesystem::path& file : sourcesUnder("modules/core/include"))
    for (const std::string& line : linesOf(file))
      if (const std::string type = typeDeclaredBy(line); !type.empty())
        ofCore[type] = shortName(file);
  ASSERT_TRUE(ofCore.contains("Values") && ofCore.contains("JobQueue"));
  for (const std::string folder : {"app", "modules"})
    for (const std::filesystem::path& file : sourcesUnder(folder)) {
      if (shortName(file).starts_with("modules/core/"))
        continue;
      for (const std::string& line : linesOf(file)) {
        const auto type = ofCore.find(typeDeclaredBy(line));
        EXPECT_TRUE(type == ofCore.end())
            << shortName(file) << " declares " << type->first << ", which " << type->second << " has, too";
      }
    }
}

} // namespace viscera::house
