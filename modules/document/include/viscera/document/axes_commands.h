#pragma once

#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/document/command.h"
#include "viscera/document/document.h"
#include "viscera/medical_io/assess_patient.h"

/// The axes of a whole patient: what is doubtful about them, and commands that change the coordinates, for
/// files that turn out to be in other axes or in another unit after they were imported.
namespace viscera::document {

/// The organs at rest, for judging them together. Sample organs are left out: each is made in LPS, about an
/// origin of its own. O(vertices).
std::vector<medical_io::PlacedOrgan> placedOrgans(const OrganList& organs);

/// What is doubtful about axes, sides and size of a patient (`medical_io::assessPatient`), a sentence each,
/// for warnings and reports; without capital and full stop. O(vertices + organs^2).
std::vector<Text> doubtsAboutPatient(const OrganList& organs);

/// The repairs (`medical_io::surfaceRepairs`) that change coordinates, and so can be done to a whole
/// document: "ras-to-lps", "mirror", "y-up", "flip-z", "unit-cm" and their like.
std::vector<std::string> coordinateRepairs();

/// Does one of `coordinateRepairs` to all organs, and with them to their named places, the handles at rest
/// and in the pose, the cage, the recorded keys, distances, angles and stress probes. "ras-to-lps" also leads
/// from LPS to RAS. The scan, and what is measured in it, stay: a file states the axes of its image. The
/// organs are no longer those of their files, so that a session holds them; each has a remark on what was
/// done. A mirror image's triangles still face outward. Throws `UsageError` for another id, and for a
/// document without organs and handles. O(vertices).
Command convertCoordinates(const std::string& repair);

/// The same with all coordinates times `factor`: an atlas that is not life-sized. Throws `UsageError` for a
/// factor that is not positive and finite.
Command scaleCoordinates(double factor);

} // namespace viscera::document
