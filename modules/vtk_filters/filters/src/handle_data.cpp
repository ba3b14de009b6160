#include "handle_data.h"

#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include "leaves.h"

namespace viscera::vtk_filters {

void fillHandles(vtkPolyData* data, const Points& positions) {
  auto points = newPoints(positions.rows());
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Handle");
  std::copy_n(positions.data(), positions.size(), memoryOf(points));
  for (vtkIdType i = 0; i < positions.rows(); ++i) {
    vertices->InsertNextCell(1, &i);
    numbers->InsertNextValue(static_cast<int>(i));
  }
  data->Initialize();
  data->SetPoints(points);
  data->SetVerts(vertices);
  data->GetPointData()->AddArray(numbers);
}

} // namespace viscera::vtk_filters
