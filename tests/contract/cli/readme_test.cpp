#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <map>
#include <regex>
#include <sstream>

#include "bench_scenes.h"
#include "build_paths.h"
#include "cli_test.h"
#include "shared_organs.h"

namespace viscera::app::cli {
namespace {

[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...) {
  std::array<char, 256> text{};
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(text.data(), text.size(), format, arguments);
  va_end(arguments);
  return text.data();
}

/// "35,947"; for numbers from a thousand to a million.
std::string withComma(Eigen::Index number) {
  return formatted("%d,%03d", static_cast<int>(number / 1000), static_cast<int>(number % 1000));
}

} // namespace

/// The numbers of README.md that do not depend on the machine; resources/scripts/measure_readme.sh prints
/// all.
class Readme : public CliTest {
protected:
  static std::string readme() { return contents(VISCERA_SOURCE_DIR "/README.md"); }

  static void expectSaid(const std::string& figure) {
    EXPECT_NE(readme().find(figure), std::string::npos) << "README.md should say: " << figure;
  }

  /// The number in the README that the group of `pattern` matches.
  static double numberSaid(const std::string& pattern) {
    std::smatch found;
    const std::string text = readme();
    if (!std::regex_search(text, found, std::regex(pattern)))
      ADD_FAILURE() << "README.md should have " << pattern;
    return found.empty() ? std::nan("") : std::stod(found[1]);
  }

