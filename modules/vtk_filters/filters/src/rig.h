#pragma once

#include <map>
#include <memory>
#include <string>

#include "ranks.h"
#include "viscera/coordinates/coordinate_system.h"

class vtkPointSet;
class vtkPolyData;

namespace viscera::vtk_filters {

/// The handles, the same on every rank, and the coordinates that points get with respect to them.
struct Rig {
  std::shared_ptr<const coordinates::CoordinateSystem> system;
  coordinates::HandleSet handles;
  Points pose; ///< `h x 3` mm, finite.
  coordinates::BindOptions options;

  /// Whether bindings to the other may be used for this one.
  bool bindsAs(const Rig& other) const;
};

/// What a user chooses.
struct Choices {
  std::string system;
  std::map<std::string, double> parameters; ///< Those that the system does not offer are refused.
  double locality = 0;                      ///< 0: not given.
  double softness = 0;
  int threads = 0;
};

/// The handles of all ranks: ghosts do not count, and a rank that holds what an earlier one holds has a copy.
/// Triangles among the rest handles are a cage. Collective. Throws, on all ranks alike, `UsageError` for an
/// unknown system or parameter, `DataError` for handles that are none, or not as many as posed ones.
Rig gatherRig(const Ranks& ranks, vtkPointSet* rest, vtkPointSet* posed, const Choices& choices);

/// Makes `data` the handles at `positions` (`h x 3` mm): a vertex each, and its number as point data
/// "Handle".
void fillHandles(vtkPolyData* data, const Points& positions);

} // namespace viscera::vtk_filters
