#include "viscera/geometry/sides_of_plane.h"

#include <array>
#include <cmath>

namespace viscera::geometry {
namespace {

/// A corner with its height over the plane.
struct Corner {
  Vec3 place; ///< From the plane's origin.
  double height = 0;
  bool front() const { return height >= 0; }
};

double sixfold(const Vec3& a, const Vec3& b, const Vec3& c) {
  return a.dot(b.cross(c));
}

/// Where the edge between two corners on different sides meets the plane: the same bits from both triangles
/// of the edge.
Vec3 crossing(const Corner& a, const Corner& b) {
  const Corner& front = a.front() ? a : b;
  const Corner& back = a.front() ? b : a;
  return front.place + front.height / (front.height - back.height) * (back.place - front.place);
}

/// Sums of one side after the other, before they are divided.
struct Sums {
  double front = 0;
  double back = 0;
  Vec3 face = Vec3::Zero(); ///< Twice its area, as a vector.

  double& of(const Corner& corner) { return corner.front() ? front : back; }
};

/// A triangle whose first corner lies on one side and whose others lie on the other.
void addCut(const Corner& single, const Corner& second, const Corner& third, Sums& sums) {
  const Vec3 there = crossing(single, second), back = crossing(third, single);
  sums.of(single) += sixfold(single.place, there, back);
  sums.of(second) += sixfold(there, second.place, third.place) + sixfold(there, third.place, back);
  sums.face += single.front() ? there.cross(back) : back.cross(there);
}

} // namespace

SidesOfPlane sidesOfPlane(const SurfaceView& surface, const Plane& plane) {
  const Points& points = *surface.points;
  const Triangles& triangles = *surface.triangles;
  Sums sums;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    std::array<Corner, 3> corners;
    int front = 0;
    for (int k = 0; k < 3; ++k) {
      corners[k].place = points.row(triangles(t, k)).transpose() - plane.origin;
      corners[k].height = plane.normal.dot(corners[k].place);
      front += corners[k].front();
    }
    if (front == 0 || front == 3) {
      sums.of(corners[0]) += sixfold(corners[0].place, corners[1].place, corners[2].place);
      continue;
    }
    int single = 0;
    while (corners[single].front() != (front == 1))
      ++single;
    addCut(corners[single], corners[(single + 1) % 3], corners[(single + 2) % 3], sums);
  }
  return {sums.front / 6, sums.back / 6, std::abs(plane.normal.dot(sums.face)) / 2};
}

} // namespace viscera::geometry
