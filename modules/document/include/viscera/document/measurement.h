#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/document/ids.h"

namespace viscera::document {

struct Organ;

/// An end point of a measurement, on an organ's surface or in space. A point on an organ's surface moves with
/// it.
struct MeasuredPoint {
  Vec3 rest = Vec3::Zero();    ///< At rest, mm, LPS.
  OrganId organ;               ///< The organ on whose surface it lies; none for a place of the scan.
  int triangle = -1;           ///< Row of that organ's triangles.
  Vec3 weights = Vec3::Zero(); ///< Barycentric, of the triangle's corners; their sum is 1.

  friend bool operator==(const MeasuredPoint&, const MeasuredPoint&) = default;
};

enum class MeasurementKind { distance, angle, rectangle, sphere, gap };

/// A measurement of the document: the distance of two points; the angle at the middle one of three; the
/// values of the scan in a rectangle between two corners of a slice, or in a sphere around the first point
/// through the second. The points of these two are on no organ. A gap is the shortest way between the
/// surfaces of the two organs that its points are on, wherever they are nearest.
struct Measurement {
  MeasurementId id;
  std::string name;
  std::vector<MeasuredPoint> points; ///< As many as `pointCount` of its kind.
  MeasurementKind kind = MeasurementKind::distance;
  int axis = 2; ///< Of a rectangle: which of x, y, z (0, 1, 2) its plane stands on; its sides lie along the
                ///< other two. 2 for every other kind.

  friend bool operator==(const Measurement&, const Measurement&) = default;
};

using MeasurementList = std::vector<Measurement>;

/// The number of points of a measurement of that kind.
std::size_t pointCount(MeasurementKind kind);
/// Whether it is a length, in mm.
bool isLength(MeasurementKind kind);
/// Whether it measures the scan's values.
bool isRegion(MeasurementKind kind);
/// "distance", "angle", "rectangle", "sphere", "gap".
std::string nameOf(MeasurementKind kind);
/// The kind of that name; none for another word.
std::optional<MeasurementKind> measurementKindFromName(const std::string& name);

/// The point with these weights of a triangle's corners. Weights whose sum differs from 1 by rounding are
/// normalised. Throws `DataError` when there is no such triangle or the weights are no place in it.
MeasuredPoint surfacePoint(const Organ& organ, int triangle, const Vec3& weights);

/// The point of an organ's surface at rest that is nearest to a place (mm, LPS). O(triangles).
MeasuredPoint nearestPoint(const Organ& organ, const Vec3& place);

} // namespace viscera::document
