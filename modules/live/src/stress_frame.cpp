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

void StressRecord::add(const StressSample& sample) {
  if (!samples_.empty() && sample.seconds <= samples_.back().seconds)
    samples_.clear();
  if (capacity_ > 0 && samples_.size() >= 2 * capacity_)
    samples_.erase(samples_.begin(), samples_.end() - static_cast<std::ptrdiff_t>(capacity_));
  samples_.push_back(sample);
}

StressPeak stressPeak(const deformation::WitnessGradients& gradients, Eigen::Index witnesses,
                      const sequences::Sequence& sequence, double ratePerMinute, int frames, Threads threads,
                      Progress& progress) {
  StressPeak peak;
  Points pose;
  deformation::StressMap map;
  for (int frame = 0; frame < frames; ++frame) {
    progress.throwIfCancelled();
    progress.report(static_cast<double>(frame) / frames, "peak stress over the sequence");
    const double seconds = 60.0 / ratePerMinute * frame / frames;
    sequence.poseAt(seconds, ratePerMinute, pose);
    gradients.evaluate(pose, map, threads);
    if (frame == 0)
      peak.map = map;
    else
      takeWorse(peak.map, map);
    peak.cycle.push_back({seconds, deformation::statisticsOf(map, witnesses)});
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
