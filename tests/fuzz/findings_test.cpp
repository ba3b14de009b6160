#include <algorithm>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "fuzz_target.h"
#include "temporary_folder.h"
#include "viscera/core/error.h"

/// Runs every seed, and every input that a fuzzer once found a fault with, in each build.
namespace viscera::fuzz {
namespace {

class FuzzFindings : public testing::TestWithParam<Target> {
protected:
  static bool accepts(const std::string& input) {
    try {
      GetParam().run({reinterpret_cast<const std::uint8_t*>(input.data()), input.size()});
      return true;
    } catch (const Error& refusal) {
      EXPECT_FALSE(refusal.problem().empty());
      return false;
    }
  }
};

TEST_P(FuzzFindings, AreReadOrRefused) {
  const std::filesystem::path folder =
      std::filesystem::path(VISCERA_SOURCE_DIR) / "tests/fuzz/findings" / GetParam().name;
  if (!std::filesystem::exists(folder))
    return;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().filename());
    accepts(tests::contentsOf(entry.path()));
  }
}

TEST_P(FuzzFindings, BeginWithSeedsThatAreRead) {
  const std::vector<std::string> seeds = GetParam().seeds();
  ASSERT_FALSE(seeds.empty());
  const auto accepted = std::count_if(seeds.begin(), seeds.end(), accepts);
  if (GetParam().name != "plugins") { // What is no plugin is refused in the end.
    EXPECT_GE(2 * accepted, static_cast<std::ptrdiff_t>(seeds.size()));
  }
}

std::string nameOf(const testing::TestParamInfo<Target>& instance) {
  return instance.param.name;
}
INSTANTIATE_TEST_SUITE_P(OfReader, FuzzFindings, testing::ValuesIn(readerTargets()), nameOf);
INSTANTIATE_TEST_SUITE_P(OfProgram, FuzzFindings, testing::ValuesIn(programTargets()), nameOf);

} // namespace
} // namespace viscera::fuzz
