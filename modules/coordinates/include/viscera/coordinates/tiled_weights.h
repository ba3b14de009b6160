#pragma once

#include "viscera/coordinates/zeroed_memory.h"
#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"

namespace viscera::coordinates {

/// A `points x handles` matrix of coordinates, stored in tiles of 16 points by all handles: the layout in
/// which a pose costs least (see docs/performance.md), and in which one handle's column is still read in
/// whole cache lines. The products run as AVX-512, AVX2 or plain code, chosen by what the processor has when
/// the program runs.
class TiledWeights {
public:
  static constexpr int kTile = 16;
  static constexpr Eigen::Index kTilesOfAPiece = 64; ///< The products are computed in pieces of these.

  /// All zero. O(points x handles) memory, whose pages the first writer brings in: a parallel solver does
  /// that in parallel. Throws `std::bad_alloc`.
  TiledWeights(Eigen::Index points, Eigen::Index handles);
  TiledWeights(const TiledWeights& other);
  TiledWeights(TiledWeights&& other) noexcept = default;
  TiledWeights& operator=(const TiledWeights& other);
  TiledWeights& operator=(TiledWeights&& other) noexcept = default;

  Eigen::Index points() const { return points_; }
  Eigen::Index handles() const { return handles_; }
  Eigen::Index tiles() const { return (points_ + kTile - 1) / kTile; }

  /// The tile's `handles x 16` numbers, handle by handle, aligned to a cache line; the last tile is padded
  /// with zeros, and whoever writes it keeps them zero.
  double* tile(Eigen::Index tile) { return data_.get() + tile * kTile * handles_; }
  const double* tile(Eigen::Index tile) const { return data_.get() + tile * kTile * handles_; }

  double operator()(Eigen::Index point, Eigen::Index handle) const {
    return tile(point / kTile)[handle * kTile + point % kTile];
  }
  void set(Eigen::Index point, Eigen::Index handle, double value) {
    tile(point / kTile)[handle * kTile + point % kTile] = value;
  }

  /// `points = W pose`, resized to `points x 3`; `pose` is `handles x 3`. Bitwise independent of the number
  /// of threads.
  void multiply(const Points& pose, Points& points, Threads threads) const;
  /// The same of one tile: `rows` (16 x 3, row by row) become its 16 points. For whoever goes through the
  /// tiles in an order of its own. O(handles).
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

  Eigen::Index points_;
  Eigen::Index handles_;
  ZeroedMemory data_;
};

} // namespace viscera::coordinates
