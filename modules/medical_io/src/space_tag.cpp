#include "space_tag.h"

#include <algorithm>

#include "viscera/core/phrase.h"

#include "file_bytes.h"
#include "text_scanner.h"

namespace viscera::medical_io {
namespace {

constexpr std::string_view kSpaceTag = "SPACE";
constexpr std::string_view kProgram = "Viscera: ";

bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// The text after `SPACE=` at `at`; empty when there is no equals sign.
std::string_view valueAfterTag(std::string_view text, std::size_t at) {
  text.remove_prefix(at + kSpaceTag.size());
  text = trimmed(text);
  if (!text.starts_with('='))
    return {};
  text = trimmed(text.substr(1));
  if (text.starts_with('"'))
    text.remove_prefix(1);
  std::size_t length = 0;
  while (length < text.size() && (isLetter(text[length]) || text[length] == '-'))
    ++length;
  return text.substr(0, length);
}

/// Never cuts a UTF-8 character in two.
std::string_view cut(std::string_view text, std::size_t longest) {
  if (text.size() <= longest)
    return text;
  while (longest > 0 && (static_cast<unsigned char>(text[longest]) & 0xC0U) == 0x80U)
    --longest;
  return text.substr(0, longest);
}

} // namespace

std::string_view spaceName(Space space) {
  return space == Space::lps ? "LPS" : "RAS";
}

std::optional<Space> findSpace(std::string_view comment, std::vector<Text>& warnings) {
  for (std::size_t at = comment.find(kSpaceTag); at != comment.npos; at = comment.find(kSpaceTag, at + 1)) {
    if (at > 0 && isLetter(comment[at - 1]))
      continue;
    const std::string_view value = valueAfterTag(comment, at);
    if (value == "RAS" || value == "right-anterior-superior")
      return Space::ras;
    if (value == "LPS" || value == "left-posterior-superior")
      return Space::lps;
    if (!value.empty())
      warnings.push_back(phrase("its axes %1 are unknown; LPS is assumed", inQuotes(value)));
  }
  return std::nullopt;
}

std::string writtenComment(const WriteSurface& options, std::size_t longest) {
  const std::string tag = "; SPACE=" + std::string(spaceName(options.space));
  std::string name = options.name;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return c < ' ' || c == 0x7F; }, ' ');
  return std::string(kProgram) + std::string(cut(name, longest - kProgram.size() - tag.size())) + tag;
}

std::string nameInComment(std::string_view comment) {
  comment = trimmed(comment);
  const std::size_t tag = comment.rfind("; SPACE=");
  if (!comment.starts_with(kProgram) || tag == comment.npos || tag < kProgram.size())
    return {};
  return std::string(trimmed(comment.substr(kProgram.size(), tag - kProgram.size())));
}

} // namespace viscera::medical_io
