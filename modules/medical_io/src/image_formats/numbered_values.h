#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <unordered_map>
#include <vector>

#include "scalar.h"
#include "viscera/medical_io/label_layer.h"

/// Stored values of an image as numbers of the different ones, block by block as they are read.
namespace viscera::medical_io {

/// Returns the end of the equal values that begin at `begin` of `count` values of one size, at any address.
/// O(length), eight bytes at a time.
template <class Bits>
std::size_t endOfRun(const char* values, std::size_t begin, std::size_t count) {
  constexpr std::size_t kWord = sizeof(std::uint64_t), kInWord = kWord / sizeof(Bits);
  std::array<char, kWord> repeated;
  for (std::size_t i = 0; i < kWord; i += sizeof(Bits))
    std::memcpy(repeated.data() + i, values + begin * sizeof(Bits), sizeof(Bits));
  const auto pattern = std::bit_cast<std::uint64_t>(repeated);
  std::size_t end = begin + 1;
  for (std::uint64_t word = 0; end + kInWord <= count; end += kInWord) {
    std::memcpy(&word, values + end * sizeof(Bits), kWord);
    if (word != pattern)
      break;
  }
  while (end < count && std::memcmp(values + end * sizeof(Bits), repeated.data(), sizeof(Bits)) == 0)
    ++end;
  return end;
}

/// Numbers the different values of an image in the order in which they come.
class ValueNumbering {
public:
  /// The bytes of a value as the file stores them, from the first on.
  using Stored = std::array<char, sizeof(std::uint64_t)>;
  /// Whether a value that is new, as `loadDouble` gives it, gets a number.
  using Accept = std::function<bool(double value)>;
  /// Told of `length` equal values that follow one another; a longer run may come in parts.
  using Run = std::function<void(std::size_t number, std::size_t length)>;

  /// Numbers the next values, of one type and byte order in all calls. Gives how many it took: all, or those
  /// before the first that `accept` refuses. No more than 65,536 values are accepted.
  std::size_t take(const char* bytes, std::size_t count, Scalar scalar, std::endian order,
                   const Accept& accept, const Run& run);

  /// The values that have numbers, by their numbers: as stored, and as `loadDouble` gives them.
  const std::vector<Stored>& stored() const { return stored_; }
  const std::vector<double>& values() const { return values_; }

private:
  template <class Bits>
  std::size_t takeAs(const char* bytes, std::size_t count, Scalar scalar, std::endian order,
                     const Accept& accept, const Run& run);
  template <class Bits>
  std::uint32_t& numberOf(Bits bits);

  std::vector<Stored> stored_;
  std::vector<double> values_;
  std::vector<std::uint32_t> ofSmall_; ///< Number + 1 of each value of one or two bytes.
  std::unordered_map<std::uint64_t, std::uint32_t> ofLarge_; ///< The same of larger ones.
};

/// The numbers of the values of many voxels. One byte each up to 256 different ones, else two.
class VoxelNumbers {
public:
  void reserve(std::size_t voxels);
  void append(std::size_t number, std::size_t length);

  /// The layer in which each number is replaced by that in `table`, in the same memory where it can be.
  /// Leaves nothing here. On all threads.
  LabelLayer mapped(const std::vector<std::uint16_t>& table);
  /// Hands the values on as the file stores them, block by block, each of `width` bytes and aligned. Leaves
  /// nothing here.
  void release(const std::vector<ValueNumbering::Stored>& stored, std::size_t width,
               const std::function<void(const char* bytes, std::size_t count)>& visit);

private:
  std::vector<std::uint8_t> bytes_;
  std::vector<std::uint16_t> words_; ///< Instead of `bytes_`, where a number needs it.
  std::size_t reserved_ = 0;
  bool wide_ = false;
};

} // namespace viscera::medical_io
