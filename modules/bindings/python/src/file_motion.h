#pragma once

#include "motion_source.h"
#include "viscera/live/sequence_file.h"

namespace viscera::python {

/// Converts the contents of a sequence file to a sequence for Python. Only in the extension `_motion`.
MotionSource sourceOf(const live::SequenceFile& file);

} // namespace viscera::python
