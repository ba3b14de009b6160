#include "viscera/sequences/stomach_rig.h"

namespace viscera::sequences {
namespace {

const std::vector<Vec3>& courseOfTheStomach() {
  static const std::vector<Vec3> points{
      {61, 26, 118.65}, {59, 25, 104},  {55, 23, 84},   {51, 18, 62},    {51, 11, 40},   {49, 3, 16},
      {43, -7, -12},    {27, -15, -39}, {4, -19, -57},  {-19, -15, -57}, {-37, -7, -47}, {-48, 0, -37},
      {-54, 5, -30},    {-60, 10, -23}, {-68, 18, -18}, {-74, 27, -26},  {-75, 30, -48}, {-72, 31, -76}};
  return points;
}

constexpr double kDuodenalRingRadius = 20;
constexpr double kDuodenalRingDistance = 16;
constexpr double kBeyondTubeEnd = 14;

} // namespace

StomachAnatomy sampleStomachAnatomy(const AnatomySurface& surface) {
  StomachAnatomy anatomy{Centerline(courseOfTheStomach()), {}, surface, {}, {}};
  anatomy.course.midBody = anatomy.centerline.nearest({49, 5, 22});
  anatomy.course.pylorus = anatomy.centerline.nearest({-54, 5, -30});
  anatomy.fixed.push_back({{62, 27, 136}, {0, 0, 1}, 0, 1});
  for (const Vec3& center : {Vec3(-5, 28, 140), Vec3(-5, 28, 121), Vec3(-3, 27, 102)})
    anatomy.fixed.push_back({center, {0, 0, 1}, 17, 5});
  anatomy.fixed.push_back({{-5, 27, 157}, {0, 0, 1}, 0, 1});
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
