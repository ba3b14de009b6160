#include "viscera/circulation/parameters.h"

#include <algorithm>
#include <cmath>

#include "viscera/core/edit_distance.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"

#include "circuit.h"

namespace viscera::circulation {
namespace {

/// A parameter and where it lies.
struct Entry {
  ParameterInfo info;
  double& (*of)(Parameters&);
};

constexpr auto kFitted = "fitted to the values at rest";
constexpr auto kBurkhoff = "form: doi 10.1152/ajpheart.1993.265.5.H1819; value fitted to the values at rest";
constexpr auto kAtria =
    "form: doi 10.1152/ajpheart.1993.265.5.H1819; value: largest and stroke volume of atria, "
    "doi 10.1080/10976640500295516";
constexpr auto kWindkessel = "form: doi 10.1007/s11517-008-0359-2; value fitted to the values at rest";
constexpr auto kValveForm = "form: doi 10.1002/cnm.1466; normal areas: doi 10.1016/j.echo.2017.02.009";
constexpr auto kLeakForm = "grades: doi 10.1016/j.echo.2017.01.007";
constexpr auto kPericardium =
    "form: Sun and others, Am J Physiol 1997;272:H1499-H1515; value chosen to be slack at rest";
constexpr auto kElastance =
    "0.4 to 8.4 in patients: doi 10.1016/S0735-1097(01)01651-5; value fitted to the values at rest";
constexpr auto kRelaxation = "35 +- 10 ms in healthy people: doi 10.1056/NEJMoa032566";

constexpr auto kAreas = "effective areas of normal valves: doi 10.1016/j.echo.2017.02.009";
constexpr auto kMildAortic = "mild regurgitation is below 0.1 cm2: doi 10.1016/j.echo.2017.01.007";
constexpr auto kMildMitral = "mild regurgitation is below 0.2 cm2: doi 10.1016/j.echo.2017.01.007";

/// The range of model parameters that cannot be measured: a fifth to either side.
NormalValues aboutRest(double rest) {
  return {0.8 * rest, 1.2 * rest, "20 % around the healthy adult at rest"};
}

#define VISCERA_AT(MEMBER) [](Parameters& p) -> double& { return p.MEMBER; }

const std::vector<Entry>& entries() {
  static const std::vector<Entry> table = {
      {{"rate", "Heart rate", "1/min", 72, 30, 200, "chosen", true,
        NormalValues{60, 100, "sinus rhythm at rest"}},
       VISCERA_AT(rate)},
      {{"stressedVolume", "Preload: stressed blood volume", "ml", 975, 300, 2000, kFitted, true,
        aboutRest(975)},
       VISCERA_AT(stressedVolume)},
      {{"systemicResistance", "Afterload: systemic resistance", "mmHg s/ml", 1, 0.2, 4, kWindkessel, true,
        NormalValues{0.6, 1.2, "800 to 1600 dyn s cm^-5, customary at the bedside"}},
       VISCERA_AT(systemic.resistance)},
      {{"pulmonaryResistance", "Afterload: pulmonary resistance", "mmHg s/ml", 0.08, 0.02, 1.5, kWindkessel,
        true, NormalValues{0.02, 0.12, "up to 2 Wood units"}},
       VISCERA_AT(pulmonary.resistance)},
      {{"lvEes", "Contractility of the left ventricle", "mmHg/ml", 2.18, 0.3, 8, kElastance, true,
        aboutRest(2.18)},
       VISCERA_AT(lv.ees)},
      {{"rvEes", "Contractility of the right ventricle", "mmHg/ml", 0.45, 0.1, 3, kBurkhoff, true,
        aboutRest(0.45)},
       VISCERA_AT(rv.ees)},
      {{"lvB", "Stiffness of the left ventricle", "1/ml", 0.017, 0.01, 0.08, kBurkhoff, true,
        aboutRest(0.017)},
       VISCERA_AT(lv.b)},
      {{"aorticArea", "Aortic valve, open", "cm2", 4, 0.3, 6, kValveForm, true, NormalValues{3, 4, kAreas}},
       VISCERA_AT(aortic.open)},
      {{"aorticLeak", "Aortic valve, leak", "cm2", 0, 0, 1, kLeakForm, true,
        NormalValues{0, 0.1, kMildAortic}},
       VISCERA_AT(aortic.leak)},
      {{"mitralArea", "Mitral valve, open", "cm2", 5, 0.5, 8, kValveForm, true, NormalValues{4, 6, kAreas}},
       VISCERA_AT(mitral.open)},
      {{"mitralLeak", "Mitral valve, leak", "cm2", 0, 0, 1, kLeakForm, true,
        NormalValues{0, 0.2, kMildMitral}},
       VISCERA_AT(mitral.leak)},
      {{"pericardialFluid", "Fluid in the pericardium", "ml", 0, 0, 600, "0 in health", true,
        NormalValues{0, 50, "the amount in a healthy heart"}},
       VISCERA_AT(pericardialFluid)},
      {{"lvV0", "Left ventricle, volume without pressure", "ml", 6, 0, 60, kBurkhoff}, VISCERA_AT(lv.v0)},
      {{"lvA", "Left ventricle, scale of the passive filling curve", "mmHg", 1.5, 0.01, 5, kBurkhoff},
       VISCERA_AT(lv.a)},
      {{"lvTau", "Left ventricle, relaxation", "s", 0.035, 0.01, 0.12, kRelaxation}, VISCERA_AT(lv.tau)},
      {{"rvV0", "Right ventricle, volume without pressure", "ml", 15, 0, 60, kBurkhoff}, VISCERA_AT(rv.v0)},
      {{"rvA", "Right ventricle, scale of the passive filling curve", "mmHg", 0.6, 0.01, 5, kBurkhoff},
       VISCERA_AT(rv.a)},
      {{"rvB", "Right ventricle, steepness of the passive filling curve", "1/ml", 0.018, 0.005, 0.08,
        kBurkhoff},
       VISCERA_AT(rv.b)},
      {{"rvTau", "Right ventricle, relaxation", "s", 0.035, 0.01, 0.12, kRelaxation}, VISCERA_AT(rv.tau)},
      {{"laEes", "Left atrium, contractility", "mmHg/ml", 0.38, 0, 2, kBurkhoff}, VISCERA_AT(la.ees)},
      {{"laV0", "Left atrium, volume without pressure", "ml", 20, 0, 60, kAtria}, VISCERA_AT(la.v0)},
      {{"laA", "Left atrium, scale of the passive filling curve", "mmHg", 2, 0.005, 5, kBurkhoff},
       VISCERA_AT(la.a)},
      {{"laB", "Left atrium, steepness of the passive filling curve", "1/ml", 0.0245, 0.005, 0.1, kBurkhoff},
       VISCERA_AT(la.b)},
      {{"laTau", "Left atrium, relaxation", "s", 0.02, 0.005, 0.1, kBurkhoff}, VISCERA_AT(la.tau)},
      {{"raEes", "Right atrium, contractility", "mmHg/ml", 0.25, 0, 2, kBurkhoff}, VISCERA_AT(ra.ees)},
      {{"raV0", "Right atrium, volume without pressure", "ml", 30, 0, 60, kAtria}, VISCERA_AT(ra.v0)},
      {{"raA", "Right atrium, scale of the passive filling curve", "mmHg", 1, 0.005, 5, kBurkhoff},
       VISCERA_AT(ra.a)},
      {{"raB", "Right atrium, steepness of the passive filling curve", "1/ml", 0.027, 0.005, 0.1, kBurkhoff},
       VISCERA_AT(ra.b)},
      {{"raTau", "Right atrium, relaxation", "s", 0.02, 0.005, 0.1, kBurkhoff}, VISCERA_AT(ra.tau)},
      {{"conduction", "From atrial to ventricular contraction", "s", 0.14, 0.05, 0.3,
        "between the contractions of both, shorter than the PR interval of 0.12 to 0.20 s"},
       VISCERA_AT(conduction)},
      {{"systemicImpedance", "Aorta, characteristic impedance", "mmHg s/ml", 0.03, 0.001, 0.3, kWindkessel},
       VISCERA_AT(systemic.impedance)},
      {{"systemicCompliance", "Systemic arteries, compliance", "ml/mmHg", 1.95, 0.3, 6, kWindkessel},
       VISCERA_AT(systemic.arteryCompliance)},
      {{"systemicVeinCompliance", "Systemic veins, compliance", "ml/mmHg", 70, 10, 200, kFitted},
       VISCERA_AT(systemic.veinCompliance)},
      {{"systemicVeinResistance", "Systemic veins, resistance", "mmHg s/ml", 0.025, 0.005, 0.3, kFitted},
       VISCERA_AT(systemic.veinResistance)},
      {{"pulmonaryImpedance", "Pulmonary artery, characteristic impedance", "mmHg s/ml", 0.02, 0.001, 0.3,
        kWindkessel},
       VISCERA_AT(pulmonary.impedance)},
      {{"pulmonaryCompliance", "Pulmonary arteries, compliance", "ml/mmHg", 6.5, 0.5, 20, kWindkessel},
       VISCERA_AT(pulmonary.arteryCompliance)},
      {{"pulmonaryVeinCompliance", "Pulmonary veins, compliance", "ml/mmHg", 8, 1, 60, kFitted},
       VISCERA_AT(pulmonary.veinCompliance)},
      {{"pulmonaryVeinResistance", "Pulmonary veins, resistance", "mmHg s/ml", 0.015, 0.002, 0.3, kFitted},
       VISCERA_AT(pulmonary.veinResistance)},
      {{"tricuspidArea", "Tricuspid valve, open", "cm2", 6, 0.5, 10, kValveForm}, VISCERA_AT(tricuspid.open)},
      {{"tricuspidLeak", "Tricuspid valve, leak", "cm2", 0, 0, 1, kLeakForm}, VISCERA_AT(tricuspid.leak)},
      {{"pulmonicArea", "Pulmonary valve, open", "cm2", 4, 0.3, 6, kValveForm}, VISCERA_AT(pulmonic.open)},
      {{"pulmonicLeak", "Pulmonary valve, leak", "cm2", 0, 0, 1, kLeakForm}, VISCERA_AT(pulmonic.leak)},
      {{"pericardialRoom", "Volume that the pericardium holds without pressure", "ml", 520, 200, 1500,
        kPericardium},
       VISCERA_AT(pericardialRoom)},
      {{"pericardialScale", "Added volume that multiplies pericardial pressure by e", "ml", 40, 10, 200,
        kPericardium},
       VISCERA_AT(pericardialScale)},
  };
  return table;
}

#undef VISCERA_AT

const Entry& entry(const std::string& name) {
  const auto& table = entries();
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Entry& e) { return e.info.name == name; });
  if (found != table.end())
    return *found;
  const auto nearest = std::min_element(table.begin(), table.end(), [&](const Entry& a, const Entry& b) {
    return editDistance(a.info.name, name) < editDistance(b.info.name, name);
  });
  throw UsageError(misuse("the circulation has no parameter of that name"), name,
                   misuse("the nearest is %1; docs/circulation.md lists all", nearest->info.name));
}

