#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "label_files.h"
#include "run_process.h"
#include "shapes.h"
#include "temporary_folder.h"
#include "viscera/medical_io/surface_file.h"

/// Commands that may map less memory than they want (`ulimit -v`): each ends with a result or with a
/// sentence.
namespace viscera {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMegabyte = std::size_t{1} << 20U;

struct Hungry {
  const char* name;
  std::vector<std::string> (*prepare)(const fs::path& folder);
};

void PrintTo(const Hungry& hungry, std::ostream* stream) {
  *stream << hungry.name;
}

fs::path ballIn(const fs::path& folder, int levels) {
  medical_io::writeSurface(folder / "ball.stl", tests::sphere(levels, 60));
  return folder / "ball.stl";
}

std::vector<std::string> look(const fs::path& folder) {
  return {"info", ballIn(folder, 7)};
}

std::vector<std::string> place(const fs::path& folder) {
  return {"handles", ballIn(folder, 7), "--count", "200", "-o", folder / "handles.mrk.json"};
}

std::vector<std::string> segment(const fs::path& folder) {
  tests::LabelImage labels = tests::emptyLabels({160, 160, 160});
  tests::addBall(labels, Vec3(80, 80, 80), 60, 1);
  std::ofstream(folder / "labels.nii", std::ios::binary) << tests::niftiFile(labels);
  return {"segment", folder / "labels.nii", "-o", folder / "surfaces"};
}

std::vector<std::string> play(const fs::path& folder) {
  return {"play", "breathing", "--csv", folder / "volumes.csv"};
}

class ShortOfMemory : public testing::TestWithParam<Hungry> {
protected:
  static test::ProcessResult run(const std::vector<std::string>& arguments, std::size_t bytes) {
    std::vector<std::string> command = {VISCERA_PROGRAM};
    command.insert(command.end(), arguments.begin(), arguments.end());
    test::ProcessOptions options;
    options.addressSpace = bytes;
    // OpenMP's own library ends a program for which it cannot make a thread.
    options.environment["OMP_NUM_THREADS"] = "1";
    return test::runProcess(command, options);
  }
  /// What the program and its libraries take without any work, in steps of 8 MB.
  static std::size_t least() {
    std::size_t bytes = 64 * kMegabyte;
    while (run({"--version"}, bytes).exitCode != 0)
      bytes += 8 * kMegabyte;
    return bytes;
  }
};

TEST_P(ShortOfMemory, EndsWithAResultOrASentence) {
  const tests::TemporaryFolder folder;
  const std::vector<std::string> arguments = GetParam().prepare(folder.path());
  std::size_t bytes = least();
  bool refused = false;
  for (std::size_t step = 4 * kMegabyte;; bytes += step, step = step * 3 / 2) {
    const test::ProcessResult result = run(arguments, bytes);
    SCOPED_TRACE(testing::Message() << bytes / kMegabyte << " MB: exit code " << result.exitCode << ", "
                                    << result.err);
    if (result.exitCode == 0)
      break;
    refused = true;
    ASSERT_LT(result.exitCode, 126) << "a signal ended it, or it could not begin";
    // VTK may have told of it before, in its own words.
    const std::size_t sentence = result.err.rfind("viscera: ");
    ASSERT_NE(sentence, std::string::npos) << "nothing was said";
    ASSERT_EQ(result.err.find("viscera: "), sentence) << "said twice";
    ASSERT_EQ(result.err.find('\n', sentence), result.err.size() - 1) << "not one sentence";
    ASSERT_NE(result.err.find("memory"), std::string::npos);
    ASSERT_LT(bytes, std::size_t{16} << 30U);
  }
  EXPECT_TRUE(refused) << "the command was never short of memory";
}

constexpr Hungry kCommands[] = {{"Info", look}, {"Handles", place}, {"Segment", segment}, {"Play", play}};

INSTANTIATE_TEST_SUITE_P(Commands, ShortOfMemory, testing::ValuesIn(kCommands),
                         [](const auto& of) { return std::string(of.param.name); });

} // namespace
} // namespace viscera
