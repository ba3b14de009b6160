#include "image_formats/numbered_values.h"

#include <algorithm>
#include <limits>
#include <type_traits>

#include "viscera/core/parallel.h"

namespace viscera::medical_io {
namespace {

constexpr std::size_t kMostNumbers = std::size_t{1} << 16U;
constexpr std::size_t kReleasedAtOnce = std::size_t{1} << 16U;
constexpr Eigen::Index kMappedAtOnce = Eigen::Index{1} << 20U;

/// Replaces each number by that in `table`.
template <class To, class From>
void mapInto(std::vector<To>& to, const std::vector<From>& from, const std::vector<std::uint16_t>& table) {
  parallelRanges(static_cast<Eigen::Index>(from.size()), kMappedAtOnce, {},
                 [&](Eigen::Index begin, Eigen::Index end) {
                   for (auto v = static_cast<std::size_t>(begin); v < static_cast<std::size_t>(end); ++v)
                     to[v] = static_cast<To>(table[from[v]]);
                 });
}

} // namespace

template <class Bits>
std::uint32_t& ValueNumbering::numberOf(Bits bits) {
  if constexpr (sizeof(Bits) > sizeof(std::uint16_t))
    return ofLarge_[bits];
  if (ofSmall_.empty())
    ofSmall_.assign(std::size_t{1} << (8 * std::min(sizeof(Bits), sizeof(std::uint16_t))), 0);
  return ofSmall_[static_cast<std::size_t>(bits)];
}

template <class Bits>
std::size_t ValueNumbering::takeAs(const char* bytes, std::size_t count, Scalar scalar, std::endian order,
                                   const Accept& accept, const Run& run) {
  for (std::size_t begin = 0; begin < count;) {
    const char* at = bytes + begin * sizeof(Bits);
    Bits bits;
    std::memcpy(&bits, at, sizeof(Bits));
    std::uint32_t& number = numberOf(bits);
    if (number == 0) {
      const double value = loadDouble(at, scalar, order);
      if (values_.size() == kMostNumbers || !accept(value))
        return begin;
      values_.push_back(value);
      std::memcpy(stored_.emplace_back().data(), at, sizeof(Bits));
      number = static_cast<std::uint32_t>(values_.size());
    }
    const std::size_t end = endOfRun<Bits>(bytes, begin, count);
    run(number - 1, end - begin);
    begin = end;
  }
  return count;
}

std::size_t ValueNumbering::take(const char* bytes, std::size_t count, Scalar scalar, std::endian order,
                                 const Accept& accept, const Run& run) {
  switch (sizeOf(scalar)) {
  case 1:
    return takeAs<std::uint8_t>(bytes, count, scalar, order, accept, run);
  case 2:
    return takeAs<std::uint16_t>(bytes, count, scalar, order, accept, run);
  case 4:
    return takeAs<std::uint32_t>(bytes, count, scalar, order, accept, run);
  default:
    return takeAs<std::uint64_t>(bytes, count, scalar, order, accept, run);
  }
}

void VoxelNumbers::reserve(std::size_t voxels) {
  reserved_ = voxels;
  if (wide_)
    words_.reserve(voxels);
  else
    bytes_.reserve(voxels);
}

void VoxelNumbers::append(std::size_t number, std::size_t length) {
  if (!wide_ && number > std::numeric_limits<std::uint8_t>::max()) {
    words_.reserve(std::max(reserved_, bytes_.size() + length));
    words_.assign(bytes_.begin(), bytes_.end());
    bytes_ = {};
    wide_ = true;
  }
  if (wide_)
    words_.resize(words_.size() + length, static_cast<std::uint16_t>(number));
  else
    bytes_.resize(bytes_.size() + length, static_cast<std::uint8_t>(number));
}

LabelLayer VoxelNumbers::mapped(const std::vector<std::uint16_t>& table) {
  const std::uint16_t largest =
      table.empty() ? std::uint16_t{0} : *std::max_element(table.begin(), table.end());
  if (wide_) {
    mapInto(words_, words_, table);
    return LabelLayer(std::move(words_));
  }
  if (largest > std::numeric_limits<std::uint8_t>::max()) {
    words_.resize(bytes_.size());
    mapInto(words_, bytes_, table);
    bytes_ = {};
    return LabelLayer(std::move(words_));
  }
  mapInto(bytes_, bytes_, table);
  return LabelLayer(std::move(bytes_));
}

void VoxelNumbers::release(const std::vector<ValueNumbering::Stored>& stored, std::size_t width,
                           const std::function<void(const char* bytes, std::size_t count)>& visit) {
  const auto hand = [&](const auto& numbers) {
    std::vector<std::uint64_t> block(kReleasedAtOnce); // Aligned for values of any size.
    char* bytes = reinterpret_cast<char*>(block.data());
    for (std::size_t begin = 0; begin < numbers.size(); begin += kReleasedAtOnce) {
      const std::size_t count = std::min(kReleasedAtOnce, numbers.size() - begin);
      for (std::size_t v = 0; v < count; ++v)
        std::memcpy(bytes + v * width, stored[numbers[begin + v]].data(), width);
      visit(bytes, count);
    }
  };
  wide_ ? hand(words_) : hand(bytes_);
  *this = {};
}

} // namespace viscera::medical_io
