#include "phrase_index.h"

#include <algorithm>

#include "word_list.h"

namespace viscera::anatomy {
namespace {

constexpr char kPiece = '~', kAlone = '!';

/// Names of chambers. Abbreviations give way to every organ, because "la" is an article in three languages.
struct ChamberWords {
  Chamber chamber;
  Side side;
  int rank;
  std::string_view list;
};
constexpr ChamberWords kChamberWords[] = {
    {Chamber::ventricle, Side::left, 0, "lv|lvbp|lvendo|lvcav"},
    {Chamber::ventricle, Side::right, 0, "rv|rvbp|rvendo|rvcav"},
    {Chamber::atrium, Side::left, 0, "!la"},
    {Chamber::atrium, Side::right, 0, "!ra"},
    {Chamber::ventricle, Side::none, 1,
     "ventricle|ventricles|ventricular|ventrikel|herzkammer|ventricule|ventricules|ventriculo|ventriculos|"
     "ventriculus|ventriculi|ventricul|ventricle of heart"},
    {Chamber::atrium, Side::none, 1,
     "atrium|atria|atrial|vorhof|vorhofe|oreillette|oreillettes|auricula|auriculas|atrio|atri|"
     "~atrial appendage|~auricle|~herzohr|~auricula atrii"}};

bool isBegunBy(std::string_view word, std::string_view pattern) {
  return pattern.back() == kAnyEnd ? word.starts_with(pattern.substr(0, pattern.size() - 1))
                                   : word == pattern;
}

bool fitsAt(const Phrase& phrase, const std::vector<NameWord>& words, std::size_t at) {
  if (at + phrase.words.size() > words.size())
    return false;
  for (std::size_t i = 0; i < phrase.words.size(); ++i)
    if (!isBegunBy(words[at + i].text, phrase.words[i]))
      return false;
  return true;
}

} // namespace

PhraseIndex::PhraseIndex() {
  for (const OrganFacts& facts : organs())
    forEachWord(facts.words, '|', [&](std::string_view text) { add(text, {{}, &facts, facts.rank}); });
  for (const ChamberWords& words : kChamberWords)
    forEachWord(words.list, '|', [&](std::string_view text) {
      add(text, {{}, &organ("heart"), words.rank, false, false, words.side, words.chamber});
    });
}

void PhraseIndex::add(std::string_view text, Phrase phrase) {
  for (; text.front() == kPiece || text.front() == kAlone; text.remove_prefix(1))
    (text.front() == kPiece ? phrase.piece : phrase.alone) = true;
  forEachWord(text, ' ', [&](std::string_view word) { phrase.words.push_back(word); });
  std::string_view first = phrase.words.front();
  const bool open = first.back() == kAnyEnd;
  if (open)
    first.remove_suffix(1);
  (open ? begin_ : whole_)[first].push_back(std::move(phrase));
}

const Phrase* PhraseIndex::longestAt(const std::vector<NameWord>& words, std::size_t at) const {
  const Phrase* longest = nullptr;
  const auto consider = [&](const ByFirstWord& index, std::string_view first) {
    const auto found = index.find(first);
    if (found == index.end())
      return;
    for (const Phrase& phrase : found->second)
      if (fitsAt(phrase, words, at) && (!longest || phrase.words.size() > longest->words.size()))
        longest = &phrase;
  };
  const std::string_view word = words[at].text;
  consider(whole_, word);
  for (std::size_t length = word.size(); length >= kShortestBegin; --length)
    consider(begin_, word.substr(0, length));
  return longest;
}

bool PhraseIndex::names(std::string_view word) const {
  const Phrase* phrase = longestAt({NameWord{std::string(word)}}, 0);
  return phrase != nullptr && !phrase->alone;
}

} // namespace viscera::anatomy
