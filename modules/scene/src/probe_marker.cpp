#include "viscera/scene/probe_marker.h"

#include <algorithm>
#include <array>

#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>

#include "viscera/scene/organ_view.h"

#include "before_render.h"
#include "blended_actor.h"
#include "view_geometry.h"

namespace viscera::scene {
namespace {
/// Logical pixels.
constexpr double kRadius = 5;
constexpr double kRimRadius = 7;
constexpr double kBehindOpacity = 0.45;
constexpr int kSides = 24;
} // namespace

struct ProbeMarker::Parts {
  Vec3 position = Vec3::Zero();
  vtkNew<BlendedActor> ball;
  vtkNew<BlendedActor> rim;
  vtkNew<BlendedActor> behind;
  vtkNew<vtkMatrix4x4> ballMatrix;
  vtkNew<vtkMatrix4x4> rimMatrix;
  BeforeRender beforeRender{[this] { follow(); }};

  std::array<BlendedActor*, 3> actors() { return {behind.Get(), rim.Get(), ball.Get()}; }
  void follow();
};

void ProbeMarker::Parts::follow() {
  if (!ball->GetVisibility())
    return;
  auto* renderer = beforeRender.renderer();
  const auto view = viewGeometry(renderer);
  const double pixel = pixelRatioOf(renderer->GetRenderWindow()) *
                       view.worldPerPixel(std::max((position - view.eye).dot(view.forward), 0.0));
  for (int i = 0; i < 3; ++i) {
    ballMatrix->SetElement(i, i, kRadius * pixel);
    rimMatrix->SetElement(i, i, kRimRadius * pixel);
    ballMatrix->SetElement(i, 3, position[i]);
    rimMatrix->SetElement(i, 3, position[i]);
  }
}

ProbeMarker::ProbeMarker() : parts_(std::make_unique<Parts>()) {
  auto& p = *parts_;
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1);
  sphere->SetThetaResolution(kSides);
  sphere->SetPhiResolution(kSides);
  for (BlendedActor* actor : p.actors()) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    actor->SetMapper(mapper);
    actor->SetUserMatrix(actor == p.rim ? p.rimMatrix : p.ballMatrix);
    actor->GetProperty()->LightingOff();
    actor->SetVisibility(false);
  }
  p.rim->GetProperty()->FrontfaceCullingOn();
  p.ball->GetProperty()->BackfaceCullingOn();
  p.behind->GetProperty()->BackfaceCullingOn();
  p.behind->setBehindOnly(true);
  p.behind->GetProperty()->SetOpacity(kBehindOpacity);
  setTheme(darkTheme());
}

ProbeMarker::~ProbeMarker() {
  setRenderer(nullptr);
}

void ProbeMarker::setRenderer(vtkRenderer* renderer) {
  parts_->beforeRender.setRenderer(renderer, parts_->actors());
}

void ProbeMarker::setTheme(const Theme& theme) {
  auto& p = *parts_;
  p.ball->GetProperty()->SetColor(1, 1, 1);
  p.behind->GetProperty()->SetColor(theme.accent.x(), theme.accent.y(), theme.accent.z());
  p.rim->GetProperty()->SetColor(0.08, 0.09, 0.1);
}

void ProbeMarker::show(const Vec3& position) {
  parts_->position = position;
  for (auto* actor : parts_->actors())
    actor->SetVisibility(true);
}

void ProbeMarker::hide() {
  for (auto* actor : parts_->actors())
    actor->SetVisibility(false);
}

bool ProbeMarker::visible() const {
  return parts_->ball->GetVisibility() != 0;
}

Vec3 ProbeMarker::position() const {
  return parts_->position;
}

} // namespace viscera::scene
