#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellType.h>
#include <vtkDataSetAttributes.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include "viscera/core/arrays.h"
#include "viscera/core/error.h"

class vtkDataObject;
class vtkPoints;
class vtkPointSet;

namespace viscera::vtk_filters {

/// One set of points of the input and its copy in the output.
struct Leaf {
  vtkPointSet* from = nullptr;
  vtkPointSet* to = nullptr;
};

/// Copies the input, shallow, into the output and pairs the leaves with points; blocks without points are
/// left out. Throws `DataError` for a block that has cells but no points of its own (an image).
std::vector<Leaf> copyLeaves(vtkDataObject* input, vtkDataObject* output);

/// Rows [begin, end) of the points, mm. Throws `DataError` that names the first one that is not finite.
Points pointsOf(vtkPointSet* set, vtkIdType begin, vtkIdType end);

/// All points in double precision, to be filled; and the memory of such.
vtkSmartPointer<vtkPoints> newPoints(vtkIdType count);
double* memoryOf(vtkPoints* points);

/// The corner of a point in such memory.
inline Vec3 corner(const double* memory, vtkIdType id) {
  return Eigen::Map<const Vec3>(memory + 3 * id);
}

/// Calls `triangle(a, b, c)` for every triangle of the cells (polygons as fans) and `tetrahedron(a, b, c, d)`
/// for every tetrahedron, with the rows of their points; ghost and hidden cells, vertices and lines do not
/// count. Throws `DataError` that names the first cell of another kind. For any thread, and several.
template <typename Triangle, typename Tetrahedron>
void forEachCell(vtkPointSet* set, Triangle triangle, Tetrahedron tetrahedron) {
  auto* surface = vtkPolyData::SafeDownCast(set);
  auto* grid = vtkUnstructuredGrid::SafeDownCast(set);
  if (!surface && !grid)
    throw DataError(std::string("a ") + set->GetClassName() + " has no surface and no tetrahedra", "cells",
                    "extract its surface, or tetrahedralise it");
  if (surface && surface->GetNumberOfStrips() > 0)
    throw DataError("there are triangle strips", "cells", "triangulate them");
  vtkCellArray* cells = surface ? surface->GetPolys() : grid->GetCells();
  if (!cells || cells->GetNumberOfCells() == 0)
    return;
  const vtkIdType first = surface ? surface->GetNumberOfVerts() + surface->GetNumberOfLines() : 0;
  auto* ghosts = set->GetCellGhostArray();
  constexpr unsigned char kGhost = vtkDataSetAttributes::DUPLICATECELL | vtkDataSetAttributes::HIDDENCELL;
  auto cell = vtk::TakeSmartPointer(cells->NewIterator());
  for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
    const vtkIdType number = cell->GetCurrentCellId();
    if (ghosts && (ghosts->GetValue(first + number) & kGhost))
      continue;
    vtkIdType count = 0;
    const vtkIdType* id = nullptr;
    cell->GetCurrentCell(count, id);
    switch (surface ? static_cast<int>(VTK_POLYGON) : grid->GetCellType(number)) {
    case VTK_TETRA:
      tetrahedron(id[0], id[1], id[2], id[3]);
      break;
    case VTK_TRIANGLE:
    case VTK_QUAD:
    case VTK_POLYGON:
      for (vtkIdType i = 2; i < count; ++i)
        triangle(id[0], id[i - 1], id[i]);
      break;
    case VTK_EMPTY_CELL:
    case VTK_VERTEX:
    case VTK_POLY_VERTEX:
    case VTK_LINE:
    case VTK_POLY_LINE:
      break;
    default:
      throw DataError("it is of VTK's type " + std::to_string(grid->GetCellType(number)),
                      "cell " + std::to_string(number), "use triangles, polygons or tetrahedra");
    }
  }
}

/// Whether the point belongs to another rank.
inline bool isGhostPoint(vtkUnsignedCharArray* ghosts, vtkIdType point) {
  return ghosts && (ghosts->GetValue(point) & vtkDataSetAttributes::DUPLICATEPOINT);
}

} // namespace viscera::vtk_filters
