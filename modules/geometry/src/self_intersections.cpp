#include "viscera/geometry/self_intersections.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include <unsupported/Eigen/BVH>

#include "viscera/core/exact_sum.h"

namespace viscera::geometry {
namespace {

using Box = Eigen::AlignedBox3d;
using CornerPoints = std::array<Vec3, 3>;

constexpr double kRounding = std::numeric_limits<double>::epsilon() / 2;
/// Part of the permanent of the determinant, with the rounding of the bound itself.
constexpr double kBound3 = 8 * kRounding;
constexpr double kBound2 = 4 * kRounding;
constexpr Eigen::Index kTrianglesAtOnce = 256;

int sign(double value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

/// a b = fl(a b) + fma(a, b, -fl(a b)), without an error.
void addProduct(ExactSum& sum, double a, double b) {
  const double product = a * b;
  sum.add(product);
  sum.add(std::fma(a, b, -product));
}

void addProduct(ExactSum& sum, double a, double b, double c) {
  const double product = a * b;
  addProduct(sum, product, c);
  addProduct(sum, std::fma(a, b, -product), c);
}

/// Adds `factor` (1 or -1) times the determinant of three points.
void addDeterminant(ExactSum& sum, double factor, const Vec3& a, const Vec3& b, const Vec3& c) {
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    addProduct(sum, factor * a[k], b[i], c[j]);
    addProduct(sum, -factor * a[k], b[j], c[i]);
  }
}

/// Computes `side` without rounding, where rounding could have changed the sign of its determinant.
int exactSide(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  // det(a - d, b - d, c - d) = det(a, b, c) - det(d, b, c) - det(a, d, c) - det(a, b, d), where nothing is
  // subtracted before it is summed exactly.
  ExactSum sum;
  addDeterminant(sum, 1, a, b, c);
  addDeterminant(sum, -1, d, b, c);
  addDeterminant(sum, -1, a, d, c);
  addDeterminant(sum, -1, a, b, d);
  return sign(sum.value());
}

/// The side of the plane through a, b, c on which d is.
int side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  // The sign of det(a - d, b - d, c - d), expanded along its last row. Rounding changes it by less than
  // kBound3 times the same sum of magnitudes (the permanent).
  const Vec3 x = a - d, y = b - d, z = c - d;
  const Vec3 minors(y[0] * z[1] - y[1] * z[0], z[0] * x[1] - z[1] * x[0], x[0] * y[1] - x[1] * y[0]);
  const Vec3 sizes(std::abs(y[0] * z[1]) + std::abs(y[1] * z[0]),
                   std::abs(z[0] * x[1]) + std::abs(z[1] * x[0]),
                   std::abs(x[0] * y[1]) + std::abs(x[1] * y[0]));
  const Vec3 heights(x[2], y[2], z[2]);
  const double value = heights.dot(minors);
  return std::abs(value) > kBound3 * heights.cwiseAbs().dot(sizes) ? sign(value) : exactSide(a, b, c, d);
}

/// The same in the plane that is left when an axis is dropped.
class Flat {
public:
  explicit Flat(const CornerPoints& triangle) {
    const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]).cwiseAbs();
    Eigen::Index dropped = 0;
    normal.maxCoeff(&dropped);
    u_ = (dropped + 1) % 3;
    v_ = (dropped + 2) % 3;
  }

  int side(const Vec3& a, const Vec3& b, const Vec3& c) const {
    // The sign of (a - c) x (b - c) in the plane, in the same way.
    const double left = (a[u_] - c[u_]) * (b[v_] - c[v_]);
    const double right = (a[v_] - c[v_]) * (b[u_] - c[u_]);
    const double value = left - right;
    return std::abs(value) > kBound2 * (std::abs(left) + std::abs(right)) ? sign(value) : exactSide(a, b, c);
  }

  bool inside(const Vec3& p, const CornerPoints& t) const {
    // Never left of one edge and right of another.
    const std::array<int, 3> sides = {side(t[0], t[1], p), side(t[1], t[2], p), side(t[2], t[0], p)};
    const auto [low, high] = std::minmax_element(sides.begin(), sides.end());
    return *low >= 0 || *high <= 0;
  }

  bool cross(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b) const {
    const int pa = side(p, q, a), pb = side(p, q, b), ap = side(a, b, p), aq = side(a, b, q);
    if (pa == 0 && pb == 0) // On one line; an end within the other is found by `inside`.
      return false;
    return pa * pb <= 0 && ap * aq <= 0;
  }

  bool meets(const Vec3& p, const Vec3& q, const CornerPoints& t) const {
    return inside(p, t) || inside(q, t) || cross(p, q, t[0], t[1]) || cross(p, q, t[1], t[2]) ||
           cross(p, q, t[2], t[0]);
  }

private:
  int exactSide(const Vec3& a, const Vec3& b, const Vec3& c) const {
    ExactSum sum;
    for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &c), std::pair(&c, &a)}) {
      addProduct(sum, (*from)[u_], (*to)[v_]);
      addProduct(sum, -(*from)[v_], (*to)[u_]);
    }
    return sign(sum.value());
  }

  Eigen::Index u_ = 0, v_ = 1;
};

