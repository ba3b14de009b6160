#pragma once

#include <vector>

#include "viscera/live/motion_series.h"
#include "viscera/medical_io/label_map.h"

namespace viscera::live {

/// The surfaces of a heart by the names of its labels (`medical_io::heartLabels`): "heart" with muscle
/// and all chambers, and a cavity for each chamber ("LV", "RV", "LA", "RA"). Empty where there is no muscle
/// or no ventricle, or where a chamber comes twice.
std::vector<LabelledSurface> heartSurfaces(const medical_io::LabelMap& map);

} // namespace viscera::live
