#include "viscera/live/retarget.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "landmark_finder.h"
#include "sample_heart.h"
#include "sequence_binding.h"
#include "viscera/anatomy/organ_facts.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/document/organ_commands.h"
#include "viscera/document/rig_commands.h"
#include "viscera/document/system_commands.h"
#include "viscera/geometry/self_intersections.h"
#include "viscera/heart/heart_fit.h"
#include "viscera/heart/outer_heartbeat.h"
#include "viscera/heart/scaled_sequence.h"
#include "viscera/live/unsuited_motion.h"
#include "viscera/sequences/peristalsis.h"
#include "viscera/sequences/stomach_fit.h"

namespace viscera::live {
namespace {

/// Waves are made shallower by such steps, down to the least depth, until the surface nowhere crosses itself.
constexpr double kDepthStep = 0.1;
constexpr double kLeastWaveDepth = 0.4;
/// Instants of a cycle at which that is looked at.
constexpr int kLooks = 12;
/// Organs that differ more from the sample organ's size are asked about.
constexpr double kOddSize = 2;

/// Makes the sequences in the standard size, on a copy of the organ's surface in that size.
class Retargeter {
public:
  Retargeter(const document::Organ& organ, const LandmarkFinder& finder, Threads threads)
      : organ_(organ), finder_(finder), threads_(threads) {}

  RetargetedSequence heartbeat(Landmarks landmarks) {
    const Vec3 apex = landmarks.find("apex")->position;
    const Vec3 base = landmarks.find("base")->position;
    scale_ = (apex - base).norm() / heart::kStandardHeartLength;
    const heart::HeartLandmarks marks{apex / scale_, base / scale_,
                                      landmarks.find("right")->position / scale_};
    heart::HeartRigOptions options;
    options.cavities = false;
    options.atrialHandles = 0;
    options.firstWall = true;
    heart::HeartRig rig = makeHeartRig(fitHeart(marks, surface(), organ_.mesh->points / scale_), options);
    const Points rest = rig.restHandles();
    const document::SystemChoice standard = softCoordinates(kSoftnessMm);
    return finished(std::make_shared<heart::OuterHeartbeat>(heart::HeartMotion(std::move(rig)),
                                                            compensationFor(rest, standard, threads_),
                                                            volumeAlong(movedVolume(rest, standard))),
                    std::move(landmarks));
  }

  RetargetedSequence peristalsis(Landmarks landmarks, Progress& progress) {
    StomachLine line = stomachLine(landmarks, organ_.name);
    scale_ = line.pylorus / sequences::kStandardStomachLength;
    for (Vec3& point : line.points)
      point /= scale_;
    const sequences::GastricCourse course{line.midBody / scale_, line.pylorus / scale_};
    sequences::StomachRig rig = makeStomachRig(
        fitStomach(sequences::Centerline(line.points), course, surface(), organ_.mesh->points / scale_));
    const Points rest = rig.restHandles();
    const document::SystemChoice standard = softCoordinates(kSoftnessMm);
    const auto moved = movedVolume(rest, standard);
    const auto compensation = compensationFor(rest, standard, threads_);
    const int atRest = geometry::countSelfIntersections(moved->surfaceAt(rest), progress, threads_);
    std::shared_ptr<const sequences::Peristalsis> waves;
    bool crosses = true;
    for (double depth = 1; crosses && depth > kLeastWaveDepth - kDepthStep / 2; depth -= kDepthStep) {
      rig.anatomy.course.depth = depth;
      waves = std::make_shared<sequences::Peristalsis>(rig, compensation, volumeAlong(moved));
      crosses = crossings(*waves, *moved, atRest, progress) > atRest;
    }
    RetargetedSequence result = finished(waves, std::move(landmarks));
    const int percent = static_cast<int>(std::lround(100 * waves->waves().course().depth));
    if (crosses || percent < 100)
      result.warnings.push_back(phrase("the waves are %1 % as deep as in an adult: %2", percent,
                                       crosses
                                           ? "even so, folds of the surface meet when they pass"
                                           : "deeper ones would push folds of the surface into one another"));
    return result;
  }

  RetargetedSequence breathing(Landmarks landmarks) {
    return finished(liverBreathing(*organ_.mesh), std::move(landmarks));
  }

private:
  sequences::AnatomySurface surface() const {
    return [scale = scale_, finder = finder_](const Vec3& p) { return finder.depth(scale * p) / scale; };
  }

