#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dicom/slice_stack.h"
#include "timed_volumes.h"

namespace viscera::medical_io {

/// Groups of a study that are the phases of one scan, each a series of its own, in the order of time.
struct GatedSeries {
  std::vector<std::size_t> groups;
  std::vector<SlicePhase> phases; ///< One for each group.
};

/// Finds the groups of one place, size and study, of one volume each, that differ by the part of the cycle in
/// their headers, by "30%" in their descriptions, or in CT and PET by trigger time. O(n log n).
std::vector<GatedSeries> gatedSeriesOf(const FrameList& list, const std::vector<SliceGroup>& groups);

/// Sets the parts of the cycle, names and duration of phases: by the part of the cycle that their headers or
/// descriptions state, by trigger times, else by `SlicePhase::timeMs`. Phases of the same part are left out
/// of `phases`, but for the first. `volumes.numbers` are those before.
void setPhaseTimes(const FrameList& list, std::vector<SlicePhase>& phases, TimedVolumes& volumes);

} // namespace viscera::medical_io
