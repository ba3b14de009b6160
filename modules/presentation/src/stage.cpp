#include "viscera/presentation/stage.h"

#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include "viscera/scene/picture.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"

namespace viscera::presentation {
namespace {

/// Handles nearer to the organs than this part of their diagonal are brought into the picture.
constexpr double kNear = 0.1;

Bounds joined(const Bounds& a, const Bounds& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

} // namespace

Stage::Stage(int width, int height, const scene::Theme& theme, Threads threads,
             Presenter::Translate translate, double pixelRatio)
    : window_(width, height, pixelRatio), presenter_(view_, threads, std::move(translate)) {
  view_.setWindow(window_.window());
  view_.setTheme(theme);
}

Stage::~Stage() {
  window_.window()->MakeCurrent(); // Another stage may have drawn last.
}

void Stage::compose(scene::StandardView side, double room) {
  const Bounds organs = view_.bounds();
  Bounds bounds = organs;
  for (int i = 0; i < view_.handles()->GetNumberOfHandles(); ++i) {
    const Vec3 handle = view_.handles()->GetPosition(i);
    const Vec3 beyond = (organs.low - handle).cwiseMax(handle - organs.high).cwiseMax(0);
    if (view_.handles()->GetHandleShown(i) && beyond.norm() <= kNear * organs.diagonal())
      bounds = joined(bounds, {handle, handle});
  }
  for (const scene::RegionHull& hull : view_.regions().hulls())
    bounds = joined(bounds, boundsOf(hull.vertices));
  const Vec3 around = Vec3::Constant(room * bounds.diagonal());
  view_.lookFrom(side, {bounds.low - around, bounds.high + around});
}

vtkSmartPointer<vtkImageData> Stage::picture() {
  window_.window()->MakeCurrent(); // Several are drawn in turn.
  view_.renderer()->ResetCameraClippingRange();
  return scene::grabPicture(window_.window());
}

} // namespace viscera::presentation
