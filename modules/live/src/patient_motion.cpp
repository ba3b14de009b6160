#include "viscera/live/patient_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tracked_volumes.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/document/rig.h"
#include "viscera/geometry/volume.h"
#include "viscera/medical_io/label_surfaces.h"
#include "viscera/tracking/distance_fit.h"
#include "viscera/tracking/mask_distance.h"
#include "viscera/tracking/series_fit.h"

namespace viscera::live {
namespace {

using geometry::TriangleMesh;
using tracking::MotionFit;
using tracking::MotionRig;

constexpr Eigen::Index kRigCorners = 8;
constexpr double kDistanceSmoothing = 1e-4;
constexpr double kSecondsPerMinute = 60;
constexpr double kMuchWorse = 1.5;       ///< Than both neighbours: a phase's own fault.
constexpr int kMeasuredTriangles = 8000; ///< Of a measured surface that is only looked at.
/// Colours of groups of handles, one a surface, over again.
const std::vector<Vec3>& groupColors() {
  static const std::vector<Vec3> colors = {
      {0.95, 0.6, 0.2}, {0.9, 0.3, 0.3}, {0.3, 0.5, 0.95}, {0.5, 0.8, 0.4}, {0.8, 0.5, 0.9}};
  return colors;
}

/// Of the surfaces that a motion is fitted to. `betweenSlices` leaves no terraces, and more smoothing would
/// take the surface further from the measured voxels.
constexpr double kLabelSmoothing = 0.5;

/// The surface around a mask, `triangles` at most.
TriangleMesh surfaceAround(const tracking::Mask& mask, const std::string& name, int triangles,
                           std::vector<Text>& warnings, Progress& progress, Threads threads) {
  const tracking::Mask fine = tracking::betweenSlices(mask);
  medical_io::LabelMap map;
  map.size = fine.size;
  map.indexToLps = fine.indexToLps;
  map.layers.emplace_back(fine.inside);
  medical_io::Segment segment;
  segment.label = 1;
  segment.name = name;
  segment.voxels = fine.count();
  const tracking::VoxelRange range = tracking::rangeOf(fine);
  segment.low = range.low;
  segment.high = range.high;
  map.segments.push_back(segment);
  medical_io::LabelSurfaceOptions options;
  options.triangles = triangles;
  options.smoothing = kLabelSmoothing;
  options.largestPieceOnly = true;
  auto surface = std::move(medical_io::labelSurfaces(map, options, progress, threads).front());
  for (const Text& warning : surface.warnings)
    warnings.push_back(phrase("%1: %2", name, warning));
  return std::move(surface.mesh);
}

/// Everything at rest, which is the first phase.
std::vector<TriangleMesh> restSurfaces(const MotionSeries& series, const TrackOptions& options,
                                       std::vector<Text>& warnings, Progress& progress, Threads threads) {
  std::vector<TriangleMesh> rest;
  for (std::size_t i = 0; i < series.names.size(); ++i) {
    if (!series.corresponding.empty())
      rest.push_back(series.corresponding[i].at(0));
    else if (!series.meshes.empty())
      rest.push_back({series.meshes[0][i]->points, series.meshes[0][i]->triangles, {}});
    else
      rest.push_back(
          surfaceAround(series.masks[0][i], series.names[i], options.triangles, warnings, progress, threads));
  }
  return rest;
}

/// Handles on and around the surfaces, those of the box first: a group for it and one for each surface.
document::Rig madeRig(const std::vector<TriangleMesh>& rest, const MotionSeries& series,
                      const tracking::RigOptions& options) {
  const tracking::RigHandles made = tracking::placeMotionHandles(rest, series.outer, options);
  document::Rig rig = document::rigAt(made.rest);
  std::vector<std::vector<int>> rows(series.names.size() + 1);
  for (std::size_t i = 0; i < rig.handles.size(); ++i) {
    rig.handles[i].label = "H-" + std::to_string(i + 1);
    rows[static_cast<std::size_t>(made.ofSurface[i] + 1)].push_back(static_cast<int>(i));
  }
  rig.addGroup("Box", {0.6, 0.6, 0.6}, rows[0]);
  for (std::size_t i = 0; i < series.names.size(); ++i)
    rig.addGroup(series.names[i], groupColors()[i % groupColors().size()], rows[i + 1]);
  return rig;
}

/// The handles of a file; one that several groups share comes once, in the first of them.
document::Rig givenRig(const medical_io::HandleFile& file) {
  document::Rig rig;
  for (const medical_io::HandleGroupRecord& group : file.groups) {
    std::vector<int> rows;
    for (const medical_io::HandleRecord& record : group.handles) {
      if (rig.indexOf(record.label) >= 0)
        continue;
      rows.push_back(static_cast<int>(rig.handles.size()));
      document::Handle& handle = rig.handles.emplace_back();
      handle.id.value = rows.back() + 1;
      handle.label = record.label;
      handle.rest = record.position;
    }
    rig.addGroup(group.name, group.color, rows);
  }
  return rig;
}

/// The targets of the surfaces in one phase.
tracking::PhaseTargets targetsOf(const MotionSeries& series, std::size_t phase) {
  tracking::PhaseTargets targets{{}, Values(static_cast<Eigen::Index>(series.names.size()))};
  for (std::size_t i = 0; i < series.names.size(); ++i) {
    targets.volumesMl[static_cast<Eigen::Index>(i)] = series.volumesMl[phase][i];
    if (series.masks.empty())
      targets.distances.push_back(std::make_shared<const tracking::MeshDistance>(series.meshes[phase][i]));
    else
      targets.distances.push_back(std::make_shared<const tracking::MaskDistance>(series.masks[phase][i]));
    if (!series.rims.empty())
      for (const tracking::Rim& rim : series.rims[phase][i])
        targets.rims.push_back(tracking::pointsOf(rim, series.meshes[phase][i]->points));
  }
  return targets;
}

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

/// Measures how well a fit fits.
class Assessment {
public:
  Assessment(const MotionSeries& series, const MotionRig& rig, const MotionFit& fit)
      : series_(series), rig_(rig), fit_(fit) {}

