#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include <nlohmann/json.hpp>

#include "viscera/core/json_reader.h"
#include "viscera/presentation/view_state.h"

// Parts of a session's view as JSON (docs/session_format.md): strain, scan, signs of a heart. What is missing
// or out of range gets its default; each throws `JsonError` for what is not of its kind.
namespace viscera::presentation {

/// A named value of an enumeration; the first for a name that is none of them.
template <class Enum, std::size_t count>
Enum fromName(const std::array<const char*, count>& names, const nlohmann::ordered_json& name) {
  const auto found = std::find(names.begin(), names.end(), name.is_string() ? name.get<std::string>() : "");
  return static_cast<Enum>(found == names.end() ? 0 : found - names.begin());
}

/// A number of a look, or `otherwise` for one that nothing can be drawn with.
double within(double value, double low, double high, double otherwise);

nlohmann::ordered_json strainJson(const StrainLook& look);
StrainLook strainFrom(const JsonReader& json, const nlohmann::ordered_json& item, const std::string& place);

nlohmann::ordered_json scanJson(ScanLook look);
ScanLook scanFrom(const JsonReader& json, const nlohmann::ordered_json& item, const std::string& place);

nlohmann::ordered_json heartSignsJson(HeartSigns signs);
HeartSigns heartSignsFrom(const JsonReader& json, const nlohmann::ordered_json& item,
                          const std::string& place);

} // namespace viscera::presentation
