#include "sample_heart.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "sequence_binding.h"
#include "viscera/heart/heart_rig.h"

namespace viscera::live {
namespace {

using sample_organs::SampleLibrary;

sequences::AnatomySurface leastOf(std::vector<sequences::AnatomySurface> surfaces) {
  return [surfaces = std::move(surfaces)](const Vec3& point) {
    double least = surfaces.front()(point);
    for (std::size_t i = 1; i < surfaces.size(); ++i)
      least = std::min(least, surfaces[i](point));
    return least;
  };
}

heart::HeartAnatomy anatomyOf(const SampleLibrary& library) {
  const auto node = [&](const char* name) { return sample_organs::implicitSurface(library, "heart", name); };
  heart::SampleHeartSurfaces surfaces;
  surfaces.ventricles = node("ventricles");
  surfaces.rightCavity = node("surf rv");
  surfaces.rightAtrium = node("RA");
  surfaces.leftAtrium = node("LA");
  surfaces.greatVessels = leastOf({node("aorta"), node("pulmonary"), node("cavae"), node("veins_pulm")});
  return heart::sampleHeartAnatomy(surfaces);
}

} // namespace

SampleHeart sampleHeart(const SampleLibrary& library, Threads threads) {
  document::SystemChoice system = softCoordinates(kSoftnessMm);
  heart::HeartMotion motion(makeHeartRig(anatomyOf(library)));
  Points rest = motion.rig().restHandles();
  sequences::PoseCompensation compensation = compensationFor(rest, system, threads);
  return {std::move(system), std::move(motion), std::move(rest), std::move(compensation)};
}

} // namespace viscera::live
