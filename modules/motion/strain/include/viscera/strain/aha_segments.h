#pragma once

#include <array>
#include <string_view>

#include "viscera/strain/heart_axes.h"

/// The 17 segments of the left ventricle's wall (Cerqueira and others 2002, doi 10.1161/hc0402.102975).
namespace viscera::strain {

inline constexpr int kSegments = 17;

/// One segment, and its place in the bull's eye.
struct Segment {
  int number = 0;        ///< 1 to 17.
  std::string_view name; ///< "basal anterior"
  int ring = 0;          ///< 0 base, 1 middle, 2 apex, 3 the cap.
  /// The bull's eye counts degrees anticlockwise from its right (the lateral wall): 90 is the anterior wall,
  /// above, 180 the septum. Of the cap the whole circle.
  double fromDegrees = 0, toDegrees = 360;
  bool septal = false; ///< Segments 2, 3, 8, 9 and 14, between both ventricles.
};

/// All of them by number; the first is number 1.
const std::array<Segment, kSegments>& segments();

/// The number of the segment in which a point of the wall lies: thirds of the long axis, six segments of 60
/// degrees at base and middle from the anterior insertion on, four of 90 degrees at the apex, whose septal
/// one has the middle of the septum in its middle; the cap beyond the tip of the cavity. 0 for a point behind
/// the mitral annulus, which is no ventricle. O(1).
int segmentOf(const HeartAxes& axes, const Vec3& point);

} // namespace viscera::strain
