#include "viscera/sequences/heart_rig.h"
#include "viscera/sequences/stomach_rig.h"

namespace viscera::sequences {
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

const std::vector<Vec3>& courseOfTheStomach() {
  static const std::vector<Vec3> points{
      {58, 25, 119}, {56, 25, 104},  {53, 23, 84},   {50, 18, 62},    {51, 11, 40},   {49, 3, 16},
      {43, -7, -12}, {27, -15, -39}, {4, -19, -57},  {-19, -15, -57}, {-37, -7, -47}, {-48, 0, -37},
      {-54, 5, -30}, {-60, 10, -23}, {-68, 18, -18}, {-74, 27, -26},  {-75, 30, -48}, {-72, 31, -76}};
  return points;
}

constexpr double kDuodenalRingRadius = 20;
constexpr double kDuodenalRingDistance = 16;
constexpr double kBeyondTubeEnd = 14;

} // namespace

HeartAnatomy sampleHeartAnatomy(const SampleHeartSurfaces& surfaces) {
  HeartAnatomy anatomy;
  anatomy.frame = HeartFrame({-8, 22, 18}, {-0.62, -0.78, 0.05}, {0.64, -0.55, -0.54});
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

StomachAnatomy sampleStomachAnatomy(const AnatomySurface& surface) {
  StomachAnatomy anatomy{Centerline(courseOfTheStomach()), {}, surface, {}, {}};
  anatomy.course.midBody = anatomy.centerline.nearest({49, 5, 22});
  anatomy.course.pylorus = anatomy.centerline.nearest({-54, 5, -30});
  anatomy.fixed.push_back({{62, 27, 133}, {0, 0, 1}, 0, 1});
  for (const Vec3& center : {Vec3(-6, 28, 140), Vec3(-4, 28, 120), Vec3(2, 26, 100)})
    anatomy.fixed.push_back({center, {0, 0, 1}, 17, 5});
  anatomy.fixed.push_back({{-7, 28, 157}, {0, 0, 1}, 0, 1});
  for (double s = anatomy.course.pylorus + kDuodenalRingDistance; s <= anatomy.centerline.length();
       s += kDuodenalRingDistance) {
    const CrossSection section = anatomy.centerline.at(s);
    anatomy.fixed.push_back({section.center, section.tangent, kDuodenalRingRadius, 6});
  }
  // Beyond the cut ends: what sticks out of the handles near it would hang on those far away.
  const CrossSection end = anatomy.centerline.at(anatomy.centerline.length());
  anatomy.fixed.push_back({end.center + kBeyondTubeEnd * end.tangent, end.tangent, 0, 1});
  anatomy.box = {{-130, -100, -140}, {140, 110, 190}};
  return anatomy;
}

} // namespace viscera::sequences
