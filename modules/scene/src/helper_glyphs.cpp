#include "viscera/scene/helper_glyphs.h"

#include <array>
#include <utility>
#include <vector>

#include <vtkArrowSource.h>
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRegularPolygonSource.h>
#include <vtkRenderer.h>

#include "before_render.h"
#include "blended_actor.h"
#include "unit_ball.h"
#include "view_geometry.h"

namespace viscera::scene {
namespace {

/// The factor of opacity for parts behind an organ.
constexpr double kHelpersBehind = 0.4;
constexpr int kBallSides = 24;

vtkSmartPointer<vtkPolyData> disc(bool filled) {
  vtkNew<vtkRegularPolygonSource> source;
  source->SetNumberOfSides(72);
  source->SetRadius(1);
  source->SetNormal(1, 0, 0);
  source->SetGeneratePolygon(filled);
  source->SetGeneratePolyline(!filled);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> arrow() {
  vtkNew<vtkArrowSource> source;
  source->SetShaftResolution(20);
  source->SetTipResolution(20);
  source->SetShaftRadius(0.025);
  source->SetTipRadius(0.08);
  source->SetTipLength(0.26);
  source->Update();
  return source->GetOutput();
}

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

struct HelperGlyph::Parts {
  explicit Parts(HelperGlyph& glyph)
      : beforeRender([this, &glyph] {
          if (glyph.visible())
            glyph.follow(viewGeometry(beforeRender.renderer()));
        }) {}

  std::vector<vtkSmartPointer<vtkActor>> actors; ///< In the order in which they are drawn.
  vtkNew<vtkMatrix4x4> place;
  vtkNew<vtkMatrix4x4> secondPlace; ///< For what has another size.
  BeforeRender beforeRender;

  /// Two shapes, and before them what is hidden of both.
  void addBoth(vtkPolyData* fill, double fillOpacity, vtkPolyData* rim, double rimOpacity) {
    for (const bool behind : {true, false}) {
      const double part = behind ? kHelpersBehind : 1;
      actors.emplace_back(newHelper(fill, place, part * fillOpacity, behind));
      actors.emplace_back(newHelper(rim, place, part * rimOpacity, behind));
    }
  }
};

HelperGlyph::HelperGlyph() : parts_(std::make_unique<Parts>(*this)) {}

HelperGlyph::~HelperGlyph() {
  setRenderer(nullptr);
}

void HelperGlyph::follow(const ViewGeometry&) {}

void HelperGlyph::setRenderer(vtkRenderer* renderer) {
  parts_->beforeRender.setRenderer(renderer, parts_->actors);
}

void HelperGlyph::setVisible(bool visible) {
  for (const auto& actor : parts_->actors)
    actor->SetVisibility(visible);
}

void HelperGlyph::hide() {
  setVisible(false);
}

bool HelperGlyph::visible() const {
  return parts_->actors.front()->GetVisibility() != 0;
}

void HelperGlyph::drawAfterOrgans() {
  if (auto* renderer = parts_->beforeRender.renderer())
    for (const auto& actor : parts_->actors)
      drawLast(renderer, actor);
}

// ---- where a locked handle may go

namespace {
/// Logical pixels.
constexpr double kDiscRadius = 72;
constexpr double kArrowLength = 64;
constexpr double kRimWidth = 1.5;
} // namespace

ConstraintGlyph::ConstraintGlyph() {
  auto& p = *parts_;
  p.addBoth(disc(true), 0.22, disc(false), 0.85);
  const auto gradient = vtkSmartPointer<vtkActor>::New();
  attach(gradient, arrow(), p.secondPlace);
  setColor(gradient, {0.96, 0.65, 0.14});
  gradient->GetProperty()->SetAmbient(0.3);
  p.actors.push_back(gradient);
  hide();
  setTheme(darkTheme());
}

void ConstraintGlyph::setTheme(const Theme& theme) {
  for (std::size_t i = 0; i + 1 < parts_->actors.size(); ++i)
    setColor(parts_->actors[i], theme.accent);
}

void ConstraintGlyph::follow(const ViewGeometry& view) {
  auto& p = *parts_;
  const double pixel = view.logicalPixel(origin_);
  placeAlong(p.place, origin_, normal_, kDiscRadius * pixel);
  placeAlong(p.secondPlace, origin_, normal_, kArrowLength * pixel);
  for (const auto& actor : p.actors)
    actor->GetProperty()->SetLineWidth(static_cast<float>(kRimWidth * view.pixelRatio));
}

void ConstraintGlyph::show(const Vec3& origin, const Vec3& normal) {
  if (normal.norm() == 0)
    return hide();
  origin_ = origin;
  normal_ = normal.normalized();
  setVisible(true);
}

// ---- what drags are mirrored at

MirrorPlaneGlyph::MirrorPlaneGlyph() {
  parts_->addBoth(square(true), 0.10, square(false), 0.55);
  hide();
  setTheme(darkTheme());
}

void MirrorPlaneGlyph::setTheme(const Theme& theme) {
  for (const auto& actor : parts_->actors)
    setColor(actor, theme.text);
}

void MirrorPlaneGlyph::show(const Vec3& center, const Vec3& normal, double halfSize) {
  // The sides run along the patient's axes where the normal is one of them.
  Eigen::Index smallest = 0;
  normal.cwiseAbs().minCoeff(&smallest);
  const Vec3 side = normal.cross(Vec3::Unit(smallest)).normalized(), third = normal.cross(side);
  for (int row = 0; row < 3; ++row) {
    parts_->place->SetElement(row, 0, normal[row]);
    parts_->place->SetElement(row, 1, halfSize * side[row]);
    parts_->place->SetElement(row, 2, halfSize * third[row]);
    parts_->place->SetElement(row, 3, center[row]);
  }
  setVisible(true);
}

// ---- what is being looked at

namespace {
/// Logical pixels.
constexpr double kBallRadius = 5;
constexpr double kBallRimRadius = 7;
constexpr double kBallBehindOpacity = 0.45;
} // namespace

ProbeMarker::ProbeMarker() {
  auto& p = *parts_;
  p.actors = {newHelper(unitBall(kBallSides), p.place, kBallBehindOpacity, true),
              newHelper(unitBall(kBallSides), p.secondPlace, 1), newHelper(unitBall(kBallSides), p.place, 1)};
  p.actors[0]->GetProperty()->BackfaceCullingOn();
  p.actors[1]->GetProperty()->FrontfaceCullingOn(); // The rim.
  setColor(p.actors[1], {0.08, 0.09, 0.1});
  p.actors[2]->GetProperty()->BackfaceCullingOn();
  hide();
  setTheme(darkTheme());
}

void ProbeMarker::setTheme(const Theme& theme) {
  setColor(parts_->actors[0], theme.accent);
}

void ProbeMarker::follow(const ViewGeometry& view) {
  const double pixel = view.logicalPixel(position_);
  placeAlong(parts_->place, position_, Vec3::UnitX(), kBallRadius * pixel);
  placeAlong(parts_->secondPlace, position_, Vec3::UnitX(), kBallRimRadius * pixel);
}

void ProbeMarker::show(const Vec3& position) {
  position_ = position;
  setVisible(true);
}

} // namespace viscera::scene