void checkRange(const ParameterInfo& info, double value) {
  if (!(value >= info.lowest && value <= info.highest))
    throw UsageError(
        phrase("%1 is out of its range", named(info.title)), info.name + "=" + significant(value, 6),
        info.unit.empty() ? phrase("from %1 to %2", inDigits(info.lowest, 6), inDigits(info.highest, 6))
                          : phrase("from %1 to %2 %3", inDigits(info.lowest, 6), inDigits(info.highest, 6),
                                   named(info.unit)));
}

} // namespace

Parameters::Parameters() {
  for (const Entry& e : entries())
    e.of(*this) = e.info.rest;
}

const std::vector<ParameterInfo>& parameterInfos() {
  static const std::vector<ParameterInfo> infos = [] {
    std::vector<ParameterInfo> all;
    for (const Entry& e : entries())
      all.push_back(e.info);
    return all;
  }();
  return infos;
}

std::string parameterTable() {
  std::string table = "| parameter | what it is | at rest | range | source |\n|---|---|---|---|---|\n";
  for (const ParameterInfo& info : parameterInfos())
    table += "| `" + info.name + "` | " + info.title + " | " + significant(info.rest, 4) + " " + info.unit +
             " | " + significant(info.lowest, 4) + " to " + significant(info.highest, 4) + " | " +
             info.source + " |\n";
  return table;
}

