#include "slice_values.h"

#include <algorithm>
#include <cmath>

namespace viscera::presentation {
namespace {

/// Diagonal lines, white beside black so that they are seen on any tissue; device pixels.
constexpr std::size_t kHatchPeriod = 8, kHatchWhite = 2, kHatchBlack = 3;

/// So many of the eight pixels around one are folded, too, where it is hatched.
constexpr int kFoldedAround = 3;

bool isFolded(deformation::RestState state) {
  return state == deformation::RestState::folded;
}

} // namespace

void SliceValues::take(const medical_io::Scan& scan, const medical_io::SliceFrame& frame,
                       const medical_io::SampleOptions& options, const Warping* warping) {
  rest_.states.clear();
  if (warping)
    warping->rest({frame.corner, frame.right, frame.up, frame.width, frame.height}, rest_);
  findHatched(static_cast<std::size_t>(frame.width));
  medical_io::sampleSlice(scan, frame, options, values_, warping ? &rest_.points : nullptr);
}

void SliceValues::clear() {
  values_ = {};
  rest_ = {};
  hatched_.clear();
}

/// A line of single pixels is no fold: there tissue is pressed so thin that no place is found, and a slice a
/// little beside it shows it whole.
void SliceValues::findHatched(std::size_t width) {
  hatched_.clear();
  if (std::none_of(rest_.states.begin(), rest_.states.end(), isFolded))
    return;
  const std::size_t height = rest_.states.size() / width;
  const auto folded = [&](std::size_t x, std::size_t y) { return isFolded(rest_.states[y * width + x]); };
  hatched_.assign(rest_.states.size(), 0);
  bool any = false;
  for (std::size_t y = 0; y < height; ++y)
    for (std::size_t x = 0; x < width; ++x) {
      if (!folded(x, y))
        continue;
      int around = -1; // Without itself.
      for (std::size_t v = y - std::min<std::size_t>(y, 1); v < std::min(y + 2, height); ++v)
        for (std::size_t u = x - std::min<std::size_t>(x, 1); u < std::min(x + 2, width); ++u)
          around += folded(u, v) ? 1 : 0;
      hatched_[y * width + x] = around >= kFoldedAround ? 1 : 0;
      any = any || around >= kFoldedAround;
    }
  if (!any)
    hatched_.clear();
}

void SliceValues::shade(const medical_io::ValueWindow& window, std::vector<std::uint8_t>& grey,
                        Threads threads) const {
  constexpr std::uint8_t kWhite = 255;
  medical_io::greyOf(values_, window, 0, grey, threads);
  if (hatched_.empty())
    return;
  const auto width = static_cast<std::size_t>(values_.width);
  for (std::size_t i = 0; i < hatched_.size(); ++i)
    if (const std::size_t stripe = (i % width + i / width) % kHatchPeriod;
        hatched_[i] != 0 && stripe < kHatchBlack)
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
