#include "viscera/deformation/grid_witnesses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "viscera/core/error.h"
#include "viscera/geometry/winding_number.h"

namespace viscera::deformation {
namespace {

constexpr double kCountTolerance = 0.05;
constexpr double kFlatBox = 1e-9; ///< Shortest side of the box by the longest.
constexpr int kMostGridRounds = 6;
/// Nodes along the longest side of the grids by which the volume is estimated, one after the other until one
/// finds some inside.
constexpr std::array<int, 3> kEstimates = {24, 50, 100};
/// Grids of more nodes, or of more nodes a witness point, are not tried: where less than a hundredth of the
/// box is inside, the wanted number is met as nearly as possible.
constexpr double kManyNodes = 2e6, kMostNodesPerWitness = 100;
/// Walks from a cell's low corner to its high one along the axes, one a tetrahedron: Kuhn's subdivision.
constexpr std::array<std::array<int, 3>, 6> kWalks = {
    {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
constexpr std::size_t kEvenWalks = 3; ///< The first ones turn right-handed.

/// The nodes of a regular grid over a box that lie inside a surface.
class InsideGrid {
public:
  InsideGrid(const geometry::WindingNumber& winding, const Bounds& box, double spacing, Progress& progress,
             Threads threads)
      : spacing_(spacing) {
    for (int axis = 0; axis < 3; ++axis)
      size_[axis] = 1 + static_cast<Eigen::Index>(std::floor((box.high[axis] - box.low[axis]) / spacing));
    // Centred, so that no side of the organ is preferred.
    low_ = box.center() - 0.5 * spacing * (size_.cast<double>() - Vec3::Ones());
    inside_.resize(static_cast<std::size_t>(size_.prod()));
    parallelRanges(size_[1] * size_[2], 16, threads, [&](Eigen::Index begin, Eigen::Index end) {
      progress.throwIfCancelled();
      for (Eigen::Index node = begin * size_[0]; node < end * size_[0]; ++node)
        inside_[static_cast<std::size_t>(node)] = winding.inside(at(node)) ? 1 : 0;
    });
  }

  Vec3 at(Eigen::Index node) const {
    const Eigen::Index row = node / size_[0];
    return low_ + spacing_ * Vec3(static_cast<double>(node % size_[0]), static_cast<double>(row % size_[1]),
                                  static_cast<double>(row / size_[1]));
  }
  std::int64_t count() const { return std::count(inside_.begin(), inside_.end(), 1); }
  double spacing() const { return spacing_; }

  WitnessMesh mesh() const {
    WitnessMesh result;
    result.witnesses = count();
    result.points.resize(result.witnesses, 3);
    std::vector<std::int32_t> names(inside_.size(), -1);
    std::int32_t next = 0;
    for (std::size_t node = 0; node < inside_.size(); ++node)
      if (inside_[node]) {
        result.points.row(next) = at(static_cast<Eigen::Index>(node)).transpose();
        names[node] = next++;
      }
    result.tetrahedra = tetrahedra(names);
    return result;
  }

private:
  Tetrahedra tetrahedra(const std::vector<std::int32_t>& names) const {
    std::vector<std::array<std::int32_t, 4>> found;
    const std::array<Eigen::Index, 3> stride = {1, size_[0], size_[0] * size_[1]};
    for (Eigen::Index z = 0; z + 1 < size_[2]; ++z)
      for (Eigen::Index y = 0; y + 1 < size_[1]; ++y)
        for (Eigen::Index x = 0; x + 1 < size_[0]; ++x)
          for (std::size_t walk = 0; walk < kWalks.size(); ++walk) {
            Eigen::Index node = x + y * stride[1] + z * stride[2];
            std::array<std::int32_t, 4> corners{names[static_cast<std::size_t>(node)]};
            for (std::size_t step = 0; step < 3; ++step) {
              node += stride[static_cast<std::size_t>(kWalks[walk][step])];
              corners[step + 1] = names[static_cast<std::size_t>(node)];
            }
            if (walk >= kEvenWalks)
              std::swap(corners[2], corners[3]);
            if (*std::min_element(corners.begin(), corners.end()) >= 0)
              found.push_back(corners);
          }
    Tetrahedra result(static_cast<Eigen::Index>(found.size()), 4);
    for (std::size_t t = 0; t < found.size(); ++t)
      for (int corner = 0; corner < 4; ++corner)
        result(static_cast<Eigen::Index>(t), corner) = found[t][static_cast<std::size_t>(corner)];
    return result;
  }

  double spacing_;
  Eigen::Matrix<Eigen::Index, 3, 1> size_;
  Vec3 low_;
  std::vector<std::uint8_t> inside_;
};

[[noreturn]] void refuseEmpty() {
  throw DataError("the surface encloses nothing that witness points could lie in", "surface",
                  "check that its triangles face outward and that its holes are small");
}

/// The volume inside, mm^3, from the first grid that finds any.
double estimatedVolume(const geometry::WindingNumber& winding, const Bounds& box, Progress& progress,
                       Threads threads) {
  for (const int nodes : kEstimates) {
    const double spacing = (box.high - box.low).maxCoeff() / nodes;
    const auto inside = InsideGrid(winding, box, spacing, progress, threads).count();
    if (inside > 0)
      return static_cast<double>(inside) * std::pow(spacing, 3);
  }
  refuseEmpty();
}

} // namespace

WitnessMesh gridWitnesses(const geometry::TriangleMesh& surface, int wanted, Progress& progress,
                          Threads threads) {
  geometry::requireValid(surface, "surface");
  const Bounds box = boundsOf(surface.points);
  const Vec3 extent = box.high - box.low;
  if (surface.triangles.rows() == 0 || !(extent.minCoeff() > kFlatBox * extent.maxCoeff()))
    throw DataError("the surface has no triangles or is flat, so it encloses nothing", "surface");
  const geometry::WindingNumber winding(surface);
  const double mostNodes = std::max(kManyNodes, kMostNodesPerWitness * wanted);
  const double finest = std::cbrt(extent.prod() / mostNodes);
  // n = V / h^3 points of a grid of spacing h lie in the volume V; and so h grows by (n / wanted)^1/3 from
  // one grid to the next.
  double spacing = std::cbrt(estimatedVolume(winding, box, progress, threads) / wanted);
  WitnessMesh best;
  for (int round = 0; round < kMostGridRounds; ++round) {
    progress.report(static_cast<double>(round) / kMostGridRounds, "witness points on a grid");
    spacing = std::max(spacing, finest);
    const InsideGrid grid(winding, box, spacing, progress, threads);
    const auto count = grid.count();
    if (best.witnesses == 0 || std::abs(count - wanted) < std::abs(best.witnesses - wanted))
      best = grid.mesh();
    if (std::abs(count - wanted) <= kCountTolerance * wanted || (spacing == finest && count < wanted))
      break;
    // Halved where the grid missed everything.
    spacing *= count > 0 ? std::cbrt(static_cast<double>(count) / wanted) : 0.5;
  }
  if (best.tetrahedra.rows() == 0)
    refuseEmpty();
  requireUsable(best, "grid inside the surface");
  progress.report(1);
  return best;
}

} // namespace viscera::deformation
