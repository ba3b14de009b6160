#include "viscera/core/atomic_file.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <stdexcept>
#include <string>

#include <unistd.h>

#include <gtest/gtest.h>

#include "viscera/core/error.h"

namespace viscera {
namespace fs = std::filesystem;

class AtomicFileTest : public testing::Test {
protected:
  void SetUp() override {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    folder_ = fs::temp_directory_path() / ("viscera atomic file " + name + " " + std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path target() const { return folder_ / "rig.mrk.json"; }
  void put(const std::string& text) const { std::ofstream(target()) << text; }
  std::string contents() const {
    std::ifstream stream(target());
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  fs::path folder_;
};

TEST_F(AtomicFileTest, ReplacesWhatWasThere) {
  put("before");
  writeAtomically(target(), [](std::ostream& stream) { stream << "after"; });
  EXPECT_EQ(contents(), "after");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFileTest, KeepsWhatWasThereWhenTheWriterFails) {
  put("before");
  EXPECT_THROW(writeAtomically(target(),
                               [](std::ostream& stream) {
                                 stream << "half of it";
                                 throw std::runtime_error("enough");
                               }),
               std::runtime_error);
  EXPECT_EQ(contents(), "before");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFileTest, KeepsWhatWasThereWhenTheStreamFails) {
  put("before");
  EXPECT_THROW(writeAtomically(target(), [](std::ostream& stream) { stream.setstate(std::ios::badbit); }),
               CannotCreateError);
  EXPECT_EQ(contents(), "before");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFileTest, ShowsNothingUnderTheNameBeforeItIsComplete) {
  AtomicFile file(target());
  EXPECT_FALSE(fs::exists(target()));
  EXPECT_TRUE(file.temporary().string().ends_with("rig.mrk.json"))
      << "writers choose the format by the ending";
  file.commit();
  EXPECT_TRUE(fs::exists(target()));
}

TEST_F(AtomicFileTest, WritesThroughASymbolicLink) {
  put("before");
  const fs::path link = folder_ / "link.json";
  fs::create_symlink(target(), link);
  writeAtomically(link, [](std::ostream& stream) { stream << "after"; });
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(contents(), "after");
}

TEST_F(AtomicFileTest, WritesToADeviceWithoutReplacingIt) {
  writeAtomically("/dev/null", [](std::ostream& stream) { stream << "gone"; });
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(AtomicFileTest, GivesNewFilesTheUsualRights) {
  put("as every other file");
  const fs::perms usual = fs::status(target()).permissions();
  writeAtomically(folder_ / "other", [](std::ostream& stream) { stream << "x"; });
  EXPECT_EQ(fs::status(folder_ / "other").permissions(), usual);
}

TEST_F(AtomicFileTest, RefusesFoldersThatAreNotThereAndFoldersAsFiles) {
  EXPECT_THROW(AtomicFile(folder_ / "missing" / "file"), CannotCreateError);
  EXPECT_THROW(AtomicFile{folder_}, CannotCreateError);
}

TEST_F(AtomicFileTest, RemovesAbandonedWritesOfTheTargetAndNothingElse) {
  put("whole");
  const AtomicFile living(target());
  for (const char* name : {".17-rig.mrk.json", ".4294967295-rig.mrk.json"})
    std::ofstream(folder_ / name) << "half of it";
  const auto others = {".17-other.mrk.json", ".17-my-rig.mrk.json", ".a1-rig.mrk.json",
                       ".-rig.mrk.json",     "17-rig.mrk.json",     ".17rig.mrk.json"};
  for (const char* name : others)
    std::ofstream(folder_ / name) << "somebody's";
  fs::create_directory(folder_ / ".18-rig.mrk.json");
  fs::create_symlink(target(), folder_ / ".19-rig.mrk.json");
  removeAbandonedWrites(target());
  EXPECT_FALSE(fs::exists(folder_ / ".17-rig.mrk.json"));
  EXPECT_FALSE(fs::exists(folder_ / ".4294967295-rig.mrk.json"));
  EXPECT_TRUE(fs::exists(living.temporary())) << "its writer lives";
  EXPECT_EQ(contents(), "whole");
  for (const char* name : others)
    EXPECT_TRUE(fs::exists(folder_ / name)) << name;
  EXPECT_TRUE(fs::is_directory(folder_ / ".18-rig.mrk.json"));
  removeAbandonedWrites(folder_ / "missing" / "file");
}

TEST_F(AtomicFileTest, RemovesAbandonedWritesBehindASymbolicLink) {
  put("whole");
  fs::create_directory(folder_ / "elsewhere");
  fs::create_symlink(target(), folder_ / "elsewhere" / "link.json");
  std::ofstream(folder_ / ".17-rig.mrk.json") << "half of it";
  removeAbandonedWrites(folder_ / "elsewhere" / "link.json");
  EXPECT_FALSE(fs::exists(folder_ / ".17-rig.mrk.json"));
}

} // namespace viscera
