#include "sample_heart.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "sequence_binding.h"
#include "viscera/heart/heart_rig.h"

namespace viscera::live {
namespace {

using sample_organs::SampleLibrary;

constexpr const char* kHeart = "heart";
constexpr std::string_view kHeartAt = "heart@"; ///< Before the resolution.

sequences::AnatomySurface leastOf(std::vector<sequences::AnatomySurface> surfaces) {
  return [surfaces = std::move(surfaces)](const Vec3& point) {
    double least = surfaces.front()(point);
    for (std::size_t i = 1; i < surfaces.size(); ++i)
      least = std::min(least, surfaces[i](point));
    return least;
  };
}

heart::HeartAnatomy anatomyOf(const SampleLibrary& library) {
  const auto node = [&](const char* name) { return sample_organs::implicitSurface(library, kHeart, name); };
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

std::optional<sample_organs::Resolution> heartResolutionOf(const document::OrganOrigin& origin) {
  if (!origin.sample.starts_with(kHeartAt))
    return std::nullopt;
  return sample_organs::resolutionFromName(origin.sample.substr(kHeartAt.size()));
}

std::vector<geometry::NamedVessel> heartVessels(const SampleLibrary& library,
                                                sample_organs::Resolution resolution) {
  return sample_organs::namedVessels(library, kHeart, "outer",
                                     std::max(resolution, sample_organs::Resolution::medium));
}

std::shared_ptr<const geometry::TriangleMesh> heartSurface(const SampleLibrary& library, const char* name,
                                                           sample_organs::Resolution resolution,
                                                           Progress& progress, Threads threads) {
  return sample_organs::sampleSurface(library, kHeart, name, resolution, progress, threads).mesh;
}

} // namespace viscera::live
