#include "flat_shape.h"

#include <cmath>
#include <vector>

#include <vtkPolyDataMapper2D.h>
#include <vtkTextProperty.h>

namespace viscera::scene {

FlatShape::FlatShape() {
  data->SetPoints(points);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  actor->SetMapper(mapper);
}

void FlatShape::end() {
  points->Modified();
  data->Modified();
}

void FlatShape::addBox(double left, double bottom, double right, double top, vtkCellArray* polygons) {
  polygons->InsertNextCell({add(left, bottom), add(right, bottom), add(right, top), add(left, top)});
}

void FlatShape::addDisc(double x, double y, double radius, int corners, vtkCellArray* polygons) {
  polygons->InsertNextCell(corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners;
    polygons->InsertCellPoint(add(x + radius * std::cos(angle), y + radius * std::sin(angle)));
  }
}

vtkSmartPointer<vtkTextActor> newText(int size) {
  auto text = vtkSmartPointer<vtkTextActor>::New();
  text->GetTextProperty()->SetFontSize(size);
  return text;
}

void setTextSize(vtkTextActor* text, double size, const Theme& theme) {
  text->GetTextProperty()->SetFontSize(static_cast<int>(std::lround(size * theme.typeScale)));
}

} // namespace viscera::scene
