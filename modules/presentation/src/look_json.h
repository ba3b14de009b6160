#pragma once

#include <algorithm>
#include <array>
#include <string>

#include <nlohmann/json.hpp>

#include "viscera/core/json_reader.h"
#include "viscera/presentation/view_state.h"

// Parts of a session's view as JSON (docs/session_format.md): stress, scan, signs of a heart. What is missing
// or out of range gets its default; each throws `JsonError` for what is not of its kind.
namespace viscera::presentation {

inline constexpr const char* kView = "the session's view";
inline constexpr const char* kViewAdvice = "the organs and the handles are complete; save the session anew";

/// A named value of an enumeration; the first for a name that is none of them.
template <class Enum, std::size_t count>
Enum fromName(const std::array<const char*, count>& names, const nlohmann::ordered_json& name) {
  const auto found = std::find(names.begin(), names.end(), name.is_string() ? name.get<std::string>() : "");
  return static_cast<Enum>(found == names.end() ? 0 : found - names.begin());
}

/// A number of a look, or `otherwise` for one that nothing can be drawn with.
double within(double value, double low, double high, double otherwise);

/// Of unit length; the first direction again for one without any.
Vec3 unit(const Vec3& normal);

nlohmann::ordered_json stressJson(StressLook look);

/// Throws JsonError for a value of another kind; one beyond its bounds is moved onto them.
StressLook stressFrom(const JsonReader& json, const nlohmann::ordered_json& item, const std::string& place);

/// Format 1 kept the user's settings, some of them as text.
StressLook stressFromSettings(const JsonReader& json, const nlohmann::ordered_json& settings);

nlohmann::ordered_json scanJson(ScanLook look);
ScanLook scanFrom(const JsonReader& json, const nlohmann::ordered_json& item, const std::string& place);

nlohmann::ordered_json heartSignsJson(HeartSigns signs);
HeartSigns heartSignsFrom(const JsonReader& json, const nlohmann::ordered_json& item,
                          const std::string& place);

} // namespace viscera::presentation
