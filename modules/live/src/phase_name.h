#pragma once

#include <cstddef>
#include <string>

#include "viscera/core/phrase.h"

namespace viscera::live {

/// The name of a phase of a series in messages.
inline Text phaseName(std::size_t phase) {
  return phrase("phase %1", phase + 1);
}

} // namespace viscera::live
