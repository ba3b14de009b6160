#include "cli/positions.h"

#include <charconv>
#include <cmath>

#include "viscera/core/error.h"

namespace viscera::app::cli {

Vec3 positionOf(const std::string& text, const std::string& option) {
  Vec3 position;
  const char* at = text.data();
  const char* const end = text.data() + text.size();
  for (int axis = 0; axis < 3; ++axis) {
    const auto [next, error] = std::from_chars(at, end, position[axis]);
    const bool separated = axis == 2 ? next == end : next != end && *next == ',';
    if (error != std::errc() || !separated || !std::isfinite(position[axis]))
      throw UsageError("It is not a position X,Y,Z in mm", option + " " + text,
                       "for instance " + option + " 12,-40,310");
    at = next + 1;
  }
  return position;
}

} // namespace viscera::app::cli
