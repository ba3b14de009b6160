#pragma once

#include <vector>

#include "viscera/medical_io/label_map.h"

namespace viscera::medical_io {

/// Writes `number` where `mask` is not 0 into the first of the layers in which all these voxels are free, or
/// into a new one; gives that layer's index. All are of one size. O(layers voxels).
int addToFreeLayer(std::vector<LabelMap::Layer>& layers, const LabelMap::Layer& mask, std::uint16_t number);

} // namespace viscera::medical_io
