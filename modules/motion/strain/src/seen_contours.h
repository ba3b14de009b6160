#pragma once

#include <optional>
#include <vector>

#include "heart_contours.h"
#include "viscera/core/parallel.h"
#include "viscera/strain/heart_gauge.h"

namespace viscera::strain {

/// Contours along the axis that are cut anew in the surfaces that were seen in each phase of a motion
/// (`HeartPhases::seen`); none where none were. The planes move with the fit: with the middle of the mitral
/// annulus, and with the vertex at the apex. Immutable.
class SeenContours {
public:
  /// `phases` has to live longer. O(n + m) for each phase.
  SeenContours(const HeartSurfaces& rest, const FoundAxes& axes, const HeartPhases& phases, Threads threads);

  /// The lengths of a contour in all phases, mm. None for one that is listed, that was not found in some
  /// phase, or whose line there is so much longer or shorter than the followed one that it must be another.
  std::optional<std::vector<double>> lengthsOf(const HeartContour& contour) const;

private:
  const HeartPhases& phases_;
  std::vector<HeartSurfaces> surfaces_;
  std::vector<HeartContours> cut_;
};

} // namespace viscera::strain
