#include "viscera/coordinates/weights_binding.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <utility>

#include "rest_errors.h"
#include "viscera/core/phrase.h"

namespace viscera::coordinates {
namespace {

constexpr Eigen::Index kTilesPerCheck = 64;

/// A bit for each failed point of each tile.
std::vector<std::uint16_t> failedLanes(const std::vector<int>& failures, Eigen::Index tiles) {
  std::vector<std::uint16_t> lanes(static_cast<std::size_t>(tiles));
  for (const int point : failures)
    lanes[static_cast<std::size_t>(point / TiledWeights::kTile)] |=
        static_cast<std::uint16_t>(1 << point % TiledWeights::kTile);
  return lanes;
}

} // namespace

BindingReport WeightsBinding::reportOf(const TiledWeights& weights, const Points& restHandles,
                                       const Points& restPoints, std::vector<int> failures, double seconds,
                                       Threads threads, std::vector<Text> notes) {
  assert(restHandles.rows() == weights.handles() && restPoints.rows() == weights.points());
  const std::vector<std::uint16_t> failed = failedLanes(failures, weights.tiles());
  std::vector<RestErrors> ranges(
      static_cast<std::size_t>((weights.tiles() + kTilesPerCheck - 1) / kTilesPerCheck));
  parallelRanges(weights.tiles(), kTilesPerCheck, threads, [&](Eigen::Index begin, Eigen::Index end) {
    RestErrors errors; // Not in the shared array: the threads would take its cache lines from each other.
    std::vector<double> room(static_cast<std::size_t>(weights.handles()) * TiledWeights::kTile);
    for (Eigen::Index tile = begin; tile < end; ++tile)
      errors.addTile(weights.read(tile, room.data()), restHandles, restPoints, tile,
                     failed[static_cast<std::size_t>(tile)]);
    ranges[static_cast<std::size_t>(begin / kTilesPerCheck)] = errors;
  });
  BindingReport report;
  report.failures = std::move(failures);
  report.seconds = seconds;
  report.threads = threads.resolved();
  report.notes = std::move(notes);
  tellErrors(ranges, weights.points(), report);
  return report;
}

WeightsBinding::WeightsBinding(TiledWeights&& weights, const Points& restPoints, BindingReport measured)
    : weights_(std::move(weights)), report_(std::move(measured)) {
  const std::vector<int>& failures = report_.failures;
  assert(restPoints.rows() == weights_.points() && std::is_sorted(failures.begin(), failures.end()));
  failedRest_.resize(static_cast<Eigen::Index>(failures.size()), 3);
  const Values zero = Values::Zero(weights_.handles());
  for (std::size_t index = 0; index < failures.size(); ++index) {
    failedRest_.row(static_cast<Eigen::Index>(index)) = restPoints.row(failures[index]);
    weights_.setRow(failures[index], zero);
  }
  if (weights_.single())
    report_.notes.push_back(
        phrase("the coordinates are kept in single precision: they would take %1 MiB otherwise",
               TiledWeights::bytesInDoubles(weights_.points(), weights_.handles()) >> 20));
}

WeightsBinding::WeightsBinding(TiledWeights weights, const Points& restHandles, const Points& restPoints,
                               std::vector<int> failures, double seconds, Threads threads,
                               std::vector<Text> notes)
    : WeightsBinding(std::move(weights), restPoints,
                     reportOf(weights, restHandles, restPoints, std::move(failures), seconds, threads,
                              std::move(notes))) {} // `weights` is moved when the report is there.

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
