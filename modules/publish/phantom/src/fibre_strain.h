#pragma once

#include <vector>

#include "viscera/phantom/phantom_body.h"
#include "viscera/phantom/phantom_motion.h"

namespace viscera::phantom {

/// Strain of the left ventricle's wall in one instant: means over its points, stretch - 1.
struct WallStrain {
  double longitudinal = 0;
  double circumferential = 0;
  double radial = 0;
};

/// Points in the wall of the left ventricle, with the directions of the wall there.
class WallPoints {
public:
  /// Points 4 mm outside of the cavity's surface, 15 to 65 mm below the mitral valve. O(vertices).
  explicit WallPoints(const PhantomBody& body);

  /// |F e| - 1 for the three directions e at rest, F by central differences of the motion over 1 mm. The
  /// denominator is the phantom's rest.
  WallStrain strainAt(const PhantomMotion& motion) const;
  Eigen::Index count() const { return points_.rows(); }

private:
  Points points_;
  std::vector<Points> directions_; ///< Longitudinal, circumferential, radial; unit vectors.
};

} // namespace viscera::phantom
