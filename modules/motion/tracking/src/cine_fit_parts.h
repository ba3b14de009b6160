#pragma once

#include <memory>
#include <vector>

#include "cine_contours.h"
#include "cine_pose.h"
#include "viscera/tracking/cine_fit.h"
#include "wall_stiffness.h"

namespace viscera::tracking {

/// The volumes of the labels, between which those of all phases lie: of cavities, or of the only surface.
class LabelledVolumes {
public:
  LabelledVolumes() = default;
  LabelledVolumes(const MotionRig& rig, const std::vector<LabelledPose>& poses, std::size_t outer);

  Values within(const Values& volumes) const;

private:
  Eigen::Index outer_ = -1; ///< Whose volume is free; -1 for none.
  Values least_, most_;
};

/// The place of a phase that is not labelled.
struct FreePhase {
  const CineSegment* segment = nullptr;
  std::size_t at = 0;
};

/// What a `CineFitter` keeps.
struct CineFitter::Parts {
  const MotionRig& rig;
  PhaseTimes times;
  CineFitOptions options;
  std::size_t outer = 0;
  std::vector<CinePlane> planes; ///< Without images.
  std::vector<bool> isLong;
  CineStiffness hold = CineStiffness::betweenLabels();
  std::vector<LabelledPose> poses = {};
  std::unique_ptr<const WallStiffness> stiffness = nullptr;
  std::vector<CineSegment> segments = {};
  std::vector<FreePhase> free = {}; ///< Into `segments`.
  LabelledVolumes labels = {};
  CineFit fit = {};

  /// What the images say of a phase.
  CinePose imagesOf(const FreePhase& phase) const;
  /// Whether volumes of phases without labels are held within those of the labels.
  bool keepsVolumes() const { return options.keepVolumes && poses.size() > 1; }
};

/// Sets the phases with most and least blood, in the cavities together or in the only surface: of the
/// labelled ones, and of all by the images.
void findEnds(const MotionRig& rig, const std::vector<LabelledPose>& poses, std::size_t outer, CineFit& fit);

} // namespace viscera::tracking
