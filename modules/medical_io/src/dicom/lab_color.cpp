#include "dicom/lab_color.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

namespace viscera::medical_io {
namespace {

constexpr double kLargestLab = 65535;

/// CIE 15: the inverse of the cube root with a straight beginning.
double fromLab(double t) {
  constexpr double kJoint = 6.0 / 29;
  return t > kJoint ? t * t * t : 3 * kJoint * kJoint * (t - 4.0 / 29);
}

double gammaOfSrgb(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

/// The colour, 0 to 1 in sRGB, of a CIELab value as DICOM stores it (PS3.3, C.10.7.1.1: each of the three
/// over its whole range in 16 bits, under the illuminant D50). Colours that a screen cannot show are clipped.
Vec3 colorOfDicomLab(std::uint16_t l, std::uint16_t a, std::uint16_t b) {
  const double lightness = (100.0 * l / kLargestLab + 16) / 116;
  const double x = fromLab(lightness + (255.0 * a / kLargestLab - 128) / 500);
  const double z = fromLab(lightness - (255.0 * b / kLargestLab - 128) / 200);
  const Vec3 xyz = Vec3(0.96422 * x, fromLab(lightness), 0.82521 * z); // The white of D50.
  Eigen::Matrix3d toLinear; // D50, adapted to the white of sRGB after Bradford.
  toLinear << 3.1338561, -1.6168667, -0.4906146, -0.9787684, 1.9161415, 0.0334540, 0.0719453, -0.2289914,
      1.4052427;
  return (toLinear * xyz).unaryExpr(&gammaOfSrgb);
}

} // namespace

std::optional<Vec3> recommendedColor(DcmItem& item) {
  Uint16 l = 0, a = 0, b = 0;
  if (item.findAndGetUint16(DCM_RecommendedDisplayCIELabValue, l, 0).bad() ||
      item.findAndGetUint16(DCM_RecommendedDisplayCIELabValue, a, 1).bad() ||
      item.findAndGetUint16(DCM_RecommendedDisplayCIELabValue, b, 2).bad())
    return std::nullopt;
  return colorOfDicomLab(l, a, b);
}

} // namespace viscera::medical_io
