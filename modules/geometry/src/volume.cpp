#include "viscera/geometry/volume.h"

#include <algorithm>
#include <cassert>
#include <utility>
#include <vector>

namespace viscera::geometry {
namespace {

constexpr Eigen::Index kBlock = 2048;

/// Sums neighbours in a tree: the order is fixed and the error grows only with the logarithm of the count.
double pairwiseSum(std::vector<double> values) {
  for (std::size_t n = values.size(); n > 1; n = (n + 1) / 2) {
    for (std::size_t i = 0; i < n / 2; ++i)
      values[i] = values[2 * i] + values[2 * i + 1];
    if (n % 2 == 1)
      values[n / 2] = values[n - 1];
  }
  return values.empty() ? 0.0 : values.front();
}

/// Six times the signed volume of the tetrahedra from `origin` to triangles [begin, end). Four running sums,
/// so that the additions do not wait for one another.
double blockSum(const Points& points, const Triangles& triangles, const Vec3& origin, Eigen::Index begin,
                Eigen::Index end) {
  double sums[4] = {0, 0, 0, 0};
  const double* data = points.data();
  const std::int32_t* index = triangles.data() + 3 * begin;
  for (Eigen::Index t = begin; t < end; ++t, index += 3) {
    const double* a = data + 3 * index[0];
    const double* b = data + 3 * index[1];
    const double* c = data + 3 * index[2];
    const double ax = a[0] - origin[0], ay = a[1] - origin[1], az = a[2] - origin[2];
    const double bx = b[0] - origin[0], by = b[1] - origin[1], bz = b[2] - origin[2];
    const double cx = c[0] - origin[0], cy = c[1] - origin[1], cz = c[2] - origin[2];
    sums[t & 3] += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

} // namespace

VolumeSum::VolumeSum(const Points& points, const Triangles& triangles)
    : points_(points), triangles_(triangles),
      blocks_(static_cast<std::size_t>((triangles.rows() + kBlock - 1) / kBlock)) {
  if (triangles.rows() > 0)
    origin_ = points.row(triangles(0, 0)).transpose();
}

PiecesOfWork VolumeSum::pieces() {
  return {static_cast<Eigen::Index>(blocks_.size()), [this](Eigen::Index block) {
            const Eigen::Index begin = block * kBlock;
            blocks_[static_cast<std::size_t>(block)] =
                blockSum(points_, triangles_, origin_, begin, std::min(triangles_.rows(), begin + kBlock));
          }};
}

double VolumeSum::volume() const {
  return pairwiseSum(blocks_) / 6;
}

double volume(const Points& points, const Triangles& triangles, Threads threads) {
  VolumeSum sum(points, triangles);
  parallelPieces({sum.pieces()}, threads);
  return sum.volume();
}

void volumeGradient(const Points& points, const Triangles& triangles, const VertexTriangles& around,
                    Points& gradient, Threads threads) {
  assert(around.first.size() == static_cast<std::size_t>(points.rows()) + 1);
  gradient.resize(points.rows(), 3);
  parallelRanges(points.rows(), kBlock, threads, [&](Eigen::Index begin, Eigen::Index end) {
    const double* data = points.data();
    for (Eigen::Index v = begin; v < end; ++v) {
      // 6 dV/dp = sum b x c over the triangles (p, b, c) around p.
      // Relative to the vertex itself the products stay as small as its triangles, so nothing cancels; the
      // sum over a closed fan is the same from any origin.
      const double* p = data + 3 * v;
      double x = 0, y = 0, z = 0;
      for (auto i = around.first[std::size_t(v)]; i < around.first[std::size_t(v) + 1]; ++i) {
        const std::int32_t* t = triangles.data() + 3 * around.items[std::size_t(i)];
        const int k = t[0] == v ? 0 : t[1] == v ? 1 : 2;
        const double* b = data + 3 * t[(k + 1) % 3];
        const double* c = data + 3 * t[(k + 2) % 3];
        const double bx = b[0] - p[0], by = b[1] - p[1], bz = b[2] - p[2];
        const double cx = c[0] - p[0], cy = c[1] - p[1], cz = c[2] - p[2];
        x += by * cz - bz * cy;
        y += bz * cx - bx * cz;
        z += bx * cy - by * cx;
      }
      gradient.row(v) << x / 6, y / 6, z / 6;
    }
  });
}

double areaOf(const Points& points, const Triangles& triangles, Eigen::Index t) {
  const auto [a, b, c] = cornersOf(points, triangles, t);
  return 0.5 * (b - a).cross(c - a).norm();
}

double area(const Points& points, const Triangles& triangles) {
  double sum = 0;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    sum += areaOf(points, triangles, t);
  return sum;
}

} // namespace viscera::geometry
