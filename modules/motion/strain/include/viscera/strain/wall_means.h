#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/strain/aha_segments.h"
#include "viscera/strain/wall_fields.h"

/// Means of the material strain over segments, and how certain they are.
namespace viscera::strain {

/// Numbers of each segment by its number, 0: of the whole wall. Engineering strain, a part.
struct WallMeans {
  std::array<double, kSegments + 1> longitudinal{}, circumferential{}, radial{}; ///< NaN without a point.
};

/// The state of a wall that strain is measured from: its local axes carried along, and the inverse of the
/// deformation gradients. Immutable; thread-safe.
class WallReference {
public:
  /// `gradients` are those of the reference, one for each of `points`, which have to live longer. Points that
  /// are folded there are left out of all means. O(points).
  WallReference(const WallPoints& points, std::vector<Eigen::Matrix3d> gradients);

  /// The means over the volumes of the points, at `gradients` against the same rest. O(points).
  WallMeans meansAt(const std::vector<Eigen::Matrix3d>& gradients) const;

private:
  const WallPoints& points_;
  std::vector<LocalAxes> axes_;
  std::vector<bool> usable_;
  std::vector<Eigen::Matrix3d> inverse_;
};

/// Fills the deformation gradients at the points of a wall, in the reference and in the phase that is looked
/// at, as they would be had the fit of the motion gone wrong by one draw of its errors. Called from several
/// threads, once for each draw.
using DrawnGradients =
    std::function<void(int draw, std::vector<Eigen::Matrix3d>& reference, std::vector<Eigen::Matrix3d>& now)>;

/// The standard deviations of the means over `draws` (at least two): a parametric bootstrap (Efron and
/// Tibshirani 1986, doi 10.1214/ss/1177013815). NaN for segments without a point. Throws `Cancelled`.
/// O(draws x points), besides the work of `gradients`. Does not depend on the number of threads.
WallMeans deviationsOfMeans(const WallPoints& points, const DrawnGradients& gradients, int draws,
                            Progress& progress, Threads threads = {});

} // namespace viscera::strain
