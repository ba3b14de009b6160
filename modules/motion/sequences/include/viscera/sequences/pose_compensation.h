#pragma once

#include <array>
#include <functional>
#include <string>

#include <Eigen/Core>

#include "viscera/core/arrays.h"

namespace viscera::sequences {

/// Enlarges the motion of handles, so that the organ itself, which follows them only in part, moves as far as
/// intended.
///
/// Coordinates with softness do not interpolate: what an organ does at a handle is an average of that handle
/// and its neighbours, and a motion that differs from handle to handle comes out flattened. With W the
/// coordinates of the handles' own rest places (row p: those of handle p), displacements u of the handles
/// move the organ there by W u. This applies the first terms of the inverse of W, u' = sum_k (I - W)^k u (Van
/// Cittert's deconvolution): few terms sharpen smooth motions without amplifying oscillations. Rigid and
/// linear motions pass unchanged, since W reproduces them. Immutable; thread-safe.
class PoseCompensation {
public:
  /// A compensation that does not change poses.
  PoseCompensation() = default;

  /// `selfWeights` is `n x n`; every row sums to 1. `terms` beyond the first, 0 to 16. O(terms n^3). Throws
  /// `DataError` when the matrix is not square, not finite, or has a row that does not sum to 1.
  explicit PoseCompensation(const Eigen::MatrixXd& selfWeights, int terms = 3);

  /// Changes `pose` (`n x 3`) of handles that rest at `rest`. O(n^2).
  void apply(const Points& rest, Points& pose) const;

  /// The number of handles, 0 for one that does nothing.
  Eigen::Index handleCount() const { return matrix_.rows(); }

  /// Throws `DataError`, which names `organ` and `sequence`, for one that is for another number of handles.
  void requireFor(Eigen::Index handles, const std::string& organ, const std::string& sequence) const;

private:
  Eigen::MatrixXd matrix_;
};

/// The volume of an organ whose handles are at `pose + x direction` (both `n x 3`), as the coefficients of 1,
/// x, x^2 and x^3, ml. The cubic is exact for coordinates that are linear in the pose. May be called from
/// several threads.
using VolumeAlong = std::function<std::array<double, 4>(const Points& pose, const Points& direction)>;

} // namespace viscera::sequences
