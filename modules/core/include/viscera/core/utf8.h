#pragma once

#include <string>
#include <string_view>

namespace viscera {

/// Whether a text is UTF-8 as RFC 3629 has it: no overlong forms, surrogates or numbers above 10FFFF. O(n).
bool isUtf8(std::string_view text);

/// Text from a file, from the command line or from the system, as UTF-8. Bytes that are no UTF-8 are taken as
/// Latin-1, so that texts that differ still do. O(n).
std::string toUtf8(std::string text);

} // namespace viscera