  tracking::PhaseQuality of(std::size_t phase) const {
    tracking::PhaseQuality quality;
    const Points vertices = rig_.vertices(fit_.poses[phase]);
    const Values volumes = rig_.volumesMl(vertices);
    const tracking::PhaseTargets targets =
        series_.corresponding.empty() ? targetsOf(series_, phase) : tracking::PhaseTargets{{}, {}};
    Values all(vertices.rows()), weights(vertices.rows());
    for (std::size_t i = 0; i < series_.names.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      const Points own = vertices.middleRows(rig_.firstRow(i), rig_.rows(i));
      tracking::SurfaceQuality surface;
      surface.measuredMl = series_.volumesMl[phase][i];
      surface.freeMl = fit_.freeVolumesMl[phase][column];
      surface.fittedMl = volumes[column];
      const Values residuals = residualsOf(own, phase, i, targets, surface);
      const Values areas = tracking::vertexAreas(own, rig_.surfaces()[i].triangles);
      const tracking::Spread spread = tracking::spreadOf(residuals, areas);
      surface.meanMm = spread.mean;
      surface.p95Mm = spread.p95;
      surface.maxMm = spread.max;
      all.segment(rig_.firstRow(i), rig_.rows(i)) = residuals;
      weights.segment(rig_.firstRow(i), rig_.rows(i)) = areas / areas.sum();
      if (surface.dice)
        quality.dice = std::min(quality.dice.value_or(1), *surface.dice);
      quality.surfaces.push_back(surface);
    }
    const tracking::Spread spread = tracking::spreadOf(all, weights);
    quality.meanMm = spread.mean;
    quality.p95Mm = spread.p95;
    quality.maxMm = spread.max;
    quality.steps = fit_.steps[phase];
    quality.volumesMet = fit_.volumes.empty() || fit_.volumes[phase].met;
    return quality;
  }

private:
  /// Distances of the vertices of one surface, mm; fills in flips and Dice.
  Values residualsOf(const Points& own, std::size_t phase, std::size_t i,
                     const tracking::PhaseTargets& targets, tracking::SurfaceQuality& surface) const {
    const Triangles& triangles = rig_.surfaces()[i].triangles;
    if (!series_.corresponding.empty()) {
      const Points& measured = series_.corresponding[i].phases[phase];
      surface.flipped = tracking::opposedTriangles(triangles, own, measured);
      return (own - measured).rowwise().norm();
    }
    Values residuals(own.rows());
    for (Eigen::Index v = 0; v < own.rows(); ++v) {
      Vec3 ignored;
      residuals[v] = std::abs(targets.distances[i]->at(own.row(v).transpose(), ignored));
    }
    surface.flipped = tracking::opposedTriangles(triangles, own, *targets.distances[i]);
    if (!series_.masks.empty()) {
      const tracking::Mask& mask = series_.masks[phase][i];
      surface.dice = tracking::diceOf(tracking::voxelised({own, triangles, {}}, mask), mask);
    }
    return residuals;
  }

  const MotionSeries& series_;
  const MotionRig& rig_;
  const MotionFit& fit_;
};

SequenceFile sequenceOf(const MotionSeries& series, const MotionRig& rig, const MotionFit& fit,
                        const document::Rig& handles) {
  SequenceFile file;
  file.track.name = "Measured";
  file.track.restHandles = rig.rest();
  for (const document::Group& group : handles.groups) {
    sequences::HandleGroup& rows = file.track.groups.emplace_back();
    rows.name = group.name;
    rows.color = group.color;
    for (const document::HandleId id : group.handles)
      rows.handles.push_back(handles.indexOf(id));
  }
  file.track.periodSeconds = series.times.periodSeconds;
  file.track.loop = series.times.loop;
  file.track.interpolation = sequences::Interpolation::curve;
  for (std::size_t phase = 0; phase < fit.poses.size(); ++phase)
    file.track.keys.push_back({series.times.seconds[phase], fit.poses[phase], sequences::Easing::smooth});
  for (const document::Handle& handle : handles.handles)
    file.labels.push_back(handle.label);
  document::SystemChoice system;
  system.id = "s-celestial";
  system.parameters.set("locality", rig.locality());
  system.parameters.set("softness", rig.softnessMm());
  file.system = system;
  for (std::size_t i = 0; i < series.names.size(); ++i)
    file.organs.push_back({series.names[i], std::make_shared<const TriangleMesh>(rig.surfaces()[i])});
  return file;
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
  const document::Rig handles =
      options.handles ? givenRig(*options.handles) : madeRig(rest, series, options.rig);
  const Eigen::Index corners = options.handles ? 0 : kRigCorners;
  std::optional<MotionRig> rig;
  runPart(progress, 0.02, 0.1, [&](Progress& part) {
    const Points places = handles.restPositions();
    rig.emplace(rest, places, options.rig.locality,
                tracking::softnessFor(places, corners, options.rig.softness), part, threads);
  });
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
  motion.sequence = sequenceOf(series, *rig, fit, handles);
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
