#include "soak_faults.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <sstream>
#include <utility>

namespace viscera::tests {
namespace {

constexpr double kLatestMs = 100; ///< A frame after that is late.
constexpr double kMostGrowth = 0.01;
constexpr std::size_t kFewest = 10; ///< Samples.
constexpr std::size_t kAround = 2;  ///< Samples before and after one that tell how fast the machine was.

using Samples = std::vector<SoakSample>;

struct Faults {
  template <typename... Parts>
  void add(const Parts&... parts) {
    std::ostringstream line;
    (line << ... << parts);
    lines.push_back(line.str());
  }
  std::vector<std::string> lines;
};

/// Those after the warm-up in which nothing went on but the beating.
Samples calmOf(const Samples& samples, double warmUp) {
  Samples calm;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (samples[i].occupation == kPlaying && double(i) >= warmUp * double(samples.size()))
      calm.push_back(samples[i]);
  return calm;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

double meanMb(Samples::const_iterator first, Samples::const_iterator last, double ProcessUse::*memory) {
  std::vector<double> values;
  std::transform(first, last, std::back_inserter(values),
                 [memory](const SoakSample& s) { return s.use.*memory; });
  return mean(values);
}

/// How long the machine's work took around each sample; one frame alone has time for few works.
std::vector<double> worksOf(const Samples& calm) {
  std::vector<double> works;
  for (std::size_t i = 0; i < calm.size(); ++i) {
    const std::size_t first = i - std::min(i, kAround), last = std::min(i + kAround + 1, calm.size());
    double sum = 0;
    for (std::size_t j = first; j < last; ++j)
      sum += calm[j].machine.workUs;
    works.push_back(sum / double(last - first));
  }
  return works;
}

/// By how much each longest frame was longer because the machine was slower than usual, ms. A line is fitted
/// to the times of frames over those of the work, so that only what both have in common counts.
std::vector<double> slowedMs(const Samples& calm) {
  const std::vector<double> works = worksOf(calm);
  std::vector<double> frames;
  for (const SoakSample& sample : calm)
    frames.push_back(sample.longestMs - sample.machine.pausedMs);
  const double meanWork = mean(works), meanFrame = mean(frames), usualWork = median(works);
  double together = 0, alone = 0;
  for (std::size_t i = 0; i < calm.size(); ++i) {
    together += (works[i] - meanWork) * (frames[i] - meanFrame);
    alone += (works[i] - meanWork) * (works[i] - meanWork);
  }
  const double slope = alone > 0 ? std::max(0.0, together / alone) : 0;
  std::vector<double> slowed;
  for (const double work : works)
    slowed.push_back(slope * std::max(0.0, work - usualWork));
  return slowed;
}

/// By means, because memory differs by a few per cent with what was done before: where half of the seconds
/// follow one action, the median is that of either half by chance.
void judgeMemory(const Samples& calm, Faults& faults) {
  const auto part = static_cast<std::ptrdiff_t>(std::max<std::size_t>(calm.size() / 10, 3));
  const std::pair<const char*, double ProcessUse::*> kinds[] = {
      {"memory", &ProcessUse::ownMb}, {"allocated memory", &ProcessUse::allocatedMb}};
  for (const auto& [name, memory] : kinds) {
    const double before = meanMb(calm.begin(), calm.begin() + part, memory);
    const double after = meanMb(calm.end() - part, calm.end(), memory);
    if (after > before * (1 + kMostGrowth))
      faults.add(name, " grew from ", before, " to ", after, " MB");
  }
}

void judgeFrames(const Samples& calm, Faults& faults) {
  const std::vector<double> slowed = slowedMs(calm);
  for (std::size_t i = 0; i < calm.size(); ++i) {
    const SoakSample& sample = calm[i];
    if (sample.frames == 0)
      faults.add("no frame was drawn in the second before ", sample.seconds, " s");
    if (sample.longestMs - sample.machine.pausedMs - slowed[i] > kLatestMs)
      faults.add("a frame came after ", sample.longestMs, " ms at ", sample.seconds,
                 " s, of which the machine stood still ", sample.machine.pausedMs, " ms and was slower for ",
                 slowed[i], " ms");
  }
}

/// A line for each change, not for each second that it lasts.
void judgeDescriptors(const Samples& calm, Faults& faults) {
  for (std::size_t i = 1; i < calm.size(); ++i)
    if (const int now = calm[i].use.descriptors, before = calm[i - 1].use.descriptors; now != before)
      faults.add(now, " descriptors at ", calm[i].seconds, " s, ", before, " before");
}

void judgeThreads(const Samples& calm, Faults& faults) {
  int most = 0;
  for (std::size_t i = 0; i < calm.size(); ++i) {
    const int now = calm[i].use.threads;
    if (2 * i >= calm.size() && now > most)
      faults.add(now, " threads at ", calm[i].seconds, " s, at most ", most, " before");
    most = std::max(most, now);
  }
}

} // namespace

std::vector<std::string> soakFaults(const std::vector<SoakSample>& samples, const SoakRules& rules) {
  const Samples calm = calmOf(samples, rules.warmUp);
  if (calm.size() < kFewest)
    return {"the soak was too short to be judged"};
  Faults faults;
  judgeMemory(calm, faults);
  if (!rules.lateFramesAllowed)
    judgeFrames(calm, faults);
  judgeDescriptors(calm, faults);
  judgeThreads(calm, faults);
  return faults.lines;
}

} // namespace viscera::tests
