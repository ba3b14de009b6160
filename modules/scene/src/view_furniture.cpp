#include "view_furniture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <vtkCamera.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

#include "viscera/scene/legend.h"
#include "viscera/scene/organ_view.h"

#include "orientation_cube.h"
#include "view_geometry.h"

namespace viscera::scene {
namespace {

/// Logical pixels.
constexpr double kNarrowWidth = 480;
constexpr double kLongest = 180;
constexpr double kScaleBarBottom = 20;
constexpr double kScaleBarTick = 5;
constexpr double kCornerGap = 4;
constexpr double kTextGap = 6;
/// Heights of line and number in a small view, and what the number takes to the right of the line.
constexpr double kLowBottom = 6, kLowTextBottom = 3, kNumberRoom = 64;
constexpr double kScaleBarWidth = 1.5;
constexpr int kScaleBarFontSize = 13;
constexpr double kGroundOfNumber = 0.7; ///< Opacity.
constexpr double kSmallCube = 0.65;     ///< Of the usual size.

bool isSmall(vtkRenderer* renderer, double typeScale) {
  return renderer->GetSize()[0] < typeScale * pixelRatioOf(renderer->GetRenderWindow()) * kNarrowWidth;
}

} // namespace

bool isNarrow(vtkRenderer* renderer, double typeScale) {
  const int* size = renderer->GetSize();
  return size[0] < size[1] && isSmall(renderer, typeScale);
}

double orientationCorner(vtkRenderer* renderer, double typeScale) {
  const double usual = typeScale * kOrientationCorner * pixelRatioOf(renderer->GetRenderWindow());
  return isNarrow(renderer, typeScale) ? kSmallCube * usual : usual;
}

double roundLength(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0})
    if (step * power <= most)
      return step * power;
  return power;
}

ScaleBar::ScaleBar(vtkRenderer* renderer)
    : text_(newText(kScaleBarFontSize)), beforeRender_([this] { follow(); }) {
  line_.points->SetNumberOfPoints(4);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({0, 1, 2, 3});
  line_.data->SetLines(lines);
  text_->GetTextProperty()->SetJustificationToCentered();
  text_->GetTextProperty()->SetVerticalJustificationToBottom();
  renderer->AddActor2D(line_.actor);
  renderer->AddActor2D(text_);
  beforeRender_.setRenderer(renderer);
}

ScaleBar::~ScaleBar() = default;

void ScaleBar::setTheme(const Theme& theme) {
  line_.actor->GetProperty()->SetColor(theme.text.x(), theme.text.y(), theme.text.z());
  auto* letters = text_->GetTextProperty();
  letters->SetColor(theme.text.x(), theme.text.y(), theme.text.z());
  // Handles lie between it and the view's ground, of which it takes the colour along.
  const Vec3& ground = theme.backgroundBottom;
  letters->SetBackgroundColor(ground.x(), ground.y(), ground.z());
  letters->SetBackgroundOpacity(kGroundOfNumber);
  setTextSize(text_, kScaleBarFontSize, theme);
  typeScale_ = theme.typeScale;
}

void ScaleBar::setShown(bool shown) {
  line_.actor->SetVisibility(shown);
  text_->SetVisibility(shown);
}

void ScaleBar::follow() {
  auto* renderer = beforeRender_.renderer();
  const auto view = viewGeometry(renderer);
  const double ratio = typeScale_ * view.pixelRatio;
  const double pixel = view.worldPerPixel(renderer->GetActiveCamera()->GetDistance());
  if (!(pixel > 0) || !std::isfinite(pixel))
    return;
  // The bar stands in the middle, but not over the orientation cube of a narrow view.
  const double width = renderer->GetSize()[0];
  const double corner = orientationCorner(renderer, typeScale_) + ratio * kCornerGap;
  const double shortest = 0.25 * width;
  const double rest = width - corner - ratio * kCornerGap;
  const bool low = isSmall(renderer, typeScale_) && rest >= shortest + ratio * kNumberRoom;
  const double beside = low ? ratio * kNumberRoom : 0;
  const double most = std::min(ratio * kLongest, std::max(shortest, rest - beside));
  const double length = roundLength(pixel * most);
  const double half = 0.5 * length / pixel;
  const double middle =
      std::min(std::max(0.5 * (width - beside), corner + half), width - beside - half - ratio * kCornerGap);
  char label[32];
  std::snprintf(label, sizeof label, "%g mm", length);
  text_->SetInput(withDecimalMark(label, decimalMark_).c_str());
  text_->GetTextProperty()->SetJustification(low ? VTK_TEXT_LEFT : VTK_TEXT_CENTERED);
  if (low)
    text_->SetPosition(middle + half + ratio * kTextGap, ratio * kLowTextBottom);
  else
    text_->SetPosition(middle, ratio * (kScaleBarBottom + kTextGap));
  place(middle - half, middle + half, ratio * (low ? kLowBottom : kScaleBarBottom), ratio);
}

void ScaleBar::place(double left, double right, double bottom, double ratio) {
  const double top = bottom + ratio * kScaleBarTick;
  line_.points->SetPoint(0, left, top, 0);
  line_.points->SetPoint(1, left, bottom, 0);
  line_.points->SetPoint(2, right, bottom, 0);
  line_.points->SetPoint(3, right, top, 0);
  line_.points->Modified();
  line_.actor->GetProperty()->SetLineWidth(static_cast<float>(kScaleBarWidth * ratio));
}

} // namespace viscera::scene
