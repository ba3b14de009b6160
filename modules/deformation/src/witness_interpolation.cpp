#include "viscera/deformation/witness_interpolation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <vector>

#include <Eigen/LU>

namespace viscera::deformation {
namespace {

/// A point this little outside a tetrahedron, in barycentric coordinates, still counts as inside.
constexpr double kInside = -1e-9;
/// Edge of a cell, in terms of the cube that one point has to itself.
constexpr double kCellScale = 1.5;
constexpr double kMostCells = 2e7;

/// Lists of items by the cell of a regular grid, as one compressed array.
class CellLists {
public:
  using Cell = Eigen::Matrix<Eigen::Index, 3, 1>;

  CellLists(const Bounds& box, double edge) : low_(box.low), edge_(edge) {
    for (int axis = 0; axis < 3; ++axis)
      size_[axis] = 1 + static_cast<Eigen::Index>(std::floor((box.high[axis] - box.low[axis]) / edge));
  }

  const Cell& size() const { return size_; }
  double edge() const { return edge_; }
  Cell cellOf(const Vec3& point) const {
    Cell cell;
    for (int axis = 0; axis < 3; ++axis)
      cell[axis] = static_cast<Eigen::Index>(
          std::clamp(std::floor((point[axis] - low_[axis]) / edge_), 0.0, double(size_[axis] - 1)));
    return cell;
  }

  /// `boxOf(item)` is the box that the item touches.
  template <class BoxOf>
  void fill(Eigen::Index items, const BoxOf& boxOf) {
    first_.assign(static_cast<std::size_t>(size_.prod()) + 1, 0);
    for (Eigen::Index item = 0; item < items; ++item)
      forCells(boxOf(item), [&](std::size_t cell) { ++first_[cell + 1]; });
    for (std::size_t cell = 1; cell < first_.size(); ++cell)
      first_[cell] += first_[cell - 1];
    items_.resize(static_cast<std::size_t>(first_.back()));
    std::vector<std::int64_t> next(first_.begin(), first_.end() - 1);
    for (Eigen::Index item = 0; item < items; ++item)
      forCells(boxOf(item), [&](std::size_t cell) {
        items_[static_cast<std::size_t>(next[cell]++)] = static_cast<std::int32_t>(item);
      });
  }

  template <class Visit>
  void visit(const Cell& cell, const Visit& visit) const {
    const auto index = static_cast<std::size_t>((cell[2] * size_[1] + cell[1]) * size_[0] + cell[0]);
    for (std::int64_t i = first_[index]; i < first_[index + 1]; ++i)
      visit(items_[static_cast<std::size_t>(i)]);
  }

private:
  template <class Body>
  void forCells(const Bounds& box, const Body& body) const {
    const Cell low = cellOf(box.low), high = cellOf(box.high);
    for (Eigen::Index z = low[2]; z <= high[2]; ++z)
      for (Eigen::Index y = low[1]; y <= high[1]; ++y)
        for (Eigen::Index x = low[0]; x <= high[0]; ++x)
          body(static_cast<std::size_t>((z * size_[1] + y) * size_[0] + x));
  }

  Vec3 low_;
  double edge_;
  Cell size_;
  std::vector<std::int64_t> first_;
  std::vector<std::int32_t> items_;
};

double cellEdge(const Bounds& box, Eigen::Index points) {
  const Vec3 extent = (box.high - box.low).cwiseMax(1e-6 * box.diagonal());
  const double perPoint = std::cbrt(extent.prod() / static_cast<double>(points));
  const double edge = std::max(kCellScale * perPoint, std::cbrt(extent.prod() / kMostCells));
  return edge > 0 ? edge : 1; // All points in one place: one cell.
}

/// Finds for one point after the other the corners and weights.
class Locator {
public:
  explicit Locator(const WitnessMesh& mesh)
      : mesh_(mesh), points_(boundsOf(mesh.points), cellEdge(boundsOf(mesh.points), mesh.points.rows())),
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

  void locate(const Vec3& target, Eigen::Ref<Eigen::RowVector4i> corners,
              Eigen::Ref<Eigen::RowVector4d> weights) const {
    const std::int32_t nearest = nearestPoint(target);
    corners = Eigen::RowVector4i::Constant(nearest);
    weights = Eigen::RowVector4d::Unit(0);
    if (mesh_.points.row(nearest).transpose() == target)
      return;
    Best best;
    tetrahedra_.visit(tetrahedra_.cellOf(target), [&](std::int32_t t) { consider(t, target, best); });
    if (best.least < kInside) { // Outside: the tetrahedra at the nearest point reach furthest towards it.
      best = {};
      for (auto i = around_[std::size_t(nearest)]; i < around_[std::size_t(nearest) + 1]; ++i)
        consider(neighbours_[static_cast<std::size_t>(i)], target, best);
    }
    if (best.tetrahedron < 0)
      return;
    corners = mesh_.tetrahedra.row(best.tetrahedron);
    weights = best.weights.cwiseMax(0.0);
    weights /= weights.sum();
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
    const Vec3 inner = edges.inverse() * (target - origin);
    const Eigen::RowVector4d weights(1 - inner.sum(), inner[0], inner[1], inner[2]);
    const double least = weights.minCoeff();
    if (least > best.least)
      best = {t, least, weights};
  }

  /// By rings of cells around the target's, until the next ring is farther away than the best.
  std::int32_t nearestPoint(const Vec3& target) const {
    const CellLists::Cell center = points_.cellOf(target);
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
  void visitRing(const CellLists::Cell& center, Eigen::Index ring, const Visit& visit) const {
    for (Eigen::Index z = -ring; z <= ring; ++z)
      for (Eigen::Index y = -ring; y <= ring; ++y) {
        const bool shell = std::max(std::abs(z), std::abs(y)) == ring;
        for (Eigen::Index x = -ring; x <= ring; x += shell || ring == 0 ? 1 : 2 * ring) {
          const CellLists::Cell cell = center + CellLists::Cell(x, y, z);
          if ((cell.array() >= 0).all() && (cell.array() < points_.size().array()).all())
            points_.visit(cell, visit);
        }
      }
  }

  const WitnessMesh& mesh_;
  CellLists points_;
  CellLists tetrahedra_;
  std::vector<std::int64_t> around_;     ///< Where the tetrahedra of each point begin in `neighbours_`.
  std::vector<std::int32_t> neighbours_; ///< Tetrahedra by point.
};

} // namespace

WitnessInterpolation::WitnessInterpolation(const WitnessMesh& mesh, const Points& targets, Threads threads)
    : corners_(targets.rows(), 4), weights_(targets.rows(), 4) {
  assert(mesh.points.rows() > 0);
  const Locator locator(mesh);
  parallelRanges(targets.rows(), 256, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i)
      locator.locate(targets.row(i).transpose(), corners_.row(i), weights_.row(i));
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
