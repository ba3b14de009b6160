#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "run_process.h"
#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/medical_io/surface_file.h"

/// Commands that are killed while they record, export, bend a scan and fit a motion: where they write lies
/// what was there before, or the whole new file.
namespace viscera {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* kBefore = "what was there before";

/// How often each is killed: some times here, VISCERA_KILLS of them by hand.
int kills() {
  const char* asked = std::getenv("VISCERA_KILLS");
  return asked ? std::atoi(asked) : 3;
}

/// A command that takes a second or so, and the file that it writes in a folder made for it.
struct Work {
  const char* name;
  const char* file;
  std::vector<std::string> (*prepare)(const fs::path& folder);
};

void PrintTo(const Work& work, std::ostream* stream) {
  *stream << work.name;
}

std::vector<std::string> record(const fs::path& /*folder*/) {
  return {"play", "breathing", "--fps", "8", "--size", "160x120", "--movie"};
}

std::vector<std::string> exportLesson(const fs::path& /*folder*/) {
  return {"lesson", "breathing", "-o"};
}

/// 96 x 96 x 96 values around handles, one of which goes 10 mm to the left.
std::vector<std::string> warp(const fs::path& folder) {
  constexpr int kSize = 96;
  std::ofstream scan(folder / "scan.nrrd", std::ios::binary);
  scan << "NRRD0004\ntype: int16\ndimension: 3\nspace: left-posterior-superior\nsizes: 96 96 96\n"
          "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (-48,-48,-48)\nkinds: domain domain "
          "domain\n"
          "endian: little\nencoding: raw\n\n";
  for (int i = 0; i < kSize * kSize * kSize; ++i) {
    const auto value = static_cast<std::int16_t>(i % 997);
    scan.write(reinterpret_cast<const char*>(&value), sizeof value);
  }
  medical_io::HandleGroupRecord group;
  group.name = "Box";
  for (const double x : {-80.0, 80.0})
    for (const double y : {-80.0, 80.0})
      for (const double z : {-80.0, 80.0}) {
        medical_io::HandleRecord handle;
        handle.label = "H" + std::to_string(group.handles.size());
        handle.position = Vec3(x, y, z);
        group.handles.push_back(handle);
      }
  medical_io::writeHandles(folder / "rest.mrk.json", {{group}, {}});
  group.handles.front().position.x() += 10;
  medical_io::writeHandles(folder / "pose.mrk.json", {{group}, {}});
  return {"warp",   folder / "scan.nrrd",     "--handles", folder / "rest.mrk.json",
          "--pose", folder / "pose.mrk.json", "-o"};
}

/// A ball that grows and shrinks, in six phases.
std::vector<std::string> fit(const fs::path& folder) {
  fs::create_directory(folder / "series");
  for (int phase = 0; phase < 6; ++phase)
    medical_io::writeSurface(folder / "series" / ("ball_" + std::to_string(phase) + ".stl"),
                             tests::sphere(4, 40 + 4 * std::min(phase, 6 - phase)));
  return {"track", folder / "series", "--period-ms", "800", "-o"};
}

class KilledCommands : public testing::TestWithParam<Work> {};

TEST_P(KilledCommands, LeaveWhatWasThereBeforeOrTheWholeNewFile) {
  const tests::TemporaryFolder folder;
  const fs::path file = folder / GetParam().file;
  std::vector<std::string> command = {VISCERA_PROGRAM};
  for (const std::string& argument : GetParam().prepare(folder.path()))
    command.push_back(argument);
  command.push_back(file);

  const auto start = Clock::now();
  const test::ProcessResult whole = test::runProcess(command);
  const auto time = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start);
  ASSERT_EQ(whole.exitCode, 0) << whole.err;
  const auto size = fs::file_size(file);
  const auto entries = std::distance(fs::directory_iterator(folder.path()), {});

  std::mt19937 random(7);
  std::uniform_int_distribution<int> when(1, static_cast<int>(time.count()));
  int killed = 0;
  for (int i = 0; i < kills(); ++i) {
    folder.put(GetParam().file, kBefore);
    test::ProcessOptions options;
    options.interruptAfter = std::chrono::milliseconds(when(random));
    options.signal = SIGKILL;
    const test::ProcessResult result = test::runProcess(command, options);
    killed += result.exitCode == 128 + SIGKILL ? 1 : 0;
    if (tests::contentsOf(file) != kBefore) {
      EXPECT_EQ(fs::file_size(file), size) << "half a file after a kill";
    }
  }
  EXPECT_GT(killed, 0) << "the command was never killed while it worked";

  EXPECT_EQ(test::runProcess(command).exitCode, 0) << "what a kill leaves is in nobody's way";
  EXPECT_EQ(fs::file_size(file), size);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), entries)
      << "a kill left something for good";
}

constexpr Work kWorks[] = {{"Record", "breath.ogv", record},
                           {"Export", "lesson.html", exportLesson},
                           {"Warp", "bent.nrrd", warp},
                           {"Fit", "ball.sequence.json", fit}};

INSTANTIATE_TEST_SUITE_P(Commands, KilledCommands, testing::ValuesIn(kWorks),
                         [](const auto& of) { return std::string(of.param.name); });

} // namespace
} // namespace viscera
