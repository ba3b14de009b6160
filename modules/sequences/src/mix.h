#pragma once

namespace viscera::sequences {

/// From `from` at 0 to `to` at 1.
inline double mix(double from, double to, double part) {
  return from + part * (to - from);
}

} // namespace viscera::sequences
