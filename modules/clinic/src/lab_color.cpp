#include "lab_color.h"

#include <algorithm>
#include <cmath>

namespace viscera::clinic {
namespace {

double linearOfSrgb(double value) {
  const double c = std::clamp(value, 0.0, 1.0);
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// CIE 15: the cube root with a straight beginning.
double toLab(double t) {
  constexpr double kJoint = 6.0 / 29;
  return t > kJoint * kJoint * kJoint ? std::cbrt(t) : t / (3 * kJoint * kJoint) + 4.0 / 29;
}

std::uint16_t wordOf(double share) {
  return static_cast<std::uint16_t>(std::lround(65535 * std::clamp(share, 0.0, 1.0)));
}

} // namespace

std::array<std::uint16_t, 3> dicomLab(const Vec3& color) {
  Eigen::Matrix3d toXyz; // The white of sRGB, adapted to D50 after Bradford.
  toXyz << 0.4360747, 0.3850649, 0.1430804, 0.2225045, 0.7168786, 0.0606169, 0.0139322, 0.0971045, 0.7141733;
  const Vec3 xyz = toXyz * color.unaryExpr(&linearOfSrgb);
  const double x = toLab(xyz.x() / 0.96422), y = toLab(xyz.y()), z = toLab(xyz.z() / 0.82521);
  return {wordOf((116 * y - 16) / 100), wordOf((500 * (x - y) + 128) / 255),
          wordOf((200 * (y - z) + 128) / 255)};
}

} // namespace viscera::clinic
