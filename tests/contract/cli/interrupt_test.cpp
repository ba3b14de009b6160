#include <chrono>

#include "cli_test.h"

namespace viscera::app::cli {

/// Ctrl+C during long work. Where in the work it comes depends on the machine; what it leaves must not.
class CliInterrupt : public CliTest, public testing::WithParamInterface<int> {};

TEST_P(CliInterrupt, LeavesNothingHalfWritten) {
  options_.environment["XDG_CACHE_HOME"] = path("cache"); // Nothing is there: the organ has to be made.
  const test::ProcessResult result =
      interrupted({"sample", "stomach_and_bowel@high", "-o", path("d.vtp"), "--json"},
                  std::chrono::milliseconds(GetParam()), {"d.vtp", "cache"});
  ASSERT_EQ(result.exitCode, kCancelled) << result.err;
  expectError(result.out, kCancelled);
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_FALSE(std::filesystem::exists(path("d.vtp")));
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_))
    EXPECT_FALSE(entry.is_regular_file()) << entry.path() << " was left behind";
}

INSTANTIATE_TEST_SUITE_P(AfterMilliseconds, CliInterrupt, testing::Values(1500, 3000));

} // namespace viscera::app::cli
