#include "cli/patient_info.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

#include "cli/listing.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/document/open_files.h"
#include "viscera/document/session_file.h"
#include "viscera/medical_io/file_kind.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/scan.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::app::cli {
namespace {

using nlohmann::ordered_json;

std::string nameOf(medical_io::Direction direction) {
  switch (direction) {
  case medical_io::Direction::kept:
    return "kept";
  case medical_io::Direction::exchanged:
    return "exchanged";
  case medical_io::Direction::unknown:
    break;
  }
  return "unknown";
}

bool endsAsSurface(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto& known = medical_io::endingsOf(medical_io::FileKind::surface);
  return std::find(known.begin(), known.end(), ending) != known.end();
}

} // namespace

void appendPatient(Outcome& outcome, const std::vector<medical_io::PlacedOrgan>& organs) {
  if (organs.size() < 2)
    return;
  const medical_io::PatientAssessment patient = medical_io::assessPatient(organs);
  // Before the many warnings about single organs, which would hide it.
  std::vector<Text> warnings;
  appendFindings(warnings, patient.findings);
  for (Text& warning : outcome.warnings)
    if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end())
      warnings.push_back(std::move(warning));
  outcome.warnings = std::move(warnings);
  ordered_json repairs = ordered_json::array();
  for (const medical_io::Finding& finding : patient.findings)
    for (const std::string& repair : finding.repairs)
      repairs.push_back(repair);
  outcome.json["patient"] = {
      {"axes", patient.axes()},
      {"rightToLeft", nameOf(patient.directions[0])},
      {"frontToBack", nameOf(patient.directions[1])},
      {"footToHead", nameOf(patient.directions[2])},
      {"organs", patient.organs},
      {"margin", patient.margin},
      {"sizeFactor", patient.sizeFactor > 0 ? ordered_json(patient.sizeFactor) : ordered_json(nullptr)},
      {"repairs", std::move(repairs)}};
  outcome.json["warnings"] = outcome.warnings;
}

std::vector<std::string> surfacesIn(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored) || medical_io::isScan(folder) ||
      medical_io::isLabelMap(folder))
    return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.is_regular_file(ignored) && endsAsSurface(entry.path()))
      files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

Outcome describePatient(const std::vector<std::string>& files, CommandContext& context) {
  std::vector<std::filesystem::path> paths;
  for (const std::string& file : files) {
    const std::vector<std::string> inside = surfacesIn(file);
    paths.insert(paths.end(), inside.begin(), inside.end());
    if (inside.empty())
      paths.emplace_back(file);
  }
  const document::OpenedFiles opened = document::openFiles(paths, context.progress);
  Outcome outcome;
  outcome.warnings = opened.warnings;
  for (const Error& failure : opened.failures)
    outcome.warnings.push_back(failure.explanation());
  ordered_json organs = ordered_json::array();
  std::vector<medical_io::PlacedOrgan> placed;
  Listing listing;
  listing.add("kind", "patient").add("organs", std::to_string(opened.organs.size()));
  for (const document::NewOrgan& item : opened.organs) {
    const document::Organ& organ = item.organ;
    const Bounds bounds = boundsOf(organ.mesh->points);
    const double volumeMl = std::abs(organ.restVolumeMm3) / kMm3PerMl;
    placed.push_back({organ.name, bounds, volumeMl});
    organs.push_back({{"name", organ.name},
                      {"file", organ.file.string()},
                      {"vertices", organ.mesh->points.rows()},
                      {"triangles", organ.mesh->triangles.rows()},
                      {"closed", organ.closed()},
                      {"volumeMl", organ.closed() ? ordered_json(volumeMl) : ordered_json(nullptr)},
                      {"boundsMm",
                       {bounds.low.x(), bounds.high.x(), bounds.low.y(), bounds.high.y(), bounds.low.z(),
                        bounds.high.z()}}});
    listing.add("  " + organ.name, organ.closed() ? fixed(volumeMl, 1) + " ml" : "open, no volume");
  }
  outcome.json = {{"kind", "patient"}, {"files", files}, {"organs", organs}, {"warnings", outcome.warnings}};
  appendPatient(outcome, placed);
  if (outcome.json.contains("patient"))
    listing.add("axes", outcome.json["patient"]["axes"].get<std::string>());
  outcome.text = listing.text();
  return outcome;
}

} // namespace viscera::app::cli
