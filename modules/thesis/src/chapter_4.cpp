#include "figures.h"
#include "line_figure.h"
#include "viscera/coordinates/measure/line_profile.h"
#include "viscera/core/text.h"
#include "viscera/thesis/measured_scenes.h"

namespace viscera::thesis {
namespace {

using enum Expect;

Panel sampled(const char* name, const char* samples) {
  return {name, "c-celestial", {{"sampling", "sphere"}, {"samples", samples}}, 15, {}, false, true};
}

std::vector<Finding> smootherWithSamples(const std::vector<PanelResult>& panels) {
  std::vector<Finding> findings;
  for (std::size_t i = 1; i < panels.size(); ++i) {
    const double before = coordinates::roughness(coordinatesWithGaps(panels[i - 1])),
                 after = coordinates::roughness(coordinatesWithGaps(panels[i]));
    findings.push_back(
        {"three times the samples (" + std::string(1, static_cast<char>('a' + i - 1)) + " to " +
             std::string(1, static_cast<char>('a' + i)) + ") make the curves less rough",
         "a roughness of " + significant(before) + " and then " + significant(after), after < before});
  }
  const auto gaps = panels.back().profile.report.failures.size();
  findings.push_back(
      {"coordinates at every point with most samples", std::to_string(gaps) + " points without", gaps == 0});
  return findings;
}

LineFigure figure41() {
  return {
      "4.1",
      "C-Celestial coordinates",
      "With more Monte Carlo samples the coordinates become softer, and the number needed is overwhelming.",
      kOwnHandles +
          "Samples thrown at the unit sphere as in the thesis, of which most are lost; the program's "
          "standard is a walk inside the cone, which loses none.",
      {sampled("30,000 samples", "30000"), sampled("100,000 samples", "100000"),
       sampled("300,000 samples", "300000")},
      smootherWithSamples};
}

LineFigure figure44() {
  return {"4.4",
          "T-Celestial coordinates",
          "The coordinates are positive, continuous and smooth.",
          kOwnHandles,
          {{"T-Celestial", "t-celestial", {}, 15, {everywhere, positive, smooth}}}};
}

std::vector<Finding> likeEachOther(const std::vector<PanelResult>& panels) {
  constexpr double kSimilar = 0.05;
  const double apart = (panels[0].profile.coordinates - panels[1].profile.coordinates).cwiseAbs().maxCoeff();
  return {{"S- and T-Celestial differ by less than " + significant(kSimilar), significant(apart) + " at most",
           apart < kSimilar}};
}

LineFigure figure411() {
  return {"4.11",
          "S-Celestial coordinates",
          "The coordinates are positive, continuous and smooth, extremely similar to T-Celestial; a handle's "
          "influence does not always fall with the distance.",
          kOwnHandles,
          {{"T-Celestial", "t-celestial", {}, 15, {}},
           {"S-Celestial", "s-celestial", {}, 15, {everywhere, positive, smooth, severalMaxima}}},
          likeEachOther};
}

} // namespace

std::vector<Item> chapter4() {
  return {itemOf(figure41()),         itemOf(figure44()),         {"4.5", false, figure45},
          {"4.6", false, figure46},   itemOf(figure411()),        {"4.12", false, figure412},
          {"4.18", false, figure418}, {"4.23", false, figure423}, {"4.1", true, table41},
          {"4.2", true, table42}};
}

} // namespace viscera::thesis
