#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "viscera/core/json_reader.h"
#include "viscera/presentation/view_state.h"

/// How strain is shown, as a part of the view of a session (docs/session_format.md, "strain").
namespace viscera::presentation {

nlohmann::ordered_json strainLookJson(StrainLook look);

/// Reads what `strainLookJson` wrote. Values that are missing or of a newer version get their defaults.
/// Throws `DataError` for what is no look of strain; `place` is its path in the session.
StrainLook strainLookFrom(const JsonReader& json, const nlohmann::ordered_json& item,
                          const std::string& place);

} // namespace viscera::presentation
