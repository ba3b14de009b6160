#pragma once

#include <filesystem>
#include <vector>

#include "viscera/core/progress.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/medical_io/space.h"

namespace viscera::medical_io {

/// A surface in several phases, as read from its files, and whether its points correspond by their numbers.
struct SurfaceSeriesFile {
  /// `n x 3` mm LPS, one a file; with the points that no triangle uses.
  std::vector<Points> phases;
  /// Triangles of the first file: polygons are cut there and the same way in all.
  Triangles triangles;
  /// Whether all files have the same number of points and the same polygons as the first. If not, `phases`
  /// holds the first only.
  bool correspond = true;
  std::size_t differs = 0;       ///< The first file that does not correspond.
  std::vector<Space> spaces;     ///< For each file: the axes in which it was written.
  std::vector<bool> spaceStated; ///< For each file: whether it states its axes, or LPS is assumed.
};

/// Reads surfaces (any format of `readSurface`) of which point i is to be the same place in all: nothing is
/// merged or dropped, which `readSurface` does file by file, so that numbers would no longer agree. Throws as
/// `readSurface`; `Cancelled`. O(points of all).
SurfaceSeriesFile readSurfaceSeries(const std::vector<std::filesystem::path>& files, Progress& progress);

} // namespace viscera::medical_io
