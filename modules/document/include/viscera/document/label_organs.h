#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viscera/core/progress.h"
#include "viscera/document/organ.h"
#include "viscera/medical_io/label_map.h"
#include "viscera/medical_io/label_surfaces.h"

/// Label maps into organs. Touches no document, so that a worker can do it.
namespace viscera::document {

/// Reads a label map or a folder of masks, and makes an organ, named and coloured, of each of the labels that
/// are asked for by name or value; of all when none are. Throws what `medical_io::readLabelMap`,
/// `medical_io::segmentsNamed` and `medical_io::labelSurfaces` throw.
std::vector<Organ> readLabelOrgans(const std::filesystem::path& file, const std::vector<std::string>& labels,
                                   Progress& progress);

/// Organs of surfaces that were made from a label map, which was read from `file`. The first has the warnings
/// of the map as a whole.
std::vector<Organ> organsFrom(const medical_io::LabelMap& map, std::vector<medical_io::LabelSurface> surfaces,
                              const std::filesystem::path& file);

} // namespace viscera::document
