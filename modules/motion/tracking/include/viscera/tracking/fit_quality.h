#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/deformation/witness_gradients.h"
#include "viscera/tracking/motion_rig.h"
#include "viscera/tracking/surface_distance.h"
#include "viscera/tracking/surface_series.h"

namespace viscera::tracking {

/// The errors of one fitted surface in one phase. All distances are weighted by area.
struct SurfaceQuality {
  double meanMm = 0, p95Mm = 0, maxMm = 0; ///< Of the vertices.
  double measuredMl = 0;                   ///< Of the surface or the voxels.
  double freeMl = 0;                       ///< Fitted, before volumes were kept.
  double fittedMl = 0;                     ///< Fitted.
  std::optional<double> dice;              ///< Of the voxels; none for surfaces.
  int flipped = 0;                         ///< Triangles that face the wrong way.
};

/// The errors of all surfaces and of the tissue in one phase.
struct PhaseQuality {
  std::vector<SurfaceQuality> surfaces;
  double meanMm = 0, p95Mm = 0, maxMm = 0; ///< Of all surfaces together, each counting the same.
  std::optional<double> dice;              ///< The lowest of the surfaces.
  int folded = 0;                          ///< Witness points in the tissue with det M <= 0.
  int steps = 0;
  bool volumesMet = true;
};

/// Weighted mean, 95th percentile and largest of some numbers.
struct Spread {
  double mean = 0, p95 = 0, max = 0;
};
/// Computes these of `values` with their `weights`. O(n log n).
Spread spreadOf(const Values& values, const Values& weights);

/// Triangles of `fitted` whose normal is opposed to that of the same triangle of `measured`. O(m).
int opposedTriangles(const Triangles& triangles, const Points& fitted, const Points& measured);
/// Triangles whose normal is opposed to the way in which the distance grows at their middle. O(m).
int opposedTriangles(const Triangles& triangles, const Points& fitted, const SurfaceDistance& distance);

/// Witness points in the tissue between an outer surface and its cavities, at which poses are checked for
/// folds. With only one surface, they fill its inside.
class TissueWitnesses {
public:
  /// About `wanted` points. Throws what `deformation::gridWitnesses` throws, `Cancelled`.
  TissueWitnesses(const MotionRig& rig, std::size_t outer, int wanted, Progress& progress,
                  Threads threads = {});

  int count() const { return static_cast<int>(count_); }
  /// The number of points that are folded in a pose. O(points x handles).
  int foldedAt(const Points& pose, Threads threads = {}) const;

private:
  std::shared_ptr<const deformation::WitnessGradients> gradients_;
  Eigen::Index count_ = 0;
};

/// The quality of a fitted phase as a traffic light.
enum class FitLight { good, amber, red };

/// The verdict on a fitted phase and its reasons: a sentence for each reason.
struct FitVerdict {
  FitLight light = FitLight::good;
  std::vector<Text> reasons;
};

/// Judges a phase by the limits of docs/patient_motion.md. `names` of the surfaces, `sliceMm` the distance of
/// the slices of label maps; 0 for surfaces.
FitVerdict verdictOf(const PhaseQuality& phase, const std::vector<std::string>& names, double sliceMm);

} // namespace viscera::tracking
