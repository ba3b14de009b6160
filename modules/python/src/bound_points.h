#pragma once

#include <memory>

#include "viscera/coordinates/coordinate_system.h"

namespace viscera::python {

/// A binding with all that it was made from, so that derivatives can be asked of it later. Immutable.
struct BoundPoints {
  std::shared_ptr<const coordinates::CoordinateSystem> system;
  coordinates::HandleSet handles;
  std::shared_ptr<const Points> points; ///< At rest, `n x 3` mm.
  coordinates::BindOptions options;
  std::shared_ptr<const coordinates::Binding> binding;
};

/// The pose as the binding wants it. Throws `DataError` for another number of handles and for numbers that
/// are not finite.
void requirePose(const BoundPoints& bound, const Points& pose);

} // namespace viscera::python
