#include "silhouette.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace viscera::scene {
namespace {

constexpr double kNothing = std::numeric_limits<double>::infinity();

/// Twice the signed area of a triangle on the display.
double area(const DisplayPoint& a, const DisplayPoint& b, double x, double y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

} // namespace

void silhouette(const geometry::TriangleMesh& mesh, const geometry::Normals& normals,
                const ViewGeometry& view, std::vector<float>& segments) {
  segments.clear();
  Values facing(mesh.points.rows());
  for (Eigen::Index i = 0; i < facing.size(); ++i) {
    const Vec3 toEye = view.parallel ? Vec3(-view.forward) : Vec3(view.eye - mesh.points.row(i).transpose());
    facing[i] = toEye.dot(normals.row(i).transpose().cast<double>());
  }
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corners = mesh.triangles.row(t);
    const bool front[3] = {facing[corners[0]] > 0, facing[corners[1]] > 0, facing[corners[2]] > 0};
    if (front[0] == front[1] && front[1] == front[2])
      continue;
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3;
      if (front[c] == front[d])
        continue;
      const double from = facing[corners[c]], to = facing[corners[d]];
      const double part = from / (from - to);
      for (int k = 0; k < 3; ++k) {
        const double a = mesh.points(corners[c], k), b = mesh.points(corners[d], k);
        segments.push_back(static_cast<float>(a + part * (b - a)));
      }
    }
  }
}

DepthGrid::DepthGrid(const geometry::TriangleMesh& mesh, const ViewGeometry& view, int cells) : view_(view) {
  std::vector<DisplayPoint> points(std::size_t(mesh.points.rows()));
  double right = -kNothing, top = -kNothing;
  left_ = bottom_ = kNothing;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = view.project(mesh.points.row(Eigen::Index(i)).transpose());
    if (points[i].depth <= 0)
      continue;
    left_ = std::min(left_, points[i].x);
    right = std::max(right, points[i].x);
    bottom_ = std::min(bottom_, points[i].y);
    top = std::max(top, points[i].y);
  }
  if (!(right > left_) || !(top > bottom_)) {
    depths_.assign(1, kNothing);
    left_ = bottom_ = 0;
    return;
  }
  cell_ = std::max(right - left_, top - bottom_) / cells;
  columns_ = static_cast<Eigen::Index>((right - left_) / cell_) + 1;
  rows_ = static_cast<Eigen::Index>((top - bottom_) / cell_) + 1;
  depths_.assign(std::size_t(columns_ * rows_), kNothing);
  for (auto& point : points) {
    point.x = (point.x - left_) / cell_;
    point.y = (point.y - bottom_) / cell_;
  }
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = mesh.triangles.row(t);
    draw(points[std::size_t(corner[0])], points[std::size_t(corner[1])], points[std::size_t(corner[2])]);
  }
}

void DepthGrid::draw(const DisplayPoint& a, const DisplayPoint& b, const DisplayPoint& c) {
  const double whole = area(a, b, c.x, c.y);
  if (whole == 0 || a.depth <= 0 || b.depth <= 0 || c.depth <= 0)
    return;
  const auto [lowX, highX] = std::minmax({a.x, b.x, c.x});
  const auto [lowY, highY] = std::minmax({a.y, b.y, c.y});
  // The middles of cells are at halves.
  const auto firstColumn = std::max<Eigen::Index>(0, std::llround(std::ceil(lowX - 0.5)));
  const auto firstRow = std::max<Eigen::Index>(0, std::llround(std::ceil(lowY - 0.5)));
  for (Eigen::Index row = firstRow; row < rows_ && double(row) + 0.5 <= highY; ++row)
    for (Eigen::Index column = firstColumn; column < columns_ && double(column) + 0.5 <= highX; ++column) {
      const double x = double(column) + 0.5, y = double(row) + 0.5;
      const double wa = area(b, c, x, y) / whole, wb = area(c, a, x, y) / whole, wc = 1 - wa - wb;
      if (wa < 0 || wb < 0 || wc < 0)
        continue;
      // The inverse of depth is linear on the display with perspective.
      const double depth = view_.parallel ? wa * a.depth + wb * b.depth + wc * c.depth
                                          : 1 / (wa / a.depth + wb / b.depth + wc / c.depth);
      at(column, row) = std::min(at(column, row), depth);
    }
}

bool DepthGrid::sees(const Vec3& point, double tolerance) const {
  const auto display = view_.project(point);
  if (display.depth <= 0)
    return false;
  const auto column = static_cast<Eigen::Index>(std::floor((display.x - left_) / cell_));
  const auto row = static_cast<Eigen::Index>(std::floor((display.y - bottom_) / cell_));
  for (Eigen::Index r = row - 1; r <= row + 1; ++r)
    for (Eigen::Index c = column - 1; c <= column + 1; ++c) {
      const bool inside = r >= 0 && c >= 0 && r < rows_ && c < columns_;
      if (!inside || depths_[std::size_t(r * columns_ + c)] >= display.depth - tolerance)
        return true;
    }
  return false;
}

} // namespace viscera::scene
