#pragma once

#include "viscera/medical_io/label_map.h"

namespace viscera::medical_io {

/// Gives the labels of FreeSurfer's segmentations of a whole brain (aseg, also within aparc+aseg) the names
/// and colours of its colour table, with a warning. That is one where three structures or more have the
/// numbers of both sides; of any other map numbers alone say nothing. Segments that are named stay.
void nameAsFreeSurfer(LabelMap& map);

} // namespace viscera::medical_io
