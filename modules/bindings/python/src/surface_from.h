#pragma once

#include <pybind11/pybind11.h>

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::python {

/// Makes a surface from arrays, n x 3 and m x 3, which are copied. Throws `DataError` for invalid arrays.
geometry::TriangleMesh meshFrom(const pybind11::handle& points, const pybind11::handle& triangles);

/// Throws `DataError` that names the first triangle with a vertex that is not there. O(m).
void requireIndices(const Triangles& triangles, Eigen::Index points);

} // namespace viscera::python
