#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "viscera/anatomy/part.h"
#include "viscera/heart/clinical_numbers.h"

/// The names of a heart's numbers in JSON: the same in every command, and in Python with other separators.
namespace viscera::app::cli {

/// Volumes, ejection fraction and output under the names that all commands have, and those of the two volumes
/// that `play` and `track` had before.
inline nlohmann::ordered_json cardiacJson(const heart::CardiacIndices& indices) {
  return {{"endDiastolicVolumeMl", indices.endDiastolicMl},
          {"endSystolicVolumeMl", indices.endSystolicMl},
          {"strokeVolumeMl", indices.strokeVolumeMl},
          {"ejectionFraction", indices.ejectionFraction},
          {"cardiacOutputLPerMinute", indices.cardiacOutputLPerMinute},
          {"endDiastolicMl", indices.endDiastolicMl},
          {"endSystolicMl", indices.endSystolicMl}};
}

/// Sets the value under the surface's name and, where that means a chamber of the heart which has no value
/// yet, under the chamber's key: "LV cavity" and "lv".
inline void setUnderNames(nlohmann::ordered_json& object, const std::string& surface,
                          const nlohmann::ordered_json& value) {
  object[surface] = value;
  const std::string key = anatomy::chamberKey(surface);
  if (!key.empty() && !object.contains(key))
    object[key] = value;
}

} // namespace viscera::app::cli
