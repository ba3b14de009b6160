#pragma once

#include <map>
#include <memory>
#include <string>

#include "ranks.h"
#include "viscera/coordinates/coordinate_system.h"

class vtkPointSet;
class vtkPolyData;

namespace viscera::vtk_filters {

/// The handles of a filter, equal on every rank, with the coordinate system.
struct Rig {
  std::shared_ptr<const coordinates::CoordinateSystem> system;
  coordinates::HandleSet handles;
  Points pose; ///< `h x 3` mm, finite.
  coordinates::BindOptions options;

  /// Whether bindings to the other may be used for this one.
  bool bindsAs(const Rig& other) const;
};

/// The settings of the filter.
struct Choices {
  std::string system;
  std::map<std::string, double> parameters; ///< Unknown ones are an error.
  double locality = 0;                      ///< 0: not given.
  double softness = 0;
  int threads = 0;
};

/// The handles of all ranks: ghosts do not count, and equal handles of a later rank count as a copy.
/// Triangles among the rest handles are a cage. Collective. Throws, on all ranks alike, `UsageError` for an
/// unknown system or parameter, `DataError` for invalid handles, or for a number that differs from the posed
/// ones.
Rig gatherRig(const Ranks& ranks, vtkPointSet* rest, vtkPointSet* posed, const Choices& choices);

/// Makes `data` the handles at `positions` (`h x 3` mm): a vertex each, and its number as point data
/// "Handle".
void fillHandles(vtkPolyData* data, const Points& positions);

} // namespace viscera::vtk_filters
