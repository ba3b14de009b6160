#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "viscera/core/json_reader.h"
#include "viscera/geometry/triangle_mesh.h"

/// Encodes a surface inside a session file without loss: compressed, as base64.
namespace viscera::document {

/// The SHA-256 of a surface's points, triangles and colours, in hexadecimal. O(n + m).
std::string surfaceHash(const geometry::TriangleMesh& mesh);

/// The surface as JSON. Throws `CannotCreateError` for one of more than 2 GB.
nlohmann::ordered_json storedSurface(const geometry::TriangleMesh& mesh);

/// The surface of `stored`; throws `DataError` through `reader` when it is damaged. The stated size is
/// checked against the data before memory is allocated.
geometry::TriangleMesh surfaceFrom(JsonReader& reader, const nlohmann::ordered_json& stored,
                                   const std::string& place);

} // namespace viscera::document
