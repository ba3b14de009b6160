#include "cli/commands/all_commands.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/circulation_findings.h"
#include "cli/listing.h"
#include "cli/stage_options.h"
#include "viscera/circulation/patient_fit.h"
#include "viscera/circulation/periodic_state.h"
#include "viscera/circulation/published.h"
#include "viscera/circulation/scenario.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/presentation/circulation_figure.h"
#include "viscera/scene/picture.h"
#include "viscera/scene/surfaceless_window.h"

namespace viscera::app::cli {
namespace {

/// `viscera circulate`: the circulation's periodic state in one scenario, with parameters of the user's.
class CirculateCommand final : public Command {
public:
  std::string name() const override { return "circulate"; }
  std::string summary() const override {
    return "Compute pressures, volumes and flows of heart and circulation";
  }
  std::vector<OutputOption> outputs() const override {
    return {tableOutput("--csv"), pictureOutput("--png")};
  }
  void addOptions(CLI::App& options) override;
  Outcome run(CommandContext& context) override;

private:
  Outcome list() const;
  Outcome published(CommandContext& context) const;
  Outcome vary(CommandContext& context) const;
  std::optional<circulation::PatientFit> fit(CommandContext& context) const;

  std::string scenario_ = "rest";
  std::vector<std::string> parameters_;
  circulation::MeasuredVentricle measured_{0, 0, 0, 0};
  std::string vary_;
  std::string csv_;
  std::string png_;
  std::string size_ = "1600x1000";
  bool list_ = false;
  bool published_ = false;
};

using circulation::Parameters;
using circulation::PeriodicState;

constexpr int kVaried = 13; ///< Points of `--vary`.

std::string scenarioNames() {
  std::string names;
  for (const circulation::Scenario& scenario : circulation::scenarios())
    names += (names.empty() ? "" : ", ") + scenario.id;
  return names;
}

double numberIn(const std::string& text, const std::string& option) {
  try {
    std::size_t end = 0;
    const double value = std::stod(text, &end);
    if (end == text.size())
      return value;
  } catch (const std::logic_error&) {
  }
  throw UsageError("It is not a number", option + " " + text);
}

/// "NAME=REST" as its two parts.
std::pair<std::string, std::string> splitAssignment(const std::string& text, const std::string& option,
                                                    const std::string& example) {
  const std::size_t equal = text.find('=');
  if (equal == std::string::npos)
    throw UsageError("There is no = in it", option + " " + text, "for instance " + option + " " + example);
  return {text.substr(0, equal), text.substr(equal + 1)};
}

Parameters parametersOf(const std::string& scenario, const std::vector<std::string>& assignments) {
  Parameters parameters = circulation::scenarioParameters(scenario);
  for (const std::string& text : assignments) {
    const auto [name, value] = splitAssignment(text, "--param", "rate=60");
    circulation::setParameter(parameters, name, numberIn(value, "--param " + name));
  }
  return parameters;
}

/// The parameters that differ from those at rest.
nlohmann::ordered_json changes(const Parameters& parameters) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const circulation::ParameterInfo& info : circulation::parameterInfos())
    if (const double value = circulation::parameter(parameters, info.name); value != info.rest)
      json[info.name] = value;
  return json;
}

nlohmann::ordered_json fitJson(const circulation::MeasuredVentricle& measured,
                               const circulation::PatientFit& fit) {
  return {{"edvMl", measured.edvMl}, {"ef", measured.ef},
          {"met", fit.met()},        {"edvErrorMl", fit.edvErrorMl},
          {"efError", fit.efError},  {"meanPressureErrorMmHg", fit.pressureErrorMmHg},
          {"atLimit", fit.atLimit}};
}

void drawPicture(const std::string& file, const presentation::ShownCirculation& shown,
                 const presentation::ShownCirculation* before, const PictureSize& size) {
  scene::SurfacelessWindow window(size.width, size.height);
  scene::CurvePanels panels;
  panels.setWindow(window.window());
  panels.setPanels(presentation::circulationFigure(shown, before));
  panels.update();
  scene::writeSmallPng(file, scene::grabPicture(window.window()));
}

} // namespace

