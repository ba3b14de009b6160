#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// The words that a name is made of.
namespace viscera::anatomy {

/// A word in small letters without accents, or "#" for a number.
struct NameWord {
  std::string text;
  bool capitals = false; ///< All of it is written in capitals: "LA" is an atrium, "la" an article.
  bool atNumber = false; ///< A number follows without anything between, as in "L1".
  bool elided = false;   ///< An apostrophe follows: "l'estomac".
};

/// Parts a name at everything that is neither a letter nor a digit, between letters and digits, and at
/// capitals inside a word ("RightKidney"). Combining accents and those of Latin letters are taken off.
/// `isKnown` says whether a word has a meaning, which decides where capitals are doubtful ("LVcavity"). Other
/// letters are words without a meaning. O(length).
std::vector<NameWord> nameWords(std::string_view name, const std::function<bool(std::string_view)>& isKnown);

} // namespace viscera::anatomy
