#pragma once

#include <cstddef>

#include "window/slices/slice_widget.h"
#include "window/timeline/measured_motion.h"

namespace viscera::app {

/// What a slice of the document's study said of the phase that is shown, for its pane: weight and quality in
/// words with their light. Empty while the organs are not posed by a motion from these images.
SliceVerdict planeVerdict(const MeasuredMotion& measured, const Playback& playback, std::size_t slice);

} // namespace viscera::app
