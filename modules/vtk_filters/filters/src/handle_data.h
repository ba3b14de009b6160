#pragma once

#include "viscera/core/arrays.h"

class vtkPolyData;

namespace viscera::vtk_filters {

/// Makes `data` the handles at `positions` (`h x 3` mm): a vertex each, and its number as point data
/// "Handle".
void fillHandles(vtkPolyData* data, const Points& positions);

} // namespace viscera::vtk_filters
