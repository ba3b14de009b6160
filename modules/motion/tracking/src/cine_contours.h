#pragma once

#include <vector>

#include "viscera/tracking/cine_fit.h"
#include "viscera/tracking/plane_tracks.h"

namespace viscera::tracking {

/// Where a labelled surface crosses an image plane, followed over the phases to the next labelled one.
struct CineContour {
  std::size_t plane = 0, surface = 0;
  Points at;               ///< `k x 3` mm, in the labelled phase.
  Eigen::MatrixXd weights; ///< `k x n`: the same points by the rig's handles.
  Values lengths;          ///< The part of the contour that is theirs, mm.
  Values onRim;            ///< 1 for those near the rim of a cap, else 0.
  /// One for each phase of the chain, the next labelled one last; without rows where there is no image.
  std::vector<PlaneTracker::Followed> followed;
  /// How far, at the next labelled phase, the tissue arrives from its surface there, and from its contour in
  /// the plane, smoothed and limited: what has drifted.
  Values closure;
  Points drift;
};

/// The phases from one labelled phase to the next.
struct CineSegment {
  std::size_t from = 0, to = 0;     ///< Which labelled phases.
  std::vector<std::size_t> phases;  ///< Those between, in the order of time.
  std::vector<double> parts;        ///< How far each is on the way in time, 0 to 1.
  std::vector<CineContour> ahead;   ///< From `from` onward.
  std::vector<CineContour> against; ///< From `to` back.
};

/// What is labelled, as a rig has it.
struct LabelledPose {
  std::size_t phase = 0;
  Points pose;     ///< `n x 3`.
  Points vertices; ///< `m x 3`.
};

/// All segments of a cycle; in a series that is no loop only those between the first and the last labelled
/// phase. Contours follow their tissue, several planes at a time. Throws `Cancelled`.
std::vector<CineSegment> cineSegments(const MotionRig& rig, const std::vector<LabelledPose>& labelled,
                                      const std::vector<CinePlane>& planes, const PhaseTimes& times,
                                      const std::vector<std::vector<Eigen::Index>>& caps, Progress& progress,
                                      Threads threads);

} // namespace viscera::tracking
