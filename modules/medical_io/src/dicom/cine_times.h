#pragma once

#include <optional>
#include <vector>

#include "dicom/slice_stack.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {

/// The pictures of one place in the order of the heart's cycle.
struct CineTimes {
  std::vector<std::size_t> frames;       ///< By indices into all frames, one for each phase.
  std::vector<double> fractions;         ///< Of the cycle, in [0, 1), ascending; one for each frame.
  std::vector<double> missing;           ///< The same of phases that have no picture, ascending.
  std::vector<double> ofDamaged;         ///< One for each damaged frame; below 0: not told.
  double intervalMs = 0;                 ///< 0: not stated, and not to be told.
  int stated = 0;                        ///< How many phases the files say a cycle has; 0: not stated.
  std::size_t doubled = 0;               ///< Pictures of a phase that has another one already.
  std::optional<double> wrongIntervalMs; ///< Stated, but shorter than the times of the phases.
};

/// Places the frames of one place in the heart's cycle: by parts of the cycle, by trigger times, by temporal
/// positions, or by their numbers where the file states how many phases there are. `damaged` are frames of
/// the same place without pictures. Nothing where no such time tells the frames apart, and where they leave
/// more than half of the cycle out, as images of one instant do. O(n log n).
std::optional<CineTimes> cineTimesOf(const FrameList& list, const std::vector<std::size_t>& frames,
                                     const std::vector<DicomFrame>& damaged);

} // namespace viscera::medical_io
