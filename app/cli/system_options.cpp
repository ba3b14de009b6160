#include "cli/system_options.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "viscera/core/error.h"

namespace viscera::app::cli {

namespace {

bool takes(const coordinates::CoordinateSystem& system, const std::string& parameter) {
  const auto offered = system.parameters();
  return std::any_of(offered.begin(), offered.end(),
                     [&](const coordinates::Parameter& each) { return each.name == parameter; });
}

/// "name=value" taken apart.
std::pair<std::string, std::string> nameAndValue(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw UsageError("It is not NAME=VALUE", "--param " + text, "for instance --param locality=2");
  return {text.substr(0, equals), text.substr(equals + 1)};
}

} // namespace

void SystemOptions::addTo(CLI::App& options) {
  options.add_option("--system", id_, "Coordinate system; 'viscera systems' lists them")
      ->type_name("ID")
      ->capture_default_str();
  options.add_option("--param", parameters_, "A parameter of the system; may be repeated")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->take_all();
  options
      .add_option("--cage", cage_,
                  "For systems that need a cage: a closed surface with a handle at each vertex; else the "
                  "handles' convex hull")
      ->type_name("FILE");
}

std::shared_ptr<const coordinates::CoordinateSystem>
SystemOptions::system(const CommandContext& context) const {
  return context.systems.find(id_);
}

coordinates::BindOptions SystemOptions::bindOptions(const coordinates::CoordinateSystem& system,
                                                    const CommandContext& context,
                                                    const coordinates::CoordinateSystem* beside) const {
  coordinates::BindOptions options;
  options.threads = context.threads;
  for (const std::string& text : parameters_) {
    const auto [name, value] = nameAndValue(text);
    if (beside && !takes(system, name) && takes(*beside, name))
      continue;
    options.parameters.setFromText(system.parameters(), name, value);
  }
  return options;
}

std::vector<coordinates::SystemVariant>
variantsOf(const std::vector<std::shared_ptr<const coordinates::CoordinateSystem>>& systems,
           const std::vector<std::string>& parameters) {
  std::vector<coordinates::SystemVariant> variants;
  for (const auto& system : systems)
    variants.push_back({system, {}});
  for (const std::string& text : parameters) {
    const auto [name, value] = nameAndValue(text);
    bool taken = false;
    for (coordinates::SystemVariant& variant : variants)
      if (takes(*variant.system, name)) {
        variant.parameters.setFromText(variant.system->parameters(), name, value);
        taken = true;
      }
    if (!taken)
      throw UsageError("No coordinate system has this parameter", name, "viscera systems lists them");
  }
  return variants;
}

} // namespace viscera::app::cli
