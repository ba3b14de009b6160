#pragma once

#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/document/rig.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/live/motion_series.h"
#include "viscera/live/patient_motion.h"
#include "viscera/tracking/distance_fit.h"
#include "viscera/tracking/fit_quality.h"
#include "viscera/tracking/mask.h"
#include "viscera/tracking/motion_rig.h"

/// What every way of finding a motion shares: the surfaces at rest, handles, targets, quality, the sequence.
namespace viscera::live {

/// The surface around a mask, `triangles` at most.
geometry::TriangleMesh surfaceAround(const tracking::Mask& mask, const std::string& name, int triangles,
                                     std::vector<Text>& warnings, Progress& progress, Threads threads);

/// Everything at rest, which is the first phase of a series.
std::vector<geometry::TriangleMesh> restSurfaces(const MotionSeries& series, const TrackOptions& options,
                                                 std::vector<Text>& warnings, Progress& progress,
                                                 Threads threads);

/// The handles of the options, or new ones: those of the box first, a group for it and one for each surface.
document::Rig rigFor(const std::vector<geometry::TriangleMesh>& rest, const MotionSeries& series,
                     const TrackOptions& options);

/// The surfaces bound to these handles.
tracking::MotionRig boundTo(const document::Rig& handles, std::vector<geometry::TriangleMesh> rest,
                            const TrackOptions& options, Progress& progress, Threads threads);

/// The targets of the surfaces in one phase of a series without correspondence.
tracking::PhaseTargets targetsOf(const MotionSeries& series, std::size_t phase);

/// How well a fit fits the phases of its series.
class Assessment {
public:
  /// Keeps all references.
  Assessment(const MotionSeries& series, const tracking::MotionRig& rig, const tracking::MotionFit& fit)
      : series_(series), rig_(rig), fit_(fit) {}

  tracking::PhaseQuality of(std::size_t phase) const;

private:
  Values residualsOf(const Points& own, std::size_t phase, std::size_t i,
                     const tracking::PhaseTargets& targets, tracking::SurfaceQuality& surface) const;

  const MotionSeries& series_;
  const tracking::MotionRig& rig_;
  const tracking::MotionFit& fit_;
};

/// A key sequence with one key for each of `times`, the handles in their groups, and the surfaces at rest.
SequenceFile sequenceOf(const std::vector<std::string>& names, const tracking::PhaseTimes& times,
                        const tracking::MotionRig& rig, const std::vector<Points>& poses,
                        const document::Rig& handles);

} // namespace viscera::live
