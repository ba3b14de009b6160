#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <utility>

namespace viscera::medical_io {

/// How a number is stored in a file.
enum class Scalar { int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

/// Bytes of one.
std::size_t sizeOf(Scalar scalar);

inline bool isWhole(Scalar scalar) {
  return scalar < Scalar::float32;
}

/// The number at `data`, which may be unaligned; as an integer only for types that are whole.
double loadDouble(const char* data, Scalar scalar, std::endian order);
std::int64_t loadInteger(const char* data, Scalar scalar, std::endian order);

/// The value of `key` in a table, such as a format's names of its types; empty if it is not in the table.
template <class Key, class Value, std::size_t count, class Wanted>
std::optional<Value> lookUp(const std::array<std::pair<Key, Value>, count>& table, const Wanted& key) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const auto& row) { return row.first == key; });
  return found == table.end() ? std::nullopt : std::optional<Value>(found->second);
}

} // namespace viscera::medical_io
