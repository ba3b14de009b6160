#include "viscera/heart/heart_rig.h"

namespace viscera::heart {
namespace {

/// A vessel's cut end, or a bend where one handle is enough.
VesselRing fixedAt(const Vec3& center, double follow = 0) {
  return {center, Vec3::UnitZ(), 0, 1, follow};
}

/// The nearer to the valves, the more a vessel goes with the base.
std::vector<VesselRing> greatVessels() {
  return {
      // Aorta: root, ascending part, arch with its branches, descending part.
      {{-22, 4, 58}, {-4, -4, 15}, 20, 4, 0.5},
      fixedAt({-24, 5, 76}),
      fixedAt({-10, 27, 112}),
      fixedAt({14, 54, 92}),
      fixedAt({15, 58, 58}),
      fixedAt({-29, 12, 130}),
      fixedAt({12, 36, 132}),
      // Pulmonary trunk, its fork, both branches.
      {{9, -14, 54}, {5, 13, 14}, 21, 5, 0.6},
      fixedAt({16, 6, 74}, 0.2),
      fixedAt({46, 40, 68}),
      fixedAt({-64, 41, 60}),
      // Superior vena cava.
      {{-49, 15, 58}, {0, 0, 1}, 16, 3, 0.3},
      fixedAt({-48, 17, 95}),
      // Inferior vena cava.
      {{-47, 19, -20}, {0, 0, 1}, 20, 6, 0.25},
      {{-46.5, 20, -36}, {0, 0, 1}, 18, 5, 0.08},
      fixedAt({-46, 21, -50}, 0.05),
      // Pulmonary veins.
      fixedAt({32, 67, 50}, 0.12),
      fixedAt({32, 72, 15}, 0.12),
      fixedAt({-64, 65, 46}, 0.05),
      fixedAt({-64, 69, 13}, 0.05),
  };
}

} // namespace

HeartAnatomy sampleHeartAnatomy(const SampleHeartSurfaces& surfaces) {
  HeartAnatomy anatomy;
  anatomy.frame = sampleHeartFrame();
  anatomy.endocardium = {25.5, 28, 59};
  anatomy.epicardium = {33.5, 28, 65};
  anatomy.baseEpicardium = -6;
  anatomy.length = 92;
  anatomy.ventricles = surfaces.ventricles;
  anatomy.rightCavity = surfaces.rightCavity;
  anatomy.greatVessels = surfaces.greatVessels;
  anatomy.atria = {{surfaces.rightAtrium, {-52, 12, 14}, {{-40, -28, 42}, {-18, -28, 50}}},
                   {surfaces.leftAtrium, {-14, 47, 28}, {{32, 14, 54}, {40, -6, 42}}, true}};
  anatomy.vessels = greatVessels();
  anatomy.box = {{-105, -80, -95}, {95, 110, 165}};
  return anatomy;
}

} // namespace viscera::heart
