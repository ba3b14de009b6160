#pragma once

#include "viscera/geometry/triangle_mesh.h"

/// A surface elsewhere: coordinates that were in another unit or in other axes. Colours stay. O(n + m).
namespace viscera::geometry {

/// Every coordinate times `factor` (positive).
TriangleMesh scaled(TriangleMesh mesh, double factor);

/// Half a turn about the axis from foot to head, which is what leads from RAS to LPS and back: x and y change
/// their signs, nothing is mirrored. Twice is the same bits again.
TriangleMesh turnedHalf(TriangleMesh mesh);

/// Left and right exchanged: x changes its sign, and every triangle is turned around so that what faced
/// outward still does. Twice is the same bits again.
TriangleMesh mirrored(TriangleMesh mesh);

} // namespace viscera::geometry
