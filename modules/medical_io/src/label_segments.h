#pragma once

#include <vector>

#include "image_formats/raw_image.h"
#include "viscera/medical_io/label_map.h"

namespace viscera::medical_io {

/// Sets names and colours of the segments listed in `stated`; the first entry for a label counts, and a
/// warning lists the others.
void nameSegments(LabelMap& map, const std::vector<StatedSegment>& stated);

/// Gives every segment that has none a name ("label 5") and a colour, that of its anatomy or else one of its
/// own; makes equal names different.
void completeSegments(LabelMap& map);

/// Counts the voxels of every segment and finds the boxes around them; segments without voxels are left as
/// they are. O(voxels), on all threads.
void measureSegments(LabelMap& map, Progress& progress);

/// Writes `number` where `mask` is not 0 into the first of the layers in which all these voxels are free, or
/// into a new one; gives that layer's index. All are of one size. O(layers voxels).
int addToFreeLayer(std::vector<LabelLayer>& layers, const LabelLayer& mask, std::uint16_t number);

} // namespace viscera::medical_io
