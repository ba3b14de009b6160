#include "viscera/phantom/row_cover.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace viscera::phantom {
namespace {

/// Where a line enters (+1) or leaves (-1) a surface.
struct Crossing {
  double at = 0;
  int paint = 0;
  int way = 0;
};

bool isBefore(const Crossing& a, const Crossing& b) {
  return std::tie(a.at, a.paint, a.way) < std::tie(b.at, b.paint, b.way);
}

/// A surface in the index space of a grid.
struct IndexedSurface {
  Points points;
  const Triangles* triangles = nullptr;
  int paint = 0;
};

using Point2 = Eigen::Vector2d;

/// The point (i, j) at which an edge meets the plane at height k. Both triangles of an edge get the same
/// bits.
Point2 edgeAt(const Points& points, int a, int b, double k) {
  if (a > b)
    std::swap(a, b);
  const double part = (k - points(a, 2)) / (points(b, 2) - points(a, 2));
  return {points(a, 0) + part * (points(b, 0) - points(a, 0)),
          points(a, 1) + part * (points(b, 1) - points(a, 1))};
}

/// All lines through one layer of voxels.
class LayerCover {
public:
  LayerCover(const ImageGrid& grid, const std::vector<IndexedSurface>& surfaces, const LinesOfARow& lines,
             bool mirrored)
      : grid_(grid), surfaces_(surfaces), lines_(lines), mirrored_(mirrored),
        rows_(static_cast<std::size_t>(grid.size[1]) * static_cast<std::size_t>(lines.acrossJ)) {}

  /// `triangles` are those of each surface that reach into the layer.
  void run(int k, const std::vector<std::vector<std::int32_t>>& triangles, std::vector<RowPart>& parts) {
    parts.clear();
    for (int line = 0; line < lines_.acrossK; ++line) {
      for (std::vector<Crossing>& row : rows_)
        row.clear();
      const double height = k + (line + 0.5) / lines_.acrossK - 0.5;
      for (std::size_t s = 0; s < surfaces_.size(); ++s)
        for (const std::int32_t t : triangles[s])
          cut(surfaces_[s], t, height);
      for (std::size_t row = 0; row < rows_.size(); ++row)
        sweep(k, static_cast<int>(row) / lines_.acrossJ, rows_[row], parts);
    }
  }

private:
  /// Where `line` runs along j.
  double placeOf(int line) const { return (line + 0.5) / lines_.acrossJ - 0.5; }

  void cut(const IndexedSurface& surface, std::int32_t triangle, double height) {
    Point2 up = Point2::Zero(), down = Point2::Zero();
    int met = 0;
    for (int corner = 0; corner < 3; ++corner) {
      const int a = (*surface.triangles)(triangle, corner),
                b = (*surface.triangles)(triangle, (corner + 1) % 3);
      const bool below = surface.points(a, 2) < height, belowNext = surface.points(b, 2) < height;
      if (below == belowNext)
        continue;
      (below ? up : down) = edgeAt(surface.points, a, b, height);
      ++met;
    }
    if (met == 2)
      cross(up, down, surface.paint);
  }

  /// Adds the crossings of a piece of the contour. A side belongs to the lines from its lower end on, so that
  /// each line meets a closed contour an even number of times.
  void cross(const Point2& up, const Point2& down, int paint) {
    const bool rises = up.y() < down.y();
    const Point2& low = rises ? up : down;
    const Point2& high = rises ? down : up;
    const double lines = static_cast<double>(rows_.size());
    const auto lineFrom = [&](double j) {
      return static_cast<int>(std::clamp(std::ceil((j + 0.5) * lines_.acrossJ - 0.5), 0.0, lines));
    };
    // Rounding may choose one line too many: the comparison decides.
    for (int line = std::max(lineFrom(low.y()) - 1, 0);
         line < std::min(lineFrom(high.y()) + 1, static_cast<int>(rows_.size())); ++line) {
      const double j = placeOf(line);
      if (j < low.y() || j >= high.y())
        continue;
      const double at = low.x() + (j - low.y()) / (high.y() - low.y()) * (high.x() - low.x());
      rows_[static_cast<std::size_t>(line)].push_back({at, paint, rises != mirrored_ ? 1 : -1});
    }
  }

