#include "viscera/strain/aha_segments.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace viscera::strain {
namespace {

using std::numbers::pi;

constexpr double kSixth = pi / 3, kFourth = pi / 2;
/// The septum's middle lies a sixth of the circle behind the anterior insertion, and its apical segment
/// reaches 45 degrees to either side of it.
constexpr double kApicalSeptum = kSixth - kFourth / 2;
/// The walls follow the insertion in this order: anteroseptal, inferoseptal, inferior, inferolateral,
/// anterolateral, anterior.
constexpr std::array<int, 6> kRing = {2, 3, 4, 5, 6, 1};
/// Septal, inferior, lateral, anterior.
constexpr std::array<int, 4> kApex = {14, 15, 16, 13};
constexpr int kCap = 17;

int sectorOf(double angle, double width, int count) {
  const double turned = angle < 0 ? angle + 2 * pi : angle;
  return std::min(static_cast<int>(turned / width), count - 1);
}

} // namespace

const std::array<Segment, kSegments>& segments() {
  static const std::array<Segment, kSegments> all = {{
      {1, "basal anterior", 0, 60, 120, false},
      {2, "basal anteroseptal", 0, 120, 180, true},
      {3, "basal inferoseptal", 0, 180, 240, true},
      {4, "basal inferior", 0, 240, 300, false},
      {5, "basal inferolateral", 0, 300, 360, false},
      {6, "basal anterolateral", 0, 0, 60, false},
      {7, "mid anterior", 1, 60, 120, false},
      {8, "mid anteroseptal", 1, 120, 180, true},
      {9, "mid inferoseptal", 1, 180, 240, true},
      {10, "mid inferior", 1, 240, 300, false},
      {11, "mid inferolateral", 1, 300, 360, false},
      {12, "mid anterolateral", 1, 0, 60, false},
      {13, "apical anterior", 2, 45, 135, false},
      {14, "apical septal", 2, 135, 225, true},
      {15, "apical inferior", 2, 225, 315, false},
      {16, "apical lateral", 2, -45, 45, false},
      {17, "apex", 3, 0, 360, false},
  }};
  return all;
}

int segmentOf(const HeartAxes& axes, const Vec3& point) {
  const double height = axes.heightOf(point);
  if (!(height >= 0))
    return 0;
  if (height > 1)
    return kCap;
  const double angle = axes.angleOf(point);
  const int third = std::min(static_cast<int>(3 * height), 2);
  if (third == 2)
    return kApex[static_cast<std::size_t>(sectorOf(angle - kApicalSeptum, kFourth, 4))];
  return kRing[static_cast<std::size_t>(sectorOf(angle, kSixth, 6))] + 6 * third;
}

} // namespace viscera::strain
