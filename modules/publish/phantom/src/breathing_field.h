#pragma once

#include <memory>

#include "viscera/sequences/breathing.h"

namespace viscera::phantom {

/// The motion of the trunk's content in a breath: that of the liver (`sequences::LiverBreathing`, without its
/// change of height), B(x) = x + w(z) (L(x) - x). The weight w is 1 in the abdomen, 0.65 at the height of the
/// heart, which so keeps all its volumes, and 0 at the top of the lungs, with cubic steps between. The heart
/// takes 0.57 to 0.70 of the motion of the diaphragm (Wang and others 1995, doi 10.1002/mrm.1910330517).
/// Immutable; thread-safe.
class BreathingField {
public:
  /// `liver` is the box of the liver, mm.
  explicit BreathingField(const Bounds& liver);

  double standardRatePerMinute() const { return liver_.standardRatePerMinute(); }
  /// The depth of inspiration, 0 to 1.
  double inspirationAt(double seconds, double ratePerMinute) const {
    return liver_.inspiration(seconds, ratePerMinute);
  }
  /// Where a point goes that is at `rest` at the end of expiration.
  Vec3 moved(const Vec3& rest, double inspiration) const;
  /// The other way, to 1e-9 mm, by Newton's method with the derivative in closed form.
  Vec3 restOf(const Vec3& moved, double inspiration) const;

private:
  sequences::LiverBreathing liver_;
};

} // namespace viscera::phantom
