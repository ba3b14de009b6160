#pragma once

#include <memory>

#include "viscera/coordinates/coordinate_system.h"

namespace viscera::python {

/// A binding together with the data from which it was made, so that derivatives can be computed later.
/// Immutable.
struct BoundPoints {
  std::shared_ptr<const coordinates::CoordinateSystem> system;
  coordinates::HandleSet handles;
  std::shared_ptr<const Points> points; ///< At rest, `n x 3` mm.
  coordinates::BindOptions options;
  std::shared_ptr<const coordinates::Binding> binding;
};

/// Checks a pose. Throws `DataError` for another number of handles and for numbers that are not finite.
void requirePose(const BoundPoints& bound, const Points& pose);

} // namespace viscera::python
