#include "viscera/tracking/phase_times.h"

#include <algorithm>
#include <cmath>

namespace viscera::tracking {
namespace {

/// Seconds from one phase to a later one, around the period where that is the way.
double stepBetween(const PhaseTimes& times, std::size_t from, std::size_t to) {
  const double step = times.seconds[to] - times.seconds[from];
  return step > 0 ? step : step + times.periodSeconds;
}

} // namespace

PhaseTimes PhaseTimes::even(std::size_t count, double periodSeconds, bool loop) {
  PhaseTimes times{{}, periodSeconds, loop};
  for (std::size_t phase = 0; phase < count; ++phase)
    times.seconds.push_back(periodSeconds * static_cast<double>(phase) / static_cast<double>(count));
  return times;
}

bool neighboursOf(const PhaseTimes& times, std::size_t phase, Neighbours& neighbours) {
  const std::size_t count = times.count();
  if (count < 3 || (!times.loop && (phase == 0 || phase + 1 == count)))
    return false;
  neighbours.before = (phase + count - 1) % count;
  neighbours.after = (phase + 1) % count;
  const double before = stepBetween(times, neighbours.before, phase);
  // Linear in time between the two: (1 - part) x_before + part x_after.
  neighbours.part = before / (before + stepBetween(times, phase, neighbours.after));
  return true;
}

Eigen::MatrixXd unevenness(const PhaseTimes& times) {
  const auto count = static_cast<Eigen::Index>(times.count());
  Eigen::MatrixXd differences = Eigen::MatrixXd::Zero(count, count);
  const double mean = times.loop ? times.periodSeconds / static_cast<double>(count)
                                 : (times.seconds.back() - times.seconds.front()) /
                                       static_cast<double>(std::max<Eigen::Index>(count - 1, 1));
  for (Eigen::Index phase = 0; phase < count; ++phase) {
    Neighbours neighbours;
    if (!neighboursOf(times, static_cast<std::size_t>(phase), neighbours))
      continue;
    const double before = stepBetween(times, neighbours.before, static_cast<std::size_t>(phase)) / mean;
    const double after = stepBetween(times, static_cast<std::size_t>(phase), neighbours.after) / mean;
    // x'' by the three phases, 2 / (h_1 + h_2) ((x_2 - x) / h_2 - (x - x_1) / h_1), in units of the mean
    // step: of even phases x_1 - 2 x + x_2.
    const double scale = 2 / (before + after);
    differences(phase, static_cast<Eigen::Index>(neighbours.before)) += scale / before;
    differences(phase, static_cast<Eigen::Index>(neighbours.after)) += scale / after;
    differences(phase, phase) -= scale / before + scale / after;
  }
  // sum |x''|^2 = x^T D^T D x.
  return differences.transpose() * differences;
}

} // namespace viscera::tracking
