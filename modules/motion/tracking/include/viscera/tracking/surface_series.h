#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::tracking {

/// One surface of an organ in all phases, the same triangles in each: vertex i is the same material point in
/// all.
struct SurfaceSeries {
  std::string name;
  Triangles triangles;        ///< `m x 3`.
  std::vector<Points> phases; ///< `n x 3` mm LPS, one for each phase.
  /// The row now of each point that the surface had before `tidySeries`, -1 where no triangle had it; empty
  /// before.
  std::vector<std::int32_t> rowOfGiven = {};

  geometry::TriangleMesh at(std::size_t phase) const { return {phases[phase], triangles, {}}; }
};

/// A series of surfaces that were closed and oriented outward where necessary, with counts of the changes.
struct TidySeries {
  SurfaceSeries series;
  int mergedPoints = 0;     ///< Points that repeated another one in the first phase.
  double mergedApartMm = 0; ///< How far such points lie apart in another phase, at most.
  int turnedTriangles = 0;  ///< To agree with their neighbours and face outward.
  int closedHoles = 0;      ///< Each by a flat fan around the mean of the points of its rim.
};

/// Determines the changes on the first phase and applies them to all phases, so that vertex numbers still
/// correspond: equal points (to 1e-6 mm) become one, triangles run the same way round and outward, holes are
/// closed by fans, whose middle is the mean of the rim's points in every phase, so that it is linear in them.
/// Throws `DataError` for phases with other numbers of points than the first, triangles that refer to none,
/// numbers that are not finite, and surfaces whose rims cannot be closed or that stay open. O(phases x n + m
/// log m).
TidySeries tidySeries(SurfaceSeries series);

/// The surface that contains the others: the largest volume in the first phase. Throws `DataError` without
/// any surface. O(m).
std::size_t outerOf(const std::vector<geometry::TriangleMesh>& surfaces);

/// The part of the area of `inner` that lies outside `outer` by more than `toleranceMm`, 0 to 1. O(n log m).
double partOutside(const geometry::TriangleMesh& inner,
                   const std::shared_ptr<const geometry::TriangleMesh>& outer, double toleranceMm);

/// A third of the area of the triangles around each vertex, `n` numbers, mm^2. O(m).
Values vertexAreas(const Points& points, const Triangles& triangles);

} // namespace viscera::tracking
