#include "viscera/live/patient_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "motion_assembly.h"
#include "tracked_volumes.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/document/rig.h"
#include "viscera/tracking/distance_fit.h"
#include "viscera/tracking/series_fit.h"

namespace viscera::live {
namespace {

using geometry::TriangleMesh;
using tracking::MotionFit;
using tracking::MotionRig;

constexpr double kDistanceSmoothing = 1e-4;
constexpr double kSecondsPerMinute = 60;
constexpr double kMuchWorse = 1.5;       ///< Than both neighbours: a phase's own fault.
constexpr int kMeasuredTriangles = 8000; ///< Of a measured surface that is only looked at.

MotionFit fitted(const MotionSeries& series, const MotionRig& rig, const TrackOptions& options,
                 Progress& progress, Threads threads) {
  if (!series.corresponding.empty()) {
    tracking::FitOptions fit;
    fit.smoothing = options.smoothing.value_or(fit.smoothing);
    fit.keepVolumes = options.keepVolumes;
    return tracking::fitSeries(rig, series.corresponding, series.times, fit, progress);
  }
  tracking::DistanceFitOptions fit;
  fit.fit.smoothing = options.smoothing.value_or(kDistanceSmoothing);
  fit.fit.keepVolumes = options.keepVolumes;
  fit.robustMm = options.robustMm;
  if (!series.rims.empty())
    for (std::size_t i = 0; i < series.names.size(); ++i)
      for (const tracking::Rim& rim : series.rims.front()[i]) {
        tracking::RimRows& own = fit.rims.emplace_back();
        own.surface = i;
        for (const std::int32_t vertex : rim)
          own.rows.push_back(rig.firstRow(i) + vertex);
      }
  const auto make = [&](std::size_t phase) { return targetsOf(series, phase); };
  return tracking::fitDistances(rig, make, series.times, fit, progress, threads);
}

/// Adds the warnings about phases and about the whole motion.
void warn(PatientMotion& motion) {
  for (std::size_t phase = 0; phase < motion.phases.size(); ++phase)
    for (const Text& reason : motion.phases[phase].verdict.reasons)
      motion.warnings.push_back(phrase("phase %1: %2", phase + 1, reason));
  // A phase much worse than both its neighbours is likely to be at fault itself.
  const std::size_t count = motion.phases.size();
  for (std::size_t phase = 0; phase < count; ++phase) {
    const double own = motion.phases[phase].quality.meanMm;
    const double around = std::max(motion.phases[(phase + count - 1) % count].quality.meanMm,
                                   motion.phases[(phase + 1) % count].quality.meanMm);
    if (motion.phases[phase].verdict.light == tracking::FitLight::good || own <= kMuchWorse * around)
      continue;
    motion.outliers.push_back(phase);
    motion.warnings.push_back(phrase(
        "phase %1 fits much worse than its neighbours (%2 against %3 mm): look at its data, or leave it "
        "out",
        phase + 1, inFixed(own, 1), inFixed(around, 1)));
  }
}

} // namespace

void addVolumes(const MotionSeries& series, PatientMotion& motion) {
  const double rate = kSecondsPerMinute / series.times.periodSeconds;
  for (std::size_t i = 0; i < series.names.size(); ++i) {
    if (series.names.size() > 1 && i == series.outer)
      continue;
    std::vector<double> volumes;
    for (const TrackedPhase& phase : motion.phases)
      volumes.push_back(phase.quality.surfaces[i].fittedMl);
    motion.indices[series.names[i]] = heart::cardiacIndices(volumes, rate);
  }
  if (series.names.size() < 2)
    return;
  for (const TrackedPhase& phase : motion.phases) {
    double tissue = 0;
    for (std::size_t i = 0; i < series.names.size(); ++i)
      tissue += (i == series.outer ? 1 : -1) * phase.quality.surfaces[i].fittedMl;
    motion.tissueMl.push_back(tissue);
  }
}

tracking::FitLight PatientMotion::worst() const {
  tracking::FitLight light = tracking::FitLight::good;
  for (const TrackedPhase& phase : phases)
    light = std::max(light, phase.verdict.light);
  return light;
}

PatientMotion trackMotion(const MotionSeries& series, const TrackOptions& options, Progress& progress,
                          Threads threads) {
  PatientMotion motion;
  motion.warnings = series.warnings;
  motion.outer = series.outer;
  motion.corresponding = !series.corresponding.empty();
  motion.sliceMm = series.sliceMm();
  progress.report(0, "surfaces at rest");
  Progress quiet;
  const std::vector<TriangleMesh> rest = restSurfaces(series, options, motion.warnings, quiet, threads);
  progress.throwIfCancelled();
  const document::Rig handles = rigFor(rest, series, options);
  std::optional<MotionRig> rig;
  runPart(progress, 0.02, 0.1,
          [&](Progress& part) { rig.emplace(boundTo(handles, rest, options, part, threads)); });
  MotionFit fit;
  runPart(progress, 0.1, 0.85, [&](Progress& part) { fit = fitted(series, *rig, options, part, threads); });
  progress.report(0.85, "looking for folds");
  std::optional<tracking::TissueWitnesses> tissue;
  runPart(progress, 0.85, 0.9,
          [&](Progress& part) { tissue.emplace(*rig, series.outer, options.witnesses, part, threads); });
  const Assessment assessment(series, *rig, fit);
  motion.phases.resize(series.phases());
  parallelRanges(static_cast<Eigen::Index>(series.phases()), 1, threads,
                 [&](Eigen::Index begin, Eigen::Index) {
                   progress.throwIfCancelled();
                   const auto phase = static_cast<std::size_t>(begin);
                   TrackedPhase& tracked = motion.phases[phase];
                   tracked.seconds = series.times.seconds[phase];
                   tracked.quality = assessment.of(phase);
                   tracked.quality.folded = tissue->foldedAt(fit.poses[phase], Threads{1});
                   tracked.verdict = tracking::verdictOf(tracked.quality, series.names, series.sliceMm());
                 });
  motion.sequence = sequenceOf(series.names, series.times, *rig, fit.poses, handles);
  addVolumes(series, motion);
  warn(motion);
  progress.report(1);
  return motion;
}

Values MeasuredPhase::apartMm(std::size_t surface, const Points& vertices) const {
  if (distances.empty())
    return (vertices - surfaces[surface]->points).rowwise().norm();
  Values apart(vertices.rows());
  for (Eigen::Index v = 0; v < vertices.rows(); ++v) {
    Vec3 ignored;
    apart[v] = std::abs(distances[surface]->at(vertices.row(v).transpose(), ignored));
  }
  return apart;
}

MeasuredPhase measuredPhase(const MotionSeries& series, std::size_t phase, Progress& progress,
                            Threads threads) {
  MeasuredPhase measured;
  std::vector<Text> unheard; // They were said when the motion was found.
  for (std::size_t i = 0; i < series.names.size(); ++i) {
    progress.throwIfCancelled();
    if (!series.corresponding.empty())
      measured.surfaces.push_back(std::make_shared<const TriangleMesh>(series.corresponding[i].at(phase)));
    else if (!series.meshes.empty())
      measured.surfaces.push_back(series.meshes[phase][i]);
    else
      measured.surfaces.push_back(std::make_shared<const TriangleMesh>(surfaceAround(
          series.masks[phase][i], series.names[i], kMeasuredTriangles, unheard, progress, threads)));
  }
  if (series.corresponding.empty())
    measured.distances = targetsOf(series, phase).distances;
  return measured;
}

} // namespace viscera::live
