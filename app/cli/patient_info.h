#pragma once

#include <string>
#include <vector>

#include "cli/command.h"
#include "viscera/medical_io/assess_patient.h"

/// What commands say of the organs of a patient together.
namespace viscera::app::cli {

/// Puts the judgement of a patient before the warnings, and adds it to the JSON as `patient` (`axes`,
/// `rightToLeft`, `frontToBack`, `footToHead`, `organs`, `margin`, `sizeFactor`, `repairs[]`). Nothing for
/// fewer than two organs.
void appendPatient(Outcome& outcome, const std::vector<medical_io::PlacedOrgan>& organs);

/// The surfaces of a folder, in the order of their names; empty for what is no folder, for a folder of masks,
/// a DICOM folder, and one without surfaces.
std::vector<std::string> surfacesIn(const std::string& folder);

/// Describes several files of one patient: each organ, and all of them together. Throws as
/// `document::openFiles`.
Outcome describePatient(const std::vector<std::string>& files, CommandContext& context);

} // namespace viscera::app::cli
