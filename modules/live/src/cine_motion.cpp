#include "viscera/live/cine_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion_assembly.h"
#include "tracked_volumes.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/text.h"
#include "viscera/live/contour_corrections.h"

namespace viscera::live {
namespace {

using tracking::CineFit;
using tracking::FitLight;
using tracking::PlaneShare;

constexpr double kLeavesPlaneMm = 4, kUnlike = 0.15;
constexpr double kFewAmber = 0.05; ///< Weight of all contours of a phase, on average.
constexpr double kApartAmberMm = 1.5, kApartRedMm = 2.5;
constexpr double kWallChange = 0.1;   ///< Of the tissue's volume beyond those of the labels.
constexpr double kEmptierPart = 0.03; ///< Of the volume at the end of diastole.
constexpr double kMostPhases = 0.5;   ///< In which a plane may be of no use before it is red.
constexpr double kSomePhases = 0.2;   ///< The same, amber.

PlaneState stateOf(const PlaneShare& share, bool labelled, bool hasImage) {
  if (labelled)
    return PlaneState::labelled;
  if (!hasImage)
    return PlaneState::noImage;
  if (share.points == 0)
    return PlaneState::noWall;
  if (share.closureMm > kLeavesPlaneMm)
    return PlaneState::leavesPlane;
  return share.likeness < kUnlike ? PlaneState::unlike : PlaneState::used;
}

/// Says what a plane over all phases is worth.
void judgePlane(CinePlaneUse& use) {
  double shown = 0, leaving = 0, unlike = 0, missing = 0, asked = 0;
  for (std::size_t phase = 0; phase < use.shares.size(); ++phase) {
    const PlaneShare& share = use.shares[phase];
    missing += use.states[phase] == PlaneState::noImage;
    asked += use.states[phase] != PlaneState::labelled;
    if (share.points == 0)
      continue;
    ++shown;
    leaving += use.states[phase] == PlaneState::leavesPlane;
    unlike += use.states[phase] == PlaneState::unlike;
    use.weight += share.weight;
    use.likeness += share.likeness;
    use.closureMm += share.closureMm;
    use.apartMm += share.apartMm;
  }
  for (double* number : {&use.weight, &use.likeness, &use.closureMm, &use.apartMm})
    *number /= std::max(shown, 1.0);
  if (shown == 0) {
    use.light = FitLight::amber;
    use.reason = "it shows no wall that could be followed";
  } else if (leaving > kMostPhases * shown) {
    use.light = FitLight::red;
    use.reason = phrase("its tissue leaves the plane: it arrives %1 mm from the next label",
                        inFixed(use.closureMm, 1));
  } else if (unlike > kMostPhases * shown) {
    use.light = FitLight::red;
    use.reason = "its images are hardly alike around the wall";
  } else if (leaving + unlike > kSomePhases * shown) {
    use.light = FitLight::amber;
    use.reason = phrase("it counts little in %1 of %2 phases, in which its tissue leaves the plane or its "
                        "images are unlike",
                        static_cast<int>(leaving + unlike), static_cast<int>(shown));
  } else if (missing > 0) {
    use.light = FitLight::amber;
    use.reason =
        phrase("it has no image of %1 of %2 phases", static_cast<int>(missing), static_cast<int>(asked));
  }
}

/// Makes a motion's numbers from what a fit found.
class CineReport {
public:
  CineReport(const LabelledStudy& study, const tracking::MotionRig& rig, const CineFit& fit,
             CineMotion& found)
      : study_(study), rig_(rig), fit_(fit), found_(found) {}

  void addPlanes() {
    const std::vector<bool> isLong = tracking::longAxisPlanes(study_.planes);
    const auto count = static_cast<double>(study_.times.count());
    for (std::size_t plane = 0; plane < study_.planes.size(); ++plane) {
      CinePlaneUse& use = found_.planes.emplace_back();
      use.source = study_.sources[plane];
      use.longAxis = isLong[plane];
      for (std::size_t phase = 0; phase < study_.times.count(); ++phase) {
        const double fraction = study_.times.seconds[phase] / study_.times.periodSeconds;
        use.shares.push_back(fit_.planes[phase][plane]);
        use.states.push_back(stateOf(use.shares.back(), found_.isLabelled(phase),
                                     study_.planes[plane].imageAt(fraction, 0.75 / count) >= 0));
      }
      judgePlane(use);
      if (use.light != FitLight::good)
        say(use.light, phrase("%1: %2", use.source.name, use.reason), std::nullopt, plane);
    }
  }

