#pragma once

#include <string>

namespace viscera::presentation {

/// A translator that returns every text unchanged, for programs without translations.
inline std::string untranslated(const char* text) {
  return text;
}

} // namespace viscera::presentation
