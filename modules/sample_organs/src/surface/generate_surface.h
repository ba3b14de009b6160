#pragma once

#include "implicit/implicit_node.h"
#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/triangle_mesh.h"

/// Generates the surface mesh of a sample organ from its implicit surface.
namespace viscera::sample_organs {

/// The version of the generator, increased whenever the same definition gives another surface than before;
/// cached surfaces of older versions are then generated again.
inline constexpr int kGeneratorVersion = 2;

/// The goals of `generateSurface`.
struct SurfaceGoal {
  int triangles = 30000;
  double largestSpacing = 1.6; ///< mm between samples of the field.
};

/// The closed, manifold, outward surface of `node` with a colour for every vertex. Throws `DataError` when
/// there is no surface or no spacing gives a manifold one; `Cancelled`. Bitwise independent of the number of
/// threads.
geometry::TriangleMesh generateSurface(const ImplicitNode& node, const SurfaceGoal& goal, Threads threads,
                                       Progress& progress);

/// Gives each vertex the colour that the node has there.
void paintSurface(const ImplicitNode& node, geometry::TriangleMesh& mesh, Threads threads);

} // namespace viscera::sample_organs
