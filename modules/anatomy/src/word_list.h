#pragma once

#include <cstddef>
#include <string_view>

/// How the tables of words are written: words separated by a sign, with an open end where they have one.
namespace viscera::anatomy {

inline constexpr char kAnyEnd = '*';             ///< Any end of a word: "bronch*".
inline constexpr std::size_t kShortestBegin = 4; ///< Letters before an open end, so that few words begin so.

/// Calls `take` with every word of a list. O(length).
template <typename Take>
void forEachWord(std::string_view list, char separator, const Take& take) {
  while (!list.empty()) {
    const std::size_t end = list.find(separator);
    take(list.substr(0, end));
    list.remove_prefix(end == std::string_view::npos ? list.size() : end + 1);
  }
}

} // namespace viscera::anatomy
