#include "viscera/motion/heartbeat_setup.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <string_view>
#include <utility>

#include "number_cache.h"
#include "sequence_binding.h"
#include "viscera/core/content_hash.h"
#include "viscera/document/sequence_rig.h"
#include "viscera/sequences/course_heartbeat.h"
#include "viscera/sequences/heartbeat.h"
#include "viscera/sequences/sample_heart.h"

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

  /// The heart as a course says, whose volumes are those of a circulation.
  std::shared_ptr<const sequences::Sequence> follow(sequences::HeartCourse course, Progress& progress) const {
    const auto at = [&course](double phase) { return course.at(phase); };
    std::vector<double> volumes;
    for (const sequences::CourseInstant& instant : course.instants)
      volumes.insert(volumes.end(), {instant.volumes.leftMl, instant.volumes.rightMl});
    const std::uint64_t key = contentHash(
        {reinterpret_cast<const char*>(volumes.data()), volumes.size() * sizeof(double)}, keyOf(at));
    const auto found = kept("heartbeat-course-", key, [&] {
      return sequences::calibrateCourse(motion_, at, compensation_, measured(), progress);
    });
    return std::make_shared<sequences::CourseHeartbeat>(motion_, std::move(course), compensation_, found);
  }

  std::shared_ptr<const sequences::Sequence> make(Progress& progress) const {
    return std::make_shared<sequences::CalibratedHeartbeat>(motion_, cycle_, compensation_,
                                                            calibration(progress));
  }

private:
  HeartbeatCalibration calibration(Progress& progress) const {
    const auto at = [this](double phase) {
      return sequences::CourseInstant{uncorrectedState(cycle_, phase), cycle_.volumes(phase)};
    };
    return kept("heartbeat-", keyOf(at),
                [&] { return calibrateHeartbeat(motion_, cycle_, compensation_, measured(), progress); });
  }

  /// What the cache has under that name and key, or what is found now and kept.
  HeartbeatCalibration kept(const std::string& prefix, std::uint64_t key,
                            const std::function<HeartbeatCalibration()>& find) const {
    const std::string name = prefix + sample_organs::nameOf(heart_.resolution);
    if (const auto known = numbers_.load(name, key)) {
      const auto left = known->find("leftGain");
      const auto right = known->find("rightShift");
      if (left != known->end() && right != known->end())
        return {left->second, right->second};
    }
    const HeartbeatCalibration found = find();
    numbers_.store(name, key, {{"leftGain", found.leftGain}, {"rightShift", found.rightShift}});
    return found;
  }

  sequences::MeasureCavities measured() const {
    const auto left = std::make_shared<MovedVolume>(surfaceOf(heart_, "lv"), rest_, system_, threads_);
    const auto right = std::make_shared<MovedVolume>(surfaceOf(heart_, "rv"), rest_, system_, threads_);
    return [left, right](const Points& pose) { return CavityVolumes{left->at(pose), right->at(pose)}; };
  }

  /// The cavities, the handles, and what the motion makes of them at a few instants: whoever changes a
  /// formula, a curve or the coordinates changes the key.
  std::uint64_t keyOf(const sequences::CourseOverPhase& course) const {
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
      motion_.pose(course(phase).state, pose);
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

/// The heart with its coordinates, and what `make` makes of them.
template <typename Make>
SequenceSetup setUpHeart(const SampleLibrary& library, sample_organs::Resolution resolution,
                         Progress& progress, Threads threads, const Make& make) {
  SequenceSetup setup;
  runPart(progress, 0, kOrganPart, [&](Progress& part) {
    setup.organ = sample_organs::sampleOrgan(library, "heart", resolution, part, threads);
  });
  setup.system = softCoordinates(kSoftnessMm);
  runPart(progress, kOrganPart, 1, [&](Progress& part) {
    setup.sequence = make(HeartbeatMaker(library, setup.organ, setup.system, threads), part);
  });
  setup.rig = document::rigOf(*setup.sequence);
  return setup;
}

} // namespace

SequenceSetup heartbeatSetup(const SampleLibrary& library, sample_organs::Resolution resolution,
                             Progress& progress, Threads threads) {
  return setUpHeart(library, resolution, progress, threads,
                    [](const HeartbeatMaker& maker, Progress& part) { return maker.make(part); });
}

SequenceSetup courseSetup(const SampleLibrary& library, const sequences::HeartCourse& course,
                          sample_organs::Resolution resolution, Progress& progress, Threads threads) {
  return setUpHeart(
      library, resolution, progress, threads,
      [&course](const HeartbeatMaker& maker, Progress& part) { return maker.follow(course, part); });
}

} // namespace viscera::motion
