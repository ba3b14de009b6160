#include "viscera/scene/ghost_outline.h"

#include <algorithm>
#include <vector>

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTypeInt32Array.h>

#include "viscera/geometry/normals.h"
#include "viscera/scene/organ_view.h"

#include "before_render.h"
#include "blended_actor.h"
#include "depth_grid.h"
#include "silhouette.h"
#include "view_geometry.h"

namespace viscera::scene {
namespace {

constexpr double kLinePixels = 1.6;
/// The part of the outline behind the organ is this much fainter.
constexpr double kBehind = 0.4;
constexpr int kGridCells = 320;
/// Depth differences below this part of the diagonal do not hide.
constexpr double kHiddenTolerance = 0.01;

} // namespace

struct GhostOutline::Parts {
  std::shared_ptr<const geometry::TriangleMesh> mesh;
  geometry::Normals normals;
  double diagonal = 0;
  std::vector<float> segments;
  double opacity = 0.8;
  vtkMTimeType drawnFor = 0;

  vtkNew<vtkPoints> points;
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<BlendedActor> front;
  vtkNew<BlendedActor> behind;
  BeforeRender beforeRender{[this] { follow(); }};

  void follow();
  void dropHidden(const ViewGeometry& view);
  void applyOpacity() {
    front->GetProperty()->SetOpacity(opacity);
    behind->GetProperty()->SetOpacity(kBehind * opacity);
  }
};

/// Leaves out what the rest shape itself hides: only its outline is wanted.
void GhostOutline::Parts::dropHidden(const ViewGeometry& view) {
  const DepthGrid depths(*mesh, view, kGridCells);
  const double tolerance = kHiddenTolerance * diagonal;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < segments.size(); i += 6) {
    const Eigen::Map<const Eigen::Vector3f> from(&segments[i]), to(&segments[i + 3]);
    if (depths.sees((0.5F * (from + to)).cast<double>(), tolerance)) {
      std::copy_n(&segments[i], 6, &segments[kept]);
      kept += 6;
    }
  }
  segments.resize(kept);
}

/// Draws the contour anew when the camera has moved.
void GhostOutline::Parts::follow() {
  auto* renderer = beforeRender.renderer();
  const double width = kLinePixels * pixelRatioOf(renderer->GetRenderWindow());
  front->GetProperty()->SetLineWidth(static_cast<float>(width));
  behind->GetProperty()->SetLineWidth(static_cast<float>(width));
  if (!front->GetVisibility() || renderer->GetActiveCamera()->GetMTime() == drawnFor)
    return;
  drawnFor = renderer->GetActiveCamera()->GetMTime();
  const auto view = viewGeometry(renderer);
  silhouette(*mesh, normals, {view.eye, view.forward, view.parallel}, segments);
  dropHidden(view);

  const auto count = static_cast<vtkIdType>(segments.size() / 3);
  auto* array = vtkFloatArray::SafeDownCast(points->GetData());
  array->SetArray(segments.data(), 3 * count, /*save=*/1);
  array->Modified();
  points->Modified();
  vtkNew<vtkTypeInt32Array> ends;
  ends->SetNumberOfValues(count);
  for (vtkIdType i = 0; i < count; ++i)
    ends->SetValue(i, static_cast<int>(i));
  vtkNew<vtkCellArray> lines;
  lines->SetData(2, ends);
  data->SetLines(lines);
}

GhostOutline::GhostOutline(std::shared_ptr<const geometry::TriangleMesh> mesh)
    : parts_(std::make_unique<Parts>()) {
  auto& p = *parts_;
  p.mesh = std::move(mesh);
  p.normals = geometry::vertexNormals(*p.mesh);
  p.diagonal = boundsOf(p.mesh->points).diagonal();
  p.data->SetPoints(p.points);
  p.mapper->SetInputData(p.data);
  for (BlendedActor* actor : {p.front.Get(), p.behind.Get()}) {
    actor->SetMapper(p.mapper);
    actor->GetProperty()->LightingOff();
  }
  p.behind->setBehindOnly(true);
  setColor(darkTheme().text);
  p.applyOpacity();
}

GhostOutline::~GhostOutline() {
  setRenderer(nullptr);
}

void GhostOutline::setRenderer(vtkRenderer* renderer) {
  auto& p = *parts_;
  if (auto* old = p.beforeRender.renderer()) {
    old->RemoveActor(p.front);
    old->RemoveActor(p.behind);
  }
  p.beforeRender.setRenderer(renderer);
  p.drawnFor = 0;
  if (renderer) {
    renderer->AddActor(p.behind);
    renderer->AddActor(p.front);
  }
}

void GhostOutline::setColor(const Vec3& color) {
  parts_->front->GetProperty()->SetColor(color.x(), color.y(), color.z());
  parts_->behind->GetProperty()->SetColor(color.x(), color.y(), color.z());
}

void GhostOutline::setOpacity(double opacity) {
  parts_->opacity = opacity;
  parts_->applyOpacity();
}

void GhostOutline::setVisible(bool visible) {
  parts_->front->SetVisibility(visible);
  parts_->behind->SetVisibility(visible);
}

bool GhostOutline::visible() const {
  return parts_->front->GetVisibility() != 0;
}

} // namespace viscera::scene
