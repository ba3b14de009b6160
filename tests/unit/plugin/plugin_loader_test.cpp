#include "viscera/plugin/plugin_loader.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <new>

#include <dirent.h>
#include <dlfcn.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "build_paths.h"
#include "viscera/core/error.h"

namespace viscera::plugin {

/// So many entries of folders can be read; below 0: all.
int readableEntries = -1;

} // namespace viscera::plugin

/// The C library's, until a disk fails.
extern "C" [[gnu::visibility("default")]] dirent* readdir(DIR* folder) {
  static const auto own = reinterpret_cast<decltype(&readdir)>(::dlsym(RTLD_NEXT, "readdir"));
  int& left = viscera::plugin::readableEntries;
  if (left == 0) {
    errno = EIO;
    return nullptr;
  }
  left = std::max(left - 1, -1);
  return own(folder);
}

namespace viscera::plugin {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const fs::path kGood = fs::path(VISCERA_BINARY_DIR) / "lib/viscera/plugins/localised_scc_plugin.so";
const fs::path kFaulty = fs::path(VISCERA_BINARY_DIR) / "tests/plugins";

class PluginLoaderTest : public testing::Test {
protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              (std::string("viscera_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  PluginReport load(const fs::path& file) { return loadPlugins({file}, registry_).at(0); }

  /// The error by which a system refuses to bind.
  Error errorOfBinding(const std::string& system) {
    Progress progress;
    try {
      registry_.find(system)->bind({}, Points(0, 3), {}, progress);
    } catch (const Error& error) {
      return error;
    }
    ADD_FAILURE() << system << " has bound";
    return Error(0, "none");
  }

  fs::path folder_;
  coordinates::Registry registry_ = coordinates::builtInRegistry();
};

TEST_F(PluginLoaderTest, BringsTheLocalisedCoordinatesWithTheirFileAsTheSource) {
  const auto report = load(kGood);
  EXPECT_EQ(report.problem.english(), "");
  EXPECT_THAT(report.systems, ElementsAre("localised-s-celestial"));
  EXPECT_EQ(report.manifest.name, "Localised S-Celestial");
  EXPECT_EQ(registry_.list().back().source, kGood.string());
  EXPECT_TRUE(registry_.find("localised-s-celestial")->traits().usesGroups);
}

TEST_F(PluginLoaderTest, NamesAFileThatIsMissing) {
  EXPECT_THAT(load(folder_ / "nowhere.so").problem.english(), HasSubstr("no such file"));
}

TEST_F(PluginLoaderTest, TurnsDownAFileThatIsNoPlugin) {
  std::ofstream(folder_ / "text.so") << "This is not a library.";
  EXPECT_THAT(load(folder_ / "text.so").problem.english(), HasSubstr("not a Viscera plugin"));
}

TEST_F(PluginLoaderTest, TurnsDownATruncatedPlugin) {
  fs::copy_file(kGood, folder_ / "half.so");
  fs::resize_file(folder_ / "half.so", fs::file_size(kGood) / 2);
  const auto report = load(folder_ / "half.so");
  EXPECT_NE(report.problem.english(), "");
  EXPECT_THAT(report.systems, IsEmpty());
}

/// Each byte of the manifest in turn: the plugin is loaded, or it is turned down with a reason.
TEST_F(PluginLoaderTest, SurvivesADamagedManifest) {
  std::ifstream stream(kGood, std::ios::binary);
  const std::string good{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t begin = good.find("QTMETADATA !");
  ASSERT_NE(begin, std::string::npos);
  testing::internal::CaptureStderr(); // Qt says of each what is wrong.
  int turnedDown = 0;
  for (std::size_t at = begin; at < begin + 400; at += 3) {
    std::string damaged = good;
    damaged[at] = static_cast<char>(~damaged[at]);
    const fs::path file = folder_ / (std::to_string(at) + ".so");
    std::ofstream(file, std::ios::binary) << damaged;
    coordinates::Registry registry = coordinates::builtInRegistry();
    const PluginReport report = loadPlugins({file}, registry).at(0);
    EXPECT_NE(report.problem.empty(), report.systems.empty()) << "byte " << at - begin;
    turnedDown += report.problem.empty() ? 0 : 1;
    fs::remove(file);
  }
  testing::internal::GetCapturedStderr();
  EXPECT_GT(turnedDown, 0);
}

TEST_F(PluginLoaderTest, TurnsDownAPluginOfAnotherInterfaceVersionByItsManifestAlone) {
  const auto report = load(kFaulty / "plugin_old.so");
  EXPECT_THAT(report.problem.english(), HasSubstr("version 0"));
  EXPECT_EQ(report.manifest.id, "faulty");
}

TEST_F(PluginLoaderTest, SurvivesAPluginThatThrows) {
  EXPECT_THAT(load(kFaulty / "plugin_throws.so").problem.english(), HasSubstr("no disk in drive"));
}

TEST_F(PluginLoaderTest, RefusesADuplicateIdButKeepsTheOtherSystems) {
  const auto report = load(kFaulty / "plugin_duplicate.so");
  EXPECT_THAT(report.problem.english(), HasSubstr("s-celestial"));
  EXPECT_THAT(report.systems, ElementsAre("failing"));
}

TEST_F(PluginLoaderTest, AForeignExceptionInASystemArrivesAsAnErrorThatNamesThePlugin) {
  load(kFaulty / "plugin_duplicate.so");
  const Error error = errorOfBinding("failing");
  EXPECT_EQ(error.exitCode(), 70);
  EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("plugin_duplicate"), HasSubstr("out of cheese")));
}

TEST_F(PluginLoaderTest, ThatMemoryIsShortIsNoFaultOfAPlugin) {
  load(kFaulty / "plugin_duplicate.so");
  Progress progress;
  EXPECT_THROW(registry_.find("failing")->gradients({}, Points(0, 3), {}, progress), std::bad_alloc)
      << "the program has a sentence for it";
}

TEST_F(PluginLoaderTest, AsksASystemForItsDescriptionOnlyOnce) {
  EXPECT_THAT(load(kFaulty / "plugin_forgetful.so").systems, ElementsAre("forgetful"));
  for (int times = 0; times < 2; ++times) {
    const auto system = registry_.find("forgetful");
    EXPECT_EQ(system->name(), "Forgetful");
    EXPECT_EQ(system->summary(), "Describes itself once.");
    EXPECT_TRUE(system->traits().positive);
    ASSERT_EQ(system->parameters().size(), 1u);
    EXPECT_EQ(system->parameters()[0].name, "steepness");
  }
}

TEST_F(PluginLoaderTest, ASystemThatCannotBeDescribedIsLeftOutAloneWithItsPluginsName) {
  const auto report = load(kFaulty / "plugin_forgetful.so");
  EXPECT_FALSE(registry_.contains("nameless"));
  EXPECT_TRUE(registry_.contains("forgetful"));
  EXPECT_THAT(report.problem.english(), testing::AllOf(HasSubstr("plugin_forgetful"), HasSubstr("nameless")));
}

TEST_F(PluginLoaderTest, WhatIsNoExceptionAtAllArrivesAsAnErrorToo) {
  load(kFaulty / "plugin_forgetful.so");
  EXPECT_THAT(errorOfBinding("forgetful").what(),
              testing::AllOf(HasSubstr("plugin_forgetful"), HasSubstr("forgetful")));
}

TEST_F(PluginLoaderTest, OneBadPluginDoesNotKeepTheOthersOut) {
  fs::copy_file(kFaulty / "plugin_throws.so", folder_ / "a_throws.so");
  std::ofstream(folder_ / "b_text.so") << "no library";
  fs::copy_file(kGood, folder_ / "c_good.so");
  const auto reports = loadPlugins({folder_}, registry_);
  ASSERT_EQ(reports.size(), 3u);
  EXPECT_NE(reports[0].problem.english(), "");
  EXPECT_NE(reports[1].problem.english(), "");
  EXPECT_EQ(reports[2].problem.english(), "");
  EXPECT_TRUE(registry_.contains("localised-s-celestial"));
}

TEST_F(PluginLoaderTest, AFolderThatFailsWhileItIsReadKeepsNothingElseOut) {
  for (const char* name : {"a.so", "b.so", "c.so"})
    std::ofstream(folder_ / name) << "no library";
  readableEntries = 4; // Of the five with "." and "..".
  EXPECT_NO_THROW(loadPlugins({folder_}, registry_));
  EXPECT_EQ(readableEntries, 0);
  readableEntries = -1;
  EXPECT_EQ(loadPlugins({folder_}, registry_).size(), 3u);
}

TEST_F(PluginLoaderTest, SearchesWhatIsGivenThenTheEnvironmentThenTheInstallation) {
  ::setenv("VISCERA_PLUGIN_PATH", "/first:/second", 1);
  EXPECT_THAT(pluginSearchPath({"/given"}, folder_), ElementsAre("/given", "/first", "/second", folder_));
  ::unsetenv("VISCERA_PLUGIN_PATH");
  EXPECT_THAT(pluginSearchPath({}, folder_ / "absent"), IsEmpty());
}

} // namespace
} // namespace viscera::plugin
