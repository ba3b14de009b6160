#pragma once

namespace viscera::heart {

/// Linear interpolation: `from` at 0, `to` at 1.
inline double mix(double from, double to, double part) {
  return from + part * (to - from);
}

} // namespace viscera::heart
