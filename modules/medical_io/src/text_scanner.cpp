#include "text_scanner.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

bool isSpace(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
}

constexpr std::size_t kLongestQuote = 40;

} // namespace

std::optional<double> parseNumber(std::string_view token) {
  if (token.starts_with('+'))
    token.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size() || token.empty() || error == std::errc::invalid_argument)
    return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    // Too small is as good as zero; too large is reported later as a coordinate that is not finite.
    const bool tiny = token.find("e-") != token.npos || token.find("E-") != token.npos;
    return tiny ? 0.0 : std::numeric_limits<double>::infinity();
  }
  return value;
}

std::optional<std::int64_t> parseInteger(std::string_view token) {
  if (token.starts_with('+'))
    token.remove_prefix(1);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (token.empty() || error != std::errc() || end != token.data() + token.size())
    return std::nullopt;
  return value;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && isSpace(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && isSpace(text.back()))
    text.remove_suffix(1);
  return text;
}

std::string_view takeWord(std::string_view& line) {
  std::size_t begin = 0;
  while (begin < line.size() && isSpace(line[begin]))
    ++begin;
  std::size_t end = begin;
  while (end < line.size() && !isSpace(line[end]))
    ++end;
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

void appendNumber(std::string& out, double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  out.append(buffer, end);
}

void appendNumber(std::string& out, std::int64_t value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  out.append(buffer, end);
}

std::string exactNumber(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 17);
  return {buffer, end.ptr};
}

void TextScanner::skipSpace() {
  while (at_ < text_.size() && isSpace(text_[at_]))
    ++at_;
}

bool TextScanner::atEnd() {
  skipSpace();
  return at_ == text_.size();
}

std::string_view TextScanner::word() {
  skipSpace();
  start_ = at_;
  while (at_ < text_.size() && !isSpace(text_[at_]))
    ++at_;
  return text_.substr(start_, at_ - start_);
}

std::string_view TextScanner::peek() {
  const std::size_t at = at_;
  const std::string_view next = word();
  at_ = at;
  return next;
}

std::string_view TextScanner::line() {
  start_ = at_;
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  std::string_view result = text_.substr(at_, end - at_);
  at_ = std::min(end + 1, text_.size());
  if (result.ends_with('\r'))
    result.remove_suffix(1);
  return result;
}

double TextScanner::number(std::string_view part) {
  const std::string_view token = word();
  if (token.empty())
    failAtEnd(part);
  const std::optional<double> value = parseNumber(token);
  if (!value)
    fail(diagnostic("expected %2, found %1", inQuotes(token), part));
  return *value;
}

double TextScanner::coordinate(std::string_view part) {
  const std::string_view token = word();
  if (token.empty())
    failAtEnd(part);
  return coordinateFrom(token, part);
}

double TextScanner::coordinateFrom(std::string_view word, std::string_view part) {
  const std::size_t comma = word.find(',');
  std::optional<double> value;
  if (comma == word.npos) {
    value = parseNumber(word);
    const bool point = word.find('.') != word.npos;
    marks_.points = marks_.points || point;
    marks_.none = marks_.none || (!point && value != 0.0);
  } else {
    std::string english(word);
    english[comma] = '.';
    value = word.find('.') == word.npos ? parseNumber(english) : std::nullopt;
    if (!value)
      failAtCommas();
    const std::string_view whole = word.substr(0, comma).substr(word.find_first_of("0123456789,"));
    const std::string_view behind = word.substr(comma + 1);
    marks_.commas = true;
    marks_.decimalCommas =
        marks_.decimalCommas || behind.size() != 3 || whole.size() > 3 || whole.starts_with('0');
  }
  if (!value)
    fail(diagnostic("expected %2, found %1", inQuotes(word), part));
  return *value;
}

void TextScanner::failAtCommas() const {
  file_.fail("the commas in its numbers may be decimal marks or separate thousands or numbers",
             "export it with decimal points");
}

void TextScanner::finishCommas(std::vector<Text>& warnings) const {
  if (!marks_.commas)
    return;
  if (marks_.points || (marks_.none && !marks_.decimalCommas))
    failAtCommas();
  warnings.push_back("the commas in its numbers were read as decimal marks");
}

std::int64_t TextScanner::integer(std::string_view part) {
  const std::string_view token = word();
  if (token.empty())
    failAtEnd(part);
  const std::optional<std::int64_t> value = parseInteger(token);
  if (!value)
    fail(diagnostic("expected %2, found %1", inQuotes(token), part));
  return *value;
}

std::uint64_t TextScanner::count(std::string_view part, std::uint64_t bytesEach) {
  const std::int64_t value = integer(part);
  if (value < 0)
    fail(diagnostic("%1 is negative", part));
  if (saturatedProduct(static_cast<std::uint64_t>(value), bytesEach) > remaining() + bytesEach)
    fail(diagnostic("%1 is %2, more than the %3 bytes that are left can hold", part, value, remaining()));
  return static_cast<std::uint64_t>(value);
}

void TextScanner::fail(const Text& problem) const {
  const std::size_t at = static_cast<std::size_t>(text_.data() - file_.bytes.data()) + start_;
  const auto lines =
      std::count(file_.bytes.begin(),
                 file_.bytes.begin() + static_cast<std::ptrdiff_t>(std::min(at, file_.bytes.size())), '\n');
  file_.fail(diagnostic("line %1: %2", lines + 1, problem));
}

void TextScanner::failAtEnd(std::string_view part) const {
  fail(diagnostic("the file is cut off: it ends where %1 should stand", part));
}

Text inQuotes(std::string_view text) {
  std::string shown;
  for (const char c : text.substr(0, kLongestQuote))
    shown += c >= ' ' && c <= '~' ? c : '?';
  if (text.size() > kLongestQuote)
    shown += "...";
  return phrase("\"%1\"", shown);
}

} // namespace viscera::medical_io
