#pragma once

#include <vector>

#include "viscera/core/arrays.h"

namespace viscera::deformation {

/// The interface of models that decide how the free handles move to restore a volume: among all motions that
/// change the volume by the same amount to first order, the one that costs least. A quadratic cost `u^T Q u /
/// 2` under `g . u = dV` has the answer `u = Q^-1 g` up to a factor, which the volume lock then chooses
/// exactly.
class RestorationModel {
public:
  virtual ~RestorationModel() = default;

  /// The direction in which to move all handles, `n x 3`, zero for those that are not `free` (ascending).
  /// `gradient`
  /// (`n x 3`, mm^2) is the volume's at `pose`. Thread-safe.
  virtual Points direction(const Points& pose, const Points& gradient,
                           const std::vector<int>& free) const = 0;

  /// A motion of the `free` handles, `n x 3` mm, that lowers the cost and to first order keeps the volume:
  /// done before the volume is restored. Standard: none. Thread-safe.
  virtual Points relaxation(const Points& pose, const Points& /*gradient*/,
                            const std::vector<int>& /*free*/) const {
    return Points::Zero(pose.rows(), 3);
  }
};

/// The restoration model with the least displacement of the handles: Q is the identity, so each free handle
/// moves along its own gradient.
class LeastDisplacement final : public RestorationModel {
public:
  Points direction(const Points& pose, const Points& gradient, const std::vector<int>& free) const override {
    Points direction = Points::Zero(pose.rows(), 3);
    direction(free, Eigen::all) = gradient(free, Eigen::all);
    return direction;
  }
};

} // namespace viscera::deformation
