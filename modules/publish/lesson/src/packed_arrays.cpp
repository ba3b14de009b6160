#include "viscera/lesson/packed_arrays.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include <zlib.h>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::lesson {
namespace {

static_assert(std::endian::native == std::endian::little, "floats are written as they lie in memory");

constexpr std::size_t kAlignment = 4;
constexpr std::size_t kInflatedAtOnce = 1 << 16;

/// The fewest bytes that hold all values with their signs.
int widthOf(const std::vector<std::int32_t>& values) {
  std::int64_t most = 0;
  for (const std::int32_t value : values)
    most = std::max(most, value < 0 ? -(std::int64_t(value) + 1) : std::int64_t(value));
  int width = 1;
  while (width < 4 && most >= std::int64_t(1) << (8 * width - 1))
    ++width;
  return width;
}

/// The lowest `width` bytes of `value` as a number with a sign.
std::int32_t wrapped(std::int64_t value, int width) {
  const int unused = 32 - 8 * width;
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(value) << unused) >> unused;
}

} // namespace

std::size_t ArrayPacker::begin() {
  bytes_.resize((bytes_.size() + kAlignment - 1) / kAlignment * kAlignment, '\0');
  return bytes_.size();
}

PackedArray ArrayPacker::add(const std::vector<std::int32_t>& values, int stride) {
  const PackedArray array{begin(), values.size(), widthOf(values), stride, 1};
  bytes_.resize(array.at + values.size() * static_cast<std::size_t>(array.width));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto back = static_cast<std::size_t>(stride);
    const std::int64_t before = i >= back ? values[i - back] : 0;
    const std::int32_t change = wrapped(values[i] - before, array.width);
    const std::uint32_t zigzag =
        (static_cast<std::uint32_t>(change) << 1) ^ static_cast<std::uint32_t>(change >> 31);
    for (int plane = 0; plane < array.width; ++plane)
      bytes_[array.at + static_cast<std::size_t>(plane) * values.size() + i] =
          static_cast<char>(zigzag >> (8 * plane));
  }
  return array;
}

std::vector<std::int32_t> wholeSteps(const std::vector<double>& values, double step) {
  std::vector<std::int32_t> whole(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double steps = std::round(values[i] / step);
    if (!(std::abs(steps) < std::numeric_limits<std::int32_t>::max()))
      throw DataError(misuse("a number does not fit into a lesson: %1", std::to_string(values[i])), {},
                      "check the size of the organ, and its motion");
    whole[i] = static_cast<std::int32_t>(steps);
  }
  return whole;
}

PackedArray ArrayPacker::add(const std::vector<double>& values, int stride, double step) {
  PackedArray array = add(wholeSteps(values, step), stride);
  array.step = step;
  return array;
}

PackedArray ArrayPacker::addFloats(const std::vector<float>& values) {
  const PackedArray array{begin(), values.size(), 4, 0, 0};
  bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
  return array;
}

std::vector<double> unpacked(const PackedArray& array, const std::string& bytes) {
  const auto width = static_cast<std::size_t>(array.width);
  if (array.at + array.count * width > bytes.size())
    throw DataError(misuse("an array of the lesson ends behind its bytes"));
  std::vector<double> values(array.count);
  if (array.step == 0) {
    for (std::size_t i = 0; i < array.count; ++i) {
      float value = 0;
      std::memcpy(&value, bytes.data() + array.at + 4 * i, sizeof value);
      values[i] = value;
    }
    return values;
  }
  std::vector<std::int32_t> whole(array.count);
  for (std::size_t i = 0; i < array.count; ++i) {
    std::uint32_t zigzag = 0;
    for (std::size_t plane = 0; plane < width; ++plane)
      zigzag |=
          static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[array.at + plane * array.count + i]))
          << (8 * plane);
    const std::int64_t change = static_cast<std::int32_t>((zigzag >> 1) ^ (~(zigzag & 1) + 1));
    const auto back = static_cast<std::size_t>(array.stride);
    whole[i] = wrapped(change + (i >= back ? whole[i - back] : 0), array.width);
    values[i] = whole[i] * array.step;
  }
  return values;
}

std::string deflated(const std::string& bytes) {
  uLongf size = compressBound(bytes.size());
  std::string result(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(result.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), Z_BEST_COMPRESSION) != Z_OK)
    throw std::bad_alloc();
  result.resize(size);
  return result;
}

std::string inflated(const std::string& bytes) {
  z_stream stream = {};
  if (inflateInit(&stream) != Z_OK)
    throw std::bad_alloc();
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string result;
  std::array<char, kInflatedAtOnce> part;
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(part.data());
    stream.avail_out = part.size();
    state = ::inflate(&stream, Z_NO_FLUSH);
    result.append(part.data(), part.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END)
    throw DataError(misuse("the arrays of the lesson cannot be unpacked"));
  return result;
}

} // namespace viscera::lesson
