#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "viscera/coordinates/measure/system_properties.h"

/// The measured table of systems in the forms a user may want.
namespace viscera::app::cli {

/// One object a system, with one for each of its scenes in `scenes`.
nlohmann::ordered_json propertiesJson(const coordinates::SystemProperties& system);

/// A header, then one line a system and scene.
std::string propertiesCsv(const std::vector<coordinates::SystemProperties>& systems);

/// Columns for a reader: one line a system, the worst of its scenes; then why points have no coordinates.
std::string propertiesText(const std::vector<coordinates::SystemProperties>& systems);

/// "12 points of line, 26 handles", "cloud: needs groups"; one sentence for each scene with failures.
std::vector<std::string> failureReasons(const coordinates::SystemProperties& system);

} // namespace viscera::app::cli
