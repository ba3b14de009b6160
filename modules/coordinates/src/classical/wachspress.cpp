#include "viscera/coordinates/systems.h"

#include <algorithm>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include "cage/coplanar_groups.h"
#include "viscera/coordinates/cage/cage.h"
#include "viscera/coordinates/pointwise_system.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::coordinates {
namespace {

/// Part of the cage's size: how far a corner may stand out of a plane of a convex cage.
constexpr double kConvex = 1e-9;
/// Part of the cage's size: nearer to a face the distance is taken as this. That gives the limit on it to
/// the same accuracy.
constexpr double kOnFace = 1e-13;

/// The triangles around every corner, each in the order of their edges.
std::vector<std::vector<Eigen::Index>> fansOf(const Triangles& cage, Eigen::Index corners) {
  std::vector<std::map<int, std::pair<int, Eigen::Index>>> next(static_cast<std::size_t>(corners));
  for (Eigen::Index t = 0; t < cage.rows(); ++t)
    for (int i = 0; i < 3; ++i)
      next[static_cast<std::size_t>(cage(t, i))][cage(t, (i + 1) % 3)] = {cage(t, (i + 2) % 3), t};
  std::vector<std::vector<Eigen::Index>> fans(next.size());
  for (std::size_t corner = 0; corner < next.size(); ++corner) {
    if (next[corner].empty())
      continue;
    const int first = next[corner].begin()->first;
    for (int at = first; fans[corner].empty() || at != first;) {
      const auto& [to, triangle] = next[corner].at(at);
      fans[corner].push_back(triangle);
      at = to;
    }
  }
  return fans;
}

void requireConvex(const Points& handles, const Triangles& cage, double tolerance) {
  for (Eigen::Index t = 0; t < cage.rows(); ++t) {
    const auto [a, b, c] = geometry::cornersOf(handles, cage, t);
    const Vec3 normal = (b - a).cross(c - a).normalized();
    const double offset = normal.dot((a + b + c) / 3);
    for (const auto corner : cage.reshaped())
      if (handles.row(corner).dot(normal) - offset > tolerance)
        throw DataError(phrase("It is not convex at its triangle %1", t), "the cage",
                        "take a convex cage, or none: then the convex hull of the handles is the cage");
  }
}

/// The planes of a cage's flat faces, n . x = offset, and the one that each triangle lies in.
struct FacePlanes {
  Points normals;
  Values offsets;
  std::vector<Eigen::Index> ofTriangle;

  FacePlanes(const Points& handles, const Triangles& cage) {
    std::map<int, Eigen::Index> numbers;
    for (const int group : coplanarGroups(handles, cage))
      ofTriangle.push_back(numbers.emplace(group, static_cast<Eigen::Index>(numbers.size())).first->second);
    const auto count = static_cast<Eigen::Index>(numbers.size());
    normals = Points::Zero(count, 3);
    Points middles = Points::Zero(count, 3);
    Values areas = Values::Zero(count);
    for (Eigen::Index t = 0; t < cage.rows(); ++t) {
      const auto [a, b, c] = geometry::cornersOf(handles, cage, t);
      const Vec3 area = (b - a).cross(c - a);
      const Eigen::Index own = ofTriangle[static_cast<std::size_t>(t)];
      normals.row(own) += area.transpose();
      middles.row(own) += area.norm() * (a + b + c).transpose() / 3;
      areas[own] += area.norm();
    }
    normals.rowwise().normalize();
    offsets = normals.cwiseProduct(middles).rowwise().sum().cwiseQuotient(areas);
  }

  /// The planes around a corner, each once where neighbours in its fan of triangles share one.
  std::vector<Eigen::Index> around(const std::vector<Eigen::Index>& fan) const {
    std::vector<Eigen::Index> planes;
    for (const Eigen::Index triangle : fan)
      if (const Eigen::Index own = ofTriangle[static_cast<std::size_t>(triangle)];
          planes.empty() || planes.back() != own)
        planes.push_back(own);
    while (planes.size() > 1 && planes.front() == planes.back())
      planes.pop_back();
    return planes;
  }
};

class WachspressSolver final : public PointSolver {
public:
  WachspressSolver(const Points& handles, const Triangles& cage) : size_(boundsOf(handles).diagonal()) {
    requireConvex(handles, cage, kConvex * size_);
    // Triangles in one plane are one face: near it the volume between their two poles, which are the same,
    // and a third is rounding times the square of the poles' length, more than what the face itself has.
    FacePlanes planes(handles, cage);
    for (const auto& fan : fansOf(cage, handles.rows()))
      fans_.push_back(planes.around(fan));
    normals_ = std::move(planes.normals);
    offsets_ = std::move(planes.offsets);
  }

