#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/progress.h"
#include "viscera/tracking/cine_correction.h"
#include "viscera/tracking/cine_images.h"
#include "viscera/tracking/distance_fit.h"
#include "viscera/tracking/motion_rig.h"
#include "viscera/tracking/phase_times.h"
#include "viscera/tracking/series_fit.h"
#include "viscera/tracking/surface_series.h"

namespace viscera::tracking {

/// A phase of a cine study in which the surfaces are known.
struct LabelledPhase {
  std::size_t phase = 0;
  PhaseTargets targets;
};

/// The options of `fitCine`.
struct CineFitOptions {
  /// The triangles of each surface that close an opening and are no wall, such as those of valves; empty for
  /// a surface without them, or for all.
  std::vector<std::vector<Eigen::Index>> caps = {};
  /// Labelled phases have their volumes exactly, and no cavity (or only surface) of another phase is larger
  /// or smaller than all labels: ejection fraction and stroke volume are those of the labels.
  bool keepVolumes = true;
  /// Whether one labelled phase of a loop is enough. What the images show of the others is an estimate then,
  /// volumes included: there is no second label at which tissue could be seen to have drifted.
  bool fromOne = false;
  /// Points in the tissue, those of `TissueWitnesses`, at which no phase is folded where volumes can be kept
  /// without: the pose changes as little as its fit lets it. 0: folds are not looked for.
  int witnesses = 3000;
};

/// What one plane contributed to one phase.
struct PlaneShare {
  double weight = 0;    ///< 0 to 1: of its contours, on average.
  double likeness = 0;  ///< 0 to 1: of its images around that tissue to those of the labelled phases.
  double closureMm = 0; ///< How far its tissue arrived from the next labelled surface, the median.
  double apartMm = 0;   ///< Its tissue from the fitted surfaces, the mean by weight.
  int points = 0;       ///< On contours; 0: it shows no wall, or has no image in that phase.
};

/// A motion found between labelled phases.
struct CineFit {
  MotionFit motion;                            ///< Like that of a series in which every phase is labelled.
  std::vector<std::vector<PlaneShare>> planes; ///< `[phase][plane]`; none in labelled phases.
  /// How far each phase is from the labelled phase before to the next one, as the images say it, before its
  /// handles are fitted one by one; 0 in a labelled phase.
  std::vector<double> parts;
  /// The labelled phases with most and least blood in the cavities, or in the only surface.
  std::size_t endDiastole = 0, endSystole = 0;
  /// The phases with most and least of it as the images say, before volumes were kept: where another one than
  /// the label is clearly emptier, end of systole was labelled elsewhere.
  std::size_t fullest = 0, emptiest = 0;
  /// Whether a phase was taken back towards the one between its labelled phases, since its tissue would fold.
  std::vector<bool> heldBack;
  std::vector<CorrectionMet> corrections; ///< One for each corrected contour.
};

/// Finds the poses in which a rig's surfaces, bound in some phase, fit the labelled phases exactly and the
/// images of a cine study between them. docs/patient_motion.md has the method: contours of the labelled
/// surfaces are followed in every plane from both sides; one number a phase places it between its labelled
/// phases; then the handles about that pose, at least strain of the wall. A labelled phase has its measured
/// volumes, the others those of the images, within the labels'. `times` are those of all phases; a plane's
/// images are matched by parts of the cycle. Phases outside the labelled ones of a series that is no loop
/// keep the nearest one's pose.
///
/// Bitwise independent of the number of threads. About a second a phase for eleven planes. Throws `DataError`
/// for fewer than two labelled phases (one: see `fromOne`) or one named twice, what `requireValid` throws,
/// `Cancelled`.
CineFit fitCine(const MotionRig& rig, std::vector<LabelledPhase> labelled,
                const std::vector<CinePlane>& planes, const PhaseTimes& times, const CineFitOptions& options,
                Progress& progress, Threads threads = {});

/// A fit that can be corrected afterwards: it keeps what the images say of each phase, not the images.
/// Immutable; for any thread.
class CineFitter {
public:
  struct Parts;

  /// Fits as `fitCine`. Keeps the reference to the rig. Throws what `fitCine` throws.
  CineFitter(const MotionRig& rig, std::vector<LabelledPhase> labelled, const std::vector<CinePlane>& planes,
             const PhaseTimes& times, const CineFitOptions& options, Progress& progress,
             Threads threads = {});
  ~CineFitter();
  CineFitter(const CineFitter&) = delete;
  CineFitter& operator=(const CineFitter&) = delete;

  /// The fit without corrections.
  const CineFit& fit() const;
  /// The fit with corrected contours. Each goes before the images: the handles change as little as makes the
  /// surface's cut pass within `kCorrectionMetMm` of all its points, or as near as the handles can without
  /// folding tissue. Volumes stay within the labels'. Phases up to 0.15 of the cycle away follow by the
  /// square of a cosine, as far as the next labelled phase or the next correction of the same contour: images
  /// that mislead one phase mislead its neighbours. All other phases, and everything without corrections, are
  /// those of `fit` to the bit.
  ///
  /// Bitwise independent of the number of threads. About 0.1 s a phase that changes. Throws `DataError` for a
  /// labelled phase, one outside the labelled ones, a surface that is not there, and without points;
  /// `Cancelled`.
  CineFit corrected(const std::vector<CorrectedContour>& contours, Progress& progress,
                    Threads threads = {}) const;

private:
  std::unique_ptr<Parts> parts_;
};

/// The triangles of a surface that `tidySeries` closed its openings with, as `CineFitOptions::caps` wants
/// them: the fans around middles that it added. O(triangles).
std::vector<Eigen::Index> capTriangles(const TidySeries& tidy);

} // namespace viscera::tracking
