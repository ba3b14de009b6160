#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

#include "file_bytes.h"
#include "text_scanner.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {

/// Reads the numbers of a gmsh file, which are words or binary, in sections between `$Name` and `$EndName`.
class GmshValues {
public:
  explicit GmshValues(const FileBytes& file) : file_(file), scanner_(file, file.view()) {}

  /// Makes `integer`, `whole` and `number` read binary values in that order of bytes.
  void makeBinary(std::endian order) {
    binary_ = true;
    order_ = order;
  }
  bool isBinary() const { return binary_; }
  std::endian order() const { return order_; }

  /// Words and lines, also of a binary file.
  TextScanner& text() { return scanner_; }

  /// 4 bytes.
  std::int64_t integer(std::string_view part) {
    return binary_ ? take<std::int32_t>(part) : scanner_.integer(part);
  }
  /// 8 bytes.
  std::int64_t whole(std::string_view part) {
    return binary_ ? take<std::int64_t>(part) : scanner_.integer(part);
  }
  double number(std::string_view part) { return binary_ ? take<double>(part) : scanner_.number(part); }

  /// A number of things of at least so many bytes or words each. Throws `DataError` when it is negative or
  /// more than there is room for.
  std::uint64_t checkedCount(std::int64_t count, std::uint64_t bytesEach, std::string_view part) const {
    if (count < 0 || saturatedProduct(static_cast<std::uint64_t>(count), bytesEach) > scanner_.remaining())
      scanner_.fail(diagnostic("%1 is %2, more than the %3 bytes that are left can hold", part, count,
                               scanner_.remaining()));
    return static_cast<std::uint64_t>(count);
  }

  /// The next value of a binary file.
  template <class Number>
  Number take(std::string_view part) {
    if (scanner_.remaining() < sizeof(Number))
      scanner_.failAtEnd(part);
    const auto value = loadValue<Number>(scanner_.rest().data(), order_);
    scanner_.moveTo(scanner_.position() + sizeof(Number));
    return value;
  }

  /// Goes behind `$End` and that name. Throws `DataError` when it is missing.
  void skipToEnd(std::string_view section) {
    const std::string end = "$End" + std::string(section);
    const std::size_t at = scanner_.rest().find(end);
    if (at == std::string_view::npos)
      file_.fail(diagnostic("the file is cut off: %1 is missing", inQuotes(end)));
    scanner_.moveTo(scanner_.position() + at + end.size());
  }

private:
  const FileBytes& file_;
  TextScanner scanner_;
  bool binary_ = false;
  std::endian order_ = std::endian::little;
};

} // namespace viscera::medical_io