bool segmentMeets(const Vec3& p, const Vec3& q, const CornerPoints& t) {
  // The ends lie on either side of the plane, and the line p q passes the three edges on one side: the
  // tetrahedra (p, q, t_i, t_i+1) have no opposite signs.
  const int atP = side(t[0], t[1], t[2], p), atQ = side(t[0], t[1], t[2], q);
  if (atP * atQ > 0)
    return false;
  if (atP == 0 && atQ == 0)
    return Flat(t).meets(p, q, t);
  const std::array<int, 3> sides = {side(p, q, t[0], t[1]), side(p, q, t[1], t[2]), side(p, q, t[2], t[0])};
  const auto [low, high] = std::minmax_element(sides.begin(), sides.end());
  return *low >= 0 || *high <= 0;
}

class Pairs {
public:
  explicit Pairs(const TriangleMesh& mesh) : mesh_(mesh) {
    const double smallest = std::pow(kRounding * boundsOf(mesh.points).diagonal(), 2);
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(mesh.triangles.rows()); ++t) {
      const CornerPoints c = corners(t);
      if ((c[1] - c[0]).cross(c[2] - c[0]).norm() <= smallest)
        continue;
      numbers_.push_back(t);
      boxes_.push_back(Box(c[0]).extend(c[1]).extend(c[2]));
    }
    tree_.init(numbers_.begin(), numbers_.end(), boxes_.begin(), boxes_.end());
  }

  Eigen::Index count() const { return static_cast<Eigen::Index>(numbers_.size()); }

  /// Pairs of the triangle at `place` and a later one that meet.
  int meeting(Eigen::Index place) const {
    Search search{*this, numbers_[static_cast<std::size_t>(place)], boxes_[static_cast<std::size_t>(place)],
                  0};
    Eigen::BVIntersect(tree_, search);
    return search.found;
  }

private:
  struct Search {
    const Pairs& pairs;
    std::int32_t triangle;
    const Box& box;
    int found;
    bool intersectVolume(const Box& other) const { return box.intersects(other); }
    bool intersectObject(std::int32_t other) {
      if (other > triangle && pairs.meet(triangle, other))
        ++found;
      return false;
    }
  };

  CornerPoints corners(std::int32_t t) const { return cornersOf(mesh_.points, mesh_.triangles, t); }

  bool meet(std::int32_t s, std::int32_t t) const {
    const CornerPoints a = corners(s), b = corners(t);
    std::array<int, 3> partner = {-1, -1, -1}; // The corner of t that a corner of s is.
    int shared = 0;
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        if (mesh_.triangles(s, i) == mesh_.triangles(t, k)) {
          partner[static_cast<std::size_t>(i)] = k;
          ++shared;
        }
    if (shared == 0)
      return edgesMeet(a, b) || edgesMeet(b, a);
    if (shared == 1)
      return meetBesideVertex(a, b, partner);
    return shared > 2 || foldedOver(a, b, partner);
  }

  static bool edgesMeet(const CornerPoints& a, const CornerPoints& b) {
    return segmentMeets(a[0], a[1], b) || segmentMeets(a[1], a[2], b) || segmentMeets(a[2], a[0], b);
  }

  static bool meetBesideVertex(const CornerPoints& a, const CornerPoints& b,
                               const std::array<int, 3>& partner) {
    const auto i =
        static_cast<std::size_t>(std::max_element(partner.begin(), partner.end()) - partner.begin());
    const auto k = static_cast<std::size_t>(partner[i]);
    return segmentMeets(a[(i + 1) % 3], a[(i + 2) % 3], b) || segmentMeets(b[(k + 1) % 3], b[(k + 2) % 3], a);
  }

  static bool foldedOver(const CornerPoints& a, const CornerPoints& b, const std::array<int, 3>& partner) {
    const auto i =
        static_cast<std::size_t>(std::min_element(partner.begin(), partner.end()) - partner.begin());
    const Vec3 &from = a[(i + 1) % 3], &to = a[(i + 2) % 3];
    const auto k = static_cast<std::size_t>(3 - partner[(i + 1) % 3] - partner[(i + 2) % 3]);
    // Both lie in one plane, on one side of the common edge: their normals, each taken along that edge,
    // agree.
    return side(from, to, a[i], b[k]) == 0 &&
           (to - from).cross(a[i] - from).dot((to - from).cross(b[k] - from)) > 0;
  }

  const TriangleMesh& mesh_;
  std::vector<std::int32_t> numbers_;
  std::vector<Box> boxes_;
  Eigen::KdBVH<double, 3, std::int32_t> tree_;
};

} // namespace

int countSelfIntersections(const TriangleMesh& mesh, Progress& progress, Threads threads) {
  if (mesh.triangles.rows() == 0)
    return 0;
  const Pairs pairs(mesh);
  std::atomic<int> total = 0;
  parallelRanges(pairs.count(), kTrianglesAtOnce, threads, [&](Eigen::Index begin, Eigen::Index end) {
    progress.throwIfCancelled();
    int found = 0;
    for (Eigen::Index place = begin; place < end; ++place)
      found += pairs.meeting(place);
    total += found;
  });
  return total;
}

} // namespace viscera::geometry
