#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "build_paths.h"
#include "cli_test.h"

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

} // namespace

/// The numbers of README.md that do not depend on the machine; resources/scripts/measure_readme.sh prints
/// all.
class Readme : public CliTest {
protected:
  void expectSaid(const std::string& figure) const {
    EXPECT_NE(contents(VISCERA_SOURCE_DIR "/README.md").find(figure), std::string::npos)
        << "README.md should say: " << figure;
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

} // namespace viscera::app::cli