  /// Labelled phases by their labels, the others by the images.
  void addPhases(const tracking::TissueWitnesses& tissue, Threads threads, Progress& progress) {
    tracking::MotionFit atLabels;
    for (const std::size_t phase : study_.phases) {
      atLabels.poses.push_back(fit_.motion.poses[phase]);
      atLabels.freeVolumesMl.push_back(fit_.motion.freeVolumesMl[phase]);
      atLabels.steps.push_back(fit_.motion.steps[phase]);
      if (!fit_.motion.volumes.empty())
        atLabels.volumes.push_back(fit_.motion.volumes[phase]);
    }
    const Assessment assessment(study_.labels, rig_, atLabels);
    found_.motion.phases.resize(study_.times.count());
    parallelRanges(
        static_cast<Eigen::Index>(study_.times.count()), 1, threads, [&](Eigen::Index begin, Eigen::Index) {
          progress.throwIfCancelled();
          const auto phase = static_cast<std::size_t>(begin);
          const auto label = std::find(study_.phases.begin(), study_.phases.end(), phase);
          TrackedPhase& tracked = found_.motion.phases[phase];
          tracked.seconds = study_.times.seconds[phase];
          tracked.quality = label == study_.phases.end()
                                ? byImages(phase)
                                : assessment.of(static_cast<std::size_t>(label - study_.phases.begin()));
          tracked.quality.folded = tissue.foldedAt(fit_.motion.poses[phase], Threads{1});
        });
  }

  /// Verdicts of the phases; volumes of tissue are known by now.
  void judgePhases() {
    for (std::size_t phase = 0; phase < found_.motion.phases.size(); ++phase) {
      TrackedPhase& tracked = found_.motion.phases[phase];
      tracked.verdict = tracking::verdictOf(tracked.quality, study_.labels.names, study_.labels.sliceMm());
      if (!found_.isLabelled(phase))
        judgeByImages(phase, tracked.verdict);
      for (const Text& reason : tracked.verdict.reasons)
        say(tracked.verdict.light, phrase("phase %1: %2", numberOf(phase), reason), phase, std::nullopt);
    }
  }

  /// What concerns the whole cycle.
  void judgeCycle() {
    if (found_.estimate)
      say(FitLight::amber,
          phrase("only phase %1 has labels: volumes and ejection fraction are estimates, and usually too "
                 "small a motion; label the end of systole too",
                 numberOf(study_.phases.front())),
          study_.phases.front(), std::nullopt);
    const double full = bloodAt(found_.endDiastole), empty = bloodAt(found_.endSystole);
    if (!found_.estimate && found_.emptiest != found_.endSystole &&
        empty - bloodAt(found_.emptiest) > kEmptierPart * full)
      say(FitLight::amber,
          phrase("the images show phase %1 emptier than the labelled end of systole, phase %2, by %3 ml: "
                 "label that phase",
                 numberOf(found_.emptiest), numberOf(found_.endSystole),
                 inFixed(empty - bloodAt(found_.emptiest), 1)),
          found_.emptiest, std::nullopt);
    if (!found_.estimate && found_.fullest != found_.endDiastole &&
        bloodAt(found_.fullest) - full > kEmptierPart * full)
      say(FitLight::amber,
          phrase("the images show phase %1 fuller than the labelled end of diastole, phase %2, by %3 ml: "
                 "label that phase",
                 numberOf(found_.fullest), numberOf(found_.endDiastole),
                 inFixed(bloodAt(found_.fullest) - full, 1)),
          found_.fullest, std::nullopt);
    const std::vector<bool> isLong = tracking::longAxisPlanes(study_.planes);
    if (isLong.size() == 1 || std::count(isLong.begin(), isLong.end(), true) == 0)
      say(FitLight::amber,
          "planes of one direction only: what moves across them, such as the base, follows its neighbours",
          std::nullopt, std::nullopt);
  }

  /// Says which corrected contours are met in part only.
  void addCorrections(const std::vector<ContourCorrection>& corrections) {
    for (std::size_t i = 0; i < corrections.size(); ++i) {
      const ContourCorrection correction = resolved(study_, corrections[i]);
      const tracking::CorrectionMet& met = fit_.corrections[i];
      const Text where = phrase("%1, %2", named(correction.surface), study_.slices[*correction.slice].name);
      found_.corrections.push_back({correction, where, met});
      if (met.met())
        continue;
      const Text most = inFixed(met.mostMm, 1);
      say(FitLight::amber,
          met.heldBack
              ? phrase("phase %1: the corrected contour of %2 is met to %3 mm only, since the tissue "
                       "would fold",
                       numberOf(correction.phase), where, most)
              : phrase("phase %1: the corrected contour of %2 is met to %3 mm only: the handles are "
                       "too far apart for its shape",
                       numberOf(correction.phase), where, most),
          correction.phase, std::nullopt);
    }
  }

