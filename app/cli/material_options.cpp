#include "cli/material_options.h"

#include <CLI/CLI.hpp>

#include "cli/number_bounds.h"
#include "viscera/core/error.h"
#include "viscera/elasticity/tissues.h"
#include "viscera/live/stress_quantity.h"

namespace viscera::app::cli {

void MaterialOptions::addTo(CLI::App& options) {
  std::string known;
  for (const elasticity::Tissue& tissue : elasticity::tissues())
    known += (known.empty() ? "" : ", ") + std::string(tissue.name);
  CLI::Option* tissue =
      options
          .add_option("--material", tissue_, "A tissue whose stiffness is published, for pascals: " + known)
          ->type_name("NAME");
  options.add_option("--young", youngKpa_, "Young's modulus of another material, for pascals")
      ->type_name("KPA")
      ->check(above(0))
      ->excludes(tissue);
  options.add_option("--poisson", poisson_, "Poisson's ratio of the material; 0.49 without it")
      ->type_name("NU")
      ->check(between(0.01, 0.4999));
}

elasticity::StatedMaterial MaterialOptions::material() const {
  const double poisson = poisson_.value_or(elasticity::kUsualPoisson);
  if (!tissue_.empty())
    return elasticity::materialOf(tissue_, poisson);
  if (youngKpa_)
    return elasticity::ownMaterial(*youngKpa_, poisson);
  if (poisson_)
    throw UsageError("Poisson's ratio alone is no material", "--poisson",
                     "add --material NAME or --young KPA");
  return {};
}

nlohmann::ordered_json materialJson(const elasticity::StatedMaterial& material) {
  nlohmann::ordered_json json = {{"name", live::nameOf(material).english()},
                                 {"youngKpa", material.youngKpa},
                                 {"poisson", material.poisson}};
  if (material.tissue.empty())
    return json;
  const elasticity::Tissue& tissue = elasticity::tissueNamed(material.tissue);
  json["tissue"] = material.tissue;
  json["measure"] = std::string(tissue.measure);
  json["doi"] = std::string(tissue.doi);
  return json;
}

} // namespace viscera::app::cli
