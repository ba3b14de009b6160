#include "dicom/cine_times.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

namespace viscera::medical_io {
namespace {

/// Fractions of a cycle that differ by less are one phase.
constexpr double kSameFraction = 1e-6;
/// Phases leave out no more of the cycle at a stretch.
constexpr double kLargestGap = 0.5;
/// A gap is so many steps wide at least when a phase is missing in it.
constexpr double kGapWithMissing = 1.5;
/// Steps agree with the stated number of phases up to this part of them.
constexpr double kSameStep = 0.2;
constexpr std::size_t kMostMissing = 1000;

/// What tells the phases apart.
enum class Clock { percent, trigger, position, number };

std::optional<double> timeBy(Clock clock, const DicomFrame& frame) {
  switch (clock) {
  case Clock::percent:
    return frame.percent;
  case Clock::trigger:
    return frame.triggerMs;
  case Clock::position:
    return frame.temporalPosition;
  case Clock::number:
    break;
  }
  return static_cast<double>(frame.instance);
}

double median(std::vector<double> values) {
  if (values.empty())
    return 0;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<double> differences(const std::vector<double>& ascending) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < ascending.size(); ++i)
    steps.push_back(ascending[i] - ascending[i - 1]);
  return steps;
}

class Placing {
public:
  Placing(const FrameList& list, const std::vector<std::size_t>& frames,
          const std::vector<DicomFrame>& damaged)
      : list_(list), frames_(frames), damaged_(damaged) {
    // Take what most frames say, so that one damaged header does not decide.
    std::vector<double> intervals, counts;
    for (const std::size_t f : frames) {
      counts.push_back(list.files[list.frames[f].file].cardiacImages);
      if (const auto interval = list.frames[f].intervalMs; interval && *interval > 0)
        intervals.push_back(*interval);
    }
    stated_ = median(std::move(intervals));
    expected_ = std::max(static_cast<int>(median(std::move(counts))), 0);
  }

  std::optional<CineTimes> run() {
    for (const Clock clock : {Clock::percent, Clock::trigger, Clock::position, Clock::number}) {
      std::vector<double> times = distinctTimes(clock);
      if (times.size() < 2 || !setCycle(clock, times))
        continue;
      return placedBy(clock);
    }
    return std::nullopt;
  }

private:
  /// Ascending; nothing when a frame has none.
  std::vector<double> distinctTimes(Clock clock) const {
    std::vector<double> times;
    for (const std::size_t f : frames_) {
      const auto time = timeBy(clock, list_.frames[f]);
      if (!time || !std::isfinite(*time))
        return {};
      times.push_back(*time);
    }
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
  }

  /// Sets when the cycle begins and how long it is, in the unit of the times; false when they tell neither.
  bool setCycle(Clock clock, const std::vector<double>& times) {
    wrongInterval_.reset();
    if (clock == Clock::percent) {
      begin_ = 0;
      length_ = 100;
      return true;
    }
    return clock == Clock::trigger ? setCycleInMs(times) : setCycleInSteps(clock, times);
  }

  bool setCycleInMs(const std::vector<double>& times) {
    const double span = times.back() - times.front(), step = median(differences(times));
    const double steps = std::max(std::round(span / step) + 1, double(expected_));
    length_ = stated_ > span ? stated_ : step * steps;
    if (stated_ > 0 && stated_ <= span)
      wrongInterval_ = stated_;
    begin_ = times.front() >= 0 && times.back() < length_ ? 0 : times.front();
    return std::isfinite(length_) && length_ > 0;
  }

  /// Counted from the first one on. Numbers alone are no times, unless the file is about a heart's cycle.
  bool setCycleInSteps(Clock clock, const std::vector<double>& times) {
    const bool ofHeart = expected_ > 1 || stated_ > 0;
    const std::vector<double> steps = differences(times);
    const double step = *std::min_element(steps.begin(), steps.end());
    const double count = std::round((times.back() - times.front()) / step) + 1;
    if (!ofHeart || (expected_ > 1 && count > expected_) || (clock == Clock::number && expected_ < 2))
      return false;
    begin_ = times.front();
    length_ = step * std::max(count, double(expected_));
    return true;
  }

