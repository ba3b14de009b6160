#pragma once

#include <functional>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/document/ids.h"

namespace viscera::document {

struct DocumentState;
struct Organ;

/// A place that is measured from or to. On an organ's surface it goes where the surface goes.
struct MeasuredPoint {
  Vec3 rest = Vec3::Zero();    ///< At rest, mm, LPS.
  OrganId organ;               ///< Whose surface it is on; none for a place that stays.
  int triangle = -1;           ///< Row of that organ's triangles.
  Vec3 weights = Vec3::Zero(); ///< Barycentric, of the triangle's corners; their sum is 1.

  friend bool operator==(const MeasuredPoint&, const MeasuredPoint&) = default;
};

/// What a user measures: two points are a distance, three the angle at the middle one.
struct Measurement {
  MeasurementId id;
  std::string name;
  std::vector<MeasuredPoint> points; ///< Two or three.

  friend bool operator==(const Measurement&, const Measurement&) = default;
};

using MeasurementList = std::vector<Measurement>;

enum class MeasurementKind { distance, angle };

/// Two points are a distance, more an angle.
MeasurementKind kindOf(const Measurement& measurement);
/// "distance" or "angle".
std::string nameOf(MeasurementKind kind);
/// "mm" or "deg".
std::string unitOf(MeasurementKind kind);

/// The distance of two places in mm, or the angle at the second of three in degrees, 0 to 180. The angle is 0
/// where one of its legs has no length.
double measuredValue(const std::vector<Vec3>& places);

/// What a measurement says.
struct MeasuredValues {
  double rest = 0;          ///< mm or degrees, at rest.
  double now = 0;           ///< With the organs' points as they are given.
  std::vector<Vec3> places; ///< Where its points are now, mm, LPS.
};

/// Where an organ's points are now, `n x 3` mm; asked for organs of the document only.
using PointsOf = std::function<const Points&(OrganId)>;

/// Measures. A point of an organ that the document does not have stays at its place at rest. O(organs).
MeasuredValues measure(const Measurement& measurement, const DocumentState& state, const PointsOf& pointsOf);

/// The point with these weights of a triangle's corners. Weights that are a little off (rounding) are made
/// whole. Throws `DataError` when there is no such triangle or the weights are no place in it.
MeasuredPoint surfacePoint(const Organ& organ, int triangle, const Vec3& weights);

/// The point of an organ's surface at rest that is nearest to a place (mm, LPS). O(triangles).
MeasuredPoint nearestPoint(const Organ& organ, const Vec3& place);

} // namespace viscera::document
