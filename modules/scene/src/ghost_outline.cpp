#include "viscera/scene/ghost_outline.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTypeInt32Array.h>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/scene/organ_view.h"

#include "before_render.h"
#include "blended_actor.h"
#include "silhouette.h"
#include "view_geometry.h"

namespace viscera::scene {
namespace {

constexpr double kLinePixels = 1.6;
constexpr double kOpacity = 0.8;
/// The part of the outline behind the organ is this much fainter.
constexpr double kOutlineBehind = 0.4;
constexpr int kGridCells = 320;
/// Depth differences below this part of the diagonal do not hide.
constexpr double kHiddenTolerance = 0.01;

} // namespace

struct GhostOutline::Parts {
  std::shared_ptr<const geometry::TriangleMesh> mesh;
  std::shared_ptr<geometry::TriangleMesh> posed; ///< `mesh`, once it has points of its own.
  geometry::Normals normals;
  double diagonal = 0;
  bool through = true;
  std::vector<float> segments;
  vtkMTimeType drawnFor = 0;

  vtkNew<vtkPoints> points;
  vtkNew<vtkPolyData> data;
  const std::array<vtkSmartPointer<BlendedActor>, 2> actors = {newHelper(data, nullptr, 1, true),
                                                               newHelper(data, nullptr, 1)};
  BeforeRender beforeRender{[this] { follow(); }};

  void follow();
  void dropHidden(const ViewGeometry& view);
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
  const auto view = viewGeometry(renderer);
  for (const auto& actor : actors)
    actor->GetProperty()->SetLineWidth(static_cast<float>(kLinePixels * view.pixelRatio));
  if (!actors[1]->GetVisibility() || renderer->GetActiveCamera()->GetMTime() == drawnFor)
    return;
  drawnFor = renderer->GetActiveCamera()->GetMTime();
  silhouette(*mesh, normals, view, segments);
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
  setColor(darkTheme().text);
  setOpacity(kOpacity);
}

void GhostOutline::setPoints(const Points& points, const geometry::Normals& normals) {
  auto& p = *parts_;
  if (points.rows() != p.mesh->points.rows() || normals.rows() != points.rows())
    throw UsageError(
        misuse("the outline of %1 vertices cannot follow %2", p.mesh->points.rows(), points.rows()));
  if (!p.posed) {
    p.posed = std::make_shared<geometry::TriangleMesh>(*p.mesh);
    p.mesh = p.posed;
  }
  p.posed->points = points;
  p.normals = normals;
  p.drawnFor = 0;
}

GhostOutline::~GhostOutline() {
  setRenderer(nullptr);
}

void GhostOutline::setRenderer(vtkRenderer* renderer) {
  parts_->beforeRender.setRenderer(renderer, parts_->actors);
  parts_->drawnFor = 0;
}

void GhostOutline::setColor(const Vec3& color) {
  for (const auto& actor : parts_->actors)
    scene::setColor(actor, color);
}

void GhostOutline::setOpacity(double opacity) {
  parts_->actors[0]->GetProperty()->SetOpacity(kOutlineBehind * opacity);
  parts_->actors[1]->GetProperty()->SetOpacity(opacity);
}

void GhostOutline::setSeenThrough(bool through) {
  parts_->through = through;
  setVisible(visible());
}

void GhostOutline::setClipPlane(const Vec3& origin, const Vec3& normal) {
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(origin.data());
  plane->SetNormal(normal.normalized().eval().data());
  clearClipPlane();
  for (const auto& actor : parts_->actors)
    actor->GetMapper()->AddClippingPlane(plane);
}

void GhostOutline::clearClipPlane() {
  for (const auto& actor : parts_->actors)
    actor->GetMapper()->RemoveAllClippingPlanes();
}

void GhostOutline::setVisible(bool visible) {
  parts_->actors[0]->SetVisibility(visible && parts_->through);
  parts_->actors[1]->SetVisibility(visible);
}

bool GhostOutline::visible() const {
  return parts_->actors[1]->GetVisibility() != 0;
}

} // namespace viscera::scene
