#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "viscera/coordinates/parameters.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/sequences/sequence.h"

namespace viscera::python {

/// A sequence with its coordinate system, labels of handles and surfaces. Immutable.
struct MotionSource {
  std::shared_ptr<const sequences::Sequence> sequence; ///< Never null.
  std::string system = "s-celestial";                  ///< The coordinate system for which it was made.
  coordinates::ParameterValues parameters;
  std::vector<std::string> labels; ///< Of the handles; may be empty.
  /// The surfaces that it was made for, in order; may be empty.
  std::vector<std::pair<std::string, std::shared_ptr<const geometry::TriangleMesh>>> surfaces;
  std::vector<Text> warnings;
};

} // namespace viscera::python
