#pragma once

#include "viscera/core/arrays.h"

namespace viscera::coordinates {

/// Appends rows to a pose that some coordinate systems need in their weighted sums: Green coordinates add the
/// cage's normals, systems that do not reproduce a point from its handles alone add the remainder. `points =
/// weights * lift(pose)` then holds for them as `points = weights * pose` does for the others. Immutable; may
/// be asked from several threads.
class PoseLift {
public:
  virtual ~PoseLift() = default;

  /// Rows of a lifted pose: the handles first, then the further ones.
  virtual Eigen::Index rowCount() const = 0;

  /// `rowCount x 3`; the first rows are `pose` (`handles x 3`, mm) itself.
  virtual Points lift(const Points& pose) const = 0;

  /// Given the derivative of a scalar with respect to the rows of `lift(pose)`, its derivative with respect
  /// to the handles, `handles x 3`.
  virtual Points pullBack(const Points& pose, const Points& rowGradient) const = 0;
};

} // namespace viscera::coordinates
