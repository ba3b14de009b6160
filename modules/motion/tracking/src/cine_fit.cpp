#include "viscera/tracking/cine_fit.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

#include <Eigen/Cholesky>

#include "cine_fit_parts.h"
#include "fold_relief.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::tracking {
namespace {

/// What a labelled pose costs beside the mean square of its surfaces' change, while folds are taken out.
constexpr double kLabelBending = 6, kLabelHandles = 1e-4, kLabelFloor = 1e-7;

void requireLabels(const std::vector<LabelledPhase>& labelled, const PhaseTimes& times, bool fromOne) {
  if (labelled.size() < (fromOne ? 1 : 2))
    throw DataError("One labelled phase is too few for the motion between two", "phases",
                    "label the end of diastole and the end of systole");
  if (labelled.size() == 1 && !times.loop)
    throw DataError("From one labelled phase only a whole cycle can be followed", "phases",
                    "label the last phase as well");
  for (std::size_t i = 0; i < labelled.size(); ++i) {
    if (labelled[i].phase >= times.count())
      throw DataError(phrase("There is no phase %1", labelled[i].phase), "phases",
                      phrase("phases are 0 to %1", times.count() - 1));
    if (i > 0 && labelled[i].phase == labelled[i - 1].phase)
      throw DataError(phrase("Phase %1 has labels twice", labelled[i].phase), "phases",
                      "name each phase once");
  }
}

/// The pose of each labelled phase by itself, its volumes exact; as parts of `fit`.
std::vector<LabelledPose> labelledPoses(const MotionRig& rig, const std::vector<LabelledPhase>& labelled,
                                        const PhaseTimes& times, const CineFitOptions& options,
                                        MotionFit& fit, Progress& progress, Threads threads) {
  std::vector<LabelledPose> poses;
  DistanceFitOptions single;
  single.fit.keepVolumes = options.keepVolumes;
  single.foreignRig = true; // Labels are far apart: what bends little comes first.
  for (const LabelledPhase& label : labelled) {
    Progress quiet;
    progress.report(static_cast<double>(poses.size()) / static_cast<double>(labelled.size()),
                    phrase("fitting phase %1", label.phase + 1));
    progress.throwIfCancelled();
    MotionFit one = fitDistances(
        rig, [&](std::size_t) { return label.targets; }, PhaseTimes::even(1, times.periodSeconds, false),
        single, quiet, threads);
    fit.steps[label.phase] = one.steps[0];
    fit.freeVolumesMl[label.phase] = one.freeVolumesMl[0];
    if (options.keepVolumes)
      fit.volumes[label.phase] = one.volumes[0];
    poses.push_back({label.phase, one.poses[0], rig.vertices(one.poses[0])});
  }
  return poses;
}

/// Takes folds out of the labelled poses, whose volumes stay exact.
void unfoldLabels(const MotionRig& rig, const WallStiffness& stiffness, bool keepVolumes,
                  std::vector<LabelledPose>& poses) {
  const Eigen::MatrixXd hold = stiffness.strain() + kLabelBending * stiffness.bending() +
                               kLabelHandles * rig.bending() +
                               kLabelFloor * Eigen::MatrixXd::Identity(rig.handles(), rig.handles());
  const Eigen::MatrixXd surface = rig.weights().transpose() * rig.weights() / double(rig.weights().rows());
  const Eigen::LLT<Eigen::MatrixXd> matrix(hold + surface);
  for (LabelledPose& label : poses)
    if (relieveFolds(
            rig, stiffness, [&](const Points& gradient) { return Points(matrix.solve(gradient)); },
            keepVolumes, label.pose))
      label.vertices = rig.vertices(label.pose);
}

std::vector<FreePhase> freePhases(const std::vector<CineSegment>& segments) {
  std::vector<FreePhase> phases;
  for (const CineSegment& segment : segments)
    for (std::size_t at = 0; at < segment.phases.size(); ++at)
      phases.push_back({&segment, at});
  return phases;
}

/// Sizes everything for so many phases; volumes that nothing asks for count as met.
CineFit emptyFit(std::size_t phases, std::size_t planes, Eigen::Index surfaces, bool keepVolumes) {
  CineFit fit;
  fit.motion.poses.resize(phases);
  fit.motion.freeVolumesMl.resize(phases);
  fit.motion.steps.resize(phases, 1);
  if (keepVolumes)
    fit.motion.volumes.resize(phases, {Values::Zero(surfaces), 0, true});
  fit.planes.resize(phases, std::vector<PlaneShare>(planes));
  fit.parts.resize(phases, 0);
  return fit;
}

/// Phases before the first and after the last label of a series that is no loop.
void keepEnds(const std::vector<LabelledPose>& poses, MotionFit& fit) {
  for (std::size_t phase = 0; phase < fit.poses.size(); ++phase) {
    if (fit.poses[phase].rows() > 0)
      continue;
    const LabelledPose& nearest = phase < poses.front().phase ? poses.front() : poses.back();
    fit.poses[phase] = nearest.pose;
    fit.freeVolumesMl[phase] = fit.freeVolumesMl[nearest.phase];
  }
}

/// Fits one phase between labelled ones.
void fitFree(const CineFitter::Parts& parts, const FreePhase& place, CineFit& fit,
             std::vector<std::uint8_t>& heldBack) {
  const CinePose images = parts.imagesOf(place);
  const std::size_t phase = place.segment->phases[place.at];
  fit.parts[phase] = images.partOfWay();
  bool held = false;
  Points pose = images.fitted(images.between(fit.parts[phase]), *parts.stiffness, held);
  heldBack[phase] = held;
  const Values volumes = parts.rig.volumesMl(parts.rig.vertices(pose)), wanted = parts.labels.within(volumes);
  if (parts.keepsVolumes() && wanted != volumes)
    fit.motion.volumes[phase] = images.giveVolumes(wanted, *parts.stiffness, pose);
  if (parts.options.witnesses > 0 && !images.unfold(*parts.stiffness, parts.options.keepVolumes, pose))
    heldBack[phase] = true;
  fit.planes[phase] = images.shares(pose);
  fit.motion.freeVolumesMl[phase] = volumes;
  fit.motion.poses[phase] = std::move(pose);
}

std::vector<CinePlane> withoutImages(const std::vector<CinePlane>& planes) {
  std::vector<CinePlane> places;
  for (const CinePlane& plane : planes)
    places.push_back({plane.name, plane.origin, plane.alongRow, plane.alongColumn, plane.spacing, {}, {}});
  return places;
}

} // namespace

