#pragma once

#include "motion_source.h"
#include "viscera/motion/sequence_file.h"

namespace viscera::python {

/// What a sequence file holds. In `_motion` alone.
MotionSource sourceOf(const motion::SequenceFile& file);

} // namespace viscera::python
