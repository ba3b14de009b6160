#pragma once

#include <memory>

#include "viscera/coordinates/pose_lift.h"
#include "viscera/coordinates/weights_binding.h"
#include "viscera/core/phrase.h"

namespace viscera::coordinates {

/// The binding of systems whose points are weighted sums of a lifted pose. Points that failed keep their rest
/// position in any pose.
class LiftedBinding final : public Binding {
public:
  /// `weights` has a column for every row of a lifted pose; the rest as for `WeightsBinding`. Unity and the
  /// smallest weight are those of the handles' own columns.
  LiftedBinding(std::shared_ptr<const PoseLift> lift, TiledWeights weights, const Points& restHandles,
                const Points& restPoints, std::vector<int> failures, double seconds, Threads threads,
                std::vector<Text> notes);

  Eigen::Index handleCount() const override { return handles_; }
  Eigen::Index pointCount() const override { return rows_.pointCount(); }
  const BindingReport& report() const override { return report_; }
  void deform(const Points& pose, Points& points, Threads threads) const override;
  /// O(points x rows of the lifted pose that move with the handle).
  void moveHandle(const Points& pose, int handle, const Vec3& delta, Points& points,
                  Threads threads) const override;
  PiecesOfWork deformInPieces(const Points& pose, Points& points) const override;
  PiecesOfWork moveHandleInPieces(const Points& pose, int handle, const Vec3& delta,
                                  Points& points) const override;
  void pullBack(const Points& pose, const Points& pointGradient, Points& handleGradient,
                Threads threads) const override;
  Values influence(int handle) const override { return rows_.influence(handle); }
  double weight(Eigen::Index point, int handle) const override { return rows_.weight(point, handle); }

private:
  std::shared_ptr<const PoseLift> lift_;
  Eigen::Index handles_;
  WeightsBinding rows_; ///< With a "handle" for every row of a lifted pose.
  BindingReport report_;
};

} // namespace viscera::coordinates
