#include "viscera/coordinates/tiled_weights.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include "simd/usable_kernels.h"

namespace viscera::coordinates {
namespace {

/// Calls `body(tile, rows)` with `rows` pointing to the tile's 16 rows of `points` inside a range of tiles.
/// The last, incomplete tile gets a copy, zero where there are no points, which is written back when `Rows`
/// may be changed.
template <class Rows, class Body>
void forTiles(Eigen::Index begin, Eigen::Index end, Rows& points, const Body& body) {
  const Eigen::Index whole = std::min(end, points.rows() / TiledWeights::kTile);
  for (Eigen::Index tile = begin; tile < whole; ++tile)
    body(tile, points.data() + tile * TiledWeights::kTile * 3);
  if (whole == end)
    return;
  double last[TiledWeights::kTile * 3] = {};
  const std::size_t bytes =
      static_cast<std::size_t>(points.rows() - whole * TiledWeights::kTile) * 3 * sizeof(double);
  std::memcpy(last, points.data() + whole * TiledWeights::kTile * 3, bytes);
  body(whole, last);
  if constexpr (!std::is_const_v<Rows>)
    std::memcpy(points.data() + whole * TiledWeights::kTile * 3, last, bytes);
}

} // namespace

TiledWeights::TiledWeights(Eigen::Index points, Eigen::Index handles)
    : points_(points), handles_(handles), data_(allocateZeroed(storedDoubles())) {}

TiledWeights::TiledWeights(Eigen::Index points, Eigen::Index handles, std::size_t mostBytes)
    : points_(points), handles_(handles), single_(bytesInDoubles(points, handles) > mostBytes),
      data_(allocateZeroed(storedDoubles())) {}

TiledWeights::TiledWeights(const TiledWeights& other)
    : points_(other.points_), handles_(other.handles_), single_(other.single_),
      data_(allocateZeroed(storedDoubles())) {
  std::memcpy(data_.get(), other.data_.get(), bytes());
}

TiledWeights& TiledWeights::operator=(const TiledWeights& other) {
  if (this != &other)
    *this = TiledWeights(other);
  return *this;
}

void TiledWeights::filled(Eigen::Index index, double* numbers) {
  if (single_)
    simd::tileKernels().round(numbers, handles_, ownSingleTile(index));
}

const double* TiledWeights::read(Eigen::Index index, double* room) const {
  if (!single_)
    return tile(index);
  const float* own = singleTile(index);
  for (Eigen::Index handle = 0; handle < handles_; ++handle)
    for (int lane = 0; lane < kTile; ++lane)
      room[handle * kTile + lane] = static_cast<double>(own[handle * kTile + lane]) * factorOf(own, lane);
  return room;
}

void TiledWeights::setRow(Eigen::Index point, const Values& row) {
  assert(row.size() == handles_);
  if (!single_) {
    for (Eigen::Index handle = 0; handle < handles_; ++handle)
      set(point, handle, row[handle]);
    return;
  }
  // The kernel `round` does the same for 16 points.
  float* own = ownSingleTile(point / kTile) + point % kTile;
  double kept = 0, lost = 0;
  for (Eigen::Index handle = 0; handle < handles_; ++handle) {
    const double exact = row[handle];
    const float rounded = std::abs(exact) < simd::kLeastSingle ? 0.0F : static_cast<float>(exact);
    own[handle * kTile] = rounded;
    kept += static_cast<double>(rounded);
    lost += exact - static_cast<double>(rounded);
  }
  const bool usable =
      std::abs(lost) < simd::kMostCorrection * std::abs(kept) && std::abs(lost / kept) >= simd::kLeastSingle;
  own[handles_ * kTile] = usable ? static_cast<float>(lost / kept) : 0.0F;
}

/// `body(tile, rows)` for the tiles of each piece, as `forTiles` calls it.
template <class Body>
PiecesOfWork TiledWeights::pieces(Points& points, Body body) const {
  return {(tiles() + kTilesOfAPiece - 1) / kTilesOfAPiece,
          [this, &points, body = std::move(body)](Eigen::Index piece) {
            const Eigen::Index begin = piece * kTilesOfAPiece;
            forTiles(begin, std::min(tiles(), begin + kTilesOfAPiece), points, body);
          }};
}

PiecesOfWork TiledWeights::multiplyInPieces(const Points& pose, Points& points) const {
  assert(pose.rows() == handles_);
  points.resize(points_, 3);
  return pieces(points, [this, &pose](Eigen::Index index, double* rows) { multiplyTile(index, pose, rows); });
}

PiecesOfWork TiledWeights::addColumnInPieces(Eigen::Index handle, const Vec3& delta, Points& points) const {
  assert(points.rows() == points_ && handle >= 0 && handle < handles_);
  return pieces(points, [this, handle, delta](Eigen::Index index, double* rows) {
    if (single_)
      simd::tileKernels().addColumnSingle(singleTile(index), handle, handles_, delta.data(), rows);
    else
      simd::tileKernels().addColumn(tile(index) + handle * TiledWeights::kTile, delta.data(), rows);
  });
}

void TiledWeights::multiply(const Points& pose, Points& points, Threads threads) const {
  parallelPieces({multiplyInPieces(pose, points)}, threads);
}

void TiledWeights::multiplyTile(Eigen::Index index, const Points& pose, double* rows) const {
  assert(pose.rows() == handles_);
  if (single_)
    simd::tileKernels().multiplySingle(singleTile(index), pose.data(), handles_, rows);
  else
    simd::tileKernels().multiply(tile(index), pose.data(), handles_, rows);
}

void TiledWeights::addColumn(Eigen::Index handle, const Vec3& delta, Points& points, Threads threads) const {
  parallelPieces({addColumnInPieces(handle, delta, points)}, threads);
}

void TiledWeights::multiplyTransposed(const Points& rows, Points& out, Threads threads) const {
  assert(rows.rows() == points_);
  const std::size_t numbers = static_cast<std::size_t>(handles_) * 3;
  const std::size_t ranges = static_cast<std::size_t>((tiles() + kTilesOfAPiece - 1) / kTilesOfAPiece);
  std::vector<double> partial(ranges * numbers);
  parallelRanges(tiles(), kTilesOfAPiece, threads, [&](Eigen::Index begin, Eigen::Index end) {
    std::vector<double> lanes(numbers * simd::kSumLanes);
    forTiles(begin, end, rows, [&](Eigen::Index index, const double* tileRows) {
      if (single_)
        simd::tileKernels().addTransposedSingle(singleTile(index), tileRows, handles_, lanes.data());
      else
        simd::tileKernels().addTransposed(tile(index), tileRows, handles_, lanes.data());
    });
    double* sums = partial.data() + static_cast<std::size_t>(begin / kTilesOfAPiece) * numbers;
    for (std::size_t number = 0; number < numbers; ++number)
      for (int lane = 0; lane < simd::kSumLanes; ++lane)
        sums[number] += lanes[number * simd::kSumLanes + lane];
  });
  out.setZero(handles_, 3);
  for (std::size_t range = 0; range < ranges; ++range)
    out += Eigen::Map<const Points>(partial.data() + range * numbers, handles_, 3);
}

Values TiledWeights::column(Eigen::Index handle) const {
  assert(handle >= 0 && handle < handles_);
  Values values(points_);
  for (Eigen::Index point = 0; point < points_; ++point)
    values[point] = (*this)(point, handle);
  return values;
}

} // namespace viscera::coordinates
