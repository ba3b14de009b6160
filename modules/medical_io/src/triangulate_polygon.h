#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::medical_io {

/// Cuts a polygon of three or more different corners (rows of `points`) into triangles of the same
/// orientation and appends them. Quadrilaterals are cut so that no triangle turns over, along the shorter
/// diagonal where both ways do; larger polygons by ears, which is quadratic, so that those above 2000 corners
/// become a fan. False when a polygon that is not a triangle or quadrilateral had to become a fan, which is
/// right only for a convex one.
bool triangulatePolygon(std::span<const std::int32_t> polygon, const Points& points,
                        std::vector<std::array<std::int32_t, 3>>& out);

} // namespace viscera::medical_io
