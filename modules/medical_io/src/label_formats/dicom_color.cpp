#include "label_formats/dicom_color.h"

#include <algorithm>
#include <cmath>

namespace viscera::medical_io {
namespace {

constexpr double kLargest = 65535;

/// CIE 15: the inverse of the cube root with a straight beginning.
double fromLab(double t) {
  constexpr double kJoint = 6.0 / 29;
  return t > kJoint ? t * t * t : 3 * kJoint * kJoint * (t - 4.0 / 29);
}

double gammaOfSrgb(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

} // namespace

Vec3 colorOfDicomLab(std::uint16_t l, std::uint16_t a, std::uint16_t b) {
  const double lightness = (100.0 * l / kLargest + 16) / 116;
  const double x = fromLab(lightness + (255.0 * a / kLargest - 128) / 500);
  const double z = fromLab(lightness - (255.0 * b / kLargest - 128) / 200);
  const Vec3 xyz = Vec3(0.96422 * x, fromLab(lightness), 0.82521 * z); // The white of D50.
  Eigen::Matrix3d toLinear; // D50, adapted to the white of sRGB after Bradford.
  toLinear << 3.1338561, -1.6168667, -0.4906146, -0.9787684, 1.9161415, 0.0334540, 0.0719453, -0.2289914,
      1.4052427;
  return (toLinear * xyz).unaryExpr(&gammaOfSrgb);
}

} // namespace viscera::medical_io
