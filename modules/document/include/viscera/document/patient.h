#pragma once

#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/document/document.h"
#include "viscera/medical_io/assess_patient.h"

namespace viscera::document {

/// The organs at rest, for judging them together. Sample organs are left out: each is made in LPS, about an
/// origin of its own. O(vertices).
std::vector<medical_io::PlacedOrgan> placedOrgans(const OrganList& organs);

/// What is doubtful about axes, sides and size of a patient (`medical_io::assessPatient`), a sentence each,
/// for warnings and reports; without capital and full stop. O(vertices + organs^2).
std::vector<Text> doubtsAboutPatient(const OrganList& organs);

} // namespace viscera::document
