#include "viscera/scene/mirror_plane_glyph.h"

#include <array>
#include <utility>

#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkWeakPointer.h>

#include "blended_actor.h"

namespace viscera::scene {
namespace {

constexpr double kFillOpacity = 0.10;
constexpr double kRimOpacity = 0.55;
constexpr double kBehind = 0.4;

/// The square [-1, 1] x [-1, 1] in the plane x = 0, or its rim.
vtkSmartPointer<vtkPolyData> square(bool filled) {
  vtkNew<vtkPoints> corners;
  for (const auto& [y, z] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    corners->InsertNextPoint(0, y, z);
  const std::array<vtkIdType, 5> around = {0, 1, 2, 3, 0};
  vtkNew<vtkCellArray> cell;
  cell->InsertNextCell(filled ? 4 : 5, around.data());
  auto shape = vtkSmartPointer<vtkPolyData>::New();
  shape->SetPoints(corners);
  filled ? shape->SetPolys(cell) : shape->SetLines(cell);
  return shape;
}

} // namespace

struct MirrorPlaneGlyph::Parts {
  vtkNew<BlendedActor> fill, rim, fillBehind, rimBehind;
  vtkNew<vtkMatrix4x4> matrix;
  vtkWeakPointer<vtkRenderer> renderer;

  std::array<BlendedActor*, 4> actors() { return {fillBehind.Get(), rimBehind.Get(), fill.Get(), rim.Get()}; }
};

MirrorPlaneGlyph::MirrorPlaneGlyph() : parts_(std::make_unique<Parts>()) {
  auto& p = *parts_;
  const auto attach = [&p](BlendedActor* actor, bool filled, double opacity) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(square(filled));
    actor->SetMapper(mapper);
    actor->SetUserMatrix(p.matrix);
    actor->SetVisibility(false);
    actor->PickableOff();
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetOpacity(opacity);
  };
  attach(p.fill, true, kFillOpacity);
  attach(p.rim, false, kRimOpacity);
  attach(p.fillBehind, true, kBehind * kFillOpacity);
  attach(p.rimBehind, false, kBehind * kRimOpacity);
  p.fillBehind->setBehindOnly(true);
  p.rimBehind->setBehindOnly(true);
  setTheme(darkTheme());
}

MirrorPlaneGlyph::~MirrorPlaneGlyph() {
  setRenderer(nullptr);
}

void MirrorPlaneGlyph::setRenderer(vtkRenderer* renderer) {
  auto& p = *parts_;
  for (auto* actor : p.actors()) {
    if (p.renderer)
      p.renderer->RemoveActor(actor);
    if (renderer)
      renderer->AddActor(actor);
  }
  p.renderer = renderer;
}

void MirrorPlaneGlyph::setTheme(const Theme& theme) {
  for (auto* actor : parts_->actors())
    actor->GetProperty()->SetColor(theme.text.x(), theme.text.y(), theme.text.z());
}

void MirrorPlaneGlyph::show(const Vec3& center, const Vec3& normal, double halfSize) {
  auto& p = *parts_;
  // Its sides run along the patient's axes where the normal is one of them.
  Eigen::Index smallest = 0;
  normal.cwiseAbs().minCoeff(&smallest);
  const Vec3 side = normal.cross(Vec3::Unit(smallest)).normalized(), third = normal.cross(side);
  for (int row = 0; row < 3; ++row) {
    p.matrix->SetElement(row, 0, normal[row]);
    p.matrix->SetElement(row, 1, halfSize * side[row]);
    p.matrix->SetElement(row, 2, halfSize * third[row]);
    p.matrix->SetElement(row, 3, center[row]);
  }
  for (auto* actor : p.actors())
    actor->SetVisibility(true);
}

void MirrorPlaneGlyph::hide() {
  for (auto* actor : parts_->actors())
    actor->SetVisibility(false);
}

bool MirrorPlaneGlyph::visible() const {
  return parts_->fill->GetVisibility() != 0;
}

void MirrorPlaneGlyph::drawAfterOrgans() {
  if (parts_->renderer)
    for (auto* actor : parts_->actors())
      drawLast(parts_->renderer, actor);
}

} // namespace viscera::scene
