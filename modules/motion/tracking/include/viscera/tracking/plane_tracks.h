#pragma once

#include <memory>
#include <vector>

#include "viscera/core/progress.h"
#include "viscera/tracking/cine_images.h"

namespace viscera::tracking {

/// Follows tissue within one plane of a cine study from phase to phase: local cross-correlation (grey values
/// less their mean, over their deviation, within 7 mm), frame to frame with composition, then against the
/// phase where the chain began. What leaves the plane cannot be followed.
class PlaneTracker {
public:
  /// Takes the images of `plane` that are nearest to `phaseFractions`, in a window around `around` (mm) with
  /// a margin. Images smaller or larger than 1.4 mm a pixel by a quarter are resampled. O(phases x pixels).
  PlaneTracker(const CinePlane& plane, const std::vector<double>& phaseFractions, const Points& around);
  ~PlaneTracker();
  PlaneTracker(PlaneTracker&&) noexcept;
  PlaneTracker& operator=(PlaneTracker&&) noexcept;

  /// Whether the plane has an image of that phase.
  bool has(std::size_t phase) const;

  /// The tissue that is at `points` (`n x 3` mm, in the plane) in phase `from` in each phase of `order`,
  /// which leads away from it; without rows for a phase that has no image, or when `from` has none.
  /// Deterministic. Throws `Cancelled`. About 0.1 s a phase.
  struct Followed {
    Points at;       ///< `n x 3` mm, in the plane.
    Values likeness; ///< 0 to 1: (max(0, c - 0.3) / 0.6)^2, c the correlation of 9 x 9 pixels around it.
  };
  std::vector<Followed> follow(const Points& points, std::size_t from, const std::vector<std::size_t>& order,
                               Progress& progress) const;

private:
  struct Window;
  std::unique_ptr<const Window> window_;
};

} // namespace viscera::tracking
