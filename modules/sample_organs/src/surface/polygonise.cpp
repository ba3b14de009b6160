#include "surface/polygonise.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "viscera/core/error.h"
#include "viscera/geometry/connected_pieces.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/medical_io/contour.h"

namespace viscera::sample_organs {
namespace {

using geometry::TriangleMesh;

constexpr int kCoarsest = 32; // points along an edge of a block
constexpr int kFinest = 2;
constexpr double kMostPoints = 1 << 30;
// A field may exceed the true distance by this factor, and vessels stand out by about this many mm
// unannounced.
constexpr double kOvershoot = 1.35;
constexpr double kUnannounced = 1.0;
// Crossings nearer to a grid point than this share of the spacing would make slivers.
constexpr double kKeepOff = 0.03;

/// Values of an implicit surface on a regular grid, x fastest. Exact near the surface; elsewhere only the
/// sign is.
struct SampleGrid {
  Vec3 origin = Vec3::Zero(); ///< mm
  double spacing = 1;         ///< mm
  std::array<int, 3> size = {0, 0, 0};
  std::vector<float> values; ///< mm, negative inside; never nearer to zero than a small share of the spacing.
};

class Sampler {
public:
  Sampler(const ImplicitNode& node, SampleGrid& grid) : node_(node), grid_(grid) {}

  using Corner = std::array<int, 3>;

  void fill(const Corner& low, int edge) {
    const Corner high = clipped(low, edge);
    const double halfDiagonal = 0.5 * std::numbers::sqrt3 * edge * grid_.spacing;
    // |d(x) - d(m)| <= L |x - m| with L the field's steepness, plus what stands out unannounced: farther than
    // that from zero in the middle, d has one sign in the whole block.
    const double change = kOvershoot * halfDiagonal + kUnannounced;
    const double middle = node_.distanceUpTo(at(low, 0.5 * edge), 2 * change);
    if (!std::isfinite(middle))
      throw DataError("the implicit surface is not finite", {}, "check its numbers");
    if (std::abs(middle) > change)
      setAll(low, high, middle);
    else if (edge == kFinest)
      evaluate(low, high, std::max(middle, 0.0) + change);
    else
      divide(low, high, edge / 2);
  }

private:
  Corner clipped(const Corner& low, int edge) const {
    Corner high;
    for (std::size_t axis = 0; axis < 3; ++axis)
      high[axis] = std::min(low[axis] + edge, grid_.size[axis]);
    return high;
  }

  Vec3 at(const Corner& low, double further) const {
    return grid_.origin + grid_.spacing * Vec3(low[0] + further, low[1] + further, low[2] + further);
  }

  void divide(const Corner& low, const Corner& high, int edge) {
    for (int z = low[2]; z < high[2]; z += edge)
      for (int y = low[1]; y < high[1]; y += edge)
        for (int x = low[0]; x < high[0]; x += edge)
          fill({x, y, z}, edge);
  }

  template <class Value>
  void assign(const Corner& low, const Corner& high, Value value) {
    for (int z = low[2]; z < high[2]; ++z)
      for (int y = low[1]; y < high[1]; ++y) {
        const std::size_t row =
            (static_cast<std::size_t>(z) * grid_.size[1] + static_cast<std::size_t>(y)) * grid_.size[0];
        for (int x = low[0]; x < high[0]; ++x)
          grid_.values[row + static_cast<std::size_t>(x)] = value(x, y, z);
      }
  }

  void setAll(const Corner& low, const Corner& high, double value) {
    const auto same = static_cast<float>(value);
    assign(low, high, [same](int, int, int) { return same; });
  }

  /// No value of the block can be above `limit` mm where the surface is near.
  void evaluate(const Corner& low, const Corner& high, double limit) {
    const double off = kKeepOff * grid_.spacing;
    assign(low, high, [&](int x, int y, int z) {
      double value = node_.distanceUpTo(at({x, y, z}, 0), limit);
      if (std::abs(value) < off)
        value = value < 0 ? -off : off;
      return static_cast<float>(value);
    });
  }

