#pragma once

#include <memory>
#include <vector>

#include "viscera/coordinates/coordinate_system.h"

namespace viscera::localised_scc {

/// Localised Celestial coordinates (thesis 4.5), id `localised-s-celestial`. A point of one region has that
/// region's coordinates, a point of a swapping zone those of the zone's super-region, and within the offset
/// of a zone the two are blended. Handles of other groups have weight exactly 0. With one group it is the
/// inner system itself.
///
/// Points in no region are failures, as are those for which the inner system has no answer. Gradients follow
/// by the product rule from the inner system's and the blend's. The layout has the regions, zones and
/// super-regions of the groups; the offset's upper bound is the largest among the regions.
///
/// Departs from the thesis where its zones are ambiguous; see `RegionLayout`.
///
/// `inner` are the systems that a user may choose inside the regions, positive ones without a cage; the first
/// is the standard one. At least one.
std::shared_ptr<const coordinates::CoordinateSystem>
localisedSCelestial(std::vector<std::shared_ptr<const coordinates::CoordinateSystem>> inner);

/// The localised system of the program: its inner systems are the built-in ones that are positive,
/// continuous, defined everywhere and need nothing but handles.
std::shared_ptr<const coordinates::CoordinateSystem> localisedWithBuiltIns();

} // namespace viscera::localised_scc
