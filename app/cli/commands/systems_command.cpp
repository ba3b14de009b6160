#include "cli/commands/all_commands.h"

#include <CLI/CLI.hpp>

#include "cli/listing.h"

namespace viscera::app::cli {
namespace {

using coordinates::Parameter;
using coordinates::Traits;
using nlohmann::ordered_json;

ordered_json traitsJson(const Traits& traits) {
  return {{"needsCage", traits.needsCage},
          {"needsTetrahedra", traits.needsTetrahedra},
          {"positive", traits.positive},
          {"interpolates", traits.interpolates},
          {"closedFormGradient", traits.closedFormGradient},
          {"usesGroups", traits.usesGroups},
          {"rotationInvariant", traits.rotationInvariant},
          {"everywhere", traits.everywhere},
          {"continuous", traits.continuous},
          {"smooth", traits.smooth},
          {"affine", traits.affine}};
}

std::string traitsText(const Traits& traits) {
  std::string text = traits.needsCage ? "needs a cage" : "no cage";
  const std::pair<bool, const char*> others[] = {{traits.needsTetrahedra, "needs tetrahedra"},
                                                 {traits.positive, "positive"},
                                                 {traits.interpolates, "passes through its handles"},
                                                 {traits.closedFormGradient, "closed-form gradient"},
                                                 {traits.usesGroups, "uses groups"},
                                                 {!traits.everywhere, "without an answer at some points"},
                                                 {!traits.continuous, "jumps"},
                                                 {traits.continuous && !traits.smooth, "has kinks"},
                                                 {!traits.affine, "does not follow affine motions"}};
  for (const auto& [has, words] : others)
    if (has)
      text += std::string(", ") + words;
  return text;
}

ordered_json parameterJson(const Parameter& parameter) {
  return {{"name", parameter.name},         {"minimum", parameter.minimum}, {"maximum", parameter.maximum},
          {"standard", parameter.standard}, {"unit", parameter.unit},       {"integer", parameter.integer},
          {"choices", parameter.choices},   {"help", parameter.help}};
}

std::string parameterText(const Parameter& parameter) {
  std::string range = significant(parameter.minimum, 6) + " to " + significant(parameter.maximum, 6);
  if (!parameter.choices.empty()) {
    range.clear();
    for (const std::string& choice : parameter.choices)
      range += (range.empty() ? "" : " | ") + choice;
  }
  if (!parameter.unit.empty())
    range += " " + parameter.unit;
  return parameter.name + " (" + range + "; " + significant(parameter.standard, 6) + "): " + parameter.help;
}

/// `viscera systems`: lists the available coordinate systems.
class SystemsCommand final : public Command {
public:
  std::string name() const override { return "systems"; }
  std::string summary() const override { return "List the coordinate systems and their parameters"; }

  void addOptions(CLI::App&) override {}

  Outcome run(CommandContext& context) override {
    Outcome outcome;
    outcome.json["systems"] = ordered_json::array();
    for (const coordinates::Registry::Entry& entry : context.systems.list()) {
      const coordinates::CoordinateSystem& system = *entry.system;
      ordered_json parameters = ordered_json::array();
      Listing listing;
      listing.add("  name", system.name())
          .add("  source", entry.source)
          .add("  traits", traitsText(system.traits()));
      for (const Parameter& parameter : system.parameters()) {
        parameters.push_back(parameterJson(parameter));
        listing.add("  parameter", parameterText(parameter));
      }
      outcome.json["systems"].push_back({{"id", system.id()},
                                         {"name", system.name()},
                                         {"summary", system.summary()},
                                         {"source", entry.source},
                                         {"traits", traitsJson(system.traits())},
                                         {"parameters", parameters}});
      outcome.text += system.id() + ": " + system.summary() + "\n" + listing.text();
    }
    return outcome;
  }
};

} // namespace

std::unique_ptr<Command> systemsCommand() {
  return std::make_unique<SystemsCommand>();
}

} // namespace viscera::app::cli
