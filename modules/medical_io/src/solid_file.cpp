#include "viscera/medical_io/solid_file.h"

#include <algorithm>
#include <utility>

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "quiet_vtk.h"
#include "text_scanner.h"
#include "viscera/core/atomic_file.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

vtkSmartPointer<vtkDoubleArray> doubles(const double* from, Eigen::Index rows, int columns) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetNumberOfComponents(columns);
  array->SetNumberOfTuples(rows);
  std::copy(from, from + rows * columns, array->GetPointer(0));
  return array;
}

struct ToVtk {
  vtkSmartPointer<vtkDataArray> operator()(const Values& values) const {
    return doubles(values.data(), values.size(), 1);
  }
  vtkSmartPointer<vtkDataArray> operator()(const Points& vectors) const {
    return doubles(vectors.data(), vectors.rows(), 3);
  }
  vtkSmartPointer<vtkDataArray> operator()(const std::vector<std::uint8_t>& flags) const {
    auto array = vtkSmartPointer<vtkUnsignedCharArray>::New();
    array->SetNumberOfTuples(static_cast<vtkIdType>(flags.size()));
    std::copy(flags.begin(), flags.end(), array->GetPointer(0));
    return array;
  }
};

void addCells(vtkUnstructuredGrid& grid, const deformation::Tetrahedra& tetrahedra, Eigen::Index points) {
  std::vector<bool> used(static_cast<std::size_t>(points), false);
  grid.Allocate(tetrahedra.rows());
  for (Eigen::Index t = 0; t < tetrahedra.rows(); ++t) {
    vtkIdType corners[4];
    for (int k = 0; k < 4; ++k) {
      corners[k] = tetrahedra(t, k);
      used[static_cast<std::size_t>(tetrahedra(t, k))] = true;
    }
    grid.InsertNextCell(VTK_TETRA, 4, corners);
  }
  for (vtkIdType i = 0; i < points; ++i)
    if (!used[static_cast<std::size_t>(i)])
      grid.InsertNextCell(VTK_VERTEX, 1, &i);
}

vtkSmartPointer<vtkUnstructuredGrid> gridOf(const Points& points, const deformation::Tetrahedra& tetrahedra,
                                            const std::vector<SolidArray>& arrays,
                                            const std::filesystem::path& file) {
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> places;
  places->SetData(doubles(points.data(), points.rows(), 3));
  grid->SetPoints(places);
  addCells(*grid, tetrahedra, points.rows());
  for (const SolidArray& array : arrays) {
    const auto values = std::visit(ToVtk(), array.values);
    if (values->GetNumberOfTuples() != points.rows())
      throw DataError(misuse("the array %1 has %2 values for %3 points", array.name,
                             values->GetNumberOfTuples(), points.rows()),
                      file.string());
    values->SetName(array.name.c_str());
    grid->GetPointData()->AddArray(values);
  }
  if (!arrays.empty())
    grid->GetPointData()->SetActiveScalars(arrays.front().name.c_str());
  return grid;
}

} // namespace

void writeSolid(const std::filesystem::path& file, const Points& points,
                const deformation::Tetrahedra& tetrahedra, const std::vector<SolidArray>& arrays) {
  if (file.extension() != ".vtu")
    throw CannotCreateError(phrase("this cannot be written as %1", inQuotes(file.extension().string())),
                            file.string(), phrase("let its name end in %1", ".vtu"));
  const auto grid = gridOf(points, tetrahedra, arrays, file);
  AtomicFile atomic(file);
  vtkNew<vtkXMLUnstructuredGridWriter> writer;
  const QuietVtk quiet(writer);
  writer->SetFileName(atomic.temporary().c_str());
  writer->SetInputData(grid);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  if (writer->Write() != 1 || quiet.failed())
    throw CannotCreateError(quiet.failed() ? phrase("the solid could not be written: %1", quiet.error())
                                           : "the solid could not be written",
                            file.string(), "check the space left on the disk");
  atomic.commit();
}

} // namespace viscera::medical_io
