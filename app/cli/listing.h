#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "viscera/core/text.h"
#include "viscera/medical_io/assess_surface.h"

/// What commands say of what they have found.
namespace viscera::app::cli {

/// Lines "label  value" for a reader, the values below each other.
class Listing {
public:
  Listing& add(std::string label, std::string value);
  std::string text() const;

private:
  std::vector<std::pair<std::string, std::string>> lines_;
};

/// One object a finding: `light`, `text`, `repairs[]`.
nlohmann::ordered_json findingsJson(const std::vector<medical_io::Finding>& findings);

/// Adds what is doubtful or wrong and has not been said already.
void appendFindings(std::vector<std::string>& warnings, const std::vector<medical_io::Finding>& findings);

/// Removes what is said of a surface that has become another one since.
void removeFindings(std::vector<std::string>& warnings, const std::vector<medical_io::Finding>& findings);

} // namespace viscera::app::cli
