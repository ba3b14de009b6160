#pragma once

#include <bit>
#include <cstddef>
#include <string>
#include <string_view>

#include "file_bytes.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {

/// Reads binary data value by value, and throws at its end instead of reading past it.
class ByteCursor {
public:
  /// `data` is a part of `file`, which is named in errors and outlives the cursor.
  ByteCursor(const FileBytes& file, std::string_view data, std::endian order)
      : file_(file), data_(data), order_(order) {}

  std::size_t remaining() const { return data_.size() - at_; }
  std::endian order() const { return order_; }

  /// The next value; `part` names what is read when the data end before it. Throws `DataError`.
  template <typename T>
  T take(std::string_view part) {
    return loadValue<T>(takeBytes(sizeof(T), part).data(), order_);
  }

  /// The next `count` bytes. Throws `DataError` when there are fewer.
  std::string_view takeBytes(std::uint64_t count, std::string_view part) {
    if (count > remaining())
      file_.fail(diagnostic("the file is cut off: %1 should have %2 bytes, but only %3 are left", part, count,
                            remaining()));
    const std::string_view taken = data_.substr(at_, static_cast<std::size_t>(count));
    at_ += static_cast<std::size_t>(count);
    return taken;
  }

private:
  const FileBytes& file_;
  std::string_view data_;
  std::endian order_;
  std::size_t at_ = 0;
};

} // namespace viscera::medical_io
