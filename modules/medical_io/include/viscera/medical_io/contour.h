#pragma once

#include <array>
#include <vector>

#include "viscera/geometry/triangle_mesh.h"

/// Makes surfaces from values on a grid (isosurfaces). Flying edges make them.
namespace viscera::medical_io {

/// The surface on which `values` are equal to `level`. The values lie, x fastest, at `origin` + `spacing` (i,
/// j, k), as many as the product of `size`. `Value` is float or unsigned char. Empty if there is no such
/// surface. Without colours; the orientation of triangles depends on the values. Points
/// and triangles come in a fixed order, whatever the number of threads. O(values). For any thread.
///
///     const std::vector<float> values = {-1, 1, -1, 1, -1, 1, -1, 1};
///     const geometry::TriangleMesh plane = contourOf(values, {2, 2, 2}, 0.0);
///     const double x = plane.points(0, 0); // 0.5
template <class Value>
geometry::TriangleMesh contourOf(const std::vector<Value>& values, const std::array<int, 3>& size,
                                 double level, const Vec3& origin = Vec3::Zero(), double spacing = 1);

} // namespace viscera::medical_io
