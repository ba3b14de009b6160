#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/heart/clinical_numbers.h"
#include "viscera/live/motion_series.h"
#include "viscera/live/sequence_file.h"
#include "viscera/medical_io/handle_file.h"
#include "viscera/tracking/fit_quality.h"
#include "viscera/tracking/motion_rig.h"
#include "viscera/tracking/surface_distance.h"

/// Finds a patient's own motion from a series: handles and their poses over time that move one organ through
/// the phases of the series.
namespace viscera::live {

/// The options of tracking a motion. docs/patient_motion.md explains the default values.
struct TrackOptions {
  tracking::RigOptions rig;
  std::optional<medical_io::HandleFile> handles; ///< A given rig; none: one is generated.
  std::optional<double> smoothing;               ///< In time; 1e-5 for surfaces that correspond, else 1e-4.
  bool keepVolumes = true;
  double robustMm = 0;  ///< Beyond it distances count less (Huber); 0: all alike.
  int triangles = 4000; ///< Of a surface that is made from a label map.
  int witnesses = 3000; ///< In the tissue, where folds are looked for.
};

/// One phase of a tracked motion: its time and how well it fits.
struct TrackedPhase {
  double seconds = 0;
  tracking::PhaseQuality quality;
  tracking::FitVerdict verdict;
};

/// A tracked motion: handles, poses, and the quality of the fit.
struct PatientMotion {
  /// A key for every phase, the handles in groups by surface, the coordinates, and the organ's surfaces at
  /// rest: everything that is needed to play it. Its volumes at the keys are the measured ones.
  SequenceFile sequence;
  std::size_t outer = 0; ///< Index in `sequence.organs` of the surface that contains the others.
  std::vector<TrackedPhase> phases;
  /// Indices of every cavity, or of the only surface, by its name.
  std::map<std::string, heart::CardiacIndices> indices;
  /// The outer surface less its cavities in every phase, ml: tissue, as a check of the data. Empty for one
  /// surface.
  std::vector<double> tissueMl;
  bool corresponding = false;        ///< Whether points were known from phase to phase.
  double sliceMm = 0;                ///< Of label maps.
  std::vector<std::size_t> outliers; ///< Phases that fit much worse than both neighbours and should be left
                                     ///< out.
  std::vector<Text> warnings;

  tracking::FitLight worst() const;
};

/// The motion of a series: a rig on the surfaces of the first phase, their poses in all phases (least squares
/// where points correspond, else by signed distances), volumes kept exactly, and how well it all fits. For
/// any thread; reports progress phase by phase. Deterministic, whatever the number of threads. Throws
/// `DataError` for surfaces that a rig cannot be made for or that lie outside a given one, what reading of
/// labels throws, `Cancelled`. O(phases x vertices x handles) where points correspond; some seconds a phase
/// else.
PatientMotion trackMotion(const MotionSeries& series, const TrackOptions& options, Progress& progress,
                          Threads threads = {});

/// The measured surfaces of one phase of a series, for display beside the motion. Immutable.
struct MeasuredPhase {
  /// mm LPS, one for each surface; never null.
  std::vector<std::shared_ptr<const geometry::TriangleMesh>> surfaces;
  /// Distances from the same surfaces or voxels; empty where points correspond.
  std::vector<std::shared_ptr<const tracking::SurfaceDistance>> distances;

  /// How far each vertex (`n x 3` mm, those of the motion's organ) of a surface is from what was measured,
  /// mm, never negative: from the same point where points correspond, else from the surface or the voxels.
  Values apartMm(std::size_t surface, const Points& vertices) const;
};

/// Makes the measured surfaces of one phase of a series. Of label maps the surface around the voxels and
/// their distances, some tenths of a second; else O(vertices). Throws `Cancelled`.
MeasuredPhase measuredPhase(const MotionSeries& series, std::size_t phase, Progress& progress,
                            Threads threads = {});

} // namespace viscera::live
