#include "viscera/geometry/exact_volume.h"

namespace viscera::geometry {
namespace {

/// a . (b x c), each product and sum rounded as written.
double product(const Vec3& a, const Vec3& b, const Vec3& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

} // namespace

void ExactVolume::addTriangle(const Vec3& a, const Vec3& b, const Vec3& c) {
  // 6 V = sum det(a - o, b - o, c - o), by Gauss's theorem the same for any o where the surface is closed.
  sixfold_.add(product(a - origin_, b - origin_, c - origin_));
}

void ExactVolume::addTetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  sixfold_.add(product(b - a, c - a, d - a));
}

void ExactVolumeAlong::addCubic(const Eigen::Matrix3d& at, const Eigen::Matrix3d& by) {
  // det(a + s u, b + s v, c + s w) by powers of s: det(a, b, c), then det(u, b, c) + det(a, v, c) +
  // det(a, b, w), then det(a, v, w) + det(u, b, w) + det(u, v, c), and det(u, v, w).
  const Vec3 a = at.col(0), b = at.col(1), c = at.col(2), u = by.col(0), v = by.col(1), w = by.col(2);
  sixfold_[0].add(product(a, b, c));
  sixfold_[1].add(product(u, b, c));
  sixfold_[1].add(product(a, v, c));
  sixfold_[1].add(product(a, b, w));
  sixfold_[2].add(product(a, v, w));
  sixfold_[2].add(product(u, b, w));
  sixfold_[2].add(product(u, v, c));
  sixfold_[3].add(product(u, v, w));
}

void ExactVolumeAlong::addTriangle(const Eigen::Matrix3d& at, const Eigen::Matrix3d& by) {
  Eigen::Matrix3d from = at;
  from.colwise() -= origin_;
  addCubic(from, by);
}

void ExactVolumeAlong::addTetrahedron(const Eigen::Matrix<double, 3, 4>& at,
                                      const Eigen::Matrix<double, 3, 4>& by) {
  Eigen::Matrix3d edges, motion;
  for (int i = 0; i < 3; ++i) {
    edges.col(i) = at.col(i + 1) - at.col(0);
    motion.col(i) = by.col(i + 1) - by.col(0);
  }
  addCubic(edges, motion);
}

std::array<double, 4> ExactVolumeAlong::mm3() const {
  std::array<double, 4> cubic;
  for (std::size_t i = 0; i < cubic.size(); ++i)
    cubic[i] = sixfold_[i].value() / 6;
  return cubic;
}

} // namespace viscera::geometry
