#include "leaves.h"

#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkPointSet.h>
#include <vtkPoints.h>

namespace viscera::vtk_filters {
namespace {

void requirePoints(vtkDataObject* block, const std::string& where) {
  if (!vtkPointSet::SafeDownCast(block))
    throw DataError(std::string("a ") + block->GetClassName() + " has no points that could move", where,
                    "give polygons or an unstructured grid");
}

} // namespace

std::vector<Leaf> copyLeaves(vtkDataObject* input, vtkDataObject* output) {
  std::vector<Leaf> leaves;
  auto* blocks = vtkCompositeDataSet::SafeDownCast(input);
  if (!blocks) {
    requirePoints(input, "input");
    output->ShallowCopy(input);
    leaves.push_back({vtkPointSet::SafeDownCast(input), vtkPointSet::SafeDownCast(output)});
    return leaves;
  }
  auto* copies = vtkCompositeDataSet::SafeDownCast(output);
  copies->CopyStructure(blocks);
  auto place = vtk::TakeSmartPointer(blocks->NewIterator());
  for (place->InitTraversal(); !place->IsDoneWithTraversal(); place->GoToNextItem()) {
    auto* block = place->GetCurrentDataObject();
    requirePoints(block, "block " + std::to_string(place->GetCurrentFlatIndex()));
    auto copy = vtk::TakeSmartPointer(block->NewInstance());
    copy->ShallowCopy(block);
    copies->SetDataSet(place, copy);
    leaves.push_back({vtkPointSet::SafeDownCast(block), vtkPointSet::SafeDownCast(copy.Get())});
  }
  return leaves;
}

Points pointsOf(vtkPointSet* set, vtkIdType begin, vtkIdType end) {
  Points points(end - begin, 3);
  for (vtkIdType i = begin; i < end; ++i) {
    set->GetPoint(i, points.row(i - begin).data());
    if (!points.row(i - begin).allFinite())
      throw DataError("its position is not a finite number", "point " + std::to_string(i));
  }
  return points;
}

vtkSmartPointer<vtkPoints> newPoints(vtkIdType count) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  return points;
}

double* memoryOf(vtkPoints* points) {
  return static_cast<vtkDoubleArray*>(points->GetData())->GetPointer(0);
}

} // namespace viscera::vtk_filters
