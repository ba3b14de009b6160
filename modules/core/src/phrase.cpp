#include "viscera/core/phrase.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>
#include <ostream>
#include <system_error>

#include "viscera/core/text.h"

namespace viscera {

struct Text::Node {
  Kind kind;
  std::string words; ///< The pattern, the verbatim text, the name or the digits.
  std::vector<Text> parts;
};

namespace {

/// The names of kinds of texts in files, in the order of the kinds.
constexpr const char* kKinds[] = {"message", "verbatim",   "name",   "number",
                                  "list",    "diagnostic", "misuse", "sentence"};
/// Numbers that are too large for an `int` have the form of this one.
constexpr int kMany = 2147483647;
/// The sentences before texts that stay in English.
constexpr const char* kUnreadable = "The file cannot be read: %1";
constexpr const char* kMisused = "Internal error: %1";

/// The form for `one` or for several of "{handle|handles} and more" at `at`, which moves on. Without a
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

/// `pattern` with the parts in its places.
std::string filled(std::string_view pattern, const std::vector<std::string>& parts, bool one) {
  std::string text;
  for (std::size_t at = 0; at < pattern.size();) {
    const char next = at + 1 < pattern.size() ? pattern[at + 1] : '\0';
    const std::size_t part = next == 'n' ? 0 : static_cast<std::size_t>(next - '1');
    if (pattern[at] == '%' && part < parts.size()) {
      text += parts[part];
      at += 2;
      continue;
    }
    if (pattern[at] == '{')
      if (const auto form = chosenForm(pattern, at, one)) {
        text += filled(*form, parts, one);
        continue;
      }
    text += pattern[at++];
  }
  return text;
}

/// Whether a text has places for parts: no name has them, even if an organ is called "Open %1".
bool hasPlaces(std::string_view words) {
  for (std::size_t at = words.find('%'); at != std::string_view::npos; at = words.find('%', at + 1))
    if (at + 1 < words.size() && (words[at + 1] == 'n' || (words[at + 1] >= '1' && words[at + 1] <= '9')))
      return true;
  return words.find('{') != std::string_view::npos;
}

bool choosesByNumber(std::string_view pattern) {
  if (pattern.find("%n") != std::string_view::npos)
    return true;
  std::size_t at = pattern.find('{');
  return at != std::string_view::npos && chosenForm(pattern, at, true).has_value();
}

/// UTF-8 with its first letter in upper case: of ASCII, or of Latin-1 (two bytes, the first is C3).
std::string withCapital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z')
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  else if (text.size() > 1 && text[0] == '\xC3' && text[1] >= '\xA0' && text[1] <= '\xBE' &&
           text[1] != '\xB7')
    text[1] = static_cast<char>(text[1] - 0x20);
  return text;
}

std::string joined(const std::vector<std::string>& parts) {
  std::string list;
  for (const std::string& part : parts)
    list += (list.empty() ? "" : ", ") + part;
  return list;
}

/// "%1: %2" joins texts; "It cannot be opened: %1" is a sentence.
bool joinsOnly(std::string_view pattern) {
  for (std::size_t i = 0; i < pattern.size(); ++i)
    if (pattern[i] == '%')
      ++i; // Its place.
    else if (std::isalpha(static_cast<unsigned char>(pattern[i])) != 0)
      return false;
  return true;
}

std::string translated(const Wording& language, const std::string& words, std::optional<int> number = {}) {
  std::string found =
      language.translate && !words.empty() ? language.translate(words, number) : std::string();
  return found == words ? std::string() : found;
}

/// The number that chooses between forms; `kMany` for a larger one, and 2 for what is no whole number.
int wholeIn(const std::string& digits) {
  int value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [last, error] = std::from_chars(digits.data(), end, value);
  if (last != end)
    return 2;
  return error == std::errc::result_out_of_range ? kMany : value;
}

std::string nameInWords(const std::string& name, const Wording& language) {
  if (hasPlaces(name))
    return name;
  if (std::string exact = translated(language, name); !exact.empty())
    return exact;
  // "Right ventricle (patient1)", "Septum 12": what tells one of a kind from others stays as it is.
  const std::size_t bracket = name.ends_with(')') ? name.rfind(" (") : std::string::npos;
  const std::size_t end = bracket != std::string::npos ? bracket : numberAtEnd(name);
  const std::string word = end < name.size() ? translated(language, name.substr(0, end)) : std::string();
  return word.empty() ? name : word + name.substr(end);
}

} // namespace

Text::Text(Kind kind, std::string words, std::vector<Text> parts)
    : node_(words.empty() && parts.empty()
                ? nullptr
                : std::make_shared<const Node>(Node{kind, std::move(words), std::move(parts)})) {}

Text::Text(const char* message) : Text(Kind::message, message, {}) {}

// Most of such words come from files.
Text::Text(std::string verbatim) : Text(Kind::verbatim, withoutControls(std::move(verbatim)), {}) {}

std::string Text::english() const {
  return inWords(*this, {});
}

Text Text::capitalised() const {
  return empty() || node_->kind == Kind::sentence ? *this : Text(Kind::sentence, {}, {*this});
}

