#pragma once

#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "viscera/core/arrays.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/medical_io/assess_surface.h"

/// Formats the results of commands as text and JSON.
namespace viscera::app::cli {

/// A list of lines "label  value" with the values aligned in a column.
class Listing {
public:
  Listing& add(std::string label, std::string value);
  std::string text() const;

private:
  std::vector<std::pair<std::string, std::string>> lines_;
};

/// The three numbers as an array.
nlohmann::ordered_json numbersJson(const Vec3& v);

/// The findings of an assessed surface as a JSON array of objects: `light`, `text`, `repairs[]`.
nlohmann::ordered_json findingsJson(const std::vector<medical_io::Finding>& findings);

/// Adds a warning for each finding that is a doubt or a fault, unless the same warning is there already.
void appendFindings(std::vector<Text>& warnings, const std::vector<medical_io::Finding>& findings);

/// Removes the warnings about a surface that has been repaired since.
void removeFindings(std::vector<Text>& warnings, const std::vector<medical_io::Finding>& findings);

} // namespace viscera::app::cli