double parameter(const Parameters& parameters, const std::string& name) {
  Parameters copy = parameters;
  return entry(name).of(copy);
}

void setParameter(Parameters& parameters, const std::string& name, double value) {
  const Entry& found = entry(name);
  checkRange(found.info, value);
  found.of(parameters) = value;
}

void checkParameters(const Parameters& parameters) {
  Parameters copy = parameters;
  for (const Entry& e : entries())
    checkRange(e.info, e.of(copy));
  const auto check = [](const ValveAreas& valve, const std::string& name) {
    if (valve.leak >= valve.open)
      throw UsageError("the leak area must be smaller than the area of the open valve", name,
                       phrase("choose a %1 below its %2", name + "Leak", name + "Area"));
  };
  check(parameters.mitral, "mitral");
  check(parameters.aortic, "aortic");
  check(parameters.tricuspid, "tricuspid");
  check(parameters.pulmonic, "pulmonic");
}

double conductionSeconds(const Parameters& parameters) {
  return std::min(parameters.conduction, kAtrialShare * 60 / parameters.rate);
}

double endSystoleSeconds(double rate) {
  const double ejection = std::max({413 - 1.7 * rate, 371 - 1.2 * rate, 130.0});
  const double contraction = std::clamp(40 - 15 * (rate - 75) / 75, 25.0, 40.0);
  return 0.97 * (ejection + contraction) / 1000;
}

} // namespace viscera::circulation