void findEnds(const MotionRig& rig, const std::vector<LabelledPose>& poses, std::size_t outer, CineFit& fit) {
  std::vector<double> bloodMl;
  const auto bloodOf = [&](const Values& volumes) {
    return volumes.size() > 1 ? volumes.sum() - volumes[static_cast<Eigen::Index>(outer)] : volumes[0];
  };
  for (const Values& volumes : fit.motion.freeVolumesMl)
    bloodMl.push_back(bloodOf(volumes));
  for (const LabelledPose& pose : poses)
    bloodMl[pose.phase] = bloodOf(rig.volumesMl(pose.vertices));
  const auto blood = [&](std::size_t phase) { return bloodMl[phase]; };
  fit.endDiastole = fit.endSystole = poses.front().phase;
  for (const LabelledPose& pose : poses) {
    fit.endDiastole = blood(pose.phase) > blood(fit.endDiastole) ? pose.phase : fit.endDiastole;
    fit.endSystole = blood(pose.phase) < blood(fit.endSystole) ? pose.phase : fit.endSystole;
  }
  fit.fullest = fit.endDiastole;
  fit.emptiest = fit.endSystole;
  for (std::size_t phase = 0; phase < fit.motion.poses.size(); ++phase) {
    fit.fullest = blood(phase) > blood(fit.fullest) ? phase : fit.fullest;
    fit.emptiest = blood(phase) < blood(fit.emptiest) ? phase : fit.emptiest;
  }
}

LabelledVolumes::LabelledVolumes(const MotionRig& rig, const std::vector<LabelledPose>& poses,
                                 std::size_t outer)
    : outer_(rig.surfaces().size() > 1 ? static_cast<Eigen::Index>(outer) : -1) {
  for (const LabelledPose& pose : poses) {
    const Values volumes = rig.volumesMl(pose.vertices);
    least_ = least_.size() > 0 ? Values(least_.cwiseMin(volumes)) : volumes;
    most_ = most_.size() > 0 ? Values(most_.cwiseMax(volumes)) : volumes;
  }
}