Text::Pieces Text::pieces() const {
  if (empty())
    return {kKinds[static_cast<std::size_t>(Kind::verbatim)], {}, {}};
  return {kKinds[static_cast<std::size_t>(node_->kind)], node_->words, node_->parts};
}

std::optional<Text> Text::of(Pieces pieces) {
  const auto kind = std::find(std::begin(kKinds), std::end(kKinds), pieces.kind);
  if (kind == std::end(kKinds))
    return std::nullopt;
  const auto which = static_cast<Kind>(kind - std::begin(kKinds));
  if (which == Kind::sentence && pieces.parts.size() != 1)
    return std::nullopt;
  return Text(which, std::move(pieces.words), std::move(pieces.parts));
}

bool operator==(const Text& a, const Text& b) {
  if (a.node_ == b.node_)
    return true;
  return a.node_ && b.node_ && a.node_->kind == b.node_->kind && a.node_->words == b.node_->words &&
         a.node_->parts == b.node_->parts;
}

std::ostream& operator<<(std::ostream& out, const Text& text) {
  return out << text.english();
}

std::vector<std::string> inEnglish(const std::vector<Text>& texts) {
  std::vector<std::string> list;
  for (const Text& text : texts)
    list.push_back(text.english());
  return list;
}

Text phraseOf(const char* pattern, std::vector<Text> parts) {
  return {Text::Kind::message, pattern, std::move(parts)};
}

Text diagnosticOf(const char* pattern, std::vector<Text> parts) {
  return {Text::Kind::diagnostic, pattern, std::move(parts)};
}

Text misuseOf(const char* pattern, std::vector<Text> parts) {
  return {Text::Kind::misuse, pattern, std::move(parts)};
}

Text named(std::string_view name) {
  return {Text::Kind::name, withoutControls(std::string(name)), {}};
}

Text inFixed(double value, int digits) {
  return {Text::Kind::number, fixed(value, digits), {}};
}

Text inDigits(double value, int digits) {
  return {Text::Kind::number, significant(value, digits), {}};
}

Text listOf(std::vector<Text> texts) {
  return {Text::Kind::list, {}, std::move(texts)};
}

/// Says one text in a language.
class Text::Speaker {
public:
  explicit Speaker(const Wording& language) : language_(language) {}

  std::string say(const Text& text) {
    if (text.empty())
      return {};
    const Node& node = *text.node_;
    switch (node.kind) {
    case Kind::verbatim:
      return node.words;
    case Kind::name:
      return nameInWords(node.words, language_);
    case Kind::number:
      return numberInWords(node.words);
    case Kind::sentence:
      return withCapital(say(node.parts.front()));
    case Kind::list:
      return joined(said(node.parts));
    case Kind::diagnostic:
      return introduced(kUnreadable, node);
    case Kind::misuse:
      return introduced(kMisused, node);
    case Kind::message:
      break;
    }
    return message(node);
  }

private:
  std::vector<std::string> said(const std::vector<Text>& parts) {
    std::vector<std::string> texts;
    for (const Text& part : parts)
      texts.push_back(say(part));
    return texts;
  }

  std::string numberInWords(std::string digits) const {
    const std::size_t point = digits.find('.');
    return point == std::string::npos ? digits : digits.replace(point, 1, language_.decimalMark);
  }

  /// The first text in English has its sentence before it; others, and those within a sentence, have none.
  std::string introduced(const char* sentence, const Node& node) {
    std::string english = Speaker(Wording{}).filledIn(node.words, node);
    const std::string before = introduced_ ? std::string() : translated(language_, sentence);
    introduced_ = true;
    return before.empty() ? english : filled(before, {english}, false);
  }

  std::string message(const Node& node) {
    if (joinsOnly(node.words))
      return filledIn(node.words, node);
    const bool before = std::exchange(introduced_, true);
    std::string text = filledIn(node.words, node);
    introduced_ = before;
    return text;
  }

  /// The translation of a pattern with its parts.
  std::string filledIn(const std::string& words, const Node& node) {
    const std::vector<std::string> parts = said(node.parts);
    const std::optional<int> number =
        !parts.empty() && choosesByNumber(words) ? std::optional(wholeIn(parts[0])) : std::nullopt;
    std::string pattern = translated(language_, words, number);
    if (number == kMany)
      if (const std::size_t at = pattern.find(std::to_string(kMany)); at != std::string::npos)
        pattern.replace(at, std::to_string(kMany).size(), "%n");
    return filled(pattern.empty() ? words : pattern, parts, number == 1);
  }

  const Wording& language_;
  bool introduced_ = false; ///< Whether a sentence before texts in English was said.
};

std::string inWords(const Text& text, const Wording& language) {
  return Text::Speaker(language).say(text);
}

std::size_t numberAtEnd(std::string_view name) {
  const std::size_t last = name.find_last_not_of("0123456789");
  if (last == std::string_view::npos || last == 0 || last + 1 == name.size())
    return name.size();
  const bool lettered = last > 1 && name[last] >= 'A' && name[last] <= 'Z' && name[last - 1] == ' ';
  return lettered ? last - 1 : name[last] == ' ' ? last : name.size();
}

} // namespace viscera
