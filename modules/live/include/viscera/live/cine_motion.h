#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/plane_cut.h"
#include "viscera/live/motion_series.h"
#include "viscera/live/patient_motion.h"
#include "viscera/medical_io/cine_study.h"
#include "viscera/tracking/cine_fit.h"

/// Finds a patient's own motion from cine images and the labels of a few phases. Phases are counted from 0
/// everywhere here; in texts as a request says.
namespace viscera::live {

/// The labels of one phase: a label map; or surfaces, one a file, or a folder of them.
struct PhaseLabels {
  std::size_t phase = 0; ///< Of the cycle, the first is 0.
  std::vector<std::filesystem::path> files;
};

/// A contour that a user corrected in one slice of a study at one phase: there the surface passes through
/// these points, whatever the images show.
struct ContourCorrection {
  std::size_t phase = 0; ///< Of the cycle, the first is 0. One without labels, which are the truth.
  /// The slice of the study, counted from 0, or its series; without either that in whose plane the points
  /// lie.
  std::optional<std::size_t> slice = std::nullopt;
  std::optional<int> series = std::nullopt;
  std::string surface; ///< Its name, "RV"; may be empty where there is only one.
  Points points;       ///< `k x 3` mm, LPS, in the slice's plane and in order along the contour.

  friend bool operator==(const ContourCorrection& a, const ContourCorrection& b) {
    return a.phase == b.phase && a.slice == b.slice && a.series == b.series && a.surface == b.surface &&
           a.points.rows() == b.points.rows() && a.points == b.points;
  }
};

/// What a motion is found from.
struct CineRequest {
  std::filesystem::path images;    ///< A folder of DICOM files, or a file of volumes over time.
  std::vector<PhaseLabels> labels; ///< Of two phases or more; of one for an estimate.
  /// Surfaces as in `SeriesRequest`. One surface in a file a phase may be named here, without labels.
  std::vector<LabelledSurface> surfaces;
  std::optional<double> periodSeconds;             ///< Overrides the median interval of the slices.
  std::vector<int> leftOutSeries;                  ///< Numbers of series whose slices are not used.
  std::size_t firstPhase = 0;                      ///< The number by which texts call the first phase.
  std::vector<ContourCorrection> corrections = {}; ///< Contours that the motion has to meet.
};

/// Where a plane of a joined study comes from.
struct CinePlaneSource {
  std::size_t slice = 0; ///< Of the study.
  int series = 0;        ///< Its number.
  /// "series 3, 4-chamber"; "slice 5, short axis", counted over all slices from 0, where its series has
  /// several or no number.
  Text name;
  medical_io::CinePlane view = medical_io::CinePlane::other;
};

/// A slice of a study, whether or not its images are used.
struct StudySlice {
  geometry::Plane plane;
  int series = 0; ///< Its number.
  Text name;      ///< As of `CinePlaneSource`.
};

/// Images and labels of one cycle, checked against each other. Immutable; holds the part of every picture
/// around the labels as 32-bit numbers.
struct LabelledStudy {
  /// The labelled phases in the order of the cycle, as surfaces without correspondence or as voxels.
  MotionSeries labels;
  std::vector<std::size_t> phases; ///< Which phase of the cycle each of them is.
  /// The triangles of each surface of the first labelled phase that close an opening; empty for voxels.
  std::vector<std::vector<Eigen::Index>> caps;
  tracking::PhaseTimes times;              ///< Of all phases of the cycle.
  std::vector<tracking::CinePlane> planes; ///< Those that cross what is labelled.
  std::vector<CinePlaneSource> sources;    ///< One for each plane.
  std::vector<StudySlice> slices;          ///< All of the study.
  /// Those of the request, with their slices and surfaces.
  std::vector<ContourCorrection> corrections;
  std::vector<Text> warnings; ///< What was left out, repaired or assumed, a sentence each.
  std::size_t firstPhase = 0; ///< As the request has it.
};

/// Joins a study with the labels of a request, whose `images` are not read. Slices of a stack nearer than 4
/// mm to the one before, and planes that do not cross the labels, are left out.
///
/// Throws `UsageError` without labels, for a phase that the study has not or that is named twice, for a
/// series that it has not, without a period; what `resolved` throws of corrections; `DataError` where no
/// plane crosses the labels, and what `readMotionSeries` throws of files, labels and cavities; `Cancelled`.
/// O(pixels + voxels).
LabelledStudy joinStudy(const medical_io::CineStudy& study, const CineRequest& request, Progress& progress);

/// Reads the images too: `readCineStudy` and `joinStudy`. Throws what they throw.
LabelledStudy readLabelledStudy(const CineRequest& request, Progress& progress);

/// Phases of the cycle that a study shows: those of the slice with most of them. 0 for no slices.
std::size_t phasesOf(const medical_io::CineStudy& study);

/// What a plane can say of a phase.
enum class PlaneState {
  used,
  leavesPlane, ///< Its tissue arrives more than 4 mm from the next labelled surface: it counts little.
  unlike,      ///< Its images are hardly alike around the wall: likeness below 0.15.
  noWall,      ///< No labelled surface crosses it in the neighbouring labelled phases.
  noImage,     ///< It has no image of that phase.
  labelled     ///< The phase has labels, the plane is not asked.
};

/// A plane over all phases.
struct CinePlaneUse {
  CinePlaneSource source;
  bool longAxis = false;
  std::vector<tracking::PlaneShare> shares; ///< One for each phase.
  std::vector<PlaneState> states;           ///< The same.
  double weight = 0, likeness = 0;          ///< 0 to 1, means over the phases in which it shows a wall.
  double closureMm = 0, apartMm = 0;        ///< Means over the same.
  tracking::FitLight light = tracking::FitLight::good;
  Text reason; ///< Empty where it is good.
};

/// One thing to say about a motion from images.
struct CineFinding {
  tracking::FitLight light = tracking::FitLight::amber;
  Text text;
  std::optional<std::size_t> phase = std::nullopt; ///< That it is about.
  std::optional<std::size_t> plane = std::nullopt; ///< Index in `CineMotion::planes`.
};

/// What became of a corrected contour.
struct CorrectionOutcome {
  ContourCorrection correction;
  Text where; ///< "RV, series 3, 4-chamber"
  tracking::CorrectionMet met;
};

/// A motion from images and the labels of a few phases.
struct CineMotion {
  /// The motion of a series with labels in every phase, a key for each. Where no labels are, `measuredMl` is
  /// what the images say after volumes were kept, `freeMl` before, and `meanMm` how far followed tissue is
  /// from the surfaces; `p95Mm`, `maxMm` are 0 there, not known.
  PatientMotion motion;
  std::vector<std::size_t> labelled; ///< The labelled phases, ascending.
  /// Only one phase has labels: each volume, ejection fraction and pose of the others is an estimate, and a
  /// right ventricle has no `indices`.
  bool estimate = false;
  std::vector<CinePlaneUse> planes;
  std::vector<CineFinding> findings;          ///< Worst first; their texts are among `motion.warnings`.
  std::vector<CorrectionOutcome> corrections; ///< In the order of the request.
  /// The labelled phases with most and least blood, and those that the images show so, before volumes were
  /// kept.
  std::size_t endDiastole = 0, endSystole = 0, fullest = 0, emptiest = 0;