  /// The organs of the rows about binding; the last one lies beside the project and may be absent.
  static std::vector<std::string> boundOrgans() {
    std::vector<std::string> organs{"sample:heart", "sample:stomach", "sample:liver", "sample:kidney_left"};
    const std::string bunny = VISCERA_SHARED_ORGANS "/bunny.obj";
    if (std::filesystem::exists(bunny))
      organs.push_back(bunny);
    return organs;
  }
};

TEST_F(Readme, SaysTheVolumesOfTheBeatAsTheyAreMeasured) {
  const json beat = runJson({"play", "heartbeat"});
  const auto ml = [&](const char* surface, const char* key) {
    return beat["volumes"][surface][key].get<double>();
  };
  expectSaid(formatted("| %.1f to %.1f ml, ejection fraction %.3f |", ml("lv", "maxMl"), ml("lv", "minMl"),
                       beat["ejectionFraction"].get<double>()));
  expectSaid(formatted("| %.1f to %.1f ml; changes by %.1f %% at most; by %.1f %% |", ml("rv", "maxMl"),
                       ml("rv", "minMl"), 100 * beat["maxRelativeOuterChange"].get<double>(),
                       100 * beat["leftVentricularMuscle"]["maxRelativeChange"].get<double>()));
}

TEST_F(Readme, SaysTheStomachsVolumeAsItIsMeasured) {
  const json waves = runJson({"play", "peristalsis", "--fps", "0.5"});
  expectSaid(formatted("| %.1f ml in every frame |", waves["volumes"]["outer"]["minMl"].get<double>()));
  EXPECT_LT(waves["maxRelativeOuterChange"].get<double>(), 1e-9);
}

TEST_F(Readme, SaysTheErrorsOfCoordinatesAsTheyAreMeasured) {
  double identity = 0, unity = 0, least = 1;
  for (const std::string& organ : boundOrgans()) {
    runJson({"handles", organ, "-o", path("h.mrk.json"), "--count", "30"});
    const json bound = runJson({"bind", organ, "--handles", path("h.mrk.json")});
    EXPECT_EQ(bound["failures"], 0) << organ;
    if (organ == "sample:liver")
      expectSaid("the liver's " + withComma(bound["vertices"].get<int>()) + " vertices");
    identity = std::max(identity, bound["identityError"].get<double>());
    unity = std::max(unity, bound["unityError"].get<double>());
    least = std::min(least, bound["minWeight"].get<double>());
  }
  // Rounding errors depend a little on the width of the processor's vectors.
  EXPECT_LT(identity, 2 * numberSaid(R"(\| ([-0-9.e]+) of the diagonal \|)"));
  EXPECT_LT(unity, 2 * numberSaid(R"(\| ([-0-9.e]+), \+[0-9.]+, none \|)"));
  expectSaid(formatted(", %+.4f, none |", least));
}

/// The time depends on the machine, but not what follows from it.
TEST_F(Readme, DividesTheTimeOfBindingByVerticesAndHandles) {
  const std::string row = R"(binding the liver's 14,716 vertices \| )";
  const double ms = numberSaid(row + R"(([0-9.]+) ms, that is [0-9.]+ ns a vertex and handle \|)");
  const double ns = numberSaid(row + R"([0-9.]+ ms, that is ([0-9.]+) ns a vertex and handle \|)");
  const double handles = numberSaid(R"(bunny, ([0-9]+) handles: identity error)");
  runJson({"handles", "sample:liver", "-o", path("h.mrk.json"), "--count", "30"});
  const json bound = runJson({"bind", "sample:liver", "--handles", path("h.mrk.json")});
  EXPECT_EQ(bound["vertices"], 14716);
  EXPECT_EQ(bound["handles"], handles);
  EXPECT_NEAR(ns, ms * 1e6 / (14716 * handles), 0.05 * ns);
}

TEST_F(Readme, SaysTheErrorOfALockedVolumeAsItIsMeasured) {
  const std::string rest = path("rest.mrk.json");
  runJson({"handles", "sample:liver", "-o", rest, "--count", "30"});
  json rig = json::parse(contents(rest));
  json& x = rig.at("markups").back().at("controlPoints").at(2).at("position").at(0);
  x = x.get<double>() + 12;
  const json bent = runJson({"deform", "sample:liver", "--handles", rest, "--pose",
                             put("pose.mrk.json", rig.dump()), "--lock-volume"});
  EXPECT_LT(std::abs(bent["relativeVolumeError"].get<double>()),
            numberSaid(R"(\| a locked deformation's volume error \| below ([-0-9.e]+) \|)"));
  EXPECT_GT(bent["maxDisplacementMm"].get<double>(), 1) << "nothing was deformed";
}

/// The rows themselves are held by `CliReproduce`.
TEST_F(Readme, CountsTheVerdictsOfTheDocumentation) {
  std::istringstream rows(contents(VISCERA_SOURCE_DIR "/docs/reproduction.md"));
  int holds = 0, differs = 0, refuted = 0;
  for (std::string row; std::getline(rows, row);)
    if (row.starts_with("| Figure ") || row.starts_with("| Table ")) {
      holds += row.ends_with("| holds |") ? 1 : 0;
      differs += row.ends_with("| differs |") ? 1 : 0;
      refuted += row.ends_with("| does not hold |") ? 1 : 0;
    }
  EXPECT_GT(holds + differs, 20);
  expectSaid(formatted("| %d; %d; %d |", holds, differs, refuted));
}

/// S-, T- and localised S-Celestial have lines of their own.
TEST_F(Readme, CountsTheFurtherSystems) {
  const std::map<std::ptrdiff_t, std::string> words = {
      {16, "Sixteen"}, {17, "Seventeen"}, {18, "Eighteen"}, {19, "Nineteen"}, {20, "Twenty"}};
  const json result = runJson({"systems"});
  const json& systems = result.at("systems");
  const std::ptrdiff_t further = std::count_if(systems.begin(), systems.end(), [](const json& system) {
    const std::string id = system.at("id");
    return id != "s-celestial" && id != "t-celestial" && !id.starts_with("localised");
  });
  ASSERT_EQ(words.count(further), 1u) << further;
  expectSaid("* " + words.at(further) + " further systems");
}

TEST_F(Readme, SaysTheSizesOfTheSurfacesThatBenchmarksTake) {
  const std::string most = withComma(bench::largeBlob().points.rows());
  expectSaid("dragging one handle of " + most + " vertices");
  EXPECT_EQ(bench::largeBlob().points.rows(), bench::kMostVertices);
  expectSaid("of a heart of " + withComma(bench::kMostVertices) + " vertices");
}

TEST_F(Readme, SaysTheSizeOfTheBunny) {
  const auto bunny = tests::bunny(VISCERA_SHARED_ORGANS);
  if (!bunny)
    GTEST_SKIP() << "bunny.obj is not there";
  const std::string vertices = withComma(bunny->points.rows());
  expectSaid("S-Celestial binding of " + vertices + " vertices");
  expectSaid("localised coordinates of " + vertices + " vertices");
}

TEST_F(Readme, CountsTheLabelsAndTrianglesOfTheAtlas) {
  const std::string atlas = VISCERA_SHARED_ORGANS "/abdomen_seg.nrrd";
  if (!std::filesystem::exists(atlas))
    GTEST_SKIP() << "abdomen_seg.nrrd is not there";
  const json result = runJson({"segment", atlas, "-o", path("organs")});
  const json& organs = result.at("organs");
  double triangles = 0;
  for (const json& organ : organs)
    triangles += organ.at("triangles").get<double>();
  expectSaid(formatted("(%d labels;", static_cast<int>(organs.size())));
  expectSaid(formatted("all surfaces, %.0f,000 triangles,", triangles / 1000));
}

} // namespace viscera::app::cli
