#include "viscera/live/stress_frame.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace viscera::live {
namespace {

/// How far a volume ratio is from 1, as a factor; infinite for what is folded.
double departure(double ratio) {
  return ratio <= 0 ? std::numeric_limits<double>::infinity() : std::max(ratio, 1 / ratio);
}

void takeWorse(deformation::StressMap& worst, const deformation::StressMap& map) {
  worst.rotationalStress = worst.rotationalStress.cwiseMax(map.rotationalStress);
  worst.stretchMax = worst.stretchMax.cwiseMax(map.stretchMax);
  worst.stretchMin = worst.stretchMin.cwiseMin(map.stretchMin);
  for (Eigen::Index i = 0; i < map.volumeRatio.size(); ++i)
    if (departure(map.volumeRatio[i]) > departure(worst.volumeRatio[i]))
      worst.volumeRatio[i] = map.volumeRatio[i];
}

} // namespace

StressPeak stressPeak(const deformation::WitnessGradients& gradients, Eigen::Index witnesses,
                      const PosedCycle& cycle, int frames, Threads threads, Progress& progress) {
  StressPeak peak;
  peak.periodSeconds = cycle.periodSeconds;
  deformation::StressMap map;
  for (int frame = 0; frame < frames; ++frame) {
    progress.throwIfCancelled();
    const double fraction = static_cast<double>(frame) / frames;
    progress.report(fraction, "peak stress over the sequence");
    gradients.evaluate(cycle.poseAt(fraction), map, threads);
    if (frame == 0)
      peak.map = map;
    else
      takeWorse(peak.map, map);
    peak.cycle.push_back({fraction * cycle.periodSeconds, deformation::statisticsOf(map, witnesses)});
  }
  peak.map.folded = static_cast<int>((peak.map.volumeRatio.array() <= 0).count());
  progress.report(1);
  return peak;
}

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
