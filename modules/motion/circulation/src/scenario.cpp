#include "viscera/circulation/scenario.h"

#include <algorithm>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::circulation {

const std::vector<Scenario>& scenarios() {
  static const std::vector<Scenario> all = {
      {"rest", "Rest", "A healthy adult lying down.", {}},
      {"exercise",
       "Exercise",
       "Hard upright work: a fast and strong heart, open muscle vessels, veins that give blood back.",
       {{"rate", 150},
        {"lvEes", 3.5},
        {"rvEes", 0.75},
        {"raEes", 0.32},
        {"lvTau", 0.018},
        {"rvTau", 0.02},
        {"laB", 0.022},
        {"conduction", 0.095},
        {"systemicResistance", 0.45},
        {"systemicCompliance", 1.2},
        {"pulmonaryResistance", 0.033},
        {"stressedVolume", 1600}}},
      {"haemorrhage",
       "Haemorrhage",
       "A quarter of the stressed blood volume is lost; no reflex answers, so that pressures fall more than "
       "in life.",
       {{"stressedVolume", 745}}},
      {"heart-failure-reduced-ef",
       "Heart failure, reduced EF",
       "A weak, dilated left ventricle and retained fluid: the loop lies far to the right, blood backs up to "
       "the lungs. Its wall has more muscle and is no thicker.",
       {{"lvEes", 0.7},
        {"lvV0", 30},
        {"lvB", 0.0145},
        {"lvTau", 0.05},
        {"systemicResistance", 1.15},
        {"stressedVolume", 1290}},
       1.35},
      {"heart-failure-preserved-ef",
       "Heart failure, preserved EF",
       "A stiff left ventricle that relaxes slowly: it empties well and fills only at a high pressure.",
       {{"lvEes", 3.0},
        {"lvA", 0.8},
        {"lvB", 0.033},
        {"lvTau", 0.059},
        {"laEes", 0.3},
        {"systemicResistance", 1.2},
        {"stressedVolume", 1140}},
       1.3},
      {"hypertension",
       "Hypertension",
       "Narrow small arteries and stiff large ones, against which a stronger, stiffer, thicker ventricle "
       "works.",
       {{"systemicResistance", 1.38},
        {"systemicCompliance", 1.0},
        {"lvEes", 2.6},
        {"lvB", 0.0185},
        {"lvTau", 0.042},
        {"stressedVolume", 1030}},
       1.3},
      {"aortic-stenosis",
       "Aortic stenosis",
       "The aortic valve opens to 0.8 cm2: the pressure of the hypertrophied ventricle is far higher than "
       "that of "
       "the aorta.",
       {{"aorticArea", 0.8}, {"lvEes", 2.8}, {"lvB", 0.0195}, {"lvTau", 0.05}, {"stressedVolume", 1060}},
       1.45},
      {"mitral-regurgitation",
       "Mitral regurgitation",
       "The mitral valve leaks through 0.45 cm2: half of what the ventricle ejects goes back into the "
       "atrium.",
       {{"mitralLeak", 0.45}, {"stressedVolume", 1150}}},
      {"tamponade",
       "Tamponade",
       "Fluid in the pericardium presses on all chambers: they fill little, and all filling pressures are "
       "the same.",
       {{"pericardialFluid", 410}, {"rate", 95}, {"systemicResistance", 1.3}, {"stressedVolume", 1640}}},
  };
  return all;
}

const Scenario& scenario(const std::string& id) {
  const auto& all = scenarios();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Scenario& s) { return s.id == id; });
  if (found != all.end())
    return *found;
  std::string names;
  for (const Scenario& s : all)
    names += (names.empty() ? "" : ", ") + s.id;
  throw UsageError(misuse("there is no such scenario"), id, misuse("choose one of %1", names));
}

double leftMuscleOf(const std::string& name) {
  for (const Scenario& s : scenarios())
    if (name == s.name || name == s.name + ", changed")
      return s.leftMuscle;
  return 1;
}

Parameters scenarioParameters(const std::string& id) {
  Parameters parameters;
  for (const auto& [name, value] : scenario(id).changes)
    setParameter(parameters, name, value);
  return parameters;
}

} // namespace viscera::circulation
