#include <algorithm>
#include <set>

#include "name_words.h"
#include "phrase_index.h"
#include "viscera/anatomy/organ_facts.h"
#include "viscera/anatomy/part.h"
#include "word_meanings.h"

namespace viscera::anatomy {
namespace {

const PhraseIndex& phrases() {
  static const PhraseIndex index;
  return index;
}

/// What the words of a name say, before it is decided which part they mean.
struct Reading {
  std::vector<const Phrase*> found; ///< In the order of the name.
  bool left = false, right = false;
  bool sideInLetters = false; ///< "L" may be anything; "left" says it.
  bool inside = false, wall = false, piece = false, lesion = false, denied = false;

  Side side() const { return left == right ? Side::none : left ? Side::left : Side::right; }
  bool has(std::string_view organ) const {
    return std::any_of(found.begin(), found.end(),
                       [&](const Phrase* phrase) { return phrase->organ->id == organ; });
  }
};

/// "leftkidney" and "kidneyleft" become two words where the rest names an organ.
void partSides(std::vector<NameWord>& words) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string text = words[i].text;
    if (meaningOf(text) != Meaning::unknown || phrases().names(text))
      continue;
    for (const std::string_view side : {"left", "right"}) {
      if (text.size() <= side.size())
        continue;
      const bool before = text.starts_with(side), behind = text.ends_with(side);
      const std::string rest = before ? text.substr(side.size()) : text.substr(0, text.size() - side.size());
      if ((!before && !behind) || !phrases().names(rest))
        continue;
      words[i].text = rest;
      words.insert(words.begin() + static_cast<std::ptrdiff_t>(i), NameWord{std::string(side)});
      break;
    }
  }
}

bool isSide(const NameWord& word, Meaning meaning) {
  const bool oneLetter = word.text.size() == 1;
  return (meaning == Meaning::left || meaning == Meaning::right) &&
         !(oneLetter && (word.atNumber || word.elided));
}

/// Takes the words for the sides out of a name: "adrenal left gland" is an adrenal gland.
void takeSides(std::vector<NameWord>& words, Reading& reading) {
  std::erase_if(words, [&](const NameWord& word) {
    const Meaning meaning = meaningOf(word.text);
    if (!isSide(word, meaning))
      return false;
    (meaning == Meaning::left ? reading.left : reading.right) = true;
    reading.sideInLetters = reading.sideInLetters || word.text.size() > 2;
    return true;
  });
}

void takeMeaning(Meaning meaning, Reading& reading) {
  reading.inside = reading.inside || meaning == Meaning::inside;
  reading.wall = reading.wall || meaning == Meaning::wall;
  reading.piece = reading.piece || meaning == Meaning::piece;
  reading.lesion = reading.lesion || meaning == Meaning::lesion;
  reading.denied = reading.denied || meaning == Meaning::denial;
}

/// Whether no word beside [begin, end) could mean that the name is about something else. `codes`: a word
/// before a number, as in "A08_Ren dexter", is the code of a file.
bool isAlone(const std::vector<NameWord>& words, std::size_t begin, std::size_t end, bool codes) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    const Meaning meaning = meaningOf(words[i].text);
    const bool strange = meaning == Meaning::unknown || meaning == Meaning::denial;
    const bool code = codes && i < begin && i + 1 < words.size() && words[i + 1].text == "#";
    if ((i < begin || i >= end) && words[i].text != "#" && strange && !code)
      return false;
  }
  return true;
}

Reading read(std::string_view name) {
  std::vector<NameWord> words = nameWords(name, [](std::string_view word) {
    return meaningOf(word) != Meaning::unknown || phrases().names(word);
  });
  Reading reading;
  partSides(words);
  takeSides(words, reading);
  for (std::size_t at = 0; at < words.size();) {
    const Phrase* phrase = phrases().longestAt(words, at);
    const std::size_t end = at + (phrase ? phrase->words.size() : 1);
    // "LA" in capitals is an atrium, whatever is beside it.
    const bool abbreviation = phrase && phrase->rank == 0 && words[at].capitals;
    const bool sided = phrase && phrase->organ->place == Place::eitherSide && (reading.left || reading.right);
    if (phrase && (!phrase->alone || abbreviation || isAlone(words, at, end, sided))) {
      reading.found.push_back(phrase);
      at = end;
    } else {
      takeMeaning(meaningOf(words[at].text), reading);
      ++at;
    }
  }
  return reading;
}

/// The side and the chamber that a phrase says join what other words say.
void takeChambers(Reading& reading) {
  for (const Phrase* phrase : reading.found) {
    reading.left = reading.left || phrase->side == Side::left;
    reading.right = reading.right || phrase->side == Side::right;
  }
}

/// A ventricle is the brain's where a word says so, or where nothing says that it is the heart's.
bool isOfBrain(const Reading& reading) {
  const bool ofHeart = reading.has("myocardium") || reading.has("valve") ||
                       std::any_of(reading.found.begin(), reading.found.end(), [](const Phrase* phrase) {
                         return phrase->organ->id == "heart" && phrase->chamber != Chamber::ventricle;
                       });
  return reading.has("brain") || (!ofHeart && !reading.left && !reading.right);
}

bool namesVentricle(const Reading& reading) {
  return std::any_of(reading.found.begin(), reading.found.end(),
                     [](const Phrase* phrase) { return phrase->chamber == Chamber::ventricle; });
}

