#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

namespace viscera {

/// `value` with that many digits after the point, always with a point, whatever the locale: "83.4". No
/// errors; from any thread.
std::string fixed(double value, int digits);
/// `value` with that many significant digits, likewise: "3.1e-15".
std::string significant(double value, int digits = 3);

/// A text as a field of comma-separated values (RFC 4180): quoted where it needs it.
inline std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos)
    return text;
  std::string quoted = "\"";
  for (const char letter : text)
    quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
}

/// Whether a text is UTF-8 as defined by RFC 3629: no overlong forms, surrogates or numbers above 10FFFF.
/// O(n).
bool isUtf8(std::string_view text);

/// Text from a file, from the command line or from the system, as UTF-8. Bytes that are not UTF-8 are read as
/// Latin-1, so that different texts stay different. O(n).
std::string toUtf8(std::string text);

/// The text without control characters (C0, DEL, C1 in UTF-8) but line breaks and tabs, so that no text of a
/// file commands a terminal. O(n).
std::string withoutControls(std::string text);

/// The name of something in a file, for lists, messages and the window: UTF-8 on one line, without control
/// characters and without white space around it. Line breaks and tabs become spaces. O(n).
std::string printableName(std::string text);

/// All bytes of a stream from its present place to its end; nothing from one that was never opened. O(n).
/// Throws `NoInputError` with `where`, the name of the file, when reading fails before the end (a disk or a
/// connection that is gone), so that no file is taken for a shorter one.
std::string restOf(std::istream& stream, const std::string& where);
/// Throws as `restOf` when reading of a stream has failed before its end, for readers of single lines.
void requireReadToEnd(const std::istream& stream, const std::string& where);

} // namespace viscera
