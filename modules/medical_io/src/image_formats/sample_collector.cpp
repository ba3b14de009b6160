#include "image_formats/sample_collector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace viscera::medical_io {
namespace {

Scan::Samples emptySamples(Scalar stated) {
  switch (stated) {
  case Scalar::int8:
    return std::vector<std::int8_t>();
  case Scalar::uint8:
    return std::vector<std::uint8_t>();
  case Scalar::int16:
    return std::vector<std::int16_t>();
  case Scalar::uint16:
    return std::vector<std::uint16_t>();
  case Scalar::uint32:
    return std::vector<std::uint32_t>();
  case Scalar::int32:
  case Scalar::int64:
  case Scalar::uint64:
    return std::vector<std::int32_t>();
  default:
    return std::vector<float>();
  }
}

template <class Sample>
bool isStoredAs(Scalar scalar) {
  switch (scalar) {
  case Scalar::int8:
    return std::is_same_v<Sample, std::int8_t>;
  case Scalar::uint8:
    return std::is_same_v<Sample, std::uint8_t>;
  case Scalar::int16:
    return std::is_same_v<Sample, std::int16_t>;
  case Scalar::uint16:
    return std::is_same_v<Sample, std::uint16_t>;
  case Scalar::int32:
    return std::is_same_v<Sample, std::int32_t>;
  case Scalar::uint32:
    return std::is_same_v<Sample, std::uint32_t>;
  case Scalar::float32:
    return std::is_same_v<Sample, float>;
  default:
    return false;
  }
}

template <class Sample>
bool fits(double value) {
  if constexpr (std::is_integral_v<Sample>)
    return value >= double(std::numeric_limits<Sample>::min()) &&
           value <= double(std::numeric_limits<Sample>::max()) && value == std::floor(value);
  return true;
}

/// Appends values as long as they fit; gives how many.
template <class Sample>
std::size_t append(std::vector<Sample>& samples, const char* bytes, std::size_t count, Scalar scalar,
                   std::endian order) {
  if (isStoredAs<Sample>(scalar) && order == std::endian::native) {
    const auto* first = reinterpret_cast<const Sample*>(bytes); // Blocks are aligned.
    samples.insert(samples.end(), first, first + count);
    return count;
  }
  const std::size_t width = sizeOf(scalar);
  for (std::size_t i = 0; i < count; ++i) {
    const double value = loadDouble(bytes + i * width, scalar, order);
    if (!fits<Sample>(value))
      return i;
    samples.push_back(static_cast<Sample>(value));
  }
  return count;
}

} // namespace

SampleCollector::SampleCollector(Scalar stated) : samples_(emptySamples(stated)) {}

void SampleCollector::reserve(std::size_t count) {
  std::visit([count](auto& samples) { samples.reserve(count); }, samples_);
}

void SampleCollector::take(const char* bytes, std::size_t count, Scalar scalar, std::endian order) {
  const std::size_t taken =
      std::visit([&](auto& samples) { return append(samples, bytes, count, scalar, order); }, samples_);
  if (taken == count)
    return;
  rounded_ = true;
  std::vector<float> fractions;
  std::visit(
      [&](auto& samples) {
        fractions.reserve(samples.capacity());
        for (const auto sample : samples)
          fractions.push_back(static_cast<float>(sample));
      },
      samples_);
  append(fractions, bytes + taken * sizeOf(scalar), count - taken, scalar, order);
  samples_ = std::move(fractions);
}

} // namespace viscera::medical_io
