#include "slice_values.h"

#include <algorithm>
#include <cmath>

namespace viscera::presentation {
namespace {

/// Diagonal lines, white beside black so that they are seen on any tissue; device pixels.
constexpr std::size_t kHatchPeriod = 8, kHatchWhite = 2, kHatchBlack = 3;

bool isFolded(deformation::RestState state) {
  return state == deformation::RestState::folded;
}

} // namespace

void SliceValues::take(const medical_io::Scan& scan, const slices::SliceFrame& frame,
                       const slices::SampleOptions& options, const Bending* bending) {
  rest_.states.clear();
  if (bending)
    bending->rest({frame.corner, frame.right, frame.up, frame.width, frame.height}, rest_);
  anyFolded_ = std::any_of(rest_.states.begin(), rest_.states.end(), isFolded);
  slices::sampleSlice(scan, frame, options, values_, bending ? &rest_.points : nullptr);
}

void SliceValues::clear() {
  values_ = {};
  rest_ = {};
  anyFolded_ = false;
}

void SliceValues::shade(const medical_io::ValueWindow& window, std::vector<std::uint8_t>& grey,
                        Threads threads) const {
  constexpr std::uint8_t kWhite = 255;
  slices::greyOf(values_, window, 0, grey, threads);
  if (!anyFolded_)
    return;
  const auto width = static_cast<std::size_t>(values_.width);
  for (std::size_t i = 0; i < rest_.states.size(); ++i)
    if (const std::size_t stripe = (i % width + i / width) % kHatchPeriod;
        isFolded(rest_.states[i]) && stripe < kHatchBlack)
      grey[i] = stripe < kHatchWhite ? kWhite : 0;
}

std::optional<std::size_t> SliceValues::indexOf(long x, long y) const {
  if (values_.values.empty() || x < 0 || y < 0 || x >= values_.width || y >= values_.height)
    return std::nullopt;
  return static_cast<std::size_t>(y * values_.width + x);
}

std::optional<double> SliceValues::at(long x, long y) const {
  const auto index = indexOf(x, y);
  if (!index || std::isnan(values_.values[*index]))
    return std::nullopt;
  return values_.values[*index];
}

bool SliceValues::foldedAt(long x, long y) const {
  const auto index = indexOf(x, y);
  return index && *index < rest_.states.size() && isFolded(rest_.states[*index]);
}

} // namespace viscera::presentation