  const ImplicitNode& node_;
  SampleGrid& grid_;
};

SampleGrid emptyGrid(const Extent& extent, double spacing) {
  const Extent box = grown(extent, 3 * spacing + kUnannounced);
  SampleGrid grid;
  grid.origin = box.min();
  grid.spacing = spacing;
  const Vec3 points = (box.sizes() / spacing).array().ceil() + 1;
  if (!(points.prod() <= kMostPoints))
    throw DataError("the surface is too large for its spacing, or unlimited", {},
                    "close half spaces by an intersection, or widen \"spacing\"");
  for (int axis = 0; axis < 3; ++axis)
    grid.size[static_cast<std::size_t>(axis)] = static_cast<int>(points[axis]);
  grid.values.resize(static_cast<std::size_t>(points.prod()));
  return grid;
}

/// Samples a box around the node's extent. Divides blocks of 32^3 points down to 2^3 wherever the surface may
/// pass.
SampleGrid sampleGrid(const ImplicitNode& node, double spacing, Threads threads, Progress& progress) {
  SampleGrid grid = emptyGrid(node.extent(), spacing);
  std::array<Eigen::Index, 3> blocks;
  for (std::size_t axis = 0; axis < 3; ++axis)
    blocks[axis] = (grid.size[axis] + kCoarsest - 1) / kCoarsest;
  const Eigen::Index count = blocks[0] * blocks[1] * blocks[2];
  std::atomic<Eigen::Index> done{0};
  parallelRanges(count, 1, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index block = begin; block < end; ++block) {
      progress.throwIfCancelled();
      const Sampler::Corner low = {static_cast<int>(block % blocks[0]) * kCoarsest,
                                   static_cast<int>(block / blocks[0] % blocks[1]) * kCoarsest,
                                   static_cast<int>(block / (blocks[0] * blocks[1])) * kCoarsest};
      Sampler(node, grid).fill(low, kCoarsest);
      progress.report(static_cast<double>(++done) / static_cast<double>(count));
    }
  });
  return grid;
}

/// The piece with the most triangles, points in the order in which triangles name them.
TriangleMesh largestPart(const TriangleMesh& mesh) {
  const auto [count, piece] = geometry::connectedPieces(mesh);
  std::vector<int> size(static_cast<std::size_t>(count), 0);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    ++size[static_cast<std::size_t>(piece[static_cast<std::size_t>(mesh.triangles(t, 0))])];
  const auto largest = static_cast<std::int32_t>(std::max_element(size.begin(), size.end()) - size.begin());

  TriangleMesh result;
  std::vector<std::int32_t> renamed(piece.size(), -1);
  std::int32_t points = 0;
  Eigen::Index triangles = 0;
  result.points.resize(mesh.points.rows(), 3);
  result.triangles.resize(mesh.triangles.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    if (piece[static_cast<std::size_t>(mesh.triangles(t, 0))] != largest)
      continue;
    for (int k = 0; k < 3; ++k) {
      std::int32_t& name = renamed[static_cast<std::size_t>(mesh.triangles(t, k))];
      if (name < 0) {
        name = points++;
        result.points.row(name) = mesh.points.row(mesh.triangles(t, k));
      }
      result.triangles(triangles, k) = name;
    }
    ++triangles;
  }
  result.points.conservativeResize(points, 3);
  result.triangles.conservativeResize(triangles, 3);
  return result;
}

} // namespace

TriangleMesh polygonise(const ImplicitNode& node, double spacing, Threads threads, Progress& progress) {
  const SampleGrid grid = sampleGrid(node, spacing, threads, progress);
  const TriangleMesh all = medical_io::contourOf(grid.values, grid.size, 0, grid.origin, grid.spacing);
  if (all.triangles.rows() == 0)
    throw DataError("the implicit surface is empty", {},
                    "check that its parts meet and that \"spacing\" is fine enough");
  TriangleMesh mesh = largestPart(all);
  geometry::orientOutward(mesh);
  return mesh;
}

} // namespace viscera::sample_organs
