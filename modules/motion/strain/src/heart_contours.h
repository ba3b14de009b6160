#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viscera/strain/heart_gauge.h"
#include "viscera/strain/material_contour.h"

namespace viscera::strain {

/// A surface of a heart, at rest and in the phases.
struct SurfacePlace {
  std::optional<HeartSurface> HeartSurfaces::*rest;
  std::vector<Points> HeartPhases::*phases;
};
inline constexpr SurfacePlace kLeftPlace{&HeartSurfaces::left, &HeartPhases::left};
inline constexpr SurfacePlace kRightPlace{&HeartSurfaces::right, &HeartPhases::right};
inline constexpr SurfacePlace kOuterPlace{&HeartSurfaces::outer, &HeartPhases::outer};
inline constexpr SurfacePlace kAtriumPlace{&HeartSurfaces::atrium, &HeartPhases::atrium};
inline constexpr SurfacePlace kPlaces[] = {kLeftPlace, kRightPlace, kOuterPlace, kAtriumPlace};

/// A material line on one of the surfaces of a heart.
struct HeartContour {
  std::string name;
  MaterialContour line;
  SurfacePlace surface; ///< On which it lies.
  bool listed = false;  ///< Not cut, but given by its vertices.
};

/// The contours whose lengths are measured.
struct HeartContours {
  std::vector<HeartContour> longitudinal, circumferential;
  std::optional<HeartContour> rightFreeWall;
  std::vector<HeartContour> reservoir; ///< Of the left atrium; their mean is measured.
  std::vector<HeartContour> others;    ///< Listed ones of other names.
};

/// The surfaces with their caps, which are found where they are not known.
HeartSurfaces withCaps(HeartSurfaces surfaces, const HeartAxes& axes);

/// Cuts them at rest; listed ones take the place of those of the same name. The caps of all surfaces have to
/// be known. Throws `DataError` for a listed contour that cannot be. O(n + m) for each.
HeartContours findContours(const HeartSurfaces& surfaces, const HeartAxes& axes,
                           const std::vector<ListedContour>& listed);

} // namespace viscera::strain
