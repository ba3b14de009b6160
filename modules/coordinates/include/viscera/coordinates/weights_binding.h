#pragma once

#include "viscera/coordinates/binding.h"
#include "viscera/coordinates/tiled_weights.h"
#include "viscera/core/phrase.h"

namespace viscera::coordinates {

/// The binding of all coordinate systems that write a point as a weighted sum of handles, `p = sum a_i v_i`.
/// Points that failed keep their rest position in any pose.
class WeightsBinding final : public Binding {
public:
  /// Measures the report from the weights, the rest handles and the rest points. `failures` ascending; their
  /// rows of `weights` are ignored. `seconds` is the time the system took, `notes` the sentences for its
  /// report.
  WeightsBinding(TiledWeights weights, const Points& restHandles, const Points& restPoints,
                 std::vector<int> failures, double seconds, Threads threads, std::vector<Text> notes = {});
  /// Takes the report of a system that measured its weights while it made them, and saves a pass over them.
  WeightsBinding(TiledWeights&& weights, const Points& restPoints, BindingReport measured);

  Eigen::Index handleCount() const override { return weights_.handles(); }
  Eigen::Index pointCount() const override { return weights_.points(); }
  const BindingReport& report() const override { return report_; }
  void deform(const Points& pose, Points& points, Threads threads) const override;
  void moveHandle(const Points& pose, int handle, const Vec3& delta, Points& points,
                  Threads threads) const override;
  PiecesOfWork deformInPieces(const Points& pose, Points& points) const override;
  PiecesOfWork moveHandleInPieces(const Points& pose, int handle, const Vec3& delta,
                                  Points& points) const override;
  void pullBack(const Points& pose, const Points& pointGradient, Points& handleGradient,
                Threads threads) const override;
  Values influence(int handle) const override;
  double weight(Eigen::Index point, int handle) const override { return weights_(point, handle); }

  const TiledWeights& weights() const { return weights_; }

private:
  void restoreFailed(Eigen::Index begin, Eigen::Index end, Points& points) const;
  static BindingReport reportOf(const TiledWeights& weights, const Points& restHandles,
                                const Points& restPoints, std::vector<int> failures, double seconds,
                                Threads threads, std::vector<Text> notes);

  TiledWeights weights_;
  Points failedRest_; ///< Rest positions of the points in `report_.failures`.
  BindingReport report_;
};

} // namespace viscera::coordinates
