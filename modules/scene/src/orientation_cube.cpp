#include "orientation_cube.h"

#include <vtkAnnotatedCubeActor.h>
#include <vtkCamera.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include "viscera/scene/organ_view.h"

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

} // namespace viscera::scene
