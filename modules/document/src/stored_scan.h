#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "viscera/core/json_reader.h"
#include "viscera/medical_io/scan.h"

/// Encodes a scan inside a session file: its raw samples and their meaning (docs/session_format.md).
namespace viscera::document {

/// The scan as JSON. Throws `CannotCreateError` for one of more than 1 GB. O(voxels).
nlohmann::ordered_json storedScan(const medical_io::Scan& scan);

/// The scan of `stored`; throws `DataError` through `reader` when it is damaged. The stated size is checked
/// against the data before memory is allocated. O(voxels).
medical_io::Scan scanFrom(JsonReader& reader, const nlohmann::ordered_json& stored, const std::string& place);

} // namespace viscera::document
