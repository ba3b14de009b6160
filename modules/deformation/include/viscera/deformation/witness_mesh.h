#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"
#include "viscera/geometry/triangle_mesh.h"

/// A tetrahedral mesh of an organ's interior, at whose points distortion is measured.
namespace viscera::deformation {

/// `t x 4` corners of tetrahedra, row major. Positive: `(b - a) x (c - a) . (d - a) > 0`, the order that
/// VTK's `VTK_TETRA` wants too.
using Tetrahedra = Eigen::Matrix<std::int32_t, Eigen::Dynamic, 4, Eigen::RowMajor>;

/// The interior of an organ at rest: witness points, at which distortion is measured (thesis 5.2), joined to
/// tetrahedra so that what is measured can be drawn as a solid.
struct WitnessMesh {
  /// `n x 3`, mm, LPS, at rest. The witness points, strictly inside the organ, come first; those behind them
  /// lie on its surface, or on a cavity's wall, and only close the solid.
  Points points;
  Tetrahedra tetrahedra;      ///< `t x 4` indices into `points`, positive.
  Eigen::Index witnesses = 0; ///< Rows [0, witnesses) of `points` are witness points.

  bool isWitness(Eigen::Index point) const { return point < witnesses; }
};

/// Signed volumes of the tetrahedra, `t` numbers, mm^3. O(t).
Values tetrahedronVolumes(const Points& points, const Tetrahedra& tetrahedra);

/// The triangles that belong to one tetrahedron only, outward: the skin of the solid. Sorted by their
/// corners' indices. O(t log t).
Triangles skinOf(const Tetrahedra& tetrahedra);

/// Throws `DataError` that names the first offending element: a coordinate that is not finite, an index out
/// of range, a tetrahedron that is turned around or has no volume (below 1e-15 of the box), more witnesses
/// than points, or no witness at all. `where` names the mesh in the message. O(n + t).
void requireUsable(const WitnessMesh& mesh, const std::string& where);

/// The mesh without what lies inside `cavities` (blood in a ventricle is no tissue that could be distorted),
/// with their walls as its skin there: tetrahedra in a cavity are removed, those on its wall are cut along
/// it, with a new point on every edge that goes through. Corners inside a cavity are no longer witnesses, and
/// unused points are removed; all other witnesses keep their place and order and come first. Unchanged when
/// no cavity meets the mesh or nothing would be left. O((n + t) log m) on several threads; the same answer
/// whatever their number.
WitnessMesh withoutCavities(const WitnessMesh& mesh,
                            const std::vector<std::shared_ptr<const geometry::TriangleMesh>>& cavities,
                            Threads threads = {});

/// Takes at most `most` of the first `count` points, spread evenly: one in each cell of a cubic grid, the
/// one nearest to the cell's middle. Ascending. The same points give the same answer. O(count).
std::vector<int> thinnedPoints(const Points& points, Eigen::Index count, int most);

} // namespace viscera::deformation
