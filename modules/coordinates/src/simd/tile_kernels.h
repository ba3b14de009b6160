#pragma once

/// The loops over tiles of weights, compiled for several instruction sets. Tiles hold 16 points, see
/// `TiledWeights`.
namespace viscera::coordinates::simd {

/// Independent partial sums that `TileKernels::addTransposed` keeps for each number.
inline constexpr int kSumLanes = 8;

/// Numbers below this become zero in single precision: still smaller ones cost a hundred times as much to
/// read.
inline constexpr double kLeastSingle = 1.2e-38;

/// Rows whose sum rounding changes by this part of it or more are not corrected: they add up to zero, or are
/// not weights.
inline constexpr double kMostCorrection = 1e-6;

struct TileKernels {
  /// Rows 0 to 15 of `points` (16 x 3) become the tile times `pose` (`handles x 3`).
  void (*multiply)(const double* tile, const double* pose, long handles, double* points);

  /// `points` (16 x 3) grow by the tile's column (16) times `delta` (3).
  void (*addColumn)(const double* column, const double* delta, double* points);

  /// `sums` (`handles x 3 x kSumLanes`) grow by the tile's columns times `rows` (16 x 3). Lane l takes the
  /// rows l and l + 8, in this order, whatever the instruction set.
  void (*addTransposed)(const double* tile, const double* rows, long handles, double* sums);

  /// How well the tile reproduces `points` (3 x 16) from `positions` (`handles x 3`): fills `found` (5 x 16)
  /// with `sum a_i (v_i - p)` (three rows), `sum a_i`, and the smallest a_i.
  void (*measure)(const double* tile, const double* positions, long handles, const double* points,
                  double* found);

  // Tiles in single precision are `(handles + 1) x 16`: the last row holds each point's factor minus 1, which
  // restores the sum that its numbers had before rounding.

  /// Rounds the tile (`handles x 16`) into `single`; it becomes what `single` stands for.
  void (*round)(double* tile, long handles, float* single);

  /// The same three for a tile in single precision. Everything is computed in double precision.
  void (*multiplySingle)(const float* tile, const double* pose, long handles, double* points);
  void (*addColumnSingle)(const float* tile, long handle, long handles, const double* delta, double* points);
  void (*addTransposedSingle)(const float* tile, const double* rows, long handles, double* sums);
};

namespace baseline {
extern const TileKernels kTileKernels;
}
namespace avx2 {
extern const TileKernels kTileKernels;
}
namespace avx512 {
extern const TileKernels kTileKernels;
}

} // namespace viscera::coordinates::simd
