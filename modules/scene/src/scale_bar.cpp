#include "scale_bar.h"

#include <cmath>
#include <cstdio>

#include <vtkActor2D.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include "viscera/scene/organ_view.h"

#include "view_geometry.h"

namespace viscera::scene {
namespace {

/// Logical pixels.
constexpr double kLongest = 180;
constexpr double kBottom = 20;
constexpr double kTick = 5;
constexpr double kTextGap = 6;
constexpr double kLineWidth = 1.5;
constexpr int kFontSize = 13;

} // namespace

double roundLength(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0})
    if (step * power <= most)
      return step * power;
  return power;
}

ScaleBar::ScaleBar(vtkRenderer* renderer) : beforeRender_([this] { follow(); }) {
  points_->SetNumberOfPoints(4);
  vtkNew<vtkCellArray> lines;
  const vtkIdType corners[] = {0, 1, 2, 3};
  lines->InsertNextCell(4, corners);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points_);
  data->SetLines(lines);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  line_->SetMapper(mapper);
  auto* text = text_->GetTextProperty();
  text->SetFontFamilyToArial();
  text->SetFontSize(kFontSize);
  text->SetJustificationToCentered();
  text->SetVerticalJustificationToBottom();
  renderer->AddActor2D(line_);
  renderer->AddActor2D(text_);
  beforeRender_.setRenderer(renderer);
}

ScaleBar::~ScaleBar() = default;

void ScaleBar::setTheme(const Theme& theme) {
  line_->GetProperty()->SetColor(theme.text.x(), theme.text.y(), theme.text.z());
  text_->GetTextProperty()->SetColor(theme.text.x(), theme.text.y(), theme.text.z());
}

void ScaleBar::setShown(bool shown) {
  line_->SetVisibility(shown);
  text_->SetVisibility(shown);
}

void ScaleBar::follow() {
  auto* renderer = beforeRender_.renderer();
  const double ratio = pixelRatioOf(renderer->GetRenderWindow());
  const auto view = viewGeometry(renderer);
  const double pixel = view.worldPerPixel(renderer->GetActiveCamera()->GetDistance());
  if (!(pixel > 0) || !std::isfinite(pixel))
    return;
  const double length = roundLength(pixel * ratio * kLongest);
  const double half = 0.5 * length / pixel;
  const double middle = 0.5 * renderer->GetSize()[0], y = ratio * kBottom;
  points_->SetPoint(0, middle - half, y + ratio * kTick, 0);
  points_->SetPoint(1, middle - half, y, 0);
  points_->SetPoint(2, middle + half, y, 0);
  points_->SetPoint(3, middle + half, y + ratio * kTick, 0);
  points_->Modified();
  line_->GetProperty()->SetLineWidth(static_cast<float>(kLineWidth * ratio));
  char label[32];
  std::snprintf(label, sizeof label, "%g mm", length);
  text_->SetInput(label);
  text_->SetPosition(middle, y + ratio * kTextGap);
}

} // namespace viscera::scene
