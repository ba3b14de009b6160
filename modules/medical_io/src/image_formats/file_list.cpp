#include "image_formats/file_list.h"

#include <array>
#include <cstdint>
#include <optional>

#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

constexpr std::int64_t kMostDataFiles = 65535;
constexpr std::size_t kWidestNumber = 18; ///< Digits.

/// A name with a number in it.
struct NamePattern {
  std::string before, after;
  std::size_t width = 0; ///< Of the number, at least.
  char filling = ' ';

  std::string nameOf(std::int64_t number) const {
    std::string digits = std::to_string(number);
    if (digits.size() < width)
      digits.insert(0, width - digits.size(), filling);
    return before + digits + after;
  }
};

/// Reads "%d", "%3d", "%03d", "%.3d", also with i and u; "%%" is a per cent sign.
std::optional<NamePattern> patternOf(std::string_view text) {
  NamePattern pattern;
  bool found = false;
  while (!text.empty()) {
    std::string& plain = found ? pattern.after : pattern.before;
    if (text.front() != '%' || text.starts_with("%%")) {
      plain += text.front();
      text.remove_prefix(text.front() == '%' ? 2 : 1);
      continue;
    }
    text.remove_prefix(1);
    pattern.filling = text.starts_with('0') || text.starts_with('.') ? '0' : ' ';
    const std::size_t end = text.find_first_not_of(".0123456789");
    if (found || end == text.npos || std::string_view("diu").find(text[end]) == std::string_view::npos)
      return std::nullopt;
    std::string_view width = text.substr(0, end);
    width.remove_prefix(width.starts_with('.') ? 1 : 0);
    const std::int64_t digits = width.empty() ? 0 : parseInteger(width).value_or(kWidestNumber + 1);
    if (digits < 0 || digits > static_cast<std::int64_t>(kWidestNumber))
      return std::nullopt;
    pattern.width = static_cast<std::size_t>(digits);
    text.remove_prefix(end + 1);
    found = true;
  }
  return found ? std::optional(pattern) : std::nullopt;
}

/// The last word, by which `text` is shortened.
std::string_view takeLastWord(std::string_view& text) {
  text = trimmed(text);
  const std::size_t space = text.find_last_of(" \t");
  const std::string_view word = space == text.npos ? text : text.substr(space + 1);
  text = space == text.npos ? std::string_view() : trimmed(text.substr(0, space));
  return word;
}

} // namespace

bool isListOfFiles(std::string_view field) {
  return takeWord(field) == "LIST";
}

std::vector<std::string> namesOfFiles(TextScanner& scanner) {
  std::vector<std::string> names;
  while (scanner.remaining() > 0)
    if (const std::string_view line = trimmed(scanner.line()); !line.empty())
      names.emplace_back(line);
  return names;
}

std::vector<std::string> filesOfPattern(const FileBytes& file, std::string_view field) {
  for (const std::size_t count :
       {std::size_t{4}, std::size_t{3}}) { // A name may have spaces and numbers, too.
    std::string_view name = field;
    std::array<std::optional<std::int64_t>, 4> numbers;
    for (std::size_t i = count; i-- > 0;)
      numbers[i] = parseInteger(takeLastWord(name));
    const auto pattern = patternOf(name);
    if (!pattern || !numbers[0] || !numbers[1] || !numbers[2] || (count == 4 && !numbers[3]))
      continue;
    const std::int64_t first = *numbers[0], last = *numbers[1], step = *numbers[2];
    constexpr std::int64_t kFar = std::int64_t{1} << 60U;
    if (step == 0 || first < -kFar || first > kFar || last < -kFar || last > kFar ||
        (last - first) / step < 0 || (last - first) / step >= kMostDataFiles)
      file.fail(diagnostic("its header is damaged: %1 names no series of files", inQuotes(field)));
    std::vector<std::string> names;
    for (std::int64_t i = 0; i <= (last - first) / step; ++i)
      names.push_back(pattern->nameOf(first + i * step));
    return names;
  }
  return {};
}

} // namespace viscera::medical_io
