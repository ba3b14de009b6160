#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/deformation/witness_mesh.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/strain/aha_segments.h"
#include "viscera/strain/heart_axes.h"
#include "viscera/strain/material_strain.h"

namespace viscera::strain {

/// The surfaces at rest that bound the wall of a left ventricle.
struct WallSurfaces {
  const geometry::TriangleMesh* leftCavity = nullptr;  ///< Closed; never null.
  const geometry::TriangleMesh* outer = nullptr;       ///< The epicardium, or the whole heart; never null.
  const geometry::TriangleMesh* rightCavity = nullptr; ///< Bounds the septum; null where there is none.
};

/// The witness points in the wall of a left ventricle, with their place in it.
struct WallPoints {
  std::vector<std::int32_t> rows; ///< Of the mesh's points, ascending.
  std::vector<LocalAxes> axes;    ///< One each.
  std::vector<int> segments;      ///< 1 to 17.
  Values depth;                   ///< 0 at the endocardium, 1 at the epicardium and the septum's right side.
  Values volumes;                 ///< mm^3 of tissue for which each stands.

  Eigen::Index count() const { return static_cast<Eigen::Index>(rows.size()); }
};

/// How far the wall of each segment reaches from the left cavity, mm, by the number of the segment; infinite
/// where a segment has no vertex of the cavity (and for 0). The thickness at the cavity's vertices, to the
/// nearest place of the outer surface or of the right cavity, which 3 of 4 of them do not exceed, and a tenth
/// more: fat of a groove, roots of vessels and auricles lie farther away.
std::array<double, kSegments + 1> reachOfSegments(const WallSurfaces& surfaces, const HeartAxes& axes,
                                                  const std::vector<bool>& cap, Threads threads = {});

/// Finds the points of a left ventricle's wall in the tetrahedra of a heart, and their local axes.
///
/// Two Laplace problems are solved on linear tetrahedra: across the wall, 0 on the wall of the left cavity
/// and 1 on the outer surface and the right cavity; and along it, 0 at the tip and 1 at the annulus;
/// elsewhere nothing flows through the boundary. Their gradients are the radial and, made orthogonal to it,
/// the longitudinal axis. (Bayer and others 2018, doi 10.1016/j.media.2018.01.005; Schuler and others 2021,
/// doi 10.1016/j.media.2021.102247.) Points with a depth of nearly 1 belong to the right ventricle's free
/// wall, points behind the annulus to no ventricle, points beyond `reachOfSegments` to something beside it:
/// all are left out, as are points on the boundary.
///
/// `cap` marks the triangles of the left cavity that close valves (`FoundAxes::cap`). Throws `DataError` for
/// a mesh that does not reach the wall; `Cancelled`. Sparse Cholesky: about a second for 30,000 points. From
/// any thread; the result does not depend on the number of threads.
WallPoints wallPoints(const deformation::WitnessMesh& mesh, const WallSurfaces& surfaces,
                      const HeartAxes& axes, const std::vector<bool>& cap, Progress& progress,
                      Threads threads = {});

} // namespace viscera::strain
