#pragma once

#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "viscera/scene/organ_labels.h"

#include "front_grid.h"
#include "view_geometry.h"

namespace viscera::scene {

/// A vertex that is looked at covers that much around it, or more; logical pixels.
inline constexpr double kVertexReach = 6;

/// One organ on the display, or a part of it.
struct Sighting {
  Footprint covered;
  double x = 0, y = 0; ///< The middle of its vertices; where the line of its label ends.
  double depth = 0;    ///< Of a part, mm.
  double bottom = std::numeric_limits<double>::infinity();
  double top = -std::numeric_limits<double>::infinity();
  std::size_t cells = 0; ///< Of the front that its vertices lie in ...
  std::size_t front = 0; ///< ... and those of them in which it is in front; all where it is translucent.
  bool seen = false;
  /// The cells of a translucent organ that has a label, whatever is before them.
  std::shared_ptr<FrontGrid> own = nullptr;
  bool atPlace = false; ///< The line ends at (x, y), also of an organ that is labelled at its edge.
};

/// Finds what a view shows of what has labels, one of each: nothing where it is not seen. A line ends where
/// it did `before` while that is right; where it is empty, there was none. `all` becomes what the organs
/// cover.
std::vector<std::optional<Sighting>> sightLabels(const std::vector<std::shared_ptr<OrganActor>>& organs,
                                                 const std::vector<OrganLabels::Item>& items,
                                                 const ViewGeometry& view,
                                                 const std::vector<std::optional<ScreenPlace>>& before,
                                                 Footprint& all);

} // namespace viscera::scene
