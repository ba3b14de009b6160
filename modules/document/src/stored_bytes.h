#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "viscera/core/json_reader.h"

/// Encodes arrays of numbers for a session file without loss: compressed by zlib, as base64.
namespace viscera::document {

/// The bytes as text. Throws `CannotCreateError` for more than 1 GB; `what` is "a surface".
std::string packed(std::string_view bytes, const char* what);

/// Fills memory of `bytes` bytes from the text that `key` of `stored` has. `reserve` gives that memory; it is
/// asked only when what is there can hold so much. Throws `DataError` through `reader` when the text is
/// damaged or does not hold exactly so much; `holds` says of what, as "12 rows".
void unpack(const JsonReader& reader, const nlohmann::ordered_json& stored, const char* key,
            const std::string& place, std::int64_t bytes, const std::string& holds,
            const std::function<void*()>& reserve);

} // namespace viscera::document
