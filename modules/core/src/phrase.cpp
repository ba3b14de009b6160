#include "viscera/core/phrase.h"

#include <optional>

namespace viscera {
namespace {

/// Of "{handle|handles} and more" at `at` the form for `one` or for several; moves `at` behind it. Without a
/// bar and a closing brace it is no choice, and nothing is taken.
std::optional<std::string_view> chosenForm(std::string_view pattern, std::size_t& at, bool one) {
  const std::size_t bar = pattern.find('|', at);
  const std::size_t end = pattern.find('}', at);
  if (bar == std::string_view::npos || end == std::string_view::npos || bar > end)
    return std::nullopt;
  const std::size_t begin = one ? at + 1 : bar + 1;
  at = end + 1;
  return pattern.substr(begin, (one ? bar : end) - begin);
}

} // namespace

std::string phraseOf(std::string_view pattern, const std::vector<PhrasePart>& parts) {
  const bool one = !parts.empty() && parts.front().text == "1";
  std::string text;
  for (std::size_t at = 0; at < pattern.size();) {
    const char next = at + 1 < pattern.size() ? pattern[at + 1] : '\0';
    const std::size_t part = next == 'n' ? 0 : static_cast<std::size_t>(next - '1');
    if (pattern[at] == '%' && part < parts.size()) {
      text += parts[part].text;
      at += 2;
      continue;
    }
    if (pattern[at] == '{')
      if (const auto form = chosenForm(pattern, at, one)) {
        text += phraseOf(*form, parts);
        continue;
      }
    text += pattern[at++];
  }
  return text;
}

std::size_t numberAtEnd(std::string_view name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  const bool numbered =
      last != std::string_view::npos && last > 0 && last + 1 < name.size() && name[last] == ' ';
  return numbered ? last : name.size();
}

} // namespace viscera
