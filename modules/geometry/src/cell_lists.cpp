#include "viscera/geometry/cell_lists.h"

namespace viscera::geometry {
namespace {

/// Edge of a cell, in terms of the cube that one point has to itself.
constexpr double kCellScale = 1.5;
constexpr double kMostCells = 2e7;

} // namespace

double cellEdge(const Bounds& box, Eigen::Index points) {
  const Vec3 extent = (box.high - box.low).cwiseMax(1e-6 * box.diagonal());
  const double perPoint = std::cbrt(extent.prod() / static_cast<double>(points));
  const double edge = std::max(kCellScale * perPoint, std::cbrt(extent.prod() / kMostCells));
  return edge > 0 ? edge : 1; // All points in one place: one cell.
}

} // namespace viscera::geometry
