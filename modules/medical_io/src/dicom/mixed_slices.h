#pragma once

#include <optional>
#include <vector>

#include "dicom/slice_stack.h"
#include "viscera/medical_io/scan.h"

namespace viscera::medical_io {

/// Slices of an even grid, made from measured ones of `slice` samples each, which are not even: every sample
/// is the mean of two neighbours by their weights, rounded where samples are whole numbers. A sample is
/// padding where the nearer of the two is; where the farther one is, it is the nearer one. O(samples).
Scan::Samples mixedSlices(const Scan::Samples& measured, std::size_t slice,
                          const std::vector<SliceMix>& mixes, const std::optional<double>& padding);

} // namespace viscera::medical_io
