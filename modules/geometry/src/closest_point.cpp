#include "closest_point.h"

#include <algorithm>

namespace viscera::geometry {

Vec3 closestPointOfSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double length2 = ab.squaredNorm();
  // |a + t ab - p|^2 is least at t = (p - a) . ab / |ab|^2; beyond the ends, at an end.
  const double t = length2 > 0 ? std::clamp((p - a).dot(ab) / length2, 0.0, 1.0) : 0.0;
  return a + t * ab;
}

Vec3 closestPointOfTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double area2 = normal.squaredNorm();
  if (area2 > 0) {
    // Barycentric coordinates of the projection: inside the triangle it is the answer.
    const double u = normal.dot((b - p).cross(c - p)) / area2;
    const double v = normal.dot((c - p).cross(a - p)) / area2;
    const double w = 1 - u - v;
    if (u >= 0 && v >= 0 && w >= 0)
      return u * a + v * b + w * c;
  }
  Vec3 best = closestPointOfSegment(p, a, b);
  for (const Vec3& other : {closestPointOfSegment(p, b, c), closestPointOfSegment(p, c, a)})
    if ((other - p).squaredNorm() < (best - p).squaredNorm())
      best = other;
  return best;
}

} // namespace viscera::geometry
