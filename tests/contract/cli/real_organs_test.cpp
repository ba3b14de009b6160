#include "build_paths.h"
#include "cli_test.h"

namespace viscera::app::cli {

/// Thirty automatic handles around whole organs, at the resolution that a user gets.
class CliRealOrgans : public CliTest, public testing::WithParamInterface<std::string> {
protected:
  static constexpr double kIdentityLimit = 1e-9; ///< Of the organ's diagonal.
  static constexpr double kUnityLimit = 1e-12;

  /// ORGAN as the command line takes it, or empty when the file is not there.
  static std::string organ() {
    const std::string name = GetParam();
    if (name.starts_with("sample:"))
      return name;
    const std::string file = std::string(VISCERA_SHARED_ORGANS) + "/" + name;
    return std::filesystem::exists(file) ? file : std::string();
  }
};

TEST_P(CliRealOrgans, BindWithinTheLimitsWhateverTheThreads) {
  if (organ().empty())
    GTEST_SKIP() << GetParam() << " is not there";
  const std::string handles = path("h.mrk.json");
  const json placed = runJson({"handles", organ(), "-o", handles, "--count", "30", "--enclosing"});
  EXPECT_EQ(placed["handles"], 30);
  EXPECT_EQ(placed["outsideHull"], 0);
  std::vector<std::string> weights;
  for (const std::string threads : {"1", "2", "3"}) {
    const std::string file = path("w" + threads + ".npy");
    const json bound = runJson(
        {"bind", organ(), "--handles", handles, "--system", "s-celestial", "-o", file, "--threads", threads});
    EXPECT_LE(bound["identityError"].get<double>(), kIdentityLimit);
    EXPECT_LE(bound["unityError"].get<double>(), kUnityLimit);
    EXPECT_GE(bound["minWeight"].get<double>(), 0);
    EXPECT_EQ(bound["failures"], 0);
    EXPECT_EQ(bound["handles"], 30);
    weights.push_back(contents(file));
  }
  EXPECT_TRUE(weights[0] == weights[1] && weights[0] == weights[2]) << "coordinates depend on the threads";
}

INSTANTIATE_TEST_SUITE_P(Organs, CliRealOrgans,
                         testing::Values("sample:heart", "sample:stomach", "liver.vtk", "kidney_left.vtk",
                                         "bunny.obj"),
                         [](const testing::TestParamInfo<std::string>& organ) {
                           std::string name = organ.param;
                           std::replace_if(
                               name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); },
                               '_');
                           return name;
                         });

} // namespace viscera::app::cli
