#pragma once

#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/parallel.h"

namespace viscera::coordinates {

/// A `points x handles` matrix of coordinates, stored in tiles of 16 points by all handles: the layout in which a pose
/// costs least (see docs/performance.md), and in which one handle's column is still read in whole cache lines.
class TiledWeights {
public:
  static constexpr int kTile = 16;

  TiledWeights(Eigen::Index points, Eigen::Index handles);

  Eigen::Index points() const { return points_; }
  Eigen::Index handles() const { return handles_; }
  Eigen::Index tiles() const { return (points_ + kTile - 1) / kTile; }

  /// The tile's `handles x 16` numbers, handle by handle; the last tile is padded with zeros.
  double* tile(Eigen::Index tile) { return data_.data() + tile * kTile * handles_; }
  const double* tile(Eigen::Index tile) const { return data_.data() + tile * kTile * handles_; }

  double operator()(Eigen::Index point, Eigen::Index handle) const {
    return tile(point / kTile)[handle * kTile + point % kTile];
  }
  void set(Eigen::Index point, Eigen::Index handle, double value) {
    tile(point / kTile)[handle * kTile + point % kTile] = value;
  }

  /// `points = W pose`, resized to `points x 3`.
  void multiply(const Points& pose, Points& points, Threads threads) const;
  /// `points += column(handle) delta^T`.
  void addColumn(Eigen::Index handle, const Vec3& delta, Points& points, Threads threads) const;
  /// `out = W^T rows` (`handles x 3`), summed in a fixed order.
  void multiplyTransposed(const Points& rows, Points& out, Threads threads) const;
  Values column(Eigen::Index handle) const;

private:
  Eigen::Index points_;
  Eigen::Index handles_;
  std::vector<double> data_;
};

} // namespace viscera::coordinates
