#include "viscera/motion/heartbeat_setup.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "number_cache.h"
#include "sequence_binding.h"
#include "viscera/core/content_hash.h"
#include "viscera/document/sequence_rig.h"
#include "viscera/sequences/heart_rig.h"
#include "viscera/sequences/heartbeat.h"

namespace viscera::motion {
namespace {

using sample_organs::SampleLibrary;
using sequences::CardiacCycle;
using sequences::CavityVolumes;
using sequences::HeartbeatCalibration;
using sequences::HeartMotion;
using sequences::PoseCompensation;

/// A little more than one handle spacing: the walls stay smooth between handles (design notes, "Handles that
/// move organs").
constexpr double kSoftnessMm = 25;
/// Where the time goes when nothing is cached.
constexpr double kOrganPart = 0.8;

sequences::AnatomySurface leastOf(std::vector<sequences::AnatomySurface> surfaces) {
  return [surfaces = std::move(surfaces)](const Vec3& point) {
    double least = surfaces.front()(point);
    for (std::size_t i = 1; i < surfaces.size(); ++i)
      least = std::min(least, surfaces[i](point));
    return least;
  };
}

sequences::HeartAnatomy anatomyOf(const SampleLibrary& library) {
  const auto node = [&](const char* name) { return sample_organs::implicitSurface(library, "heart", name); };
  sequences::SampleHeartSurfaces surfaces;
  surfaces.ventricles = node("ventricles");
  surfaces.rightCavity = node("surf rv");
  surfaces.rightAtrium = node("RA");
  surfaces.leftAtrium = node("LA");
  surfaces.greatVessels = leastOf({node("aorta"), node("pulmonary"), node("cavae"), node("veins_pulm")});
  return sequences::sampleHeartAnatomy(surfaces);
}

/// Handles, coordinates and cavities of one heart, and how its corrections are found.
class HeartbeatMaker {
public:
  HeartbeatMaker(const SampleLibrary& library, const sample_organs::SampleOrgan& heart,
                 const document::SystemChoice& system, Threads threads)
      : heart_(heart), system_(system), threads_(threads), numbers_(library.cache),
        motion_(makeHeartRig(anatomyOf(library))), rest_(motion_.rig().restHandles()),
        compensation_(compensationFor(rest_, system, threads)) {}

  std::shared_ptr<const sequences::Sequence> make(Progress& progress) const {
    return std::make_shared<sequences::CalibratedHeartbeat>(motion_, cycle_, compensation_,
                                                            calibration(progress));
  }

private:
  HeartbeatCalibration calibration(Progress& progress) const {
    const std::string name = "heartbeat-" + sample_organs::nameOf(heart_.resolution);
    const std::uint64_t key = keyOfAllInputs();
    if (const auto known = numbers_.load(name, key)) {
      const auto left = known->find("leftGain");
      const auto right = known->find("rightShift");
      if (left != known->end() && right != known->end())
        return {left->second, right->second};
    }
    const HeartbeatCalibration found = calibrate(progress);
    numbers_.store(name, key, {{"leftGain", found.leftGain}, {"rightShift", found.rightShift}});
    return found;
  }

  HeartbeatCalibration calibrate(Progress& progress) const {
    const MovedVolume left(surfaceOf(heart_, "lv"), rest_, system_, threads_);
    const MovedVolume right(surfaceOf(heart_, "rv"), rest_, system_, threads_);
    const auto measure = [&](const Points& pose) { return CavityVolumes{left.at(pose), right.at(pose)}; };
    return calibrateHeartbeat(motion_, cycle_, compensation_, measure, progress);
  }

  /// The cavities, the handles, and what the motion makes of them at a few instants: whoever changes a
  /// formula, a curve or the coordinates changes the key.
  std::uint64_t keyOfAllInputs() const {
    std::uint64_t key = 0;
    const auto add = [&key](const auto& array) {
      key = contentHash({reinterpret_cast<const char*>(array.data()),
                         static_cast<std::size_t>(array.size()) * sizeof(*array.data())},
                        key);
    };
    for (const char* name : {"lv", "rv"}) {
      add(surfaceOf(heart_, name)->points);
      add(surfaceOf(heart_, name)->triangles);
    }
    add(rest_);
    Points pose;
    for (const double phase : {0.05, 0.2, 0.3, 0.5, 0.65}) {
      motion_.pose(uncorrectedState(cycle_, phase), pose);
      compensation_.apply(rest_, pose);
      add(pose);
    }
    return key;
  }

  const sample_organs::SampleOrgan& heart_;
  const document::SystemChoice& system_;
  Threads threads_;
  NumberCache numbers_;
  CardiacCycle cycle_;
  HeartMotion motion_;
  Points rest_;
  PoseCompensation compensation_;
};

} // namespace

SequenceSetup heartbeatSetup(const SampleLibrary& library, sample_organs::Resolution resolution,
                             Progress& progress, Threads threads) {
  SequenceSetup setup;
  runPart(progress, 0, kOrganPart, [&](Progress& part) {
    setup.organ = sample_organs::sampleOrgan(library, "heart", resolution, part, threads);
  });
  setup.system = softCoordinates(kSoftnessMm);
  runPart(progress, kOrganPart, 1, [&](Progress& part) {
    setup.sequence = HeartbeatMaker(library, setup.organ, setup.system, threads).make(part);
  });
  setup.rig = document::rigOf(*setup.sequence);
  return setup;
}

} // namespace viscera::motion