void CirculateCommand::addOptions(CLI::App& options) {
  options.add_option("--scenario", scenario_, "State of the circulation: " + scenarioNames())
      ->type_name("NAME")
      ->capture_default_str();
  options
      .add_option("--param", parameters_,
                  "A parameter, after the scenario's; may be repeated. --list names them")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->take_all();
  options
      .add_option("--edv", measured_.edvMl,
                  "A patient's left ventricle: its end-diastolic volume, ml; with --ef. The circulation that "
                  "has just that ventricle is found")
      ->type_name("ML");
  options.add_option("--ef", measured_.ef, "Its ejection fraction, 0 to 1")->type_name("F");
  options
      .add_option("--rate", measured_.ratePerMinute,
                  "Beats a minute of that patient; otherwise the scenario's")
      ->type_name("N");
  options
      .add_option("--mean-pressure", measured_.meanAorticMmHg,
                  "Mean aortic pressure of that patient; otherwise the scenario's")
      ->type_name("MMHG");
  CLI::Option* vary =
      options
          .add_option("--vary", vary_,
                      "How the numbers answer to one parameter, as in stressedVolume=600:1400")
          ->type_name("NAME=FROM:TO");
  options.add_option("--csv", csv_, "Table of all curves over one beat")->type_name("FILE")->excludes(vary);
  options
      .add_option("--png", png_,
                  "Picture: Wiggers's diagram, and the pressure-volume loops beside those at rest")
      ->type_name("FILE")
      ->excludes(vary);
  options.add_option("--size", size_, "Size of the picture in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  options.add_flag("--list", list_, "List the scenarios and parameters, and end");
  options.add_flag("--published", published_, "Compare with published values in a table, and end");
}

Outcome CirculateCommand::run(CommandContext& context) {
  if (list_)
    return list();
  if (published_)
    return published(context);
  if (!vary_.empty())
    return vary(context);
  const auto begin = std::chrono::steady_clock::now();
  const PictureSize size = pictureSize(size_);
  for (const std::string& target : {csv_, png_})
    if (!target.empty())
      const AtomicFile writable(target); // Fails before the work, not after it.
  const std::optional<circulation::PatientFit> patient = fit(context);
  const Parameters parameters = patient ? patient->parameters : parametersOf(scenario_, parameters_);
  const PeriodicState found =
      patient ? patient->state : circulation::findPeriodicState(parameters, context.progress);
  const std::string& scenarioName = circulation::scenario(scenario_).name;
  const auto shown = shownOf(patient ? scenarioName + ", of a patient" : scenarioName, parameters, found);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (!csv_.empty())
    writeCurves(csv_, circulation::curvesOf(parameters, found.beat, shown.indices));
  if (!png_.empty()) {
    const Parameters rest;
    const bool changed = !changes(parameters).empty();
    const auto before = changed
                            ? shownOf("Rest", rest, circulation::findPeriodicState(rest, context.progress))
                            : presentation::ShownCirculation{};
    drawPicture(png_, shown, changed ? &before : nullptr, size);
  }
  Outcome outcome;
  outcome.json = {{"scenario", scenario_},
                  {"parameters", changes(parameters)},
                  {"converged", found.converged},
                  {"beats", found.beats},
                  {"ratePerMinute", parameters.rate}};
  outcome.json.update(circulationJson(shown.indices));
  outcome.json["volumeErrorMl"] = std::abs(circulation::totalVolume(found.start) - parameters.stressedVolume);
  outcome.json["seconds"] = seconds;
  Listing listing;
  if (patient) {
    outcome.json["fit"] = fitJson(measured_, *patient);
    listing.add("fit", patient->remark().english());
    if (!patient->met())
      outcome.warnings.push_back(patient->remark().english());
  }
  listing.add("scenario", shown.name.english() + ", " + significant(parameters.rate, 4) + " beats a minute")
      .add("beats", std::to_string(found.beats) + (found.converged ? "" : ", not periodic"));
  outcome.text = listing.text() + circulationText(shown.indices);
  if (!found.converged)
    outcome.warnings.push_back(found.failureReason);
  for (const auto& [key, target] : {std::pair("csv", csv_), std::pair("png", png_)})
    if (!target.empty()) {
      outcome.json[key] = target;
      outcome.text += std::string(key) + "  " + target + "\n";
    }
  return outcome;
}

/// What the fit of a patient's ventricle found; nothing when none is given.
std::optional<circulation::PatientFit> CirculateCommand::fit(CommandContext& context) const {
  if (measured_.edvMl == 0 && measured_.ef == 0) {
    if (measured_.ratePerMinute != 0 || measured_.meanAorticMmHg != 0)
      throw UsageError("Rate and pressure of a patient belong to a ventricle", "--rate, --mean-pressure",
                       "give --edv and --ef too, or --param rate=60");
    return std::nullopt;
  }
  if (measured_.edvMl == 0 || measured_.ef == 0)
    throw UsageError("A patient's ventricle has both a volume and an ejection fraction",
                     measured_.ef == 0 ? "--edv" : "--ef", "as in --edv 150 --ef 0.45");
  for (const std::string& text : parameters_)
    for (const std::string& name : circulation::fittedParameters())
      if (text.rfind(name + '=', 0) == 0)
        throw UsageError("The fit chooses it", "--param " + text, "leave it out, or --edv and --ef");
  const Parameters start = parametersOf(scenario_, parameters_);
  circulation::MeasuredVentricle measured = measured_;
  if (measured.ratePerMinute == 0)
    measured.ratePerMinute = start.rate;
  return circulation::fitToVentricle(measured, context.progress, start);
}

Outcome CirculateCommand::list() const {
  Outcome outcome;
  Listing scenarios;
  for (const circulation::Scenario& scenario : circulation::scenarios()) {
    nlohmann::ordered_json changed = nlohmann::ordered_json::object();
    for (const auto& [name, value] : scenario.changes)
      changed[name] = value;
    outcome.json["scenarios"].push_back({{"id", scenario.id},
                                         {"name", scenario.name},
                                         {"summary", scenario.summary},
                                         {"parameters", changed},
                                         {"leftMuscle", scenario.leftMuscle}});
    scenarios.add(scenario.id, scenario.summary);
    if (scenario.leftMuscle != 1)
      scenarios.add("", "Muscle of the left ventricle, drawn: " + fixed(scenario.leftMuscle, 2) +
                            " times a healthy one's.");
  }
  for (const circulation::ParameterInfo& info : circulation::parameterInfos()) {
    outcome.json["parameters"].push_back({{"name", info.name},
                                          {"title", info.title},
                                          {"unit", info.unit},
                                          {"rest", info.rest},
                                          {"lowest", info.lowest},
                                          {"highest", info.highest},
                                          {"source", info.source},
                                          {"control", info.control}});
  }
  outcome.text = scenarios.text() + "\n" + circulation::parameterTable();
  return outcome;
}

Outcome CirculateCommand::published(CommandContext& context) const {
  const auto values = circulation::publishedValues(context.progress);
  Outcome outcome;
  for (const circulation::PublishedValue& value : values)
    outcome.json["rows"].push_back({{"scenario", value.scenario},
                                    {"quantity", value.quantity},
                                    {"unit", value.unit},
                                    {"published", value.published},
                                    {"spread", value.spread},
                                    {"ours", value.ours},
                                    {"ratio", value.ratio()},
                                    {"source", value.source}});
  outcome.text = circulation::publishedTable(values);
  return outcome;
}

Outcome CirculateCommand::vary(CommandContext& context) const {
  const auto [name, range] = splitAssignment(vary_, "--vary", "stressedVolume=600:1400");
  const std::size_t colon = range.find(':');
  if (colon == std::string::npos)
    throw UsageError("There is no range in it", "--vary " + vary_,
                     "for instance --vary stressedVolume=600:1400");
  const double from = numberIn(range.substr(0, colon), "--vary " + name);
  const double to = numberIn(range.substr(colon + 1), "--vary " + name);
  std::vector<double> values;
  for (int i = 0; i < kVaried; ++i)
    values.push_back(from + (to - from) * i / (kVaried - 1));
  const std::optional<circulation::PatientFit> patient = fit(context);
  const auto points = circulation::responseTo(
      patient ? patient->parameters : parametersOf(scenario_, parameters_), name, values, context.progress);
  Outcome outcome;
  outcome.json = {{"scenario", scenario_}, {"parameter", name}};
  Listing listing;
  for (const circulation::ResponsePoint& point : points) {
    const auto& lv = point.indices.of(circulation::Compartment::lv);
    outcome.json["rows"].push_back(responseJson(point));
    listing.add(name + " " + significant(point.value, 4),
                "stroke " + fixed(lv.svMl, 1) + " of " + fixed(lv.edvMl, 1) + " ml at " +
                    fixed(lv.edpMmHg, 1) + " mmHg, aorta " + fixed(point.indices.aorta.mean, 0) + " mmHg, " +
                    fixed(point.indices.cardiacOutputLMin, 2) + " l/min");
  }
  outcome.text = listing.text();
  return outcome;
}

std::unique_ptr<Command> circulateCommand() {
  return std::make_unique<CirculateCommand>();
}

} // namespace viscera::app::cli
