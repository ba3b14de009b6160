#include <cstddef>
#include <filesystem>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "run_process.h"
#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/medical_io/surface_file.h"

/// Commands on a disk that is full, and with settings and caches in places that cannot be written to.
namespace viscera {
namespace {

namespace fs = std::filesystem;

constexpr const char* kOldFile = "what was there before";
/// Bytes. Each command writes more; clang's OpenMP needs 1,024 of shared memory, which counts as a file.
constexpr std::size_t kRoom = 1100;

/// A command that writes one file, its name last.
struct Writing {
  const char* name;
  const char* file;
  std::vector<std::string> (*prepare)(const fs::path& folder);
};

void PrintTo(const Writing& writing, std::ostream* stream) {
  *stream << writing.name;
}

fs::path ball(const fs::path& folder) {
  medical_io::writeSurface(folder / "ball.stl", tests::sphere(3, 60));
  return folder / "ball.stl";
}

std::vector<std::string> convert(const fs::path& folder) {
  return {"convert", ball(folder)};
}

constexpr Writing kWritings[] = {
    {"Stl", "organ.stl", convert},
    {"Obj", "organ.obj", convert},
    {"Ply", "organ.ply", convert},
    {"Off", "organ.off", convert},
    {"Vtk", "organ.vtk", convert},
    {"Vtp", "organ.vtp", convert},
    {"Glb", "organ.glb", convert},
    {"Sample", "organ.vtp",
     [](const fs::path&) {
       return std::vector<std::string>{"sample", "liver", "--resolution", "low", "-o"};
     }},
    {"Picture", "organ.png",
     [](const fs::path& folder) {
       return std::vector<std::string>{"render", ball(folder), "-o"};
     }},
    {"Movie", "breath.ogv",
     [](const fs::path&) {
       return std::vector<std::string>{"play", "breathing", "--fps", "4", "--size", "160x120", "--movie"};
     }},
    {"Lesson", "lesson.html",
     [](const fs::path&) {
       return std::vector<std::string>{"lesson", "breathing", "-o"};
     }},
    {"Csv", "volumes.csv",
     [](const fs::path&) {
       return std::vector<std::string>{"play", "breathing", "--csv"};
     }},
    {"Handles", "handles.mrk.json", [](const fs::path& folder) {
       return std::vector<std::string>{"handles", ball(folder), "--count", "50", "-o"};
     }}};

class FullDiskCommands : public testing::TestWithParam<Writing> {};

TEST_P(FullDiskCommands, SaySoAndLeaveTheOldFileAlone) {
  const tests::TemporaryFolder folder;
  std::vector<std::string> command = {VISCERA_PROGRAM};
  for (const std::string& argument : GetParam().prepare(folder.path()))
    command.push_back(argument);
  const fs::path file = folder.put(GetParam().file, kOldFile);
  command.push_back(file);
  const auto entries = std::distance(fs::directory_iterator(folder.path()), {});
  test::ProcessOptions options;
  options.fileSize = kRoom;
  options.environment["TMPDIR"] = folder.path() / "none"; // The thread sanitiser needs room in one.
  const test::ProcessResult result = test::runProcess(command, options);
  EXPECT_GT(result.exitCode, 0) << "it found room";
  EXPECT_LT(result.exitCode, 126) << "a signal ended it, or it could not begin";
  EXPECT_NE(result.err.find("viscera: "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find(GetParam().file), std::string::npos) << result.err;
  EXPECT_EQ(tests::contentsOf(file), kOldFile);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), entries) << "half a file was left";
}

INSTANTIATE_TEST_SUITE_P(Commands, FullDiskCommands, testing::ValuesIn(kWritings),
                         [](const auto& of) { return std::string(of.param.name); });

/// Below a file no folder can be made, not even by the administrator.
TEST(UnwritablePlaces, OfCacheSettingsAndStateStopNoCommand) {
  const tests::TemporaryFolder folder;
  test::ProcessOptions options;
  for (const char* variable : {"XDG_CACHE_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"})
    options.environment[variable] = "/dev/null/nowhere";
  const fs::path file = folder / "volumes.csv";
  const test::ProcessResult result =
      test::runProcess({VISCERA_PROGRAM, "play", "breathing", "--csv", file}, options);
  EXPECT_EQ(result.exitCode, 0) << result.err;
  EXPECT_GT(fs::file_size(file), kRoom);
}

} // namespace
} // namespace viscera
