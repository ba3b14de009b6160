#include "viscera/deformation/restoration_model.h"

namespace viscera::deformation {

Points LeastDisplacement::direction(const Points& pose, const Points& gradient,
                                    const std::vector<int>& free) const {
  Points direction = Points::Zero(pose.rows(), 3);
  for (const int handle : free)
    direction.row(handle) = gradient.row(handle);
  return direction;
}

} // namespace viscera::deformation
