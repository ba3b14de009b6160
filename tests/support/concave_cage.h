#pragma once

#include "shapes.h"
#include "viscera/coordinates/handle_set.h"

namespace viscera::tests {

/// A box of 80 mm one corner of whose top is pushed in beyond the middle.
inline coordinates::HandleSet concaveCage() {
  const auto cage = box(80, 80, 80);
  coordinates::HandleSet handles;
  handles.positions = cage.points;
  handles.cage = cage.triangles;
  handles.positions.row(7) << 25, 25, 25;
  return handles;
}

} // namespace viscera::tests
