#include "viscera/live/stress_frame.h"

#include <utility>

namespace viscera::live {

StressCopy::StressCopy(StressFrame start, std::shared_ptr<const deformation::WitnessGradients> gradients,
                       std::shared_ptr<const coordinates::Binding> positions)
    : frame_(std::move(start)), gradients_(std::move(gradients)), positions_(std::move(positions)) {
  frame_.points = points_;
  frame_.map = map_;
}

const StressFrame& StressCopy::at(const Points& pose) {
  if (!gradients_ || pose.rows() != gradients_->handles())
    return frame_;
  gradients_->evaluate(pose, *map_);
  positions_->deform(pose, *points_);
  for (const int point : positions_->report().failures)
    points_->row(point) = frame_.mesh->points.row(point);
  frame_.stretchesAt = [gradients = gradients_, pose](Eigen::Index point) {
    return deformation::principalStretches(gradients->deformationGradient(point, pose));
  };
  ++frame_.revision;
  return frame_;
}

} // namespace viscera::live
