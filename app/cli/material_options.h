#pragma once

#include <optional>
#include <string>

#include <nlohmann/json.hpp>

#include "viscera/elasticity/stated_material.h"

namespace CLI {
class App;
}

namespace viscera::app::cli {

/// The options that state a material: `--material`, `--young` and `--poisson`.
class MaterialOptions {
public:
  void addTo(CLI::App& options);

  /// The stated material; unstated without the options. Throws `UsageError` for a tissue that is not known,
  /// and for Poisson's ratio without a material.
  elasticity::StatedMaterial material() const;

private:
  std::optional<double> youngKpa_;
  std::string tissue_;
  std::optional<double> poisson_;
};

/// The material for JSON: name, youngKpa, poisson, and of a tissue measure and doi.
nlohmann::ordered_json materialJson(const elasticity::StatedMaterial& material);

} // namespace viscera::app::cli
