#include "viscera/scene/landmark_glyphs.h"

#include <cmath>

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "viscera/scene/organ_view.h"

#include "before_render.h"
#include "view_geometry.h"

namespace viscera::scene {
namespace {
constexpr double kRadius = 6; ///< Logical pixels.
constexpr double kRim = 1.5;
constexpr int kCorners = 20;
} // namespace

struct LandmarkGlyphs::Parts {
  std::vector<Mark> marks;
  vtkNew<vtkPoints> points;
  vtkNew<vtkPolyData> discs;
  vtkNew<vtkUnsignedCharArray> colors;
  vtkNew<vtkActor2D> actor;
  BeforeRender beforeRender{[this] { follow(); }};

  void follow();
  void addDisc(double x, double y, double radius, const Vec3& color, vtkCellArray* cells);
};

void LandmarkGlyphs::Parts::addDisc(double x, double y, double radius, const Vec3& color,
                                    vtkCellArray* cells) {
  vtkIdType corners[kCorners];
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * M_PI * i / kCorners;
    corners[i] = points->InsertNextPoint(x + radius * std::cos(angle), y + radius * std::sin(angle), 0);
  }
  cells->InsertNextCell(kCorners, corners);
  const Vec3 bytes = 255 * color;
  colors->InsertNextTuple3(bytes.x(), bytes.y(), bytes.z());
}

void LandmarkGlyphs::Parts::follow() {
  vtkRenderer* renderer = beforeRender.renderer();
  const double ratio = pixelRatioOf(renderer->GetRenderWindow());
  const ViewGeometry view = viewGeometry(renderer);
  points->Reset();
  colors->Reset();
  vtkNew<vtkCellArray> cells;
  for (const Mark& mark : marks) {
    const DisplayPoint place = view.project(mark.position);
    if (!(place.depth > 0))
      continue;
    addDisc(place.x, place.y, (kRadius + kRim) * ratio, Vec3::Constant(0.1), cells);
    addDisc(place.x, place.y, kRadius * ratio, mark.color, cells);
  }
  points->Modified();
  discs->SetPolys(cells);
  discs->Modified();
  actor->SetVisibility(!marks.empty());
}

LandmarkGlyphs::LandmarkGlyphs() : parts_(std::make_unique<Parts>()) {
  auto& p = *parts_;
  p.colors->SetNumberOfComponents(3);
  p.discs->SetPoints(p.points);
  p.discs->GetCellData()->SetScalars(p.colors);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(p.discs);
  p.actor->SetMapper(mapper);
  p.actor->SetVisibility(false);
}

LandmarkGlyphs::~LandmarkGlyphs() {
  setRenderer(nullptr);
}

void LandmarkGlyphs::setRenderer(vtkRenderer* renderer) {
  auto& p = *parts_;
  if (vtkRenderer* old = p.beforeRender.renderer())
    old->RemoveActor2D(p.actor);
  p.beforeRender.setRenderer(renderer);
  if (renderer)
    renderer->AddActor2D(p.actor);
}

void LandmarkGlyphs::setMarks(std::vector<Mark> marks) {
  parts_->marks = std::move(marks);
}

const std::vector<LandmarkGlyphs::Mark>& LandmarkGlyphs::marks() const {
  return parts_->marks;
}

} // namespace viscera::scene
