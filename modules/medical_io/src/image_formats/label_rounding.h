#pragma once

#include <cstdint>
#include <optional>

#include "image_formats/raw_image.h"

namespace viscera::medical_io {

/// A label, and how far the value that stands for it is from it.
struct NearLabel {
  std::int64_t label = 0;
  double distance = 0;
};

/// Tells the labels among the values of an image. Programs that keep labels as fractions, or as whole numbers
/// behind a slope, bend them: 2.00007 is 2, and 0.9999999 is 1. A value is a label when it is as near to a
/// whole number from 0 on
///
///   * as single precision and a thousandth allow, or a ten thousandth for 0, whose neighbours may be
///     measurements in a large unit; or
///   * as half a step of the slope, when the values are stored as whole numbers and a step is less than a
///     half: then no value in between stands for that label better. Of a scan, two values that follow one
///     another cannot both be so near.
class LabelRounding {
public:
  /// Rounds by the type, slope and intercept of `image`.
  explicit LabelRounding(const RawImage& image);

  double valueOf(double stored) const { return slope_ * stored + intercept_; }
  /// Nothing for a value that is no label.
  std::optional<NearLabel> nearest(double stored) const;

private:
  double slope_, intercept_;
  double halfStep_ = 0; ///< 0: the slope tells nothing.
};

} // namespace viscera::medical_io
