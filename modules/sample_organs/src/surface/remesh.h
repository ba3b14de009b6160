#pragma once

#include "implicit/implicit_node.h"
#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/triangle_mesh.h"

/// Remeshes the surface of a sample organ with equilateral triangles.
namespace viscera::sample_organs {

/// The area of an equilateral triangle with edges of length 1.
inline constexpr double kTriangleArea = 0.433;

/// Rebuilds a closed manifold surface of `node` from about equilateral triangles, about `triangles` of them
/// (within a few per cent), whose vertices lie on the surface; where the node asks for another edge scale the
/// triangles follow it. Incremental remeshing (Botsch and Kobbelt 2004, 10.1145/1057432.1057457): split above
/// 4/3 of the wanted length, collapse below 4/5, flip towards valence six, relax along the surface, project.
/// We adapt the wanted length to meet the count. Bitwise independent of the number of threads. Throws
/// `Cancelled`.
geometry::TriangleMesh remesh(const geometry::TriangleMesh& mesh, const ImplicitNode& node, int triangles,
                              Threads threads, Progress& progress);

} // namespace viscera::sample_organs
