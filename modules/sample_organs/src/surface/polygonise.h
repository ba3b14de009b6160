#pragma once

#include "implicit/implicit_node.h"
#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::sample_organs {

/// The largest connected piece of the surface where `node` is zero, as a raw closed mesh of about `2 area /
/// spacing^2` triangles, outward. `spacing` in mm: detail below twice that is lost or merged. Samples in
/// blocks that are refined only near the surface, then flying edges (Schroeder et al.
/// 2015, 10.1109/LDAV.2015.7348069). Throws `DataError` when there is no surface or when the field is not
/// finite somewhere; `Cancelled`.
geometry::TriangleMesh polygonise(const ImplicitNode& node, double spacing, Threads threads,
                                  Progress& progress);

} // namespace viscera::sample_organs
