#include "pulse.h"

#include <cmath>
#include <numbers>

namespace viscera::examples {

void Pulse::poseAt(double seconds, double ratePerMinute, Points& pose) const {
  // A sine squared begins and ends at rest, without a jump of the velocity where the cycle begins again.
  const double wave = std::sin(std::numbers::pi * seconds * ratePerMinute / 60);
  const Eigen::RowVector3d middle = rest_.colwise().mean();
  pose = ((rest_.rowwise() - middle) * (1 + swelling_ * wave * wave)).rowwise() + middle;
}

std::vector<sequences::Phase> Pulse::phases(double) const {
  return {{"swelling", 0, 0.5}, {"shrinking", 0.5, 1}};
}

} // namespace viscera::examples
