#include "viscera/medical_io/scan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

#include "image_formats/raw_image.h"
#include "scan_sampling.h"
#include "viscera/core/parallel.h"

namespace viscera::medical_io {
namespace {

constexpr Eigen::Index kGrain = Eigen::Index{1} << 20U; ///< Voxels a thread looks at in one go.
constexpr std::size_t kBins = std::size_t{1} << 14U;
constexpr double kInnermost = 0.01; ///< The part of all voxels that a first window leaves out on either side.
constexpr ValueWindow kSoftTissue{40, 400};
/// Air in Hounsfield units, or less around the scanner's circle; bone or metal at the other end.
constexpr double kLeastOfCt = -4096, kAir = -900, kBone = 500;

/// Least and largest measured sample; the first above the second when there is none.
template <class Sample>
std::array<double, 2> sampleRange(const std::vector<Sample>& samples, const Measured<Sample>& measured) {
  std::array<double, 2> range = {std::numeric_limits<double>::infinity(),
                                 -std::numeric_limits<double>::infinity()};
  std::mutex mutex;
  parallelRanges(static_cast<Eigen::Index>(samples.size()), kGrain, {},
                 [&](Eigen::Index begin, Eigen::Index end) {
                   Sample low = std::numeric_limits<Sample>::max();
                   Sample high = std::numeric_limits<Sample>::lowest();
                   bool any = false;
                   for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
                     if (measured(samples[i])) {
                       low = std::min(low, samples[i]);
                       high = std::max(high, samples[i]);
                       any = true;
                     }
                   const std::lock_guard lock(mutex);
                   if (any)
                     range = {std::min(range[0], double(low)), std::max(range[1], double(high))};
                 });
  return range;
}

/// How many measured samples lie in each of `kBins` parts of [low, high], those outside in the outer ones.
template <class Sample>
std::vector<std::uint64_t> histogram(const std::vector<Sample>& samples, const Measured<Sample>& measured,
                                     double low, double high) {
  std::vector<std::uint64_t> counts(kBins, 0);
  const double perBin = kBins / (high - low);
  std::mutex mutex;
  parallelRanges(static_cast<Eigen::Index>(samples.size()), kGrain, {},
                 [&](Eigen::Index begin, Eigen::Index end) {
                   std::vector<std::uint64_t> own(kBins, 0);
                   for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
                     if (measured(samples[i]))
                       ++own[static_cast<std::size_t>(
                           std::clamp((double(samples[i]) - low) * perBin, 0.0, kBins - 1.0))];
                   const std::lock_guard lock(mutex);
                   for (std::size_t b = 0; b < kBins; ++b)
                     counts[b] += own[b];
                 });
  return counts;
}

/// The samples below which the first and the last hundredth lie. A second look, at what lies between the
/// first answers only, makes an outlier harmless.
template <class Sample>
std::array<double, 2> percentiles(const std::vector<Sample>& samples, const Measured<Sample>& measured) {
  std::array<double, 2> range = sampleRange(samples, measured);
  for (int look = 0; look < 2 && range[0] < range[1]; ++look) {
    const std::vector<std::uint64_t> counts = histogram(samples, measured, range[0], range[1]);
    double total = 0;
    for (const std::uint64_t count : counts)
      total += double(count);
    const double width = (range[1] - range[0]) / kBins, begin = range[0];
    double sum = 0;
    std::array<std::optional<double>, 2> found;
    for (std::size_t b = 0; b < kBins; ++b) {
      sum += double(counts[b]);
      if (!found[0] && sum >= kInnermost * total)
        found[0] = begin + width * double(b);
      if (!found[1] && sum >= (1 - kInnermost) * total)
        found[1] = begin + width * double(b + 1);
    }
    range = {*found[0], *found[1]};
  }
  return range;
}

} // namespace

Bounds Scan::bounds() const {
  return boundsOfVoxels(size, indexToLps);
}

double Scan::value(int i, int j, int k) const {
  return std::visit([&](const auto& all) { return slope * double(all[indexOf(i, j, k)]) + intercept; },
                    samples);
}

std::optional<double> Scan::at(const Vec3& lps) const {
  const Vec3 index = indexToLps.linear().inverse() * (lps - indexToLps.translation());
  return std::visit(
      [&]<class Sample>(const std::vector<Sample>& all) -> std::optional<double> {
        const auto sample = TrilinearSampler<Sample>(all, size, padding)(index);
        return sample ? std::optional(slope * *sample + intercept) : std::nullopt;
      },
      samples);
}

std::array<double, 2> Scan::range() const {
  return std::visit(
      [&]<class Sample>(const std::vector<Sample>& all) -> std::array<double, 2> {
        const std::array<double, 2> found = sampleRange(all, Measured<Sample>(padding));
        if (found[0] > found[1])
          return {0, 0};
        const double a = slope * found[0] + intercept, b = slope * found[1] + intercept;
        return {std::min(a, b), std::max(a, b)};
      },
      samples);
}

ValueWindow Scan::firstWindow() const {
  if (window)
    return *window;
  if (modality == "CT")
    return kSoftTissue;
  if (modality.empty()) {
    const std::array<double, 2> all = range();
    if (all[0] >= kLeastOfCt && all[0] <= kAir && all[1] >= kBone)
      return kSoftTissue;
  }
  return std::visit(
      [&]<class Sample>(const std::vector<Sample>& all) -> ValueWindow {
        const std::array<double, 2> found = percentiles(all, Measured<Sample>(padding));
        if (!(found[0] < found[1])) // One value, or none.
          return {found[0] > found[1] ? 0 : slope * found[0] + intercept, 1};
        return {slope * 0.5 * (found[0] + found[1]) + intercept, std::abs(slope) * (found[1] - found[0])};
      },
      samples);
}

} // namespace viscera::medical_io
