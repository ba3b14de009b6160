#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viscera/strain/heart_gauge.h"
#include "viscera/strain/material_contour.h"

namespace viscera::strain {

/// A material line on one of the surfaces of a heart.
struct HeartContour {
  std::string name;
  MaterialContour line;
  std::vector<Points> HeartPhases::*surface; ///< On which it lies.
};

/// The contours whose lengths are measured.
struct HeartContours {
  std::vector<HeartContour> longitudinal, circumferential;
  std::optional<HeartContour> rightFreeWall;
  std::vector<HeartContour> reservoir; ///< Of the left atrium; their mean is measured.
  std::vector<HeartContour> others;    ///< Listed ones of other names.
};

/// Cuts them at rest; listed ones take the place of those of the same name. The caps of all surfaces have to
/// be known. Throws `DataError` for a listed contour that cannot be. O(n + m) for each.
HeartContours findContours(const HeartSurfaces& surfaces, const FoundAxes& axes,
                           const std::vector<ListedContour>& listed);

} // namespace viscera::strain