  double fractionOf(double time) const {
    const double fraction = (time - begin_) / length_, part = fraction - std::floor(fraction);
    return part > 1 - kSameFraction ? 0 : part;
  }

  std::optional<CineTimes> placedBy(Clock clock) const {
    std::vector<std::tuple<double, std::int64_t, std::size_t>> order;
    for (const std::size_t f : frames_)
      order.emplace_back(fractionOf(*timeBy(clock, list_.frames[f])), list_.frames[f].instance, f);
    std::sort(order.begin(), order.end());
    CineTimes placed;
    for (const auto& [fraction, number, f] : order) {
      if (!placed.fractions.empty() && fraction - placed.fractions.back() < kSameFraction) {
        ++placed.doubled;
        continue;
      }
      placed.fractions.push_back(fraction);
      placed.frames.push_back(f);
    }
    for (const DicomFrame& frame : damaged_) {
      const auto time = timeBy(clock, frame);
      placed.ofDamaged.push_back(time && std::isfinite(*time) ? fractionOf(*time) : -1);
    }
    if (placed.frames.size() < 2 || !coversCycle(placed))
      return std::nullopt;
    findMissing(placed);
    placed.intervalMs = clock == Clock::trigger ? length_ : stated_;
    placed.wrongIntervalMs = wrongInterval_;
    placed.stated = expected_ > 1 ? expected_ : 0;
    return placed;
  }

  static bool coversCycle(const CineTimes& placed) {
    std::vector<double> all = placed.fractions;
    std::copy_if(placed.ofDamaged.begin(), placed.ofDamaged.end(), std::back_inserter(all),
                 [](double fraction) { return fraction >= 0; });
    std::sort(all.begin(), all.end());
    const std::vector<double> steps = differences(all);
    const double around = 1 - all.back() + all.front();
    return std::max(around, *std::max_element(steps.begin(), steps.end())) <= kLargestGap;
  }

  /// The distance of phases: by their number where they agree with it.
  double stepOf(const std::vector<double>& fractions) const {
    const double seen = median(differences(fractions)), byNumber = expected_ > 1 ? 1.0 / expected_ : 0;
    return std::abs(seen - byNumber) < kSameStep * byNumber ? byNumber : seen;
  }

  void findMissing(CineTimes& placed) const {
    const std::vector<double>& there = placed.fractions;
    const double step = stepOf(there);
    for (std::size_t i = 1; i < there.size() && placed.missing.size() < kMostMissing; ++i) {
      const double gap = there[i] - there[i - 1];
      const double between = gap > kGapWithMissing * step ? std::round(gap / step) - 1 : 0;
      for (double k = 1; k <= std::min(between, double(kMostMissing)); ++k)
        placed.missing.push_back(there[i - 1] + k * gap / (between + 1));
    }
    const auto known = [&] { return static_cast<int>(there.size() + placed.missing.size()); };
    for (double at = there.front() - step; at > -kSameStep * step && known() < expected_; at -= step)
      placed.missing.push_back(std::max(at, 0.0));
    for (double at = there.back() + step; at < 1 - kSameStep * step && known() < expected_; at += step)
      placed.missing.push_back(at);
    for (const double damaged : placed.ofDamaged)
      if (damaged >= 0 && !hasNear(placed.missing, damaged, 0.5 * step) &&
          !hasNear(there, damaged, kSameFraction))
        placed.missing.push_back(damaged);
    std::sort(placed.missing.begin(), placed.missing.end());
  }

  static bool hasNear(const std::vector<double>& list, double value, double by) {
    return std::any_of(list.begin(), list.end(), [&](double one) { return std::abs(one - value) < by; });
  }

  const FrameList& list_;
  const std::vector<std::size_t>& frames_;
  const std::vector<DicomFrame>& damaged_;
  int expected_ = 0;  ///< Phases of a cycle; 0: not stated.
  double stated_ = 0; ///< Interval, ms; 0: not stated.
  double begin_ = 0, length_ = 1;
  std::optional<double> wrongInterval_;
};

} // namespace

std::optional<CineTimes> cineTimesOf(const FrameList& list, const std::vector<std::size_t>& frames,
                                     const std::vector<DicomFrame>& damaged) {
  return Placing(list, frames, damaged).run();
}

} // namespace viscera::medical_io
