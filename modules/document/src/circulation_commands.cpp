#include "viscera/document/circulation_commands.h"

#include <algorithm>

#include "viscera/circulation/scenario.h"
#include "viscera/core/phrase.h"
#include "viscera/document/edit.h"

namespace viscera::document {
namespace {

Text titleOf(const std::string& parameter) {
  const auto& infos = circulation::parameterInfos();
  const auto found =
      std::find_if(infos.begin(), infos.end(), [&](const auto& info) { return info.name == parameter; });
  return named(found == infos.end() ? parameter : found->title);
}

} // namespace

Text nameOf(const CirculationChoice& choice) {
  const Text name =
      choice.fitted ? Text("Fitted circulation") : named(circulation::scenario(choice.scenario).name);
  const circulation::Parameters chosen =
      choice.fitted ? *choice.fitted : circulation::scenarioParameters(choice.scenario);
  return choice.parameters == chosen ? name : phrase("%1, changed", name);
}

Command driveHeart(bool byCirculation) {
  return edit::onPart(byCirculation ? "Heart follows the circulation" : "Heart follows the textbook",
                      &DocumentState::circulation,
                      [=](CirculationChoice& choice) { choice.drives = byCirculation; });
}

Command chooseScenario(const std::string& id) {
  const Text name = named(circulation::scenario(id).name);
  return edit::onPart(phrase("Circulation: %1", name), &DocumentState::circulation,
                      [id](CirculationChoice& choice) {
                        choice.drives = true;
                        choice.scenario = id;
                        choice.fitted.reset();
                        choice.parameters = circulation::scenarioParameters(id);
                      });
}

Command setCirculationParameter(const std::string& name, double value) {
  return edit::onPart(
      titleOf(name), &DocumentState::circulation,
      [=](CirculationChoice& choice) {
        circulation::setParameter(choice.parameters, name, value);
        circulation::checkParameters(choice.parameters);
      },
      "circulation." + name);
}

Command takeCirculation(Text title, const circulation::Parameters& parameters) {
  circulation::checkParameters(parameters);
  return edit::onPart(std::move(title), &DocumentState::circulation, [parameters](CirculationChoice& choice) {
    choice.drives = true;
    choice.scenario = "rest";
    choice.parameters = parameters;
    choice.fitted = parameters;
  });
}

Command keepCirculation() {
  return edit::onPart("Keep circulation for comparison", &DocumentState::circulation,
                      [](CirculationChoice& choice) {
                        choice.kept = KeptCirculation{nameOf(choice), choice.parameters};
                      });
}

Command forgetKeptCirculation() {
  return edit::onPart("Discard kept circulation", &DocumentState::circulation,
                      [](CirculationChoice& choice) { choice.kept.reset(); });
}

} // namespace viscera::document
