#include "viscera/circulation/published.h"

#include <functional>
#include <map>

#include "viscera/circulation/indices.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/circulation/scenario.h"
#include "viscera/core/text.h"

namespace viscera::circulation {
namespace {

/// One scenario, solved.
struct Solved {
  Parameters parameters;
  Indices indices;
};

/// A row before anything is computed: our number from the scenario and from rest.
struct Row {
  const char* scenario;
  const char* quantity;
  const char* unit;
  double published;
  const char* spread;
  const char* source;
  std::function<double(const Solved& here, const Solved& rest)> ours;
};

constexpr auto kBloodPressure = "Whelton 2018, doi 10.1161/HYP.0000000000000065";
constexpr auto kBiobank = "Petersen 2017, doi 10.1186/s12968-017-0327-9";
constexpr auto kOxford = "Hudsmith 2005, doi 10.1080/10976640500295516";
constexpr auto kPulmonary = "Kovacs 2009, doi 10.1183/09031936.00145608";
constexpr auto kEjection = "Weissler 1968, doi 10.1161/01.CIR.37.2.149";
constexpr auto kDiastolic = "Zile 2004, doi 10.1056/NEJMoa032566";
constexpr auto kElastances = "Segers 2002, doi 10.1152/ajpheart.00764.2001";
constexpr auto kIntervals = "Alhakak 2023 (Copenhagen), doi 10.1007/s00392-023-02269-2";
constexpr auto kExercise = "Higginbotham 1986, Circ Res 58:281-291";
constexpr auto kPhlebotomy = "Leonetti 2004 (375 ml), doi 10.1007/s10286-004-0191-1";
constexpr auto kBloodLoss = "Johnson 2013 (1 l, with reflexes), doi 10.1096/fasebj.27.1_supplement.1206.3";
constexpr auto kEscape = "ESCAPE 2005, doi 10.1001/jama.294.13.1625";
constexpr auto kHypertension = "Liu 1989, Hypertension 14:129-136";
constexpr auto kStenosis = "Baumgartner 2017, doi 10.1016/j.echo.2017.02.009";
constexpr auto kRegurgitation = "Zoghbi 2017, doi 10.1016/j.echo.2017.01.007";
constexpr auto kTamponade = "Reddy 1978, doi 10.1161/01.CIR.58.2.265";

/// Ea from the arteries alone: -0.13 + 1.02 R/T + 0.31/C.
double segersElastance(const Parameters& p) {
  return -0.13 + 1.02 * p.systemic.resistance * p.rate / 60 + 0.31 / p.systemic.arteryCompliance;
}

double pulse(const Solved& s) {
  return s.indices.aorta.systolic - s.indices.aorta.diastolic;
}

std::vector<Row> restRows() {
  using enum Compartment;
  using S = const Solved&;
  return {
      {"rest", "Aorta, systolic", "mmHg", 120, "", kBloodPressure,
       [](S s, S) { return s.indices.aorta.systolic; }},
      {"rest", "Aorta, diastolic", "mmHg", 80, "", kBloodPressure,
       [](S s, S) { return s.indices.aorta.diastolic; }},
      {"rest", "LV ejection fraction (men)", "", 0.58, "+- 0.05", kBiobank,
       [](S s, S) { return s.indices.of(lv).ef; }},
      {"rest", "LV end-diastolic volume (women)", "ml", 135, "+- 26", kOxford,
       [](S s, S) { return s.indices.of(lv).edvMl; }},
      {"rest", "RV end-diastolic volume (women)", "ml", 148, "+- 35", kOxford,
       [](S s, S) { return s.indices.of(rv).edvMl; }},
      {"rest", "LA, largest volume (women)", "ml", 89, "+- 21", kOxford,
       [](S s, S) { return s.indices.of(la).edvMl; }},
      {"rest", "LA, stroke volume (women)", "ml", 48, "+- 15", kOxford,
       [](S s, S) { return s.indices.of(la).svMl; }},
      {"rest", "Pulmonary artery, mean", "mmHg", 14, "+- 3.3", kPulmonary,
       [](S s, S) { return s.indices.pulmonaryArtery.mean; }},
      {"rest", "Ejection", "ms", 413 - 1.7 * 72, "", kEjection,
       [](S s, S) { return 1000 * s.indices.ejectionSeconds; }},
      {"rest", "Isovolumic contraction", "ms", 40, "+- 10", kIntervals,
       [](S s, S) { return 1000 * s.indices.isovolumicContractionSeconds; }},
      {"rest", "Isovolumic relaxation", "ms", 96, "+- 19", kIntervals,
       [](S s, S) { return 1000 * s.indices.isovolumicRelaxationSeconds; }},
      {"rest", "LV relaxation", "ms", 35, "+- 10", kDiastolic,
       [](S s, S) { return 1000 * s.indices.relaxationSeconds; }},
      {"rest", "Arterial elastance Ea (their formula, our arteries)", "mmHg/ml", segersElastance({}), "",
       kElastances, [](S s, S) { return s.indices.arterialElastance; }},
  };
}

std::vector<Row> scenarioRows() {
  using enum Compartment;
  using S = const Solved&;
  return {
      {"exercise", "Cardiac output, of rest (167 a minute)", "", 9.7 / 3.0, "", kExercise,
       [](S s, S r) { return s.indices.cardiacOutputLMin / r.indices.cardiacOutputLMin; }},
      {"exercise", "Stroke volume, of rest", "", 58.0 / 41, "", kExercise,
       [](S s, S r) { return s.indices.of(lv).svMl / r.indices.of(lv).svMl; }},
      {"haemorrhage", "Stroke volume, of rest", "", 80.7 / 94.0, "", kPhlebotomy,
       [](S s, S r) { return s.indices.of(lv).svMl / r.indices.of(lv).svMl; }},
      {"haemorrhage", "Pulse pressure, of rest", "", 47.1 / 53.0, "", kPhlebotomy,
       [](S s, S r) { return pulse(s) / pulse(r); }},
      {"haemorrhage", "Mean arterial pressure, of rest", "", 80.8 / 89.5, "", kBloodLoss,
       [](S s, S r) { return s.indices.aorta.mean / r.indices.aorta.mean; }},
      {"heart-failure-reduced-ef", "LV ejection fraction", "", 0.19, "mean; <= 0.30", kEscape,
       [](S s, S) { return s.indices.of(lv).ef; }},
      {"heart-failure-reduced-ef", "Systolic pressure", "mmHg", 106, "", kEscape,
       [](S s, S) { return s.indices.aorta.systolic; }},
      {"heart-failure-preserved-ef", "LV relaxation", "ms", 59, "+- 14", kDiastolic,
       [](S s, S) { return 1000 * s.indices.relaxationSeconds; }},
      {"heart-failure-preserved-ef", "LV stiffness constant, of rest", "", 3, "0.03 / 0.01", kDiastolic,
       [](S s, S r) { return s.parameters.lv.b / r.parameters.lv.b; }},
      {"hypertension", "Mean arterial pressure, of rest", "", 128.6 / 96.3, "", kHypertension,
       [](S s, S r) { return s.indices.aorta.mean / r.indices.aorta.mean; }},
      {"hypertension", "Arterial compliance, of rest", "", 0.80 / 1.47, "", kHypertension,
       [](S s, S r) {
         return s.parameters.systemic.arteryCompliance / r.parameters.systemic.arteryCompliance;
       }},
      {"aortic-stenosis", "Mean gradient (severe)", "mmHg", 40, ">=", kStenosis,
       [](S s, S) { return s.indices.aorticMeanGradient; }},
      {"mitral-regurgitation", "Regurgitant volume (severe)", "ml", 60, ">=", kRegurgitation,
       [](S s, S) { return s.indices.mitralRegurgitationMl; }},
      {"mitral-regurgitation", "Regurgitant fraction (severe)", "", 0.5, ">=", kRegurgitation,
       [](S s, S) { return s.indices.mitralRegurgitantFraction; }},
      {"tamponade", "Right atrium, mean", "mmHg", 16, "+- 4", kTamponade,
       [](S s, S) { return s.indices.of(ra).meanMmHg; }},
      {"tamponade", "Cardiac output, of that without", "", 3.87 / 7.0, "", kTamponade,
       [](S s, S r) { return s.indices.cardiacOutputLMin / r.indices.cardiacOutputLMin; }},
  };
}

} // namespace

std::vector<PublishedValue> publishedValues(Progress& progress) {
  std::map<std::string, Solved> solved;
  for (const Scenario& scenario : scenarios()) {
    const Parameters parameters = scenarioParameters(scenario.id);
    Progress quiet;
    progress.throwIfCancelled();
    solved[scenario.id] = {parameters, indicesOf(parameters, findPeriodicState(parameters, quiet).beat)};
    progress.report(static_cast<double>(solved.size()) / static_cast<double>(scenarios().size()),
                    scenario.id);
  }
  std::vector<PublishedValue> values;
  for (const auto& rows : {restRows(), scenarioRows()})
    for (const Row& row : rows)
      values.push_back({row.scenario, row.quantity, row.unit, row.published, row.spread, row.source,
                        row.ours(solved.at(row.scenario), solved.at("rest"))});
  return values;
}

std::string publishedTable(const std::vector<PublishedValue>& values) {
  std::string table =
      "| scenario | number | published | ours | ratio | source |\n|---|---|---|---|---|---|\n";
  for (const PublishedValue& value : values) {
    const std::string unit = value.unit.empty() ? "" : " " + value.unit;
    const std::string spread = value.spread.empty() ? "" : " (" + value.spread + ")";
    table += "| " + value.scenario + " | " + value.quantity + " | " + significant(value.published) + unit +
             spread + " | " + significant(value.ours) + unit + " | " + fixed(value.ratio(), 2) + " | " +
             value.source + " |\n";
  }
  return table;
}

} // namespace viscera::circulation