Values LabelledVolumes::within(const Values& volumes) const {
  Values result = volumes.cwiseMax(least_).cwiseMin(most_);
  if (outer_ >= 0)
    result[outer_] = volumes[outer_];
  return result;
}

CinePose CineFitter::Parts::imagesOf(const FreePhase& phase) const {
  return {rig,    *phase.segment, phase.at, poses[phase.segment->from], poses[phase.segment->to], isLong,
          planes, options.caps,   hold};
}

CineFitter::CineFitter(const MotionRig& rig, std::vector<LabelledPhase> labelled,
                       const std::vector<CinePlane>& planes, const PhaseTimes& times,
                       const CineFitOptions& options, Progress& progress, Threads threads)
    : parts_(new Parts{.rig = rig,
                       .times = times,
                       .options = options,
                       .outer = outerOf(rig.surfaces()),
                       .planes = withoutImages(planes),
                       .isLong = longAxisPlanes(planes)}) {
  std::stable_sort(labelled.begin(), labelled.end(),
                   [](const LabelledPhase& a, const LabelledPhase& b) { return a.phase < b.phase; });
  requireLabels(labelled, times, options.fromOne);
  requireValid(planes);
  Parts& p = *parts_;
  CineFit& fit = p.fit = emptyFit(times.count(), planes.size(),
                                  static_cast<Eigen::Index>(rig.surfaces().size()), options.keepVolumes);
  runPart(progress, 0, 0.05, [&](Progress& part) {
    p.poses = labelledPoses(rig, labelled, times, options, fit.motion, part, threads);
  });
  runPart(progress, 0.05, 0.1, [&](Progress& part) {
    p.stiffness = std::make_unique<const WallStiffness>(rig, p.outer, options.witnesses, part, threads);
  });
  unfoldLabels(rig, *p.stiffness, options.keepVolumes, p.poses);
  for (const LabelledPose& pose : p.poses)
    fit.motion.poses[pose.phase] = pose.pose;
  runPart(progress, 0.1, 0.6, [&](Progress& part) {
    p.segments = cineSegments(rig, p.poses, planes, times, options.caps, part, threads);
  });
  p.free = freePhases(p.segments);
  if (labelled.size() == 1)
    p.hold = CineStiffness::fromOneLabel();
  p.labels = LabelledVolumes(rig, p.poses, p.outer);
  std::vector<std::uint8_t> heldBack(times.count(), 0);
  std::atomic<int> done{0};
  parallelRanges(static_cast<Eigen::Index>(p.free.size()), 1, threads, [&](Eigen::Index begin, Eigen::Index) {
    progress.throwIfCancelled();
    fitFree(p, p.free[static_cast<std::size_t>(begin)], fit, heldBack);
    progress.report(0.6 + 0.4 * ++done / static_cast<double>(p.free.size()), "fitting the images");
  });
  keepEnds(p.poses, fit.motion);
  fit.heldBack.assign(heldBack.begin(), heldBack.end());
  findEnds(rig, p.poses, p.outer, fit);
  progress.report(1);
}

CineFitter::~CineFitter() = default;

const CineFit& CineFitter::fit() const {
  return parts_->fit;
}

CineFit fitCine(const MotionRig& rig, std::vector<LabelledPhase> labelled,
                const std::vector<CinePlane>& planes, const PhaseTimes& times, const CineFitOptions& options,
                Progress& progress, Threads threads) {
  return CineFitter(rig, std::move(labelled), planes, times, options, progress, threads).fit();
}

std::vector<Eigen::Index> capTriangles(const TidySeries& tidy) {
  std::vector<bool> given(static_cast<std::size_t>(tidy.series.phases.front().rows()), false);
  for (const std::int32_t row : tidy.series.rowOfGiven)
    if (row >= 0)
      given[static_cast<std::size_t>(row)] = true;
  std::vector<Eigen::Index> caps;
  for (Eigen::Index t = 0; t < tidy.series.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      if (!given[static_cast<std::size_t>(tidy.series.triangles(t, k))]) {
        caps.push_back(t);
        break;
      }
  return caps;
}

} // namespace viscera::tracking
