#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::geometry {

/// A spatial index that lists items by the cells of a regular grid, stored as one compressed array.
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

/// The edge of the cells (mm) in which a few of `points` points that fill `box` lie, such that a grid of them
/// stays below twenty million.
inline double cellEdge(const Bounds& box, Eigen::Index points) {
  constexpr double kCellScale = 1.5; // Edge of a cell, in units of the cube that one point takes.
  constexpr double kMostCells = 2e7;
  const Vec3 extent = (box.high - box.low).cwiseMax(1e-6 * box.diagonal());
  const double perPoint = std::cbrt(extent.prod() / static_cast<double>(points));
  const double edge = std::max(kCellScale * perPoint, std::cbrt(extent.prod() / kMostCells));
  return edge > 0 ? edge : 1; // All points in one place: one cell.
}

} // namespace viscera::geometry
