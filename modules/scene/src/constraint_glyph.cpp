#include "viscera/scene/constraint_glyph.h"

#include <algorithm>
#include <array>
#include <utility>

#include <vtkArrowSource.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRegularPolygonSource.h>
#include <vtkRenderer.h>

#include "viscera/scene/organ_view.h"

#include "before_render.h"
#include "blended_actor.h"
#include "view_geometry.h"

namespace viscera::scene {
namespace {

/// Logical pixels.
constexpr double kDiscRadius = 72;
constexpr double kArrowLength = 64;
constexpr double kRimWidth = 1.5;
constexpr double kDiscOpacity = 0.22;
constexpr double kRimOpacity = 0.85;
/// What an organ hides of the plane is this much fainter.
constexpr double kBehind = 0.4;
constexpr int kSides = 72;
const Vec3 kArrowColor(0.96, 0.65, 0.14);

vtkNew<vtkRegularPolygonSource> polygon(bool filled) {
  vtkNew<vtkRegularPolygonSource> source;
  source->SetNumberOfSides(kSides);
  source->SetRadius(1);
  source->SetNormal(1, 0, 0);
  source->SetGeneratePolygon(filled);
  source->SetGeneratePolyline(!filled);
  return source;
}

} // namespace

struct ConstraintGlyph::Parts {
  Vec3 origin = Vec3::Zero();
  Vec3 normal = Vec3::UnitX();

  /// Disc, rim and arrow are made around the x axis and put in place by one matrix each.
  vtkNew<BlendedActor> disc;
  vtkNew<BlendedActor> rim;
  vtkNew<BlendedActor> discBehind;
  vtkNew<BlendedActor> rimBehind;
  vtkNew<vtkActor> arrow;
  vtkNew<vtkMatrix4x4> discMatrix;
  vtkNew<vtkMatrix4x4> arrowMatrix;
  BeforeRender beforeRender{[this] { follow(); }};

  std::array<vtkActor*, 5> actors() {
    return {discBehind.Get(), rimBehind.Get(), disc.Get(), rim.Get(), arrow.Get()};
  }
  void build();
  void follow();
  void place(vtkMatrix4x4* matrix, double scale) const;
};

void ConstraintGlyph::Parts::build() {
  const auto attach = [](vtkActor* actor, vtkAlgorithmOutput* source, vtkMatrix4x4* matrix) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source);
    actor->SetMapper(mapper);
    actor->SetUserMatrix(matrix);
    actor->SetVisibility(false);
    actor->PickableOff();
  };
  const auto inside = polygon(true), around = polygon(false);
  attach(disc, inside->GetOutputPort(), discMatrix);
  attach(discBehind, inside->GetOutputPort(), discMatrix);
  attach(rim, around->GetOutputPort(), discMatrix);
  attach(rimBehind, around->GetOutputPort(), discMatrix);
  vtkNew<vtkArrowSource> source;
  source->SetShaftResolution(20);
  source->SetTipResolution(20);
  source->SetShaftRadius(0.025);
  source->SetTipRadius(0.08);
  source->SetTipLength(0.26);
  attach(arrow, source->GetOutputPort(), arrowMatrix);
  for (const auto& [actor, opacity] : {std::pair{disc.Get(), kDiscOpacity}, std::pair{rim.Get(), kRimOpacity},
                                       std::pair{discBehind.Get(), kBehind * kDiscOpacity},
                                       std::pair{rimBehind.Get(), kBehind * kRimOpacity}}) {
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetOpacity(opacity);
  }
  discBehind->setBehindOnly(true);
  rimBehind->setBehindOnly(true);
  arrow->GetProperty()->SetColor(kArrowColor.x(), kArrowColor.y(), kArrowColor.z());
  arrow->GetProperty()->SetAmbient(0.3);
}

/// The x axis along the normal, scaled, at the origin.
void ConstraintGlyph::Parts::place(vtkMatrix4x4* matrix, double scale) const {
  const Vec3 side = normal.unitOrthogonal(), third = normal.cross(side);
  for (int row = 0; row < 3; ++row) {
    matrix->SetElement(row, 0, scale * normal[row]);
    matrix->SetElement(row, 1, scale * side[row]);
    matrix->SetElement(row, 2, scale * third[row]);
    matrix->SetElement(row, 3, origin[row]);
  }
}

void ConstraintGlyph::Parts::follow() {
  if (!disc->GetVisibility())
    return;
  auto* renderer = beforeRender.renderer();
  const auto view = viewGeometry(renderer);
  const double ratio = pixelRatioOf(renderer->GetRenderWindow());
  const double pixel = ratio * view.worldPerPixel(std::max((origin - view.eye).dot(view.forward), 0.0));
  place(discMatrix, kDiscRadius * pixel);
  place(arrowMatrix, kArrowLength * pixel);
  for (BlendedActor* line : {rim.Get(), rimBehind.Get()})
    line->GetProperty()->SetLineWidth(static_cast<float>(kRimWidth * ratio));
}

ConstraintGlyph::ConstraintGlyph() : parts_(std::make_unique<Parts>()) {
  parts_->build();
  setTheme(darkTheme());
}

ConstraintGlyph::~ConstraintGlyph() {
  setRenderer(nullptr);
}

void ConstraintGlyph::setRenderer(vtkRenderer* renderer) {
  parts_->beforeRender.setRenderer(renderer, parts_->actors());
}

void ConstraintGlyph::drawAfterOrgans() {
  if (auto* renderer = parts_->beforeRender.renderer())
    for (auto* actor : parts_->actors())
      drawLast(renderer, actor);
}

void ConstraintGlyph::setTheme(const Theme& theme) {
  const Vec3& c = theme.accent;
  auto& p = *parts_;
  for (BlendedActor* actor : {p.disc.Get(), p.rim.Get(), p.discBehind.Get(), p.rimBehind.Get()})
    actor->GetProperty()->SetColor(c.x(), c.y(), c.z());
}

void ConstraintGlyph::show(const Vec3& origin, const Vec3& normal) {
  if (normal.norm() == 0) {
    hide();
    return;
  }
  parts_->origin = origin;
  parts_->normal = normal.normalized();
  for (auto* actor : parts_->actors())
    actor->SetVisibility(true);
}

void ConstraintGlyph::hide() {
  for (auto* actor : parts_->actors())
    actor->SetVisibility(false);
}

bool ConstraintGlyph::visible() const {
  return parts_->disc->GetVisibility() != 0;
}

} // namespace viscera::scene
