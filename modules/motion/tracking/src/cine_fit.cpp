#include "viscera/tracking/cine_fit.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

#include "cine_contours.h"
#include "cine_pose.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "wall_stiffness.h"

namespace viscera::tracking {
namespace {

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

/// The place of a phase that is not labelled.
struct FreePhase {
  const CineSegment* segment = nullptr;
  std::size_t at = 0;
};

std::vector<FreePhase> freePhases(const std::vector<CineSegment>& segments) {
  std::vector<FreePhase> phases;
  for (const CineSegment& segment : segments)
    for (std::size_t at = 0; at < segment.phases.size(); ++at)
      phases.push_back({&segment, at});
  return phases;
}

/// The phases with most and least blood, in the cavities together or in the only surface: of the labelled
/// ones, and of all by the images.
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

/// The volumes of the labels, between which those of all phases lie: of cavities, or of the only surface.
class LabelledVolumes {
public:
  LabelledVolumes(const MotionRig& rig, const std::vector<LabelledPose>& poses, std::size_t outer)
      : outer_(rig.surfaces().size() > 1 ? static_cast<Eigen::Index>(outer) : -1) {
    for (const LabelledPose& pose : poses) {
      const Values volumes = rig.volumesMl(pose.vertices);
      least_ = least_.size() > 0 ? Values(least_.cwiseMin(volumes)) : volumes;
      most_ = most_.size() > 0 ? Values(most_.cwiseMax(volumes)) : volumes;
    }
  }
  Values within(const Values& volumes) const {
    Values result = volumes.cwiseMax(least_).cwiseMin(most_);
    if (outer_ >= 0)
      result[outer_] = volumes[outer_];
    return result;
  }

private:
  Eigen::Index outer_; ///< Whose volume is free; -1 for none.
  Values least_, most_;
};

/// The part of the fit that belongs to one phase between labelled ones.
class FreePhaseFit {
public:
  FreePhaseFit(const MotionRig& rig, const WallStiffness& stiffness, const LabelledVolumes& labels,
               bool keepVolumes)
      : rig_(rig), stiffness_(stiffness), labels_(labels), keepVolumes_(keepVolumes) {}

  void run(const CinePose& images, std::size_t phase, CineFit& fit,
           std::vector<std::uint8_t>& heldBack) const {
    fit.parts[phase] = images.partOfWay();
    bool held = false;
    Points pose = images.fitted(images.between(fit.parts[phase]), stiffness_, held);
    heldBack[phase] = held;
    const Values volumes = rig_.volumesMl(rig_.vertices(pose)), wanted = labels_.within(volumes);
    if (keepVolumes_ && wanted != volumes)
      fit.motion.volumes[phase] = images.giveVolumes(wanted, stiffness_, pose);
    fit.planes[phase] = images.shares(pose);
    fit.motion.freeVolumesMl[phase] = volumes;
    fit.motion.poses[phase] = std::move(pose);
  }

private:
  const MotionRig& rig_;
  const WallStiffness& stiffness_;
  const LabelledVolumes& labels_;
  bool keepVolumes_;
};

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

} // namespace

CineFit fitCine(const MotionRig& rig, std::vector<LabelledPhase> labelled,
                const std::vector<CinePlane>& planes, const PhaseTimes& times, const CineFitOptions& options,
                Progress& progress, Threads threads) {
  std::stable_sort(labelled.begin(), labelled.end(),
                   [](const LabelledPhase& a, const LabelledPhase& b) { return a.phase < b.phase; });
  requireLabels(labelled, times, options.fromOne);
  requireValid(planes);
  const std::size_t outer = outerOf(rig.surfaces());
  CineFit fit = emptyFit(times.count(), planes.size(), static_cast<Eigen::Index>(rig.surfaces().size()),
                         options.keepVolumes);
  std::vector<LabelledPose> poses;
  runPart(progress, 0, 0.05, [&](Progress& part) {
    poses = labelledPoses(rig, labelled, times, options, fit.motion, part, threads);
  });
  for (const LabelledPose& pose : poses)
    fit.motion.poses[pose.phase] = pose.pose;
  std::unique_ptr<const WallStiffness> stiffness;
  runPart(progress, 0.05, 0.1, [&](Progress& part) {
    stiffness = std::make_unique<const WallStiffness>(rig, outer, part, threads);
  });
  std::vector<CineSegment> segments;
  runPart(progress, 0.1, 0.6, [&](Progress& part) {
    segments = cineSegments(rig, poses, planes, times, options.caps, part, threads);
  });
  const std::vector<bool> isLong = longAxisPlanes(planes);
  const std::vector<FreePhase> free = freePhases(segments);
  const CineStiffness hold =
      labelled.size() > 1 ? CineStiffness::betweenLabels() : CineStiffness::fromOneLabel();
  const LabelledVolumes labels(rig, poses, outer);
  const FreePhaseFit phaseFit(rig, *stiffness, labels, options.keepVolumes && labelled.size() > 1);
  std::vector<std::uint8_t> heldBack(times.count(), 0);
  std::atomic<int> done{0};
  parallelRanges(static_cast<Eigen::Index>(free.size()), 1, threads, [&](Eigen::Index begin, Eigen::Index) {
    progress.throwIfCancelled();
    const auto& [segment, at] = free[static_cast<std::size_t>(begin)];
    const CinePose images(rig, *segment, at, poses[segment->from], poses[segment->to], isLong, planes,
                          options.caps, hold);
    phaseFit.run(images, segment->phases[at], fit, heldBack);
    progress.report(0.6 + 0.4 * ++done / static_cast<double>(free.size()), "fitting the images");
  });
  keepEnds(poses, fit.motion);
  fit.heldBack.assign(heldBack.begin(), heldBack.end());
  findEnds(rig, poses, outer, fit);
  progress.report(1);
  return fit;
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
