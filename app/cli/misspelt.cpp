#include "cli/misspelt.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "viscera/core/edit_distance.h"

namespace viscera::app::cli {
namespace {

constexpr std::size_t kShortestBeginning = 3;

std::string smallLetters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return text;
}

/// So many letters may differ: an exchange of two neighbours counts as two.
std::size_t tolerated(std::size_t letters) {
  return letters < 4 ? 1 : letters < 8 ? 2 : 3;
}

/// The only name that begins so; empty for none and for several.
std::string onlyOneThatBegins(const std::string& word, const std::vector<std::string>& names) {
  const auto begins = [&](const std::string& name) { return smallLetters(name).starts_with(word); };
  if (word.size() < kShortestBeginning || std::count_if(names.begin(), names.end(), begins) != 1)
    return {};
  return *std::find_if(names.begin(), names.end(), begins);
}

} // namespace

std::string meantBy(const std::string& word, const std::vector<std::string>& names) {
  const std::string typed = smallLetters(word);
  std::string nearest;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const std::string& name : names)
    if (const std::size_t distance = editDistance(typed, smallLetters(name)); distance < least) {
      least = distance;
      nearest = name;
    }
  return least <= tolerated(typed.size()) ? nearest : onlyOneThatBegins(typed, names);
}

std::string UnknownCommand::problem() const {
  return "'" + word + "' is " + (meant.empty() ? "neither a command nor a file" : "no command");
}

std::string UnknownCommand::advice() const {
  return meant.empty() ? "viscera --help lists the commands" : "did you mean '" + meant + "'?";
}

} // namespace viscera::app::cli
