#include "viscera/document/patient.h"

#include <cmath>

#include "viscera/core/arrays.h"

namespace viscera::document {

std::vector<medical_io::PlacedOrgan> placedOrgans(const OrganList& organs) {
  std::vector<medical_io::PlacedOrgan> placed;
  for (const auto& organ : organs)
    if (organ->origin.sample.empty())
      placed.push_back(
          {organ->name, boundsOf(organ->mesh->points), std::abs(organ->restVolumeMm3) / kMm3PerMl});
  return placed;
}

std::vector<Text> doubtsAboutPatient(const OrganList& organs) {
  std::vector<Text> doubts;
  for (const medical_io::Finding& finding : medical_io::assessPatient(placedOrgans(organs)).findings)
    doubts.push_back(finding.text);
  return doubts;
}

} // namespace viscera::document
