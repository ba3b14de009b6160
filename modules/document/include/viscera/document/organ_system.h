#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Finds the body system (circulation, digestion and others) of an organ by its name, to arrange long lists.
namespace viscera::document {

/// The systems in the order of a list; unknown names belong to the last one: "Heart", "Arteries", "Veins",
/// "Respiratory system", ..., "Other".
const std::vector<std::string>& organSystems();

/// One of `organSystems`, by the words of a name as TotalSegmentator, 3D Slicer and anatomical atlases give
/// them, in any case and with any separators: "kidney_left" is of the urinary system, "right renal artery"
/// among the arteries, "Lumbar3" among the bones. O(length).
const std::string& organSystem(std::string_view name);

} // namespace viscera::document
