#pragma once

#include <string>

#include "viscera/coordinates/coordinate_system.h"

namespace viscera::coordinates {

/// A domain with its edges cut and its inside filled.
struct FilledDomain {
  Eigen::Index onSurface; ///< The first points of `solid` lie on the domain's surface.
  SolidMesh solid;
};

/// Cuts the edges of `surface` and of the tetrahedra inside to a `resolution`-th of the surface's diagonal
/// and makes the points `inside` (`k x 3`, mm) corners, right behind those of the surface. Throws
/// `UsageError` where `options` bring nobody who makes tetrahedra, naming `system`, and what that one throws.
FilledDomain filledDomain(const geometry::TriangleMesh& surface, const Points& inside, double resolution,
                          const std::string& system, const BindOptions& options, Progress& progress);

/// The number of edges across the domain, for both systems.
Parameter resolutionParameter(double maximum, double standard);

} // namespace viscera::coordinates