  void finish() {
    std::stable_sort(found_.findings.begin(), found_.findings.end(),
                     [](const CineFinding& a, const CineFinding& b) { return a.light > b.light; });
    for (const CineFinding& finding : found_.findings)
      found_.motion.warnings.push_back(finding.text);
  }

private:
  /// What texts call a phase.
  std::size_t numberOf(std::size_t phase) const { return phase + study_.firstPhase; }

  void say(FitLight light, const Text& text, std::optional<std::size_t> phase,
           std::optional<std::size_t> plane) {
    found_.findings.push_back({light, text, phase, plane});
  }

  /// Blood as the images say, before volumes were kept: of the cavities, or the only surface.
  double bloodAt(std::size_t phase) const {
    const auto& surfaces = found_.motion.phases[phase].quality.surfaces;
    double blood = 0;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
      if (surfaces.size() == 1 || i != study_.labels.outer)
        blood += found_.isLabelled(phase) ? surfaces[i].fittedMl : surfaces[i].freeMl;
    return blood;
  }

  /// The mean weight of all contours of a phase.
  double evidence(std::size_t phase) const {
    double weight = 0, points = 0;
    for (const PlaneShare& share : fit_.planes[phase]) {
      weight += share.points * share.weight;
      points += share.points;
    }
    return points > 0 ? weight / points : 0;
  }

  tracking::PhaseQuality byImages(std::size_t phase) const {
    tracking::PhaseQuality quality;
    double apart = 0, weights = 0;
    for (const PlaneShare& share : fit_.planes[phase]) {
      apart += share.points * share.weight * share.apartMm;
      weights += share.points * share.weight;
    }
    quality.meanMm = weights > 0 ? apart / weights : 0;
    const Values volumes = rig_.volumesMl(rig_.vertices(fit_.motion.poses[phase]));
    for (Eigen::Index i = 0; i < volumes.size(); ++i) {
      tracking::SurfaceQuality& surface = quality.surfaces.emplace_back();
      surface.meanMm = quality.meanMm;
      surface.measuredMl = surface.fittedMl = volumes[i];
      surface.freeMl = fit_.motion.freeVolumesMl[phase][i];
    }
    quality.steps = fit_.motion.steps[phase];
    quality.volumesMet = fit_.motion.volumes.empty() || fit_.motion.volumes[phase].met;
    return quality;
  }

  void judgeByImages(std::size_t phase, tracking::FitVerdict& verdict) const {
    const auto judge = [&](FitLight light, const Text& reason) {
      verdict.light = std::max(verdict.light, light);
      verdict.reasons.push_back(reason);
    };
    const double seen = evidence(phase);
    if (seen <= 0)
      judge(FitLight::red, "no image shows a wall: its pose lies between those of the labels");
    else if (seen < kFewAmber)
      judge(FitLight::amber, "the images hardly show how the wall moved");
    const double apart = found_.motion.phases[phase].quality.meanMm;
    if (apart > kApartAmberMm)
      judge(apart > kApartRedMm ? FitLight::red : FitLight::amber,
            phrase("the tissue in the images is %1 mm from the surfaces on average", inFixed(apart, 1)));
    if (fit_.heldBack[phase])
      judge(FitLight::amber, "the tissue would have folded: it stays nearer to the pose between the labels");
    if (found_.motion.tissueMl.empty())
      return;
    double least = found_.motion.tissueMl[study_.phases.front()], most = least;
    for (const std::size_t label : study_.phases) {
      least = std::min(least, found_.motion.tissueMl[label]);
      most = std::max(most, found_.motion.tissueMl[label]);
    }
    const double wall = found_.motion.tissueMl[phase];
    if (wall < least * (1 - kWallChange) || wall > most * (1 + kWallChange))
      judge(FitLight::amber, phrase("the tissue has %1 ml, in the labelled phases %2 to %3 ml",
                                    inFixed(wall, 1), inFixed(least, 1), inFixed(most, 1)));
  }