/// The organ that is meant; of several, the first of the highest rank. `several` says whether another one has
/// the same rank.
const OrganFacts* organOf(const Reading& reading, bool& several) {
  const Phrase* best = nullptr;
  for (const Phrase* phrase : reading.found)
    if (!best || phrase->rank > best->rank)
      best = phrase;
  several = std::any_of(reading.found.begin(), reading.found.end(), [&](const Phrase* phrase) {
    return phrase->rank == best->rank && phrase->organ != best->organ;
  });
  return best ? best->organ : nullptr;
}

/// None for no chamber, and for both kinds.
Chamber chamberOf(const Reading& reading) {
  std::set<Chamber> chambers;
  for (const Phrase* phrase : reading.found)
    if (phrase->chamber != Chamber::none)
      chambers.insert(phrase->chamber);
  return chambers.size() == 1 ? *chambers.begin() : Chamber::none;
}

Extent extentOf(const Reading& reading, const OrganFacts& organ, bool chamber) {
  if (reading.lesion)
    return Extent::lesion;
  const bool phraseOfPiece =
      std::any_of(reading.found.begin(), reading.found.end(),
                  [&](const Phrase* phrase) { return phrase->organ == &organ && phrase->piece; });
  const bool one = organ.place == Place::middle || organ.place == Place::right || organ.place == Place::left;
  const bool halved = one && !chamber && reading.side() != Side::none && reading.sideInLetters;
  const bool inside = reading.inside && !chamber;
  return phraseOfPiece || reading.piece || reading.wall || halved || inside ? Extent::piece : Extent::whole;
}

/// The part that a name means, and the organ that it mentions first.
struct Meant {
  std::optional<Part> part;
  const OrganFacts* first = nullptr;
  bool lesion = false;
};

Meant meantBy(std::string_view name) {
  Reading reading = read(name);
  takeChambers(reading);
  Meant meant;
  meant.lesion = reading.lesion && !reading.denied;
  if (reading.found.empty() || reading.denied)
    return meant;
  if (namesVentricle(reading) && isOfBrain(reading)) {
    meant.first = &organ("brain");
    meant.part = {meant.first->id, reading.side(), Chamber::none,
                  reading.lesion ? Extent::lesion : Extent::piece};
    return meant;
  }
  bool several = false;
  const OrganFacts* facts = organOf(reading, several);
  meant.first = facts;
  const Chamber chamber = chamberOf(reading);
  const bool wall = chamber != Chamber::none && (reading.wall || facts->id == "muscle");
  if (wall && (facts->id == "heart" || facts->id == "muscle"))
    meant.first = facts = &organ("myocardium");
  else if (several)
    return meant;
  const bool ofHeart = facts->id == "heart" || facts->id == "myocardium";
  const bool kept = facts->place == Place::eitherSide || facts->place == Place::anywhere ||
                    (ofHeart && chamber != Chamber::none) || reading.sideInLetters;
  meant.part = {facts->id, kept ? reading.side() : Side::none, ofHeart ? chamber : Chamber::none,
                extentOf(reading, *facts, ofHeart && chamber != Chamber::none)};
  return meant;
}

} // namespace

std::optional<Part> partNamed(std::string_view name) {
  return meantBy(name).part;
}

std::optional<Part> chamberNamed(std::string_view name) {
  // "Heart/la" is the part "la" of the file "Heart": beside "heart", "la" would be an article.
  if (const std::size_t slash = name.rfind('/'); slash != std::string_view::npos)
    if (const std::optional<Part> part = chamberNamed(name.substr(slash + 1)))
      return part;
  const std::optional<Part> part = partNamed(name);
  return part && !abbreviationOf(*part).empty() ? part : std::nullopt;
}

std::string chamberKey(std::string_view name) {
  const std::optional<Part> chamber = chamberNamed(name);
  std::string key(chamber ? abbreviationOf(*chamber) : std::string_view());
  for (char& letter : key)
    letter = static_cast<char>(letter - 'A' + 'a');
  return key;
}

std::vector<std::pair<std::string, std::size_t>> chamberKeys(const std::vector<std::string>& names) {
  std::vector<std::pair<std::string, std::size_t>> keys;
  for (std::size_t i = 0; i < names.size(); ++i) {
    std::string key = chamberKey(names[i]);
    const bool known =
        std::find(names.begin(), names.end(), key) != names.end() ||
        std::any_of(keys.begin(), keys.end(), [&](const auto& one) { return one.first == key; });
    if (!key.empty() && !known)
      keys.emplace_back(std::move(key), i);
  }
  return keys;
}

std::optional<Vec3> colorNamed(std::string_view name) {
  const Meant meant = meantBy(name);
  if (meant.part)
    return colorOf(*meant.part);
  if (meant.lesion)
    return colorOf({"liver", Side::none, Chamber::none, Extent::lesion});
  return meant.first ? std::optional(colorOf({meant.first->id})) : std::nullopt;
}

const std::string& systemNamed(std::string_view name) {
  const Meant meant = meantBy(name);
  const std::vector<std::string>& systems = organSystems();
  const auto found =
      meant.first ? std::find(systems.begin(), systems.end(), meant.first->system) : systems.end();
  return found == systems.end() ? systems.back() : *found;
}

bool isBoneNamed(std::string_view name) {
  const std::optional<Part> part = partNamed(name);
  return part && part->extent != Extent::lesion && organ(part->organ).rigid;
}

bool isStillNamed(std::string_view name) {
  const auto part = partNamed(name);
  return part && part->extent != Extent::lesion && organ(part->organ).still;
}

} // namespace viscera::anatomy