  std::shared_ptr<const MovedVolume> movedVolume(const Points& rest,
                                                 const document::SystemChoice& system) const {
    auto mesh = std::make_shared<geometry::TriangleMesh>();
    mesh->points = organ_.mesh->points / scale_;
    mesh->triangles = organ_.mesh->triangles;
    return std::make_shared<const MovedVolume>(std::move(mesh), rest, system, threads_);
  }

  /// The pairs of triangles that cross, at most over a cycle at the standard and at the highest rate; no more
  /// is looked for once there are more than `allowed`.
  int crossings(const sequences::Sequence& sequence, const MovedVolume& surface, int allowed,
                Progress& progress) const {
    int most = 0;
    Points pose;
    for (const double rate : {sequence.standardRatePerMinute(), sequence.highestRatePerMinute()})
      for (int look = 0; look < kLooks && most <= allowed; ++look) {
        progress.throwIfCancelled();
        sequence.poseAt(look * 60 / rate / kLooks, rate, pose);
        most = std::max(most, geometry::countSelfIntersections(surface.surfaceAt(pose), progress, threads_));
      }
    return most;
  }

  RetargetedSequence finished(std::shared_ptr<const sequences::Sequence> standard,
                              Landmarks landmarks) const {
    RetargetedSequence result;
    result.sequence = scale_ == 1 ? std::move(standard)
                                  : std::make_shared<heart::ScaledSequence>(std::move(standard), scale_);
    result.rig = document::rigOf(*result.sequence);
    result.system = softCoordinates(kSoftnessMm * scale_);
    result.landmarks = std::move(landmarks);
    result.scale = scale_;
    result.restVolumeMl = organ_.restVolumeMm3 / kMm3PerMl;
    if (scale_ > kOddSize || scale_ < 1 / kOddSize) {
      result.warnings.push_back(
          phrase("the organ is %1 times as long as that of an adult; check its unit", inDigits(scale_, 3)));
    }
    return result;
  }

  const document::Organ& organ_;
  const LandmarkFinder& finder_;
  Threads threads_;
  double scale_ = 1;
};

} // namespace

Landmarks completeLandmarks(const std::string& sequence, const document::Organ& organ, const Landmarks& given,
                            Progress& progress) {
  landmarkRoles(sequence); // Throws for an unknown one before any work.
  progress.throwIfCancelled();
  Landmarks landmarks = LandmarkFinder(sequence, organ).complete(given);
  progress.report(1, "finding landmarks");
  return landmarks;
}

RetargetedSequence retargetSequence(const std::string& id, const document::Organ& organ,
                                    const Landmarks& given, Progress& progress, Threads threads) {
  landmarkRoles(id);
  progress.report(0, "finding landmarks");
  const LandmarkFinder finder(id, organ);
  Landmarks landmarks = finder.complete(given);
  progress.throwIfCancelled();
  progress.report(0.4, "placing handles");
  Retargeter retargeter(organ, finder, threads);
  RetargetedSequence result = id == "heartbeat"     ? retargeter.heartbeat(std::move(landmarks))
                              : id == "peristalsis" ? retargeter.peristalsis(std::move(landmarks), progress)
                                                    : retargeter.breathing(std::move(landmarks));
  progress.throwIfCancelled();
  if (Text unsuited = unsuitedTo(id, organ.name); !unsuited.empty())
    result.warnings.insert(result.warnings.begin(), std::move(unsuited)); // Before all about its numbers.
  progress.report(1);
  return result;
}

std::vector<document::OrganId> keptInPlace(const RetargetedSequence& retargeted,
                                           const document::OrganList& organs) {
  std::vector<document::OrganId> kept;
  if (retargeted.sequence->id() == "breathing")
    for (const auto& organ : organs)
      if (anatomy::isStillNamed(organ->name) && organ->mobility != document::Mobility::fixed)
        kept.push_back(organ->id);
  return kept;
}

document::Command useRetargeted(const RetargetedSequence& retargeted, const document::OrganList& organs) {
  const Text name = phrase("Take handles of %1", retargeted.sequence->name());
  std::vector<document::Command> commands;
  if (auto kept = keptInPlace(retargeted, organs); !kept.empty())
    commands.push_back(document::setMobility(std::move(kept), document::Mobility::fixed));
  commands.push_back(document::replaceRig(retargeted.rig, name));
  commands.push_back(document::setSystem(retargeted.system));
  return document::combined(name, std::move(commands));
}

} // namespace viscera::live