  const LabelledStudy& study_;
  const tracking::MotionRig& rig_;
  const CineFit& fit_;
  CineMotion& found_;
};

std::vector<tracking::LabelledPhase> labelledPhases(const LabelledStudy& study) {
  std::vector<tracking::LabelledPhase> labelled;
  for (std::size_t i = 0; i < study.phases.size(); ++i) {
    labelled.push_back({study.phases[i], targetsOf(study.labels, i)});
    labelled.back().targets.rims.clear(); // Labels far apart are fitted without them.
  }
  return labelled;
}

} // namespace

void dropUncertain(bool estimate, PatientMotion& motion) {
  if (estimate)
    std::erase_if(motion.indices, [](const auto& item) { return anatomy::chamberKey(item.first) == "rv"; });
}

bool CineMotion::isLabelled(std::size_t phase) const {
  return std::binary_search(labelled.begin(), labelled.end(), phase);
}

/// What the images were followed for.
struct CineTracker::Parts {
  std::shared_ptr<const LabelledStudy> study;
  TrackOptions options;
  std::vector<Text> warnings;
  document::Rig handles;
  std::optional<tracking::MotionRig> rig;
  std::optional<tracking::TissueWitnesses> tissue;
  std::unique_ptr<const tracking::CineFitter> fitter; ///< Refers to `rig`.
};

CineTracker::CineTracker(std::shared_ptr<const LabelledStudy> study, const TrackOptions& options,
                         Progress& progress, Threads threads) {
  auto parts = std::make_unique<Parts>();
  parts->study = std::move(study);
  parts->options = options;
  const LabelledStudy& joined = *parts->study;
  parts->warnings = joined.warnings;
  progress.report(0, "surfaces at rest");
  Progress quiet;
  const auto rest = restSurfaces(joined.labels, options, parts->warnings, quiet, threads);
  parts->handles = rigFor(rest, joined.labels, options);
  runPart(progress, 0.02, 0.08,
          [&](Progress& part) { parts->rig.emplace(boundTo(parts->handles, rest, options, part, threads)); });
  tracking::CineFitOptions fitOptions;
  fitOptions.caps = joined.caps;
  fitOptions.keepVolumes = options.keepVolumes;
  fitOptions.fromOne = true;
  fitOptions.witnesses = options.witnesses;
  runPart(progress, 0.08, 0.95, [&](Progress& part) {
    parts->fitter = std::make_unique<const tracking::CineFitter>(
        *parts->rig, labelledPhases(joined), joined.planes, joined.times, fitOptions, part, threads);
  });
  runPart(progress, 0.95, 1, [&](Progress& part) {
    parts->tissue.emplace(*parts->rig, joined.labels.outer, options.witnesses, part, threads);
  });
  parts_ = std::move(parts);
}

CineTracker::~CineTracker() = default;

const LabelledStudy& CineTracker::study() const {
  return *parts_->study;
}

CineMotion CineTracker::motion(const std::vector<ContourCorrection>& corrections, Progress& progress,
                               Threads threads) const {
  const LabelledStudy& study = *parts_->study;
  CineMotion found;
  PatientMotion& motion = found.motion;
  motion.warnings = parts_->warnings;
  motion.outer = study.labels.outer;
  motion.sliceMm = study.labels.sliceMm();
  found.labelled = study.phases;
  found.estimate = study.phases.size() == 1;
  const std::vector<tracking::CorrectedContour> contours = correctedContours(study, corrections);
  CineFit fit;
  runPart(progress, 0, 0.7,
          [&](Progress& part) { fit = parts_->fitter->corrected(contours, part, threads); });
  found.endDiastole = fit.endDiastole;
  found.endSystole = fit.endSystole;
  found.fullest = fit.fullest;
  found.emptiest = fit.emptiest;
  CineReport report(study, *parts_->rig, fit, found);
  report.addPhases(*parts_->tissue, threads, progress);
  report.judgeCycle(); // Comes first among findings that are as bad.
  report.addCorrections(corrections);
  MotionSeries cycle;
  cycle.names = study.labels.names;
  cycle.outer = study.labels.outer;
  cycle.times = study.times;
  addVolumes(cycle, motion);
  report.addPlanes();
  report.judgePhases();
  report.finish();
  dropUncertain(found.estimate, motion);
  motion.sequence =
      sequenceOf(study.labels.names, study.times, *parts_->rig, fit.motion.poses, parts_->handles);
  progress.report(1);
  return found;
}

CineMotion trackCine(const LabelledStudy& study, const TrackOptions& options, Progress& progress,
                     Threads threads) {
  std::optional<CineTracker> tracker;
  runPart(progress, 0, 0.9, [&](Progress& part) {
    // Not its own: the study outlives the tracker.
    tracker.emplace(std::shared_ptr<const LabelledStudy>(std::shared_ptr<const void>(), &study), options,
                    part, threads);
  });
  CineMotion found;
  runPart(progress, 0.9, 1,
          [&](Progress& part) { found = tracker->motion(study.corrections, part, threads); });
  return found;
}

} // namespace viscera::live