  bool isLabelled(std::size_t phase) const;
};

/// Finds the motion: `tracking::fitCine` on a rig of the first labelled phase's surfaces, and how far each
/// phase and plane can be relied upon. `options.smoothing` and `robustMm` are not used. For any thread.
/// Bitwise independent of the number of threads. Throws what making a rig throws, `Cancelled`. About 0.1 to 1
/// s a phase.
///
///     Progress progress;
///     CineRequest request;
///     request.images = "patient1";
///     request.labels = {{0, {"ed.nrrd"}}, {9, {"es.nrrd"}}};
///     const CineMotion found = trackCine(readLabelledStudy(request, progress), {}, progress);
///     writeSequence("beat.sequence.json", found.motion.sequence);
CineMotion trackCine(const LabelledStudy& study, const TrackOptions& options, Progress& progress,
                     Threads threads = {});

/// The same for a user who corrects contours one after the other: following the images takes its time once,
/// then each set of corrections about a second. Immutable; for any thread.
class CineTracker {
public:
  /// Follows the images. `study` is never null. Throws what `trackCine` throws.
  CineTracker(std::shared_ptr<const LabelledStudy> study, const TrackOptions& options, Progress& progress,
              Threads threads = {});
  ~CineTracker();
  CineTracker(const CineTracker&) = delete;
  CineTracker& operator=(const CineTracker&) = delete;

  const LabelledStudy& study() const;
  /// The motion that meets these corrections in place of the study's; `tracking::CineFitter::corrected` says
  /// how. Throws what `resolved` and the fit throw, `Cancelled`.
  CineMotion motion(const std::vector<ContourCorrection>& corrections, Progress& progress,
                    Threads threads = {}) const;

private:
  struct Parts;
  std::unique_ptr<const Parts> parts_;
};

} // namespace viscera::live
