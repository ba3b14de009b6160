#pragma once

#include <string>

namespace viscera::presentation {

/// Stands for a translator where there is none.
inline std::string untranslated(const char* text) {
  return text;
}

} // namespace viscera::presentation
