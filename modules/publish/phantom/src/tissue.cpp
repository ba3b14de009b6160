#include "viscera/phantom/tissue.h"

#include <cmath>
#include <numbers>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::phantom {
namespace {

constexpr double kFlipAngle = std::numbers::pi / 3;
constexpr double kSignalOfOne = 1000;

/// Stanisz and others 2005; de Bazelaire and others 2004; both at 1.5 T.
constexpr const char* kStanisz = "doi 10.1002/mrm.20605";
constexpr const char* kBazelaire = "doi 10.1148/radiol.2303021331";
constexpr const char* kChosen = "chosen";

} // namespace

const std::vector<Tissue>& tissues() {
  static const std::vector<Tissue> list = {
      {"air", 0, -1000, 0, 1000, 1000, 0, 0, kChosen, true, {0, 0, 0}},
      {"body", 1, 40, 12, 1008, 44, 0.9, 0.12, kStanisz, true, {0.8, 0.65, 0.5}},
      {"fat", 2, -95, 12, 343, 58, 0.9, 0.08, kBazelaire, false, {0.9, 0.82, 0.5}},
      {"right lung", 3, -840, 40, 1000, 40, 0.15, 0.25, kChosen, false, {0.85, 0.64, 0.62}},
      {"left lung", 4, -840, 40, 1000, 40, 0.15, 0.25, kChosen, false, {0.85, 0.64, 0.62}},
      {"liver", 5, 75, 12, 576, 46, 0.9, 0.12, kStanisz, false, {0.57, 0.28, 0.22}},
      {"spleen", 6, 110, 12, 1057, 79, 0.9, 0.12, kBazelaire, false, {0.52, 0.25, 0.33}},
      {"pancreas", 7, 90, 12, 584, 46, 0.9, 0.12, kBazelaire, false, {0.88, 0.69, 0.46}},
      {"stomach", 8, 25, 10, 1500, 250, 0.9, 0.1, kChosen, false, {0.84, 0.54, 0.49}},
      {"right kidney", 9, 170, 15, 690, 55, 0.9, 0.12, kStanisz, false, {0.6, 0.25, 0.2}},
      {"left kidney", 10, 170, 15, 690, 55, 0.9, 0.12, kStanisz, false, {0.6, 0.25, 0.2}},
      {"myocardium", 11, 110, 12, 1030, 40, 0.9, 0.15, kStanisz, false, {0.64, 0.23, 0.2}},
      {"right atrium", 12, 300, 8, 1441, 290, 1, 0.04, kStanisz, false, {0.35, 0.4, 0.7}},
      {"left atrium", 13, 380, 8, 1441, 290, 1, 0.04, kStanisz, false, {0.8, 0.3, 0.3}},
      {"right ventricle", 14, 300, 8, 1441, 290, 1, 0.04, kStanisz, false, {0.3, 0.35, 0.75}},
      {"left ventricle", 15, 380, 8, 1441, 290, 1, 0.04, kStanisz, false, {0.85, 0.25, 0.25}},
      {"spine", 16, 250, 30, 549, 49, 0.6, 0.15, kBazelaire, true, {0.9, 0.85, 0.72}},
  };
  return list;
}

const Tissue& tissueNamed(const std::string& name) {
  for (const Tissue& tissue : tissues())
    if (tissue.name == name)
      return tissue;
  throw UsageError(misuse("the phantom has no tissue \"%1\"", name));
}

double steadyStateSignal(const Tissue& tissue) {
  const double cosine = std::cos(kFlipAngle);
  return kSignalOfOne * tissue.protons * std::sin(kFlipAngle) /
         (1 + cosine + (1 - cosine) * tissue.t1Ms / tissue.t2Ms);
}

} // namespace viscera::phantom