  bool solve(const Vec3& point, Values& weights) const override { return add(point, weights, nullptr); }

  bool solveGradients(const Vec3& point, Values& weights, Points& gradients) const override {
    return add(point, weights, &gradients);
  }

private:
  bool add(const Vec3& point, Values& weights, Points* gradients) const {
    // h_f = n_f . v - n_f . p, the distance of p to the plane of face f; the poles p_f = n_f / h_f are the
    // corners of the polytope that is dual to the cage around p.
    const Values heights = offsets_ - normals_ * point;
    const double nearest = heights.minCoeff();
    if (nearest < -kConvex * size_ || (gradients && nearest <= kOnFace * size_))
      return false;
    const Values above = heights.cwiseMax(kOnFace * size_);
    const Points poles = normals_.array().colwise() / above.array();
    for (std::size_t corner = 0; corner < fans_.size(); ++corner)
      addCorner(static_cast<Eigen::Index>(corner), poles, weights, gradients);
    // a_v = w_v / W with W = sum w_v, and so grad a_v = (grad w_v - a_v grad W) / W.
    const double sum = weights.sum();
    if (!(sum > 0))
      return false;
    weights = weights.cwiseMax(0) / sum;
    if (gradients) {
      const Eigen::RowVector3d ofSum = gradients->colwise().sum();
      *gradients = (*gradients - weights * ofSum) / sum;
    }
    return true;
  }

  /// w_v = sum_j det(p_1, p_j, p_j+1), six times the volume between p and the dual's face of v. That face
  /// lies in the plane q . (v - p) = 1, a distance 1 / |v - p| away, so that w_v (v - p) is twice its area
  /// vector. The area vectors of a closed surface sum to zero: sum w_v (v - p) = 0.
  void addCorner(Eigen::Index corner, const Points& poles, Values& weights, Points* gradients) const {
    const auto& fan = fans_[static_cast<std::size_t>(corner)];
    for (std::size_t j = 1; j + 1 < fan.size(); ++j) {
      const Vec3 a = poles.row(fan[0]).transpose(), b = poles.row(fan[j]).transpose(),
                 c = poles.row(fan[j + 1]).transpose();
      const double volume = a.dot(b.cross(c));
      weights[corner] += volume;
      // grad h_f = -n_f makes dp_f = p_f (p_f . dp), and with a determinant linear in each column grad
      // det(p_1, p_j, p_j+1) = det(p_1, p_j, p_j+1) (p_1 + p_j + p_j+1).
      if (gradients)
        gradients->row(corner) += volume * (a + b + c).transpose();
    }
  }

  double size_;
  std::vector<std::vector<Eigen::Index>> fans_; ///< The faces around each handle, in order.
  Points normals_;
  Values offsets_;
};

} // namespace

/// Wachspress coordinates of a convex cage (thesis 2.3; Warren 1996, doi 10.1007/BF02127699; in this form
/// Floater, Gillette, Sukumar 2014, doi 10.1137/130925712). With `p_f = n_f / h_f` for the faces around a
/// corner, in order, and h the distances to their planes, the corner's weight is the sum of
/// `det(p_1, p_j, p_j+1)`: rational functions, positive and smooth inside. The cage is `HandleSet::cage`,
/// else the convex hull of the handles. Throws `DataError` for a cage that is not convex. O(triangles) a
/// point.
std::shared_ptr<const CoordinateSystem> wachspress() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{
          .id = "wachspress",
          .name = "Wachspress",
          .summary = "Rational coordinates of a convex cage; positive and smooth inside",
          .traits = {.needsCage = true, .positive = true, .interpolates = true, .closedFormGradient = true}},
      [](const HandleSet& handles, const ParameterValues&) {
        return std::make_unique<WachspressSolver>(handles.positions, cageOf(handles));
      });
}

} // namespace viscera::coordinates
