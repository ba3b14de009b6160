#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "name_words.h"
#include "phrase_index.h"
#include "viscera/anatomy/part.h"
#include "word_meanings.h"

namespace viscera::anatomy {
namespace {

using Tokens = std::vector<std::string>;

bool areDigits(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
}

// Only ASCII letters change: others are parts of UTF-8.
std::string inSmallLetters(std::string word) {
  for (char& letter : word)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return word;
}

Tokens tokensOf(std::string_view name) {
  Tokens words(1);
  for (const char letter : name)
    if (letter == '_' || letter == ' ')
      words.emplace_back();
    else
      words.back() += letter;
  std::erase(words, std::string());
  return words;
}

std::string joined(const Tokens& words) {
  std::string text;
  for (const std::string& word : words)
    text += (text.empty() ? "" : " ") + word;
  if (!text.empty())
    text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// "7" of a rib, "L1" of a vertebra.
bool isPlaceInRow(const std::string& word) {
  const bool lettered = std::isupper(static_cast<unsigned char>(word[0])) != 0;
  return areDigits(std::string_view(word).substr(lettered ? 1 : 0));
}

/// What segmenters call in words of their own, and people otherwise.
struct Written {
  std::string_view words, title;
};
constexpr Written kWritten[] = {{"vertebrae", "Vertebra"},
                                {"rib_left", "Left rib"},
                                {"rib_right", "Right rib"},
                                {"lung_upper_lobe_left", "Upper lobe of the left lung"},
                                {"lung_lower_lobe_left", "Lower lobe of the left lung"},
                                {"lung_upper_lobe_right", "Upper lobe of the right lung"},
                                {"lung_middle_lobe_right", "Middle lobe of the right lung"},
                                {"lung_lower_lobe_right", "Lower lobe of the right lung"},
                                {"autochthon_left", "Left deep back muscles"},
                                {"autochthon_right", "Right deep back muscles"},
                                {"iliopsoas_left", "Left iliopsoas muscle"},
                                {"iliopsoas_right", "Right iliopsoas muscle"}};

bool haveSameWords(std::string_view title, Tokens words) {
  Tokens wanted = tokensOf(title);
  for (Tokens* one : {&wanted, &words}) {
    std::transform(one->begin(), one->end(), one->begin(), inSmallLetters);
    std::sort(one->begin(), one->end());
  }
  return wanted == words;
}

/// The title of a whole part whose words the name has in any order, of a piece in the words of segmenters;
/// empty for others.
std::string titleWith(const Tokens& words, const std::optional<Part>& part) {
  if (part && part->extent == Extent::whole)
    if (std::string title = titleOf(*part); haveSameWords(title, words))
      return title;
  for (const Written& one : kWritten)
    if (haveSameWords(one.words, words))
      return std::string(one.title);
  return {};
}

/// Whether a word of a chamber's name tells one such chamber from another: "patient1", "ED", "2".
bool distinguishes(const std::string& word) {
  static const PhraseIndex phrases;
  const std::vector<NameWord> parts = nameWords(
      word, [](std::string_view one) { return meaningOf(one) != Meaning::unknown || phrases.names(one); });
  return std::any_of(parts.begin(), parts.end(), [](const NameWord& part) {
    return part.text == "#" || (meaningOf(part.text) == Meaning::unknown && !phrases.names(part.text));
  });
}

/// "Right ventricle (patient1)" for "patient1_RV_ENDOCARDIAL".
std::string chamberTitle(const Part& chamber, Tokens words) {
  std::erase_if(words, [](const std::string& word) { return !distinguishes(word); });
  std::string which;
  for (const std::string& word : words)
    which += (which.empty() ? "" : " ") + word;
  return titleOf(chamber) + (which.empty() ? "" : " (" + which + ")");
}

} // namespace

std::string readableName(std::string_view name) {
  Tokens words = tokensOf(name);
  if (words.empty())
    return std::string(name);
  const std::optional<Part> part = partNamed(name);
  if (std::string title = titleWith(words, part); !title.empty())
    return title;
  const bool fromFile = name.find('_') != std::string_view::npos && name.find('/') == std::string_view::npos;
  if (part && fromFile && !abbreviationOf(*part).empty())
    return chamberTitle(*part, std::move(words));
  const bool inRow = words.size() > 1 && isPlaceInRow(words.back());
  const Tokens numbered(words.end() - (inRow ? 1 : 0), words.end());
  words.resize(words.size() - numbered.size());
  std::string title = titleWith(words, part);
  if (title.empty()) {
    const std::string last = inSmallLetters(words.back());
    if (words.size() > 1 && part && (last == "left" || last == "right")) {
      words.back() = last;
      words[0] = inSmallLetters(words[0]);
      std::rotate(words.begin(), words.end() - 1, words.end());
    }
    title = joined(words);
  }
  return numbered.empty() ? title : title + ' ' + numbered.front();
}

} // namespace viscera::anatomy
