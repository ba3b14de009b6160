#include "viscera/scene/landmark_glyphs.h"

#include <array>

#include <vtkCellData.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include "before_render.h"
#include "flat_shape.h"
#include "view_geometry.h"

namespace viscera::scene {
namespace {
constexpr double kRadius = 6; ///< Logical pixels.
constexpr double kRim = 1.5;
constexpr int kCorners = 20;
} // namespace

struct LandmarkGlyphs::Parts {
  std::vector<Mark> marks;
  FlatShape discs;
  vtkNew<vtkUnsignedCharArray> colors;
  BeforeRender beforeRender{[this] { follow(); }};

  void follow();
};

void LandmarkGlyphs::Parts::follow() {
  const ViewGeometry view = viewGeometry(beforeRender.renderer());
  discs.begin();
  colors->Reset();
  vtkNew<vtkCellArray> cells;
  const auto addDisc = [&](const DisplayPoint& place, double radius, const Vec3& color) {
    discs.addDisc(place.x, place.y, radius * view.pixelRatio, kCorners, cells);
    const Vec3 bytes = 255 * color;
    colors->InsertNextTuple3(bytes.x(), bytes.y(), bytes.z());
  };
  for (const Mark& mark : marks) {
    const DisplayPoint place = view.project(mark.position);
    if (!(place.depth > 0))
      continue;
    addDisc(place, kRadius + kRim, Vec3::Constant(0.1));
    addDisc(place, kRadius, mark.color);
  }
  discs.data->SetPolys(cells);
  discs.end();
  discs.actor->SetVisibility(!marks.empty());
}

LandmarkGlyphs::LandmarkGlyphs() : parts_(std::make_unique<Parts>()) {
  auto& p = *parts_;
  p.colors->SetNumberOfComponents(3);
  p.discs.data->GetCellData()->SetScalars(p.colors);
  p.discs.actor->SetVisibility(false);
}

LandmarkGlyphs::~LandmarkGlyphs() {
  setRenderer(nullptr);
}

void LandmarkGlyphs::setRenderer(vtkRenderer* renderer) {
  parts_->beforeRender.setRenderer(renderer, std::array{parts_->discs.actor.Get()});
}

void LandmarkGlyphs::setMarks(std::vector<Mark> marks) {
  parts_->marks = std::move(marks);
}

const std::vector<LandmarkGlyphs::Mark>& LandmarkGlyphs::marks() const {
  return parts_->marks;
}

} // namespace viscera::scene
