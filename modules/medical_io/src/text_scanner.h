#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "file_bytes.h"

#include "viscera/core/phrase.h"

namespace viscera::medical_io {

/// Parses `token` as a number ("1", "-2.5e3", "nan", "inf"), independently of the locale; empty if it is
/// none.
std::optional<double> parseNumber(std::string_view token);
/// Parses `token` as a whole number; empty if it is none or does not fit.
std::optional<std::int64_t> parseInteger(std::string_view token);
/// `text` without white space around it.
std::string_view trimmed(std::string_view text);
/// The first white-space separated word of `line`, which is shortened by it; empty at the end.
std::string_view takeWord(std::string_view& line);
/// The shortest text that reads back as the same number.
void appendNumber(std::string& out, double value);
void appendNumber(std::string& out, std::int64_t value);

/// Seventeen digits, which name one double only, always with a point.
std::string exactNumber(double value);

/// Reads a text by words or by lines, and keeps the line number for messages.
class TextScanner {
public:
  /// `text` is a part of `file`, which is named in errors and outlives the scanner.
  /// A byte order mark at its beginning is skipped.
  TextScanner(const FileBytes& file, std::string_view text)
      : file_(file), text_(text), at_(text.starts_with("\xef\xbb\xbf") ? 3 : 0) {}

  bool atEnd();
  /// The next word; empty at the end.
  std::string_view word();
  /// The rest of the line, without its end; empty at the end of the text.
  std::string_view line();
  /// The next word without moving on.
  std::string_view peek();

  /// The next word as a number; `part` names what is read. Throws `DataError` with the line's number.
  double number(std::string_view part);
  /// The next word as a coordinate, whose decimal mark may be a comma (`finishCommas`).
  double coordinate(std::string_view part);
  /// `word`, which was read, as a coordinate; `part` names it.
  double coordinateFrom(std::string_view word, std::string_view part);
  /// Says in a warning that coordinates have decimal commas. Throws `DataError` when the commas may separate
  /// thousands: some coordinates have points, or all commas stand before three digits and not every
  /// coordinate has one.
  void finishCommas(std::vector<Text>& warnings) const;
  std::int64_t integer(std::string_view part);
  /// A number of things that is not negative and of which each takes `bytesEach` bytes or more of what is
  /// left.
  std::uint64_t count(std::string_view part, std::uint64_t bytesEach);

  std::size_t position() const { return at_; }
  void moveTo(std::size_t position) { at_ = position; }
  std::size_t remaining() const { return text_.size() - at_; }
  std::string_view rest() const { return text_.substr(at_); }

  /// Throws `DataError` that names the line last read from.
  [[noreturn]] void fail(const Text& problem) const;
  /// The same for a text that ends too early.
  [[noreturn]] void failAtEnd(std::string_view part) const;

private:
  void skipSpace();
  [[noreturn]] void failAtCommas() const;

  /// The forms of the coordinates so far.
  struct DecimalMarks {
    bool points = false;
    bool commas = false;
    bool decimalCommas = false; ///< Commas that cannot separate thousands.
    bool none = false;          ///< Numbers other than 0 without a mark.
  };
  const FileBytes& file_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t start_ = 0; ///< Of the word or line last read.
  DecimalMarks marks_;
};

/// `text` shortened and made printable, in quotes, for messages.
Text inQuotes(std::string_view text);

} // namespace viscera::medical_io
