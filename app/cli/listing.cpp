#include "cli/listing.h"

#include <algorithm>

namespace viscera::app::cli {
namespace {

const char* nameOf(medical_io::FindingSeverity severity) {
  switch (severity) {
  case medical_io::FindingSeverity::good:
    return "good";
  case medical_io::FindingSeverity::note:
    return "note";
  case medical_io::FindingSeverity::doubt:
    return "doubt";
  case medical_io::FindingSeverity::fault:
    break;
  }
  return "fault";
}

} // namespace

Listing& Listing::add(std::string label, std::string value) {
  lines_.emplace_back(std::move(label), std::move(value));
  return *this;
}

std::string Listing::text() const {
  std::size_t width = 0;
  for (const auto& [label, value] : lines_)
    width = std::max(width, label.size());
  std::string text;
  for (const auto& [label, value] : lines_)
    text += label + std::string(width - label.size() + 2, ' ') + value + "\n";
  return text;
}

nlohmann::ordered_json numbersJson(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

nlohmann::ordered_json findingsJson(const std::vector<medical_io::Finding>& findings) {
  auto list = nlohmann::ordered_json::array();
  for (const medical_io::Finding& finding : findings)
    list.push_back({{"light", nameOf(finding.severity)},
                    {"text", finding.text.english()},
                    {"repairs", finding.repairs}});
  return list;
}

void appendFindings(std::vector<Text>& warnings, const std::vector<medical_io::Finding>& findings) {
  for (const medical_io::Finding& finding : findings)
    if (finding.severity >= medical_io::FindingSeverity::doubt &&
        std::find(warnings.begin(), warnings.end(), finding.text) == warnings.end())
      warnings.push_back(finding.text);
}

void removeFindings(std::vector<Text>& warnings, const std::vector<medical_io::Finding>& findings) {
  std::erase_if(warnings, [&](const Text& warning) {
    return std::any_of(findings.begin(), findings.end(),
                       [&](const medical_io::Finding& finding) { return finding.text == warning; });
  });
}

} // namespace viscera::app::cli
