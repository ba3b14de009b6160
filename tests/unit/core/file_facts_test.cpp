#include "viscera/core/file_facts.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "temporary_folder.h"

namespace viscera {
namespace {

namespace fs = std::filesystem;

TEST(FileFacts, AreThoseOfTheSystem) {
  const tests::TemporaryFolder folder;
  std::ofstream(folder / "a.txt") << "12345";
  EXPECT_EQ(fileBytes(folder / "a.txt"), 5u);
  EXPECT_EQ(absolutePath("a.txt"), fs::current_path() / "a.txt");
  EXPECT_EQ(absolutePath(folder / "a.txt"), folder / "a.txt");
}

TEST(FileFacts, ThrowNothingForAFileThatVanished) {
  const tests::TemporaryFolder folder;
  EXPECT_EQ(fileBytes(folder / "a.txt"), 0u);
  EXPECT_EQ(absolutePath(""), "");
}

/// In a process of its own: the working directory is the whole program's.
TEST(FileFactsDeathTest, ThrowNothingWithoutAWorkingDirectory) {
  const tests::TemporaryFolder folder;
  const auto inRemovedFolder = [&folder] {
    const fs::path gone = folder / "gone";
    fs::create_directory(gone);
    fs::current_path(gone);
    fs::remove(gone);
    std::_Exit(absolutePath("a.txt") == "a.txt" ? 0 : 1);
  };
  EXPECT_EXIT(inRemovedFolder(), ::testing::ExitedWithCode(0), "");
}

} // namespace
} // namespace viscera
