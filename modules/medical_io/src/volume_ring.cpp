#include "volume_ring.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "viscera/core/parallel.h"

namespace viscera::medical_io {
namespace {

/// Steps from the least value to the largest; the lowest sample is left for what is no measurement.
constexpr double kSteps = 65000;
constexpr std::int16_t kNoMeasurement = -32768;
constexpr double kLowest = -32500;

} // namespace

std::size_t bytesOfSamples(const Scan& scan) {
  return std::visit(
      [](const auto& samples) {
        return samples.size() * sizeof(typename std::decay_t<decltype(samples)>::value_type);
      },
      scan.samples);
}

Scan inSixteenBits(Scan&& scan) {
  const std::array<double, 2> range = scan.range();
  const double least = std::isfinite(range[0]) ? range[0] : 0;
  const double width = std::isfinite(range[1]) && range[1] > least ? range[1] - least : 1;
  const double step = width / kSteps;
  std::vector<std::int16_t> samples(scan.voxelCount());
  std::visit(
      [&](const auto& values) {
        parallelRanges(
            static_cast<Eigen::Index>(values.size()), 1 << 16, {}, [&](Eigen::Index begin, Eigen::Index end) {
              for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
                const auto stored = static_cast<double>(values[i]);
                const double value = scan.slope * stored + scan.intercept;
                const bool measured = std::isfinite(value) && !(scan.padding && stored == *scan.padding);
                samples[i] = measured ? static_cast<std::int16_t>(std::lround(
                                            kLowest + std::clamp((value - least) / step, 0.0, kSteps)))
                                      : kNoMeasurement;
              }
            });
      },
      scan.samples);
  scan.samples = std::move(samples);
  scan.slope = step;
  scan.intercept = least - kLowest * step;
  scan.padding = double(kNoMeasurement);
  return std::move(scan);
}

VolumeRing::Volume VolumeRing::find(std::size_t phase) {
  const auto place =
      std::find_if(kept_.begin(), kept_.end(), [phase](const Kept& one) { return one.phase == phase; });
  if (place == kept_.end())
    return nullptr;
  kept_.splice(kept_.begin(), kept_, place);
  return kept_.front().volume;
}

VolumeRing::Volume VolumeRing::get(std::size_t phase, const std::function<Scan()>& decode) {
  {
    const std::lock_guard lock(mutex_);
    if (Volume volume = find(phase))
      return volume;
  }
  return keep(phase, decode());
}

VolumeRing::Volume VolumeRing::keep(std::size_t phase, Scan&& scan) {
  const auto made = std::make_shared<const Scan>(std::move(scan));
  const std::lock_guard lock(mutex_);
  if (Volume volume = find(phase))
    return volume;
  kept_.push_front({phase, made});
  held_ += bytesOfSamples(*made);
  while (held_ > most_ && kept_.size() > 1) {
    held_ -= bytesOfSamples(*kept_.back().volume);
    kept_.pop_back();
  }
  return made;
}

void VolumeRing::drop(std::size_t phase) {
  const std::lock_guard lock(mutex_);
  if (find(phase)) {
    held_ -= bytesOfSamples(*kept_.front().volume);
    kept_.pop_front();
  }
}

std::size_t VolumeRing::heldBytes() const {
  const std::lock_guard lock(mutex_);
  return held_;
}

} // namespace viscera::medical_io
