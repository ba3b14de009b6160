#include "viscera/strain/strain_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace viscera::strain {
namespace {

Peak peakAt(std::vector<double>::const_iterator place, const std::vector<double>& curve,
            const std::vector<double>& seconds) {
  const auto phase = static_cast<std::size_t>(place - curve.begin());
  return {*place, phase, seconds[phase]};
}

} // namespace

Peak shortestOf(const std::vector<double>& curve, const std::vector<double>& seconds) {
  return peakAt(std::min_element(curve.begin(), curve.end()), curve, seconds);
}

Peak longestOf(const std::vector<double>& curve, const std::vector<double>& seconds) {
  return peakAt(std::max_element(curve.begin(), curve.end()), curve, seconds);
}

std::vector<double> meanOf(const std::vector<const std::vector<double>*>& curves) {
  if (curves.empty())
    return {};
  std::vector<double> mean(curves.front()->size(), 0);
  for (std::size_t phase = 0; phase < mean.size(); ++phase) {
    int count = 0;
    for (const std::vector<double>* curve : curves)
      if (std::isfinite((*curve)[phase])) {
        mean[phase] += (*curve)[phase];
        ++count;
      }
    mean[phase] /= std::max(count, 1);
  }
  return mean;
}

std::vector<double> changeFrom(const std::vector<double>& lengths, std::size_t reference) {
  std::vector<double> change;
  change.reserve(lengths.size());
  for (const double length : lengths)
    change.push_back((length - lengths[reference]) / lengths[reference]);
  return change;
}

double deviationOf(const std::vector<double>& values) {
  if (values.size() < 2)
    return 0;
  double mean = 0, sum = 0;
  for (const double value : values)
    mean += value / static_cast<double>(values.size());
  for (const double value : values)
    sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

} // namespace viscera::strain
