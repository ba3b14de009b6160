#include "handle_glyphs.h"

#include <array>
#include <cmath>

#include <vtkFloatArray.h>
#include <vtkGlyph3DMapper.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>
#include <vtkViewport.h>

namespace viscera::scene {
namespace {

/// A ball of 10 pixels is off a circle by a quarter of a pixel with so many sides.
constexpr int kHandleBallSides = 14;
constexpr double kHandleGhostOpacity = 0.28;
constexpr double kGhostRimOpacity = 0.14;
constexpr const char* kRadii = "radius";

void configure(vtkGlyph3DMapper* mapper, vtkPolyData* glyphs, vtkSphereSource* ball) {
  mapper->SetInputData(glyphs);
  mapper->SetSourceConnection(ball->GetOutputPort());
  mapper->SetScaling(true);
  mapper->SetScaleModeToScaleByMagnitude();
  mapper->SetScaleArray(kRadii);
  mapper->SetScaleFactor(1);
  mapper->SetScalarModeToUsePointData();
  mapper->SetColorModeToDirectScalars();
  mapper->SetOrient(false);
}

} // namespace

HandleGlyphs::Layer::Layer(vtkSphereSource* ball) {

  points->SetDataTypeToDouble();
  radii->SetName(kRadii);
  colors->SetNumberOfComponents(4);
  colors->SetName("color");
  data->SetPoints(points);
  data->GetPointData()->SetScalars(colors);
  data->GetPointData()->AddArray(radii);
  configure(mapper, data, ball);
}

HandleGlyphs::Layer::~Layer() = default;

void HandleGlyphs::Layer::resize(vtkIdType count) {
  points->SetNumberOfPoints(count);
  radii->SetNumberOfTuples(count);
  colors->SetNumberOfTuples(count);
}

void HandleGlyphs::Layer::put(vtkIdType i, const Vec3& position, double radius, const Vec3& color,
                              double opacity) {
  points->SetPoint(i, position.data());
  radii->SetValue(i, static_cast<float>(radius));
  for (int c = 0; c < 3; ++c)
    colors->SetTypedComponent(i, c, static_cast<unsigned char>(std::lround(255 * color[c])));
  colors->SetTypedComponent(i, 3, static_cast<unsigned char>(std::lround(255 * opacity)));
}

void HandleGlyphs::Layer::changed() {
  points->Modified();
  radii->Modified();
  colors->Modified();
  data->Modified();
  mapper->Update(); // The glyph mapper draws nothing when its input has changed since the last update.
}

HandleGlyphs::HandleGlyphs() : balls_(ball_), rims_(ball_), ghosts_(ball_), ghostRims_(ball_) {
  ball_->SetRadius(1);
  ball_->SetThetaResolution(kHandleBallSides);
  ball_->SetPhiResolution(kHandleBallSides * 2 / 3);
  actor_->SetMapper(balls_.mapper);
  actor_->GetProperty()->SetAmbient(0.12);
  actor_->GetProperty()->SetDiffuse(0.9);
  actor_->GetProperty()->SetSpecular(0.35);
  actor_->GetProperty()->SetSpecularPower(30);
  actor_->GetProperty()->BackfaceCullingOn();
  rimActor_->SetMapper(rims_.mapper);
  rimActor_->GetProperty()->LightingOff();
  rimActor_->GetProperty()->FrontfaceCullingOn();
  ghostActor_->SetMapper(ghosts_.mapper);
  ghostActor_->GetProperty()->BackfaceCullingOn();
  ghostRimActor_->SetMapper(ghostRims_.mapper);
  ghostRimActor_->GetProperty()->FrontfaceCullingOn();
  for (BlendedActor* ghost : {ghostActor_.Get(), ghostRimActor_.Get()}) {
    ghost->setBehindOnly(true);
    ghost->GetProperty()->LightingOff();
  }
}

HandleGlyphs::~HandleGlyphs() = default;

void HandleGlyphs::set(const std::vector<HandleGlyph>& glyphs) {
  const auto count = static_cast<vtkIdType>(glyphs.size());
  for (Layer* layer : {&balls_, &rims_, &ghosts_, &ghostRims_})
    layer->resize(count);
  for (vtkIdType i = 0; i < count; ++i) {
    const auto& glyph = glyphs[std::size_t(i)];
    balls_.put(i, glyph.position, glyph.radius, glyph.color);
    rims_.put(i, glyph.position, glyph.rimRadius, glyph.rimColor);
    ghosts_.put(i, glyph.position, glyph.radius, glyph.color, kHandleGhostOpacity * glyph.ghost);
    ghostRims_.put(i, glyph.position, glyph.rimRadius, glyph.rimColor, kGhostRimOpacity * glyph.ghost);
  }
  for (Layer* layer : {&balls_, &rims_, &ghosts_, &ghostRims_})
    layer->changed();
}

int HandleGlyphs::render(vtkViewport* viewport) {
  if (balls_.points->GetNumberOfPoints() == 0)
    return 0;
  ghostRimActor_->RenderOpaqueGeometry(viewport);
  ghostActor_->RenderOpaqueGeometry(viewport);
  rimActor_->RenderOpaqueGeometry(viewport);
  return actor_->RenderOpaqueGeometry(viewport);
}

void HandleGlyphs::release(vtkWindow* window) {
  const std::array<vtkActor*, 4> actors = {actor_.Get(), rimActor_.Get(), ghostActor_.Get(),
                                           ghostRimActor_.Get()};
  for (vtkActor* actor : actors)
    actor->ReleaseGraphicsResources(window);
}

} // namespace viscera::scene
