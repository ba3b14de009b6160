#pragma once

#include <array>
#include <vector>

#include "viscera/core/arrays.h"

/// The ways in which a body's axes may lie along those of a file.
namespace viscera::medical_io {

/// An organ with its place in the file and its usual place in a body.
struct KnownOrgan {
  Vec3 at = Vec3::Zero();       ///< In the file.
  Vec3 expected = Vec3::Zero(); ///< In a body: mm, LPS, from any origin.
  Vec3 spread = Vec3::Zero();   ///< One standard deviation of it; infinite: not known.
  double weight = 1;            ///< Less for one of many of its kind.
};

/// One way: direction `a` of the body (to the left, to the back, to the head) lies along axis `axis[a]` of
/// the file, in its sense for `sign[a]` 1, against it for -1.
struct BodyWay {
  std::array<int, 3> axis = {0, 1, 2};
  std::array<int, 3> sign = {1, 1, 1};
  double factor = 1; ///< The size of the organs in the file that explains most, in sizes of life.
  double cost =
      0; ///< Of that size and of the best shift: squared standard deviations, bounded for each organ.

  bool alongAxes() const { return axis[0] == 0 && axis[1] == 1 && axis[2] == 2; }
  bool isLps() const { return alongAxes() && sign[0] > 0 && sign[1] > 0 && sign[2] > 0; }
};

/// The factor from the usual distances of the organs to those in the file; 1 for fewer than two organs.
double sizeFactorOf(const std::vector<KnownOrgan>& organs);

/// All 48 ways with their costs, the best first. Ways that are rarer in files cost a little more. O(n^2).
std::vector<BodyWay> bodyWays(const std::vector<KnownOrgan>& organs);

/// How far an organ is from where it is expected, along a direction of the body, when it lies that way: mm of
/// a usual body. O(n).
double awayFrom(const std::vector<KnownOrgan>& organs, const BodyWay& way, std::size_t organ, int direction);

} // namespace viscera::medical_io
