#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "viscera/live/measured_record.h"

namespace viscera {
class JsonReader;
}

/// A motion from images in a session (docs/session_format.md, "measured").
namespace viscera::live {

/// The record as JSON; with the verdicts of the phases of `motion`, in which the images had a part.
nlohmann::ordered_json cineRecordJson(const CineRecord& record, const PatientMotion& motion);

/// Reads what `cineRecordJson` made, without the motion. Throws `DataError`.
CineRecord cineRecordFrom(const JsonReader& reader, const nlohmann::ordered_json& item,
                          const std::string& place);
/// The verdicts in it. Throws `DataError`.
std::vector<tracking::FitVerdict> verdictsFrom(const JsonReader& reader, const nlohmann::ordered_json& item,
                                               const std::string& place);

} // namespace viscera::live
