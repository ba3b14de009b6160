#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "viscera/core/json_reader.h"
#include "viscera/core/phrase.h"

/// Keeps texts inside a session file with their patterns and parts, so that they are shown in any language.
namespace viscera::document {

nlohmann::ordered_json storedTexts(const std::vector<Text>& texts);

/// The texts of `stored`; throws `DataError` through `reader` when they are damaged.
std::vector<Text> textsFrom(JsonReader& reader, const nlohmann::ordered_json& stored,
                            const std::string& place);

} // namespace viscera::document
