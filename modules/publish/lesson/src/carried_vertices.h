#pragma once

#include "sampled_motion.h"
#include "viscera/lesson/lesson_plan.h"
#include "viscera/live/posed_organs.h"

namespace viscera::lesson {

/// The positions and weights of a plan's vertices: those of all surfaces, one after the other, then its own
/// handles. For the thread of the organs, which its members pose.
class CarriedVertices {
public:
  /// All must live longer; `organs` are those of `source.state`. Throws `DataError` for an organ that is
  /// still being bound, and for a sequence that is not for these handles.
  CarriedVertices(const LessonPlan& plan, const LessonSource& source, live::PosedOrgans& organs,
                  Threads threads);

  /// Vertices of the surfaces, without the handles.
  Eigen::Index vertexCount() const { return vertices_; }
  /// The weights by which each row of `rest` is a sum of the rig's handles; without columns if it is not such
  /// a sum (Green coordinates).
  const CarrierWeights& weights() const { return weights_; }
  /// `(vertices + own handles) x 3` mm; without the handles if `weights` has no columns.
  const Points& rest() const { return rest_; }

  /// The rig's handles at a fraction of the cycle, as the window would show them: volumes are kept, and a
  /// prescribed one is met. Throws `DataError` where they cannot be.
  void poseAt(double fraction, double ratePerMinute, Points& pose);
  /// The vertices (and handles) in a pose of the rig, exactly.
  Points in(const Points& pose);
  /// The function that `sampleMotion` asks for.
  CarriersAt carriersAt();

private:
  void gather();
  bool isSumOfHandles();

  const LessonPlan& plan_;
  const LessonSource& source_;
  live::PosedOrgans& organs_;
  live::MotionRunner runner_;
  Eigen::Index vertices_ = 0;
  Points restHandles_;
  Points rest_;
  CarrierWeights weights_;
  bool keepsVolumes_ = false;
  Threads threads_;
};

} // namespace viscera::lesson
