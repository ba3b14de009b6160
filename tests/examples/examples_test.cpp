#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "build_paths.h"
#include "least_norm.h"
#include "pulse.h"
#include "viscera/coordinates/binding.h"
#include "viscera/core/progress.h"

namespace viscera::examples {
namespace {

/// The corners of a cube of side 20 mm and one handle beside it.
coordinates::HandleSet handles() {
  Points corners(9, 3);
  for (int i = 0; i < 8; ++i)
    corners.row(i) << (i & 1 ? 10 : -10), (i & 2 ? 10 : -10), (i & 4 ? 10 : -10);
  corners.row(8) << 25, 3, -4;
  return {corners, {}, {}};
}

std::string textOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

} // namespace

TEST(DeveloperGuide, ItsSystemReproducesPointsAndItsGradientsAreThoseOfDifferences) {
  const auto system = leastNormSystem();
  Points points(3, 3);
  points << 1, 2, 3, -4, 5, 0.5, 7, -7, 2;
  Progress progress;
  const auto binding = system->bind(handles(), points, {}, progress);
  EXPECT_LT(binding->report().identityError, 1e-12);
  EXPECT_LT(binding->report().unityError, 1e-13);
  const auto closed = system->gradients(handles(), points, {}, progress);
  const auto differences = system->CoordinateSystem::gradients(handles(), points, {}, progress);
  ASSERT_TRUE(closed.closedForm);
  EXPECT_LT((closed.values - differences.values).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(DeveloperGuide, ItsSequenceComesBackAfterACycle) {
  const Pulse pulse(handles().positions, 0.2);
  Points begin, middle, end;
  pulse.poseAt(0, 75, begin);
  pulse.poseAt(0.4, 75, middle);
  pulse.poseAt(0.8, 75, end);
  EXPECT_LT((begin - handles().positions).norm(), 1e-12);
  EXPECT_LT((end - begin).norm(), 1e-12);
  EXPECT_NEAR((middle.row(0) - middle.row(1)).norm(), 24, 1e-12);
}

TEST(DeveloperGuide, QuotesTheExamplesAsTheyAre) {
  const std::filesystem::path root = VISCERA_SOURCE_DIR;
  const std::string guide = textOf(root / "docs/developer_guide.md");
  const std::string begin = "\n`tests/examples/", fence = "`:\n\n```cpp\n", end = "\n```\n";
  int quotes = 0;
  for (std::size_t at = guide.find(begin); at != guide.npos; at = guide.find(begin, at + 1), ++quotes) {
    const std::size_t code = guide.find(fence, at);
    ASSERT_NE(code, guide.npos);
    const std::string file = guide.substr(at + 2, code - at - 2);
    const std::size_t from = code + fence.size();
    EXPECT_EQ(guide.substr(from, guide.find(end, from) + 1 - from), textOf(root / file))
        << file << " has changed; quote it anew in docs/developer_guide.md";
  }
  EXPECT_EQ(quotes, 9);
}

} // namespace viscera::examples