  void sweep(int k, int j, std::vector<Crossing>& crossings, std::vector<RowPart>& parts) const {
    std::sort(crossings.begin(), crossings.end(), isBefore);
    std::array<int, 256> windings{};
    int paint = 0;
    for (std::size_t c = 0; c < crossings.size(); ++c) {
      windings[static_cast<std::size_t>(crossings[c].paint)] += crossings[c].way;
      paint = std::max(paint, crossings[c].paint);
      while (paint > 0 && windings[static_cast<std::size_t>(paint)] <= 0)
        --paint;
      if (paint > 0 && c + 1 < crossings.size() && crossings[c + 1].at > crossings[c].at)
        parts.push_back({k, j, crossings[c].at, crossings[c + 1].at, paint});
    }
  }

  const ImageGrid& grid_;
  const std::vector<IndexedSurface>& surfaces_;
  const LinesOfARow& lines_;
  bool mirrored_;
  std::vector<std::vector<Crossing>> rows_;
};

/// The triangles that reach into each layer, by layer and surface.
using LayerTriangles = std::vector<std::vector<std::vector<std::int32_t>>>;

LayerTriangles byLayer(const std::vector<IndexedSurface>& surfaces, int layers) {
  LayerTriangles lists(static_cast<std::size_t>(layers),
                       std::vector<std::vector<std::int32_t>>(surfaces.size()));
  for (std::size_t s = 0; s < surfaces.size(); ++s)
    for (Eigen::Index t = 0; t < surfaces[s].triangles->rows(); ++t) {
      const auto corners = surfaces[s].triangles->row(t);
      const Vec3 heights(surfaces[s].points(corners[0], 2), surfaces[s].points(corners[1], 2),
                         surfaces[s].points(corners[2], 2));
      const double from = std::max(std::floor(heights.minCoeff() + 0.5) - 1, 0.0);
      const double to = std::min(std::floor(heights.maxCoeff() + 0.5) + 1, layers - 1.0);
      for (int k = static_cast<int>(std::min(from, double(layers)));
           k <= static_cast<int>(std::max(to, -1.0)); ++k)
        lists[static_cast<std::size_t>(k)][s].push_back(static_cast<std::int32_t>(t));
    }
  return lists;
}

} // namespace

Points ImageGrid::centersOf(int k) const {
  Points points(static_cast<Eigen::Index>(size[0]) * size[1], 3);
  for (int j = 0; j < size[1]; ++j)
    for (int i = 0; i < size[0]; ++i)
      points.row(Eigen::Index(j) * size[0] + i) = (indexToLps * Vec3(i, j, k)).transpose();
  return points;
}

void coverRows(const ImageGrid& grid, const std::vector<PaintedSurface>& surfaces, const LinesOfARow& lines,
               Threads threads, const std::function<void(const std::vector<RowPart>& layer, int k)>& visit) {
  const Eigen::Affine3d lpsToIndex = grid.indexToLps.inverse();
  std::vector<IndexedSurface> indexed;
  for (const PaintedSurface& surface : surfaces) {
    IndexedSurface& one = indexed.emplace_back();
    one.points =
        (*surface.points * lpsToIndex.linear().transpose()).rowwise() + lpsToIndex.translation().transpose();
    one.triangles = surface.triangles;
    one.paint = surface.paint;
  }
  const LayerTriangles lists = byLayer(indexed, grid.size[2]);
  const bool mirrored = grid.indexToLps.linear().determinant() < 0;
  parallelRanges(grid.size[2], 1, threads, [&](Eigen::Index begin, Eigen::Index end) {
    LayerCover cover(grid, indexed, lines, mirrored);
    std::vector<RowPart> parts;
    for (auto k = static_cast<int>(begin); k < static_cast<int>(end); ++k) {
      cover.run(k, lists[static_cast<std::size_t>(k)], parts);
      visit(parts, k);
    }
  });
}

std::vector<std::uint8_t> paintAtCenters(const ImageGrid& grid, const std::vector<PaintedSurface>& surfaces,
                                         Threads threads) {
  std::vector<std::uint8_t> paints(grid.voxels(), 0);
  coverRows(grid, surfaces, {}, threads, [&](const std::vector<RowPart>& layer, int k) {
    for (const RowPart& part : layer) {
      const std::size_t row =
          (std::size_t(k) * std::size_t(grid.size[1]) + std::size_t(part.j)) * std::size_t(grid.size[0]);
      const double last = grid.size[0];
      const auto from = static_cast<std::size_t>(std::clamp(std::ceil(part.begin), 0.0, last));
      const auto to = static_cast<std::size_t>(std::clamp(std::ceil(part.end), 0.0, last));
      std::fill(paints.begin() + std::ptrdiff_t(row + from),
                paints.begin() + std::ptrdiff_t(row + std::max(from, to)),
                static_cast<std::uint8_t>(part.paint));
    }
  });
  return paints;
}

} // namespace viscera::phantom
