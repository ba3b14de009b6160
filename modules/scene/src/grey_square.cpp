#include "grey_square.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>

namespace viscera::scene {

GreySquare::GreySquare() {
  const double corners[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell(4);
  points_->SetDataTypeToDouble();
  for (const auto& corner : corners) {
    polygons->InsertCellPoint(points_->InsertNextPoint(0, 0, 0));
    places->InsertNextTuple(corner);
  }
  data_->SetPoints(points_);
  data_->SetPolys(polygons);
  data_->GetPointData()->SetTCoords(places);
  texture_->SetInputData(image_);
  texture_->SetColorModeToDirectScalars();
  texture_->SetWrap(vtkTexture::ClampToEdge);
}

void GreySquare::setCorners(const std::array<Vec3, 4>& corners) {
  for (vtkIdType i = 0; i < 4; ++i)
    points_->SetPoint(i, corners[static_cast<std::size_t>(i)].data());
  points_->Modified();
}

void GreySquare::setGrey(int width, int height, const std::vector<std::uint8_t>& grey) {
  const int* size = image_->GetDimensions();
  if (size[0] != width || size[1] != height || !image_->GetPointData()->GetScalars()) {
    image_->SetDimensions(width, height, 1);
    image_->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  }
  auto* out = static_cast<std::uint8_t*>(image_->GetScalarPointer());
  for (const std::uint8_t level : grey) {
    out[0] = out[1] = out[2] = level;
    out += 3;
  }
  image_->Modified();
}

} // namespace viscera::scene
