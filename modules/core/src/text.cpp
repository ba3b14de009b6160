#include "viscera/core/text.h"

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <istream>
#include <system_error>

#include "viscera/core/error.h"

namespace viscera {
namespace {

// Not printf, which follows the locale: a reader's script expects a point.
std::string written(double value, std::chars_format format, int digits) {
  char buffer[512];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value, format, digits);
  return error == std::errc() ? std::string(buffer, end) : std::string("?");
}

/// The bytes of the character that a text begins with; 0 when that is none. The text is not empty.
std::size_t lengthOfFirst(std::string_view text) {
  const auto byte = [text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80)
    return 1;
  const std::size_t length = lead >= 0xC2 && lead < 0xE0   ? 2
                             : lead >= 0xE0 && lead < 0xF0 ? 3
                             : lead >= 0xF0 && lead < 0xF5 ? 4
                                                           : 0;
  if (length == 0 || text.size() < length)
    return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80)
      return 0;
  const unsigned char second = byte(1);
  const bool overlong = (lead == 0xE0 && second < 0xA0) || (lead == 0xF0 && second < 0x90);
  const bool surrogate = lead == 0xED && second >= 0xA0;
  const bool tooLarge = lead == 0xF4 && second >= 0x90;
  return overlong || surrogate || tooLarge ? 0 : length;
}

} // namespace

std::string fixed(double value, int digits) {
  return written(value, std::chars_format::fixed, digits);
}

std::string significant(double value, int digits) {
  return written(value, std::chars_format::general, digits);
}

bool isUtf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = lengthOfFirst(text);
    if (length == 0)
      return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string toUtf8(std::string text) {
  if (isUtf8(text))
    return text;
  std::string valid;
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t length = lengthOfFirst(rest);
    if (length > 0) {
      valid += rest.substr(0, length);
    } else {
      const auto latin1 = static_cast<unsigned char>(rest.front());
      valid += static_cast<char>(0xC0 | (latin1 >> 6));
      valid += static_cast<char>(0x80 | (latin1 & 0x3F));
    }
    rest.remove_prefix(length > 0 ? length : 1);
  }
  return valid;
}

std::string withoutControls(std::string text) {
  std::size_t kept = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const bool isC0 = byte(at) < ' ' && text[at] != '\n' && text[at] != '\t';
    if (isC0 || byte(at) == 0x7F)
      continue;
    if (byte(at) == 0xC2 && at + 1 < text.size() && byte(at + 1) >= 0x80 && byte(at + 1) < 0xA0) {
      ++at;
      continue;
    }
    text[kept++] = text[at];
  }
  text.resize(kept);
  return text;
}

std::string printableName(std::string text) {
  text = withoutControls(toUtf8(std::move(text)));
  for (char& c : text)
    if (c == '\n' || c == '\t')
      c = ' ';
  const std::size_t begin = text.find_first_not_of(' ');
  return begin == text.npos ? std::string() : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

std::string restOf(std::istream& stream, const std::string& where) {
  constexpr std::size_t kBlock = std::size_t{1} << 16U;
  std::string text;
  // `read` notes what the buffer throws; the iterators of stream buffers would let it through.
  while (stream) {
    const std::size_t before = text.size();
    text.resize(before + kBlock);
    stream.read(text.data() + before, static_cast<std::streamsize>(kBlock));
    text.resize(before + static_cast<std::size_t>(stream.gcount()));
  }
  requireReadToEnd(stream, where);
  return text;
}

void requireReadToEnd(const std::istream& stream, const std::string& where) {
  if (stream.bad())
    throw NoInputError("It cannot be read to its end", where, "check the disk or the connection");
}

} // namespace viscera
