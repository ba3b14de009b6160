#include "viscera/live/stress_record.h"

#include <algorithm>
#include <limits>

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
  double most = -1;
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
    if (peak.cycle.back().statistics.max > most) {
      most = peak.cycle.back().statistics.max;
      peak.worstSeconds = seconds;
    }
  }
  peak.map.folded = static_cast<int>((peak.map.volumeRatio.array() <= 0).count());
  progress.report(1);
  return peak;
}

} // namespace viscera::live
