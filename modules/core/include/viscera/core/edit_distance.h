#pragma once

#include <cstddef>
#include <string_view>

namespace viscera {

/// The number of bytes that have to be changed, added or removed to make `b` of `a`, by which the name that
/// was meant is found beside a misspelt one. Levenshtein, "Binary codes capable of correcting deletions,
/// insertions, and reversals", Soviet Physics Doklady 10, 1966. O(|a| |b|). No errors; from any thread.
std::size_t editDistance(std::string_view a, std::string_view b);

} // namespace viscera
