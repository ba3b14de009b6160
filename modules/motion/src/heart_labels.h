#pragma once

#include <vector>

#include "viscera/medical_io/label_map.h"
#include "viscera/motion/motion_series.h"

namespace viscera::motion {

/// The surfaces of a heart by the names of its labels (`medical_io::heartLabels`): "heart" with muscle
/// and all chambers, and a cavity for each chamber ("LV", "RV", "LA", "RA"). Empty where there is no muscle
/// or no ventricle, or where a chamber comes twice.
std::vector<LabelledSurface> heartSurfaces(const medical_io::LabelMap& map);

} // namespace viscera::motion
