#pragma once

#include "viscera/core/arrays.h"

namespace viscera::geometry {

/// The point of the segment ab nearest to p; a and b may coincide.
Vec3 closestPointOfSegment(const Vec3& p, const Vec3& a, const Vec3& b);

/// The point of the triangle abc nearest to p; the triangle may be degenerate.
Vec3 closestPointOfTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

} // namespace viscera::geometry
