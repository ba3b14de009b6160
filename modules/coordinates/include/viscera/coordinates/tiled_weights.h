#pragma once

#include <cassert>
#include <cstddef>

#include "viscera/coordinates/zeroed_memory.h"
#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"

namespace viscera::coordinates {

/// A `points x handles` matrix of coordinates, stored in tiles of 16 points by all handles: the layout in
/// which a pose costs least (see docs/performance.md), and in which one handle's column is still read in
/// whole cache lines. The products run as AVX-512, AVX2 or plain code, chosen by the processor at run time.
///
/// Large matrices may be kept in single precision, with half the memory: each number then has a relative
/// error below 1.3e-7. Each point also keeps a factor that gives its numbers the sum they had, so that a pose
/// is off by that part of the handles' size, however far from the origin they are. All sums are in double
/// precision.
class TiledWeights {
public:
  static constexpr int kTile = 16;
  static constexpr Eigen::Index kTilesOfAPiece = 64; ///< The products are computed in pieces of these.

  /// All zero. O(points x handles) memory, whose pages are allocated at the first write, which a parallel
  /// solver does in parallel. Throws `std::bad_alloc`.
  TiledWeights(Eigen::Index points, Eigen::Index handles);
  /// Keeps single precision where doubles would take more than `mostBytes`.
  TiledWeights(Eigen::Index points, Eigen::Index handles, std::size_t mostBytes);
  TiledWeights(const TiledWeights& other);
  TiledWeights(TiledWeights&& other) noexcept = default;
  TiledWeights& operator=(const TiledWeights& other);
  TiledWeights& operator=(TiledWeights&& other) noexcept = default;

  Eigen::Index points() const { return points_; }
  Eigen::Index handles() const { return handles_; }
  Eigen::Index tiles() const { return (points_ + kTile - 1) / kTile; }

  /// Whether the numbers are kept in single precision.
  bool single() const { return single_; }
  std::size_t bytes() const { return storedDoubles() * sizeof(double); }
  static std::size_t bytesInDoubles(Eigen::Index points, Eigen::Index handles) {
    return static_cast<std::size_t>((points + kTile - 1) / kTile * kTile * handles) * sizeof(double);
  }

  /// The tile's `handles x 16` numbers, handle by handle, aligned to a cache line; the last tile is padded
  /// with zeros, which must stay zero. Only in double precision.
  double* tile(Eigen::Index tile) {
    assert(!single_);
    return data_.get() + tile * kTile * handles_;
  }
  const double* tile(Eigen::Index tile) const {
    assert(!single_);
    return data_.get() + tile * kTile * handles_;
  }
  /// The same in single precision: `(handles + 1) x 16`. The factor of all numbers of a point is 1 plus the
  /// value in the last row.
  const float* singleTile(Eigen::Index tile) const {
    assert(single_);
    return reinterpret_cast<const float*>(data_.get()) + tile * kTile * (handles_ + 1);
  }

  /// The memory into which to write a tile's `handles x 16` numbers: its own, or in single precision `room`
  /// (as many numbers). Call `filled` afterwards. Several threads may fill different tiles.
  double* toFill(Eigen::Index tile, double* room) { return single_ ? room : this->tile(tile); }
  /// Stores the numbers written to `numbers`; in single precision these are rounded to the stored ones.
  void filled(Eigen::Index tile, double* numbers);
  /// A tile's `handles x 16` numbers: its own memory, or in single precision `room`, filled with them.
  const double* read(Eigen::Index tile, double* room) const;

  double operator()(Eigen::Index point, Eigen::Index handle) const {
    const Eigen::Index index = handle * kTile + point % kTile;
    if (!single_)
      return tile(point / kTile)[index];
    const float* own = singleTile(point / kTile);
    return static_cast<double>(own[index]) * factorOf(own, point);
  }
  /// Leaves, in single precision, a rounding error in the point's sum; `setRow` corrects it.
  void set(Eigen::Index point, Eigen::Index handle, double value) {
    const Eigen::Index index = handle * kTile + point % kTile;
    if (!single_)
      tile(point / kTile)[index] = value;
    else
      ownSingleTile(point / kTile)[index] =
          static_cast<float>(value / factorOf(singleTile(point / kTile), point));
  }
  /// All `handles` numbers of a point.
  void setRow(Eigen::Index point, const Values& row);

  /// `points = W pose`, resized to `points x 3`; `pose` is `handles x 3`. Bitwise independent of the number
  /// of threads.
  void multiply(const Points& pose, Points& points, Threads threads) const;
  /// The same of one tile: `rows` (16 x 3, row by row) become its 16 points. For code that processes the
  /// tiles in its own order. O(handles).
  void multiplyTile(Eigen::Index tile, const Points& pose, double* rows) const;
  /// `points += column(handle) delta^T`. O(points).
  void addColumn(Eigen::Index handle, const Vec3& delta, Points& points, Threads threads) const;
  /// Both in pieces, one for each 1,024 points, for a loop over several matrices (`parallelPieces`). `points`
  /// is resized at once; it, `pose` and this must live until all are done.
  PiecesOfWork multiplyInPieces(const Points& pose, Points& points) const;
  PiecesOfWork addColumnInPieces(Eigen::Index handle, const Vec3& delta, Points& points) const;
  /// `out = W^T rows` (`handles x 3`), summed in a fixed order that does not depend on the number of threads.
  void multiplyTransposed(const Points& rows, Points& out, Threads threads) const;
  /// `points` numbers.
  Values column(Eigen::Index handle) const;

private:
  template <class Body>
  PiecesOfWork pieces(Points& points, Body body) const;
  float* ownSingleTile(Eigen::Index tile) { return const_cast<float*>(singleTile(tile)); }
  double factorOf(const float* tile, Eigen::Index point) const {
    return 1.0 + static_cast<double>(tile[handles_ * kTile + point % kTile]);
  }
  std::size_t storedDoubles() const {
    const std::size_t rows = static_cast<std::size_t>(single_ ? handles_ + 1 : handles_);
    return static_cast<std::size_t>(tiles() * kTile) * rows / (single_ ? 2 : 1);
  }

  Eigen::Index points_;
  Eigen::Index handles_;
  bool single_ = false;
  ZeroedMemory data_;
};

} // namespace viscera::coordinates
