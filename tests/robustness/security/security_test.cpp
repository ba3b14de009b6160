#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "build_paths.h"
#include "run_process.h"

/// What docs/SECURITY.md promises of the binaries, read from them with readelf.
namespace viscera {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

/// The program, TetGen's worker, the plugin, and the shared libraries of the modules that this build has.
std::vector<std::filesystem::path> binaries() {
  std::vector<std::filesystem::path> found = {VISCERA_PROGRAM, VISCERA_TETGEN_PROGRAM, VISCERA_PLUGIN_FILE};
  for (const auto& entry : std::filesystem::directory_iterator(VISCERA_LIBRARIES))
    if (entry.is_regular_file() && entry.path().filename().string().starts_with("libviscera_"))
      found.push_back(entry.path());
  return found;
}

std::string readelf(const std::string& what, const std::filesystem::path& binary) {
  const test::ProcessResult result =
      test::runProcess({"/usr/bin/env", "readelf", "--wide", what, binary.string()});
  EXPECT_EQ(result.exitCode, 0) << result.err;
  return result.out;
}

/// Names that the binary takes from other libraries, without their versions.
std::set<std::string> importedBy(const std::filesystem::path& binary) {
  std::set<std::string> names;
  const std::string symbols = readelf("--dyn-syms", binary);
  static const std::regex imported(R"(\sUND ([^\s@]+))");
  for (std::sregex_iterator match(symbols.begin(), symbols.end(), imported), end; match != end; ++match)
    names.insert((*match)[1]);
  return names;
}

TEST(Security, NothingCallsAShell) {
  ASSERT_GT(binaries().size(), 10U);
  for (const auto& binary : binaries()) {
    std::vector<std::string> shells;
    for (const std::string& name : importedBy(binary))
      if (name == "system" || name == "popen" || name == "wordexp" ||
          name.find("QProcess") != std::string::npos)
        shells.push_back(name);
    EXPECT_THAT(shells, IsEmpty()) << binary;
  }
}

TEST(Security, OnlyThePluginModuleLoadsCode) {
  for (const auto& binary : binaries()) {
    std::vector<std::string> loaders;
    for (const std::string& name : importedBy(binary))
      if (name == "dlopen" || name == "dlmopen" || name.find("QPluginLoader") != std::string::npos ||
          name.find("8QLibrary") != std::string::npos) // As mangled: QLibraryInfo only tells folders.
        loaders.push_back(name);
    if (binary.filename().string().starts_with("libviscera_plugin."))
      EXPECT_FALSE(loaders.empty());
    else
      EXPECT_THAT(loaders, IsEmpty()) << binary;
  }
}

TEST(Hardening, IsInEveryBinary) {
  if (!VISCERA_HARDENED)
    GTEST_SKIP() << "this build is not hardened (VISCERA_HARDEN is off, or a sanitiser watches)";
  std::set<std::string> imported;
  for (const auto& binary : binaries()) {
    SCOPED_TRACE(binary);
    const std::string segments = readelf("--segments", binary);
    EXPECT_THAT(segments, HasSubstr("GNU_RELRO"));
    EXPECT_FALSE(std::regex_search(segments, std::regex(R"(GNU_STACK.*RWE)"))) << "The stack is executable.";
    EXPECT_THAT(segments, HasSubstr("Elf file type is DYN")) << "It is not position-independent.";
    EXPECT_THAT(readelf("--dynamic", binary), HasSubstr("NOW"));
    imported.merge(importedBy(binary));
  }
  EXPECT_TRUE(imported.contains("__stack_chk_fail")) << "No function guards its stack.";
  EXPECT_TRUE(importedBy(VISCERA_TETGEN_PROGRAM).contains("__stack_chk_fail"))
      << "It reads surfaces of files.";
  bool fortified = false;
  for (const std::string& name : imported)
    fortified = fortified || name.ends_with("_chk");
  EXPECT_TRUE(fortified) << "No call of the C library is checked.";
}

} // namespace
} // namespace viscera
