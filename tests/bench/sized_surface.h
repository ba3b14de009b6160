#pragma once

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::bench {

/// A closed surface of exactly `vertices` vertices with the shape of `mesh` (closed): decimated below that
/// number, then its longest edges halved until the number is met. Throws `std::runtime_error` where the
/// decimation leaves a surface that is not closed.
geometry::TriangleMesh withVertices(const geometry::TriangleMesh& mesh, Eigen::Index vertices);

} // namespace viscera::bench
