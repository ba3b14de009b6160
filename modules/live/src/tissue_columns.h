#pragma once

#include <cmath>
#include <string>

#include "viscera/core/text.h"
#include "viscera/live/stress_quantity.h"

/// The columns of a stated material in tables of stress; none where no material is stated.
namespace viscera::live {

inline std::string tissueHead(const elasticity::StatedMaterial& material) {
  return material.stated() ? ",von_mises_kpa,strain_energy_kpa,material" : "";
}

/// Empty cells where the tissue is folded or missing.
inline std::string tissueCells(double vonMisesKpa, double energyKpa, int digits,
                               const elasticity::StatedMaterial& material) {
  if (!material.stated())
    return {};
  std::string cells;
  for (const double value : {vonMisesKpa, energyKpa})
    cells += ',' + (std::isfinite(value) ? significant(value, digits) : std::string());
  return cells + ',' + csvField(nameOf(material).english());
}

} // namespace viscera::live
