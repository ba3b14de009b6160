#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "viscera/medical_io/assess_surface.h"

namespace viscera::app::cli {

/// "good", "note", "doubt" or "fault".
std::string nameOf(medical_io::Light light);

/// One object a finding: `light`, `text`, `repairs[]`.
nlohmann::ordered_json findingsJson(const std::vector<medical_io::Finding>& findings);

/// Adds what is doubtful or wrong and has not been said already.
void appendFindings(std::vector<std::string>& warnings, const std::vector<medical_io::Finding>& findings);

/// Removes what is said of a surface that has become another one since.
void removeFindings(std::vector<std::string>& warnings, const std::vector<medical_io::Finding>& findings);

} // namespace viscera::app::cli
