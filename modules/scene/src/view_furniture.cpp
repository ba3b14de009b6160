#include "view_furniture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <vtkAnnotatedCubeActor.h>
#include <vtkCamera.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

#include "viscera/scene/organ_view.h"

#include "view_geometry.h"

namespace viscera::scene {
namespace {

/// Logical pixels of the corner that the cube has for itself.
constexpr double kCorner = 96;
constexpr double kCameraDistance = 5.2;

void paint(vtkProperty* property, const Vec3& color) {
  property->SetColor(color.x(), color.y(), color.z());
  property->SetAmbient(1);
  property->SetDiffuse(0);
}

/// Logical pixels.
constexpr double kLongest = 180;
constexpr double kBottom = 20;
constexpr double kTick = 5;
constexpr double kTextGap = 6;
constexpr double kLineWidth = 1.5;
constexpr int kFontSize = 13;

} // namespace

OrientationCube::OrientationCube(vtkRenderer* followed)
    : followed_(followed), beforeRender_([this] { follow(); }) {
  cube_->SetXPlusFaceText("L");
  cube_->SetXMinusFaceText("R");
  cube_->SetYPlusFaceText("P");
  cube_->SetYMinusFaceText("A");
  cube_->SetZPlusFaceText("S");
  cube_->SetZMinusFaceText("I");
  cube_->SetXFaceTextRotation(0);
  cube_->SetYFaceTextRotation(0);
  cube_->SetZFaceTextRotation(-90);
  cube_->SetFaceTextScale(0.62);
  cube_->GetCubeProperty()->SetAmbient(0.35);
  cube_->GetCubeProperty()->SetDiffuse(0.7);
  renderer_->AddViewProp(cube_);
  renderer_->SetLayer(1);
  renderer_->InteractiveOff();
  beforeRender_.setRenderer(followed);
}

OrientationCube::~OrientationCube() = default;

void OrientationCube::setTheme(const Theme& theme) {
  const Vec3 face = theme.dark ? Vec3(0.36, 0.41, 0.45) : Vec3(0.93, 0.95, 0.96);
  cube_->GetCubeProperty()->SetColor(face.x(), face.y(), face.z());
  cube_->GetTextEdgesProperty()->SetColor(face.x(), face.y(), face.z());
  for (auto* property :
       {cube_->GetXPlusFaceProperty(), cube_->GetXMinusFaceProperty(), cube_->GetYPlusFaceProperty(),
        cube_->GetYMinusFaceProperty(), cube_->GetZPlusFaceProperty(), cube_->GetZMinusFaceProperty()})
    paint(property, theme.text);
}

void OrientationCube::setShown(bool shown) {
  cube_->SetVisibility(shown);
}

void OrientationCube::follow() {
  auto* window = followed_->GetRenderWindow();
  const int* size = window->GetSize();
  const double corner = kCorner * pixelRatioOf(window);
  renderer_->SetViewport(0, 0, std::min(1.0, corner / std::max(1, size[0])),
                         std::min(1.0, corner / std::max(1, size[1])));
  auto* from = followed_->GetActiveCamera();
  auto* camera = renderer_->GetActiveCamera();
  const Vec3 direction(from->GetDirectionOfProjection());
  const Vec3 position = -kCameraDistance * direction;
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(position.data());
  camera->SetViewUp(from->GetViewUp());
  camera->SetViewAngle(24);
  renderer_->ResetCameraClippingRange();
}

double roundLength(double most) {
  const double power = std::pow(10, std::floor(std::log10(most)));
  for (const double step : {5.0, 2.0})
    if (step * power <= most)
      return step * power;
  return power;
}

ScaleBar::ScaleBar(vtkRenderer* renderer) : text_(newText(kFontSize)), beforeRender_([this] { follow(); }) {
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
  text_->GetTextProperty()->SetColor(theme.text.x(), theme.text.y(), theme.text.z());
}

void ScaleBar::setShown(bool shown) {
  line_.actor->SetVisibility(shown);
  text_->SetVisibility(shown);
}

void ScaleBar::follow() {
  auto* renderer = beforeRender_.renderer();
  const auto view = viewGeometry(renderer);
  const double ratio = view.pixelRatio;
  const double pixel = view.worldPerPixel(renderer->GetActiveCamera()->GetDistance());
  if (!(pixel > 0) || !std::isfinite(pixel))
    return;
  const double length = roundLength(pixel * ratio * kLongest);
  const double half = 0.5 * length / pixel;
  const double middle = 0.5 * renderer->GetSize()[0], y = ratio * kBottom;
  line_.points->SetPoint(0, middle - half, y + ratio * kTick, 0);
  line_.points->SetPoint(1, middle - half, y, 0);
  line_.points->SetPoint(2, middle + half, y, 0);
  line_.points->SetPoint(3, middle + half, y + ratio * kTick, 0);
  line_.points->Modified();
  line_.actor->GetProperty()->SetLineWidth(static_cast<float>(kLineWidth * ratio));
  char label[32];
  std::snprintf(label, sizeof label, "%g mm", length);
  text_->SetInput(label);
  text_->SetPosition(middle, y + ratio * kTextGap);
}

} // namespace viscera::scene
