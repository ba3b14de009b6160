#include "viscera/deformation/witness_interpolation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/LU>

#include "viscera/geometry/cell_lists.h"

namespace viscera::deformation {
namespace {

/// A point this little outside a tetrahedron, in barycentric coordinates, still counts as inside.
constexpr double kInside = -1e-9;

/// Finds for one point after the other the corners and weights.
class Locator {
public:
  explicit Locator(const WitnessMesh& mesh)
      : mesh_(mesh),
        points_(boundsOf(mesh.points), geometry::cellEdge(boundsOf(mesh.points), mesh.points.rows())),
        tetrahedra_(points_), around_(static_cast<std::size_t>(mesh.points.rows()) + 1, 0) {
    points_.fill(mesh.points.rows(), [&](Eigen::Index i) {
      return Bounds{mesh.points.row(i).transpose(), mesh.points.row(i).transpose()};
    });
    tetrahedra_.fill(mesh.tetrahedra.rows(), [&](Eigen::Index t) {
      Points corners(4, 3);
      for (int k = 0; k < 4; ++k)
        corners.row(k) = mesh.points.row(mesh.tetrahedra(t, k));
      return boundsOf(corners);
    });
    listNeighbours();
  }

  /// The distance of the target to the place that it was given.
  double locate(const Vec3& target, Eigen::Ref<Eigen::RowVector4i> corners,
                Eigen::Ref<Eigen::RowVector4d> weights) const {
    const std::int32_t nearest = nearestPoint(target);
    corners = Eigen::RowVector4i::Constant(nearest);
    weights = Eigen::RowVector4d::Unit(0);
    const double toNearest = (mesh_.points.row(nearest).transpose() - target).norm();
    if (toNearest == 0)
      return 0;
    Best best;
    tetrahedra_.visit(tetrahedra_.cellOf(target), [&](std::int32_t t) { consider(t, target, best); });
    const bool inside = best.least >= kInside;
    if (!inside) { // Outside: the tetrahedra at the nearest point reach furthest towards it.
      best = {};
      for (auto i = around_[std::size_t(nearest)]; i < around_[std::size_t(nearest) + 1]; ++i)
        consider(neighbours_[static_cast<std::size_t>(i)], target, best);
    }
    if (best.tetrahedron < 0)
      return toNearest;
    corners = mesh_.tetrahedra.row(best.tetrahedron);
    weights = best.weights.cwiseMax(0.0);
    weights /= weights.sum();
    if (inside)
      return 0;
    Vec3 given = Vec3::Zero();
    for (int k = 0; k < 4; ++k)
      given += weights[k] * mesh_.points.row(corners[k]).transpose();
    return (given - target).norm();
  }

private:
  struct Best {
    std::int32_t tetrahedron = -1;
    double least = -std::numeric_limits<double>::infinity(); ///< The smallest weight.
    Eigen::RowVector4d weights = Eigen::RowVector4d::Zero();
  };

  void listNeighbours() {
    const auto& tetrahedra = mesh_.tetrahedra;
    for (Eigen::Index i = 0; i < tetrahedra.size(); ++i)
      ++around_[static_cast<std::size_t>(tetrahedra.data()[i]) + 1];
    for (std::size_t i = 1; i < around_.size(); ++i)
      around_[i] += around_[i - 1];
    neighbours_.resize(static_cast<std::size_t>(around_.back()));
    std::vector<std::int64_t> next(around_.begin(), around_.end() - 1);
    for (Eigen::Index i = 0; i < tetrahedra.size(); ++i)
      neighbours_[static_cast<std::size_t>(next[static_cast<std::size_t>(tetrahedra.data()[i])]++)] =
          static_cast<std::int32_t>(i / 4);
  }

  void consider(std::int32_t t, const Vec3& target, Best& best) const {
    const Vec3 origin = mesh_.points.row(mesh_.tetrahedra(t, 0)).transpose();
    Eigen::Matrix3d edges;
    for (int k = 0; k < 3; ++k)
      edges.col(k) = mesh_.points.row(mesh_.tetrahedra(t, k + 1)).transpose() - origin;
    // x = o + E (b_1, b_2, b_3), and b_0 takes what is left of 1.
    const Vec3 inner = edges.inverse() * (target - origin);
    const Eigen::RowVector4d weights(1 - inner.sum(), inner[0], inner[1], inner[2]);
    const double least = weights.minCoeff();
    if (least > best.least)
      best = {t, least, weights};
  }

  /// Searches rings of cells around the target's, until the next ring is farther away than the best.
  std::int32_t nearestPoint(const Vec3& target) const {
    const geometry::CellLists::Cell center = points_.cellOf(target);
    const Eigen::Index rings = points_.size().maxCoeff();
    std::int32_t nearest = 0;
    double squared = std::numeric_limits<double>::infinity();
    for (Eigen::Index ring = 0; ring <= rings; ++ring) {
      const double reached = static_cast<double>(ring - 1) * points_.edge();
      if (ring > 1 && reached * reached > squared)
        break;
      visitRing(center, ring, [&](std::int32_t point) {
        const double distance = (mesh_.points.row(point).transpose() - target).squaredNorm();
        if (distance < squared) {
          squared = distance;
          nearest = point;
        }
      });
    }
    return nearest;
  }

  template <class Visit>
  void visitRing(const geometry::CellLists::Cell& center, Eigen::Index ring, const Visit& visit) const {
    for (Eigen::Index z = -ring; z <= ring; ++z)
      for (Eigen::Index y = -ring; y <= ring; ++y) {
        const bool shell = std::max(std::abs(z), std::abs(y)) == ring;
        for (Eigen::Index x = -ring; x <= ring; x += shell || ring == 0 ? 1 : 2 * ring) {
          const geometry::CellLists::Cell cell = center + geometry::CellLists::Cell(x, y, z);
          if ((cell.array() >= 0).all() && (cell.array() < points_.size().array()).all())
            points_.visit(cell, visit);
        }
      }
  }

  const WitnessMesh& mesh_;
  geometry::CellLists points_;
  geometry::CellLists tetrahedra_;
  std::vector<std::int64_t> around_;     ///< Where the tetrahedra of each point begin in `neighbours_`.
  std::vector<std::int32_t> neighbours_; ///< Tetrahedra by point.
};

} // namespace

WitnessInterpolation::WitnessInterpolation(const WitnessMesh& mesh, const Points& targets, Threads threads)
    : corners_(targets.rows(), 4), weights_(targets.rows(), 4), distances_(targets.rows()) {
  assert(mesh.points.rows() > 0);
  const Locator locator(mesh);
  parallelRanges(targets.rows(), 256, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i)
      distances_[i] = locator.locate(targets.row(i).transpose(), corners_.row(i), weights_.row(i));
  });
}

void WitnessInterpolation::operator()(const Values& values, Values& result) const {
  result.resize(targets());
  for (Eigen::Index i = 0; i < targets(); ++i) {
    double sum = 0;
    for (int k = 0; k < 4; ++k)
      sum += weights_(i, k) * values[corners_(i, k)];
    result[i] = sum;
  }
}

} // namespace viscera::deformation
