#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "name_words.h"
#include "viscera/anatomy/organ_facts.h"
#include "viscera/anatomy/part.h"

namespace viscera::anatomy {

/// One or more words that name an organ.
struct Phrase {
  std::vector<std::string_view> words;
  const OrganFacts* organ = nullptr; ///< Never null.
  int rank = 1;                      ///< Where a name has several organs, the highest counts.
  bool piece = false;                ///< It names a piece of the organ.
  bool alone = false;                ///< It counts only without unknown words beside it.
  Side side = Side::none;
  Chamber chamber = Chamber::none;
};

/// The phrases of all organs, by their first words.
class PhraseIndex {
public:
  PhraseIndex();

  /// The longest phrase that begins at `words[at]`; null for none. O(phrases with that word).
  const Phrase* longestAt(const std::vector<NameWord>& words, std::size_t at) const;
  /// Whether a word is a phrase by itself.
  bool names(std::string_view word) const;

private:
  using ByFirstWord = std::unordered_map<std::string_view, std::vector<Phrase>>;

  void add(std::string_view text, Phrase phrase);

  ByFirstWord whole_, begin_; ///< First words without and with an open end.
};

} // namespace viscera::anatomy
