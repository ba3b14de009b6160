#include "name_words.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace viscera::anatomy {
namespace {

/// One letter of a name, as ASCII.
struct Letter {
  enum class LetterKind { letter, digit, apostrophe, separator };
  LetterKind kind = LetterKind::separator;
  bool capital = false;
  std::string_view small = {}; ///< In small letters; two for a ligature. "?" for a letter that is not Latin.
};

/// U+00E0 to U+00FF without accents; the capitals are 32 before.
constexpr std::array<std::string_view, 32> kLatin = {"a", "a", "a", "a", "a", "a", "ae", "c", "e", "e", "e",
                                                     "e", "i", "i", "i", "i", "d", "n",  "o", "o", "o", "o",
                                                     "o", "",  "o", "u", "u", "u", "u",  "y", "?", "y"};
constexpr std::string_view kAscii = "abcdefghijklmnopqrstuvwxyz";

/// Reads one code point of UTF-8 from the front of `text`; a byte that is none stands for itself.
std::uint32_t takeCodePoint(std::string_view& text) {
  const auto byteAt = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::uint32_t first = byteAt(0);
  const std::size_t length = first < 0xC0 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  std::uint32_t code = length == 1 ? first : first & (0xFFU >> (length + 1));
  std::size_t used = 1;
  for (; used < length && used < text.size() && (byteAt(used) & 0xC0U) == 0x80; ++used)
    code = code << 6 | (byteAt(used) & 0x3FU);
  if (used < length) {
    code = first;
    used = 1;
  }
  text.remove_prefix(used);
  return code;
}

bool isDropped(std::uint32_t code) {
  constexpr std::uint32_t kMiddleDot = 0xB7, kCombiningBegin = 0x300, kCombiningEnd = 0x370;
  return code == kMiddleDot || (code >= kCombiningBegin && code < kCombiningEnd);
}

Letter asciiLetter(std::uint32_t code) {
  using LetterKind = Letter::LetterKind;
  const auto c = static_cast<char>(code);
  if (c >= '0' && c <= '9')
    return {LetterKind::digit};
  if (c == '\'')
    return {LetterKind::apostrophe};
  const bool capital = c >= 'A' && c <= 'Z', small = c >= 'a' && c <= 'z';
  if (!capital && !small)
    return {};
  return {LetterKind::letter, capital, kAscii.substr(static_cast<std::size_t>(c - (capital ? 'A' : 'a')), 1)};
}

Letter letterOf(std::uint32_t code) {
  using LetterKind = Letter::LetterKind;
  constexpr std::uint32_t kSharpS = 0xDF, kLatinBegin = 0xC0, kSmallBegin = 0xE0, kLatinEnd = 0x100;
  constexpr std::uint32_t kLigatureOe = 0x152, kApostrophe = 0x2019, kPunctuation = 0x2000,
                          kPunctuationEnd = 0x2070, kOtherLetters = 0x100;
  if (code < 0x80)
    return asciiLetter(code);
  if (code == kSharpS)
    return {LetterKind::letter, false, "ss"};
  if (code >= kLatinBegin && code < kLatinEnd) {
    const bool capital = code < kSmallBegin;
    const std::string_view small = kLatin[code - (capital ? kLatinBegin : kSmallBegin)];
    return small.empty() ? Letter() : Letter{LetterKind::letter, capital, small};
  }
  if (code == kLigatureOe || code == kLigatureOe + 1)
    return {LetterKind::letter, code == kLigatureOe, "oe"};
  if (code == kApostrophe)
    return {LetterKind::apostrophe};
  const bool punctuation = code >= kPunctuation && code < kPunctuationEnd;
  return code >= kOtherLetters && !punctuation ? Letter{LetterKind::letter, false, "?"} : Letter();
}

std::vector<Letter> lettersOf(std::string_view name) {
  std::vector<Letter> letters;
  while (!name.empty())
    if (const std::uint32_t code = takeCodePoint(name); !isDropped(code))
      letters.push_back(letterOf(code));
  return letters;
}

std::string smallOf(const Letter* begin, const Letter* end) {
  std::string text;
  for (; begin != end; ++begin)
    text += begin->small;
  return text;
}

/// Adds a run of letters, parted at its capitals: "RightKidney", "LVCavity", "LVcavity".
void addLetters(std::vector<NameWord>& words, const Letter* begin, const Letter* end,
                const std::function<bool(std::string_view)>& isKnown) {
  while (begin != end) {
    const auto isCapital = [](const Letter& letter) { return letter.capital; };
    const Letter* capitals = std::find_if_not(begin, end, isCapital);
    const Letter* last = std::find_if(capitals, end, isCapital);
    if (capitals - begin > 1 && capitals != end) // Of capitals before a small word, the last one belongs to
                                                 // it, unless the word is known without it.
      last = isKnown(smallOf(capitals, last)) ? capitals : capitals - 1;
    words.push_back({smallOf(begin, last), std::all_of(begin, last, isCapital)});
    begin = last;
  }
}

} // namespace

std::vector<NameWord> nameWords(std::string_view name, const std::function<bool(std::string_view)>& isKnown) {
  using LetterKind = Letter::LetterKind;
  const std::vector<Letter> letters = lettersOf(name);
  std::vector<NameWord> words;
  const Letter* const end = letters.data() + letters.size();
  for (const Letter* at = letters.data(); at != end;) {
    const LetterKind kind = at->kind;
    const Letter* next = std::find_if(at, end, [&](const Letter& letter) { return letter.kind != kind; });
    if (kind == LetterKind::letter) {
      addLetters(words, at, next, isKnown);
      words.back().atNumber = next != end && next->kind == LetterKind::digit;
      words.back().elided = next != end && next->kind == LetterKind::apostrophe;
    } else if (kind == LetterKind::digit) {
      words.push_back({"#"});
    }
    at = next;
  }
  return words;
}

} // namespace viscera::anatomy
