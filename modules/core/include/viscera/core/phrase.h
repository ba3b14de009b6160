#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Texts for a user that are put together from parts, in a form that can be translated.
///
/// The numerical modules produce English texts without any translation; the window translates them
/// (app/window/language.h). It recognises a text by its pattern, so a text with a number or a name in it is
/// written as a pattern with its parts instead of being added up:
///
///     throw DataError(phrase("The pose has %1 handles, the document %2", posed, count));
///
/// `%1` to `%9` stand for the parts in their order. `%n` is the first part as a number, and chooses between
/// the forms in braces: the first for 1, the second for any other. Each pattern stands as one literal, which
/// the test `Translations` finds in the sources and looks up in resources/translations/names_*.ts.
namespace viscera {

/// One part of a phrase: a text or a whole number.
struct PhrasePart {
  PhrasePart(std::string part) : text(std::move(part)) {}
  PhrasePart(std::string_view part) : text(part) {}
  PhrasePart(const char* part) : text(part) {}
  PhrasePart(std::integral auto number) : text(std::to_string(number)) {}

  std::string text;
};

/// The English text of a pattern with its parts. A place that has no part stays as it is. O(n); from any
/// thread.
std::string phraseOf(std::string_view pattern, const std::vector<PhrasePart>& parts);

template <class... Parts>
std::string phrase(std::string_view pattern, const Parts&... parts) {
  return phraseOf(pattern, {PhrasePart(parts)...});
}

/// The index at which the trailing number of a name begins, with the space before it: 6 in "Septum 12"; the
/// name's size when there is none. Such a name is translated without its number. O(n); from any thread.
std::size_t numberAtEnd(std::string_view name);

} // namespace viscera
