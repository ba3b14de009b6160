#include "viscera/geometry/signed_distance_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "closest_point.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/winding_number.h"

namespace viscera::geometry {
namespace {

constexpr int kMargin = 4; ///< Nodes around the box: the band and one more.
constexpr double kMostNodes = 3e7;
constexpr int kSlab = 8; ///< Layers that one thread fills at a time.
/// Away from the surface the winding number changes slowly: a node that is this sure of its side speaks for
/// the next ones of its row.
constexpr double kSure = 0.05;
constexpr int kSpokenFor = 3;

SignedDistanceGrid emptyGrid(const Bounds& box, double spacing) {
  SignedDistanceGrid grid;
  grid.spacing = spacing;
  grid.origin = box.low - kMargin * spacing * Vec3::Ones();
  double nodes = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double extent = box.high[Eigen::Index(axis)] - box.low[Eigen::Index(axis)];
    const double count = std::ceil(extent / spacing) + 1 + 2 * kMargin;
    nodes *= count;
    if (!(nodes <= kMostNodes))
      throw DataError(misuse("a distance grid of this spacing is too large"), "surface",
                      misuse("choose a larger spacing"));
    grid.size[axis] = static_cast<int>(count);
  }
  grid.values.assign(static_cast<std::size_t>(nodes), static_cast<float>(kDistanceBand * spacing));
  return grid;
}

/// Tells node by node along a row which are inside.
class RowSigns {
public:
  RowSigns(const WindingNumber& winding, float band) : winding_(winding), band_(band) {}

  bool inside(const Vec3& node, float distance) {
    if (distance >= band_ && spokenFor_ > 0) {
      --spokenFor_;
      return inside_;
    }
    const double number = winding_(node);
    inside_ = number > 0.5;
    const bool sure = std::abs(number - (inside_ ? 1 : 0)) < kSure;
    spokenFor_ = distance >= band_ && sure ? kSpokenFor : 0;
    return inside_;
  }

private:
  const WindingNumber& winding_;
  float band_;
  bool inside_ = false;
  int spokenFor_ = 0;
};

/// The nodes along an axis that are within the band of [low, high].
std::pair<int, int> nodesNear(const SignedDistanceGrid& grid, std::size_t axis, double low, double high) {
  const double band = kDistanceBand * grid.spacing, origin = grid.origin[Eigen::Index(axis)];
  return {std::max(0, static_cast<int>(std::ceil((low - band - origin) / grid.spacing))),
          std::min(grid.size[axis] - 1, static_cast<int>(std::floor((high + band - origin) / grid.spacing)))};
}

/// Lowers the values in the layers [first, last] to the distance from one triangle.
void lower(SignedDistanceGrid& grid, const std::array<Vec3, 3>& corners, int first, int last) {
  const auto& [a, b, c] = corners;
  const Vec3 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
  const auto [x0, x1] = nodesNear(grid, 0, low[0], high[0]);
  const auto [y0, y1] = nodesNear(grid, 1, low[1], high[1]);
  const auto [z0, z1] = nodesNear(grid, 2, low[2], high[2]);
  for (int z = std::max(z0, first); z <= std::min(z1, last); ++z)
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const Vec3 node = grid.origin + grid.spacing * Vec3(x, y, z);
        const auto distance = static_cast<float>((closestPointOfTriangle(node, a, b, c) - node).norm());
        float& value = grid.values[(std::size_t(z) * std::size_t(grid.size[1]) + std::size_t(y)) *
                                       std::size_t(grid.size[0]) +
                                   std::size_t(x)];
        value = std::min(value, distance);
      }
}

/// The triangles that come near each slab of layers.
std::vector<std::vector<std::int32_t>> trianglesOfSlabs(const SignedDistanceGrid& grid,
                                                        const TriangleMesh& surface) {
  std::vector<std::vector<std::int32_t>> slabs(static_cast<std::size_t>((grid.size[2] + kSlab - 1) / kSlab));
  for (Eigen::Index t = 0; t < surface.triangles.rows(); ++t) {
    const Vec3 z(surface.points(surface.triangles(t, 0), 2), surface.points(surface.triangles(t, 1), 2),
                 surface.points(surface.triangles(t, 2), 2));
    const auto [first, last] = nodesNear(grid, 2, z.minCoeff(), z.maxCoeff());
    for (int slab = first / kSlab; slab <= last / kSlab; ++slab)
      slabs[static_cast<std::size_t>(slab)].push_back(static_cast<std::int32_t>(t));
  }
  return slabs;
}

/// One pass along one axis, from `from` to `to`: a line is `count` values `stride` apart.
void smoothenAlong(const SignedDistanceGrid& grid, std::size_t axis, const std::vector<float>& from,
                   std::vector<float>& to, Threads threads) {
  const std::array<std::ptrdiff_t, 3> strides = {1, grid.size[0],
                                                 std::ptrdiff_t(grid.size[0]) * grid.size[1]};
  const auto stride = strides[axis];
  parallelRanges(static_cast<Eigen::Index>(from.size()), 1 << 16, threads,
                 [&](Eigen::Index begin, Eigen::Index end) {
                   for (Eigen::Index i = begin; i < end; ++i) {
                     const auto place = i / stride % grid.size[axis];
                     const float before = from[std::size_t(place > 0 ? i - stride : i)];
                     const float after = from[std::size_t(place + 1 < grid.size[axis] ? i + stride : i)];
                     // d = (d_-1 + 2 d_0 + d_+1) / 4: a pass widens like a Gaussian of variance h^2 / 2; the
                     // ends stand in for what is beyond them.
                     to[std::size_t(i)] = 0.25f * (before + 2 * from[std::size_t(i)] + after);
                   }
                 });
}

} // namespace

SignedDistanceGrid signedDistanceGrid(const TriangleMesh& surface, double spacing, Progress& progress,
                                      Threads threads) {
  SignedDistanceGrid grid = emptyGrid(boundsOf(surface.points), spacing);
  const auto slabs = trianglesOfSlabs(grid, surface);
  const WindingNumber winding(surface);
  parallelRanges(static_cast<Eigen::Index>(slabs.size()), 1, threads, [&](Eigen::Index slab, Eigen::Index) {
    const int first = static_cast<int>(slab) * kSlab;
    const int last = std::min(first + kSlab, grid.size[2]) - 1;
    // |d| = min over the triangles of the distance to each, cut off at the band, and d < 0 where the winding
    // number is above 1/2.
    for (const std::int32_t t : slabs[static_cast<std::size_t>(slab)])
      lower(grid, cornersOf(surface.points, surface.triangles, t), first, last);
    auto value = grid.values.begin() + std::ptrdiff_t(first) * grid.size[0] * grid.size[1];
    for (int z = first; z <= last; ++z) {
      progress.throwIfCancelled();
      for (int y = 0; y < grid.size[1]; ++y) {
        RowSigns signs(winding, static_cast<float>(kDistanceBand * spacing));
        for (int x = 0; x < grid.size[0]; ++x, ++value)
          if (signs.inside(grid.origin + spacing * Vec3(x, y, z), *value))
            *value = -*value;
      }
    }
  });
  return grid;
}

void smoothen(SignedDistanceGrid& grid, int rounds, Threads threads) {
  std::vector<float> other(grid.values.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      smoothenAlong(grid, axis, grid.values, other, threads);
      grid.values.swap(other);
    }
}

} // namespace viscera::geometry
