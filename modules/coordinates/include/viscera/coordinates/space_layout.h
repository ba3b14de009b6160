#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "viscera/core/arrays.h"
#include "viscera/core/phrase.h"

namespace viscera::coordinates {

/// One convex piece of the space around the handles in which a system treats points alike. May be flat: a
/// face, an edge or a single point.
struct SpacePart {
  enum class Kind {
    region,     ///< Where one group of handles acts.
    zone,       ///< Where regions meet. One connected zone may have several such pieces.
    superRegion ///< All groups that meet in one zone.
  };
  Kind kind = Kind::region;
  std::string name;
  std::vector<int> groups;               ///< Rows of `HandleSet::groups` that take part, ascending.
  Points vertices;                       ///< `n x 3` mm, the corners.
  Triangles triangles;                   ///< Over `vertices`; none for an edge or a point.
  std::vector<std::array<int, 2>> edges; ///< Pairs of `vertices`; a point is its own edge.
};

/// How a system divides the space around given handles, for pictures and for messages to the user. Empty for
/// systems that treat all space alike.
struct SpaceLayout {
  std::vector<SpacePart> parts;
  /// Upper bounds of parameters that depend on these handles; larger values have no further effect.
  std::map<std::string, double> upperBounds;
  std::vector<Text> notes; ///< Sentences for a user: what was cut, left out or joined.
};

} // namespace viscera::coordinates
