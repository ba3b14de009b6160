#include "viscera/deformation/restoration_model.h"

namespace viscera::deformation {

Points RestorationModel::relaxation(const Points& pose, const Points&, const std::vector<int>&) const {
  return Points::Zero(pose.rows(), 3);
}

Points LeastDisplacement::direction(const Points& pose, const Points& gradient,
                                    const std::vector<int>& free) const {
  Points direction = Points::Zero(pose.rows(), 3);
  for (const int handle : free)
    direction.row(handle) = gradient.row(handle);
  return direction;
}

} // namespace viscera::deformation
