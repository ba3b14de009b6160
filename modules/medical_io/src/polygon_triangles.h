#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::medical_io {

/// What the triangles of a polygon are.
enum class PolygonCut {
  exact,  ///< They cover it, each place once.
  uneven, ///< It is not flat, and they overlap seen along its normal.
  failed  ///< It is flat and crosses itself, or is too large to be cut: no triangles were made.
};

/// Cuts a polygon of three or more corners (rows of `points`) into triangles of the same orientation and
/// appends them. Each corner stays a corner of a triangle, so that neighbours along its edges are not opened.
/// The polygon may be concave, run along an edge twice, as the bridge to a hole does, or pass through a place
/// several times, under one number or several; corners in a line and slightly bent polygons are right, too.
///
/// Quadrilaterals are cut so that no triangle turns over, along the shorter diagonal where both ways do.
/// Larger polygons lose ear after ear (Meisters 1975, doi 10.2307/2319703), the best shaped first; an ear is
/// one that no edge of the rest enters. Where that finds none, up to 200 corners, the triangles with the
/// least sum of areas are searched (Klincsek 1980, doi 10.1016/S0167-5060(08)70044-X). A result is exact when
/// the sum of its areas is the polygon's own: then no triangle is turned over, so that none lies outside.
/// Above 5000 corners only polygons are cut that a fan covers. O(n^2) as a rule.
PolygonCut triangulatePolygon(std::span<const std::int32_t> polygon, const Points& points,
                              std::vector<std::array<std::int32_t, 3>>& out);

} // namespace viscera::medical_io
