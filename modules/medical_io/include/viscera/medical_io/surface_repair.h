#pragma once

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::medical_io {

/// How a surface is made anew.
struct RepairOptions {
  int cells = 100;        ///< Grid cells along the longest side; details smaller than one are lost.
  int triangles = 10'000; ///< About as many as the result is to have.
};

/// A closed surface without intersections near a given one that may be open, self-intersecting or not
/// manifold: the zero level of its signed distance on a grid, by flying edges, smoothed and thinned out.
/// Pieces with less than a hundredth of the volume are left out. Expects valid indices. Throws `DataError`
/// when the surface encloses nothing, `Cancelled`. A second or two; bitwise independent of the number of
/// threads.
geometry::TriangleMesh repairSurface(const geometry::TriangleMesh& mesh, const RepairOptions& options,
                                     Progress& progress, Threads threads = {});

/// The surface with about `triangles` triangles, by quadric decimation (Hoppe 1999); a coarser one is
/// returned as it is. A closed surface stays closed, but may come to intersect itself.
geometry::TriangleMesh thinSurface(const geometry::TriangleMesh& mesh, int triangles);

} // namespace viscera::medical_io
