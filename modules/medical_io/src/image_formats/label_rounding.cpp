#include "image_formats/label_rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace viscera::medical_io {
namespace {

constexpr double kNearWhole = 1e-3, kNearZero = 1e-4;
/// Errors of single precision: of slope, intercept and their sum.
constexpr double kRoundings = 4;
constexpr double kLongestStep = 0.5;
constexpr double kFarthest = 0.25;                   ///< No value farther away is a label.
constexpr double kLargestLabel = 9007199254740992.0; ///< All whole numbers up to it are doubles.

} // namespace

LabelRounding::LabelRounding(const RawImage& image) : slope_(image.slope), intercept_(image.intercept) {
  if (isWhole(image.scalar) && std::abs(slope_) < kLongestStep)
    halfStep_ = std::abs(slope_) / 2;
}

std::optional<NearLabel> LabelRounding::nearest(double stored) const {
  const double value = valueOf(stored), whole = std::round(value);
  if (!(whole >= 0 && whole <= kLargestLabel))
    return std::nullopt;
  const double rounding = kRoundings * double(std::numeric_limits<float>::epsilon()) *
                          (std::abs(slope_ * stored) + std::abs(intercept_));
  const double near = std::max(whole == 0 ? kNearZero : kNearWhole, halfStep_) + rounding;
  const double distance = std::abs(value - whole);
  if (!(distance <= std::min(near, kFarthest)))
    return std::nullopt;
  return NearLabel{static_cast<std::int64_t>(whole), distance};
}

} // namespace viscera::medical_io
