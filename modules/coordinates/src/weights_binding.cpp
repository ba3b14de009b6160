#include "viscera/coordinates/weights_binding.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "simd/usable_kernels.h"

namespace viscera::coordinates {
namespace {

constexpr Eigen::Index kTilesPerCheck = 64;

struct Extremes {
  double identity = 0;
  double unity = 0;
  double least = std::numeric_limits<double>::infinity();

  void add(double identityError, double unityError, double weight) {
    keep(identity, identityError, identityError > identity);
    keep(unity, unityError, unityError > unity);
    keep(least, weight, weight < least);
  }

private:
  /// A NaN stays visible: it replaces every number and is replaced by none.
  static void keep(double& extreme, double value, bool isMore) {
    if (isMore || std::isnan(value))
      extreme = value;
  }
};

/// Adds the points of a tile to `extremes`; the bits of `failed` leave points out.
void measureTile(const TiledWeights& weights, const Points& handles, const Points& rest, Eigen::Index tile,
                 unsigned failed, Extremes& extremes) {
  const Eigen::Index first = tile * TiledWeights::kTile,
                     count = std::min<Eigen::Index>(TiledWeights::kTile, rest.rows() - first);
  double points[3 * TiledWeights::kTile] = {}, found[5 * TiledWeights::kTile];
  for (Eigen::Index lane = 0; lane < count; ++lane)
    for (int axis = 0; axis < 3; ++axis)
      points[axis * TiledWeights::kTile + lane] = rest(first + lane, axis);
  simd::tileKernels().measure(weights.tile(tile), handles.data(), handles.rows(), points, found);
  for (Eigen::Index lane = 0; lane < count; ++lane) {
    if (failed >> lane & 1)
      continue;
    const double unity = found[3 * TiledWeights::kTile + lane] - 1;
    // The sums are relative to the point, so that an organ far from the origin is not measured by its
    // distance.
    Vec3 error;
    for (int axis = 0; axis < 3; ++axis)
      error[axis] =
          found[axis * TiledWeights::kTile + lane] + unity * points[axis * TiledWeights::kTile + lane];
    extremes.add(error.norm(), std::abs(unity), found[4 * TiledWeights::kTile + lane]);
  }
}

/// A bit for each failed point of each tile.
std::vector<std::uint16_t> failedLanes(const std::vector<int>& failures, Eigen::Index tiles) {
  std::vector<std::uint16_t> lanes(static_cast<std::size_t>(tiles));
  for (const int point : failures)
    lanes[static_cast<std::size_t>(point / TiledWeights::kTile)] |=
        static_cast<std::uint16_t>(1 << point % TiledWeights::kTile);
  return lanes;
}

} // namespace

WeightsBinding::WeightsBinding(TiledWeights weights, const Points& restHandles, const Points& restPoints,
                               std::vector<int> failures, double seconds, Threads threads,
                               std::vector<std::string> notes)
    : weights_(std::move(weights)), failedRest_(failures.size(), 3) {
  assert(restPoints.rows() == weights_.points() && restHandles.rows() == weights_.handles());
  assert(std::is_sorted(failures.begin(), failures.end()));
  for (std::size_t index = 0; index < failures.size(); ++index) {
    failedRest_.row(static_cast<Eigen::Index>(index)) = restPoints.row(failures[index]);
    for (Eigen::Index handle = 0; handle < weights_.handles(); ++handle)
      weights_.set(failures[index], handle, 0);
  }
  const std::vector<std::uint16_t> failed = failedLanes(failures, weights_.tiles());
  std::vector<Extremes> ranges(
      static_cast<std::size_t>((weights_.tiles() + kTilesPerCheck - 1) / kTilesPerCheck));
  parallelRanges(weights_.tiles(), kTilesPerCheck, threads, [&](Eigen::Index begin, Eigen::Index end) {
    Extremes extremes; // Not in the shared array: the threads would take its cache lines from each other.
    for (Eigen::Index tile = begin; tile < end; ++tile)
      measureTile(weights_, restHandles, restPoints, tile, failed[static_cast<std::size_t>(tile)], extremes);
    ranges[static_cast<std::size_t>(begin / kTilesPerCheck)] = extremes;
  });
  Extremes all;
  for (const Extremes& range : ranges)
    all.add(range.identity, range.unity, range.least);
  const bool anyBound = failures.size() < static_cast<std::size_t>(weights_.points());
  report_ = {all.identity, all.unity,          anyBound ? all.least : 0, std::move(failures),
             seconds,      threads.resolved(), std::move(notes)};
}

/// Puts the failed points of [begin, end) to rest.
void WeightsBinding::restoreFailed(Eigen::Index begin, Eigen::Index end, Points& points) const {
  const std::vector<int>& failures = report_.failures;
  for (auto point = std::lower_bound(failures.begin(), failures.end(), begin);
       point != failures.end() && *point < end; ++point)
    points.row(*point) = failedRest_.row(point - failures.begin());
}

PiecesOfWork WeightsBinding::deformInPieces(const Points& pose, Points& points) const {
  PiecesOfWork product = weights_.multiplyInPieces(pose, points);
  if (report_.failures.empty())
    return product;
  return {product.count, [this, &points, multiply = std::move(product.run)](Eigen::Index piece) {
            constexpr Eigen::Index kPoints = TiledWeights::kTilesOfAPiece * TiledWeights::kTile;
            multiply(piece);
            restoreFailed(piece * kPoints, (piece + 1) * kPoints, points);
          }};
}

PiecesOfWork WeightsBinding::moveHandleInPieces(const Points&, int handle, const Vec3& delta,
                                                Points& points) const {
  return weights_.addColumnInPieces(handle, delta, points);
}

void WeightsBinding::deform(const Points& pose, Points& points, Threads threads) const {
  parallelPieces({deformInPieces(pose, points)}, threads);
}

void WeightsBinding::moveHandle(const Points&, int handle, const Vec3& delta, Points& points,
                                Threads threads) const {
  weights_.addColumn(handle, delta, points, threads);
}

void WeightsBinding::pullBack(const Points&, const Points& pointGradient, Points& handleGradient,
                              Threads threads) const {
  weights_.multiplyTransposed(pointGradient, handleGradient, threads);
}

Values WeightsBinding::influence(int handle) const {
  return weights_.column(handle);
}

} // namespace viscera::coordinates
