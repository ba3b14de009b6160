// GLEW has to come before any other OpenGL header.
#include <vtk_glew.h>

#include "viscera/scene/organ_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkLight.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkWeakPointer.h>

#include "viscera/scene/vtkVisceraGizmoRepresentation.h"
#include "viscera/scene/vtkVisceraGizmoWidget.h"
#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"
#include "viscera/scene/vtkVisceraHandleSetWidget.h"

#include "before_render.h"
#include "blended_actor.h"
#include "camera_fitter.h"
#include "orientation_cube.h"
#include "standard_view.h"
#include "text_guard.h"
#include "view_furniture.h"
#include "view_geometry.h"

namespace viscera::scene {
namespace {

constexpr double kFramingMargin = 1.12;
constexpr int kOrganViewSamples = 4;
constexpr int kPeelsOnGpu = 8;
constexpr int kPeelsInSoftware = 4;
/// Vertices that a software renderer draws as they are while something moves, and of more than that at most.
constexpr Eigen::Index kAllDrawnInMotion = 30000;
constexpr Eigen::Index kDrawnInMotion = 64000;
constexpr Eigen::Index kDrawnOfOneInMotion = 16000; ///< Of one organ: finer triangles show no more.
constexpr Eigen::Index kTransparentPasses = 3;      ///< See `WallActor::Render`.
/// Half side of the box that an empty view frames, mm.
constexpr double kEmptyHalfSize = 100;
/// The part of a view's height, and of its width, that a legend leaves to organs, at least.
constexpr double kLeastFreeHeight = 0.4, kLeastFreeWidth = 0.5;

/// Factor of one turn of the wheel.
constexpr double kZoomPerStep = 1.15;

/// The mouse as in 3D Slicer: left rotates, middle or Shift+left pans, right drag or wheel zooms. VTK's
/// letter keys (quit, wireframe, stereo, pick) do nothing: keys belong to the window.
class SlicerLikeStyle : public vtkInteractorStyleTrackballCamera {
public:
  static SlicerLikeStyle* New();
  vtkTypeMacro(SlicerLikeStyle, vtkInteractorStyleTrackballCamera)

      void OnChar() override {}

  // The base class renders each turn of the wheel twice.
  void OnMouseWheelForward() override { turnWheel(MouseWheelMotionFactor); }
  void OnMouseWheelBackward() override { turnWheel(-MouseWheelMotionFactor); }

private:
  void turnWheel(double steps) {
    const int* at = Interactor->GetEventPosition();
    FindPokedRenderer(at[0], at[1]);
    if (CurrentRenderer)
      Dolly(std::pow(kZoomPerStep, steps));
  }
};
vtkStandardNewMacro(SlicerLikeStyle);

/// A light that goes with the camera; x to the right of the picture, y up, z towards the reader.
void addLight(vtkRenderer* renderer, const Vec3& from, const Vec3& color, double intensity) {
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(from.data());
  light->SetFocalPoint(0, 0, 0);
  light->SetColor(color.x(), color.y(), color.z());
  light->SetIntensity(intensity);
  renderer->AddLight(light);
}

void addLights(vtkRenderer* renderer) {
  renderer->SetAutomaticLightCreation(false);
  addLight(renderer, {-0.45, 0.65, 1.0}, {1.0, 0.98, 0.95}, 0.86); // key
  addLight(renderer, {0.9, -0.15, 0.75}, {0.9, 0.95, 1.0}, 0.42);  // fill
  addLight(renderer, {0.35, 0.8, -0.9}, {0.92, 0.96, 1.0}, 0.4);   // back
}

} // namespace

double pixelRatioOf(vtkRenderWindow* window) {
  return window ? std::max(1.0, window->GetDPI() / kLogicalDpi) : 1.0;
}

bool rendersInSoftware(vtkRenderWindow* window) {
  window->MakeCurrent();
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  constexpr std::array<const char*, 4> kSoftware = {"llvmpipe", "softpipe", "swrast", "SWR"};
  return name && std::any_of(kSoftware.begin(), kSoftware.end(),
                             [name](const char* software) { return std::strstr(name, software); });
}

struct OrganView::Parts {
  Theme theme = darkTheme();
  std::vector<std::shared_ptr<OrganActor>> organs;
  std::function<std::optional<Bounds>()> alsoFramed;
  vtkNew<vtkRenderer> renderer;
  vtkWeakPointer<vtkRenderWindow> window;
  bool knowsGpu = false;
  bool software = false;
  bool moving = false;
  bool held = false; ///< The mouse moves something.
  bool quick = false;
  Shortcuts shortcuts;
  bool peeling = true;
  MeshLook meshLook;
  vtkNew<vtkCallbackCommand> motion;
  vtkNew<vtkVisceraHandleSetRepresentation> handles;
  vtkNew<vtkVisceraHandleSetWidget> widget;
  vtkNew<vtkVisceraGizmoRepresentation> gizmo;
  vtkNew<vtkVisceraGizmoWidget> gizmoWidget;
  ConstraintGlyph constraint;
  RegionHulls regions;
  MirrorPlaneGlyph mirrorPlane;
  Legend legend;
  char decimalMark = '.';
  OrientationCube cube{renderer};
  ScaleBar scaleBar{renderer};
  CameraFitter sight;
  BeforeRender beforeRender{[this] { prepareFrame(); }};
  vtkNew<vtkCallbackCommand> beforeWindow;
  unsigned long beforeWindowTag = 0;

  Bounds bounds() const;
  CameraFitter::Shape room(const LegendRoom& taken) const;
  void prepareWindow();
  void prepareFrame();
  bool hurries() const { return software && (moving || quick); }
  bool anyTranslucent() const;
  Eigen::Index verticesDrawn() const;
  int partDrawn() const;
  int partDrawn(const OrganActor& organ, int ofAll) const;
  void smoothEdges();
  void watchMotion(vtkObject* source);
  void orderProps();
  void peelOrOrder(const Vec3& eye);
  void putHandlesIntoRenderer();
};

/// What the legend leaves to organs. It is about the middle of the view, where an organ stays while it is
/// turned.
CameraFitter::Shape OrganView::Parts::room(const LegendRoom& taken) const {
  const int* size = renderer->GetSize();
  if (size[0] <= 0 || size[1] <= 0)
    return {};
  const double width = std::max(kLeastFreeWidth, 1 - 2 * taken.beside / size[0]);
  return {width * size[0] / size[1], std::max(kLeastFreeHeight, 1 - 2 * taken.above / size[1])};
}

/// What follows the camera does so when a renderer begins: the camera is at its place before. It stands still
/// under the mouse: a handle that is pressed may bring a legend.
void OrganView::Parts::prepareWindow() {
  if (!held)
    sight.follow(renderer, room(legend.room()), [this] { return bounds(); });
  smoothEdges();
}

/// Multisampling doubles the time of a frame in software (FXAA triples it), so it waits until there is time.
/// Depth peeling draws nothing at all into a multisampled buffer, so there FXAA steps in.
void OrganView::Parts::smoothEdges() {
  if (!window)
    return;
  const bool smooth = !hurries();
  const int samples = smooth && !anyTranslucent() ? kOrganViewSamples : 0;
  if (window->GetMultiSamples() != samples)
    window->SetMultiSamples(samples);
  renderer->SetUseFXAA(smooth && samples == 0);
  cube.renderer()->SetUseFXAA(smooth && samples == 0);
}

void OrganView::Parts::prepareFrame() {
  if (!knowsGpu) { // Only now the window surely has a context to ask.
    knowsGpu = true;
    software = rendersInSoftware(renderer->GetRenderWindow());
    renderer->SetMaximumNumberOfPeels(software ? kPeelsInSoftware : kPeelsOnGpu);
  }
  const Vec3 eye(renderer->GetActiveCamera()->GetPosition());
  const int ofAll = partDrawn();
  for (const auto& organ : organs) {
    const int part = partDrawn(*organ, ofAll);
    organ->cullBackFaces(eye);
    organ->setCoarse(part);
    organ->setMeshLook({meshLook.edges && part == 1, meshLook.flat});
  }
  peelOrOrder(eye);
}

bool OrganView::Parts::anyTranslucent() const {
  return std::any_of(organs.begin(), organs.end(),
                     [](const auto& organ) { return organ->drawn() && organ->opacity() < 1; });
}

Eigen::Index OrganView::Parts::verticesDrawn() const {
  Eigen::Index vertices = 0;
  for (const auto& organ : organs)
    if (organ->drawn())
      vertices += organ->mesh().points.rows() * (organ->opacity() < 1 ? kTransparentPasses : 1);
  return vertices;
}

/// One in how many vertices is drawn: a power of two, so that an organ more or less seldom makes another one.
int OrganView::Parts::partDrawn() const {
  const Eigen::Index vertices = verticesDrawn();
  if (!hurries() || !shortcuts.fewerTriangles || vertices <= kAllDrawnInMotion)
    return 1;
  int part = 2;
  while (vertices > kDrawnInMotion * part)
    part *= 2;
  return part;
}

int OrganView::Parts::partDrawn(const OrganActor& organ, int ofAll) const {
  int part = ofAll;
  while (part > 1 && organ.mesh().points.rows() > kDrawnOfOneInMotion * part)
    part *= 2;
  return part;
}

/// Peeling draws the organs once for every layer. In a hurry a software renderer blends instead, the farther
/// organs first; a cavity is farther than the wall around it.
void OrganView::Parts::peelOrOrder(const Vec3& eye) {
  const bool peel = !hurries() || !shortcuts.blending;
  for (const auto& organ : organs)
    organ->setDrawnWithoutPeeling(!peel);
  if (peel && !std::exchange(peeling, peel))
    orderProps();
  peeling = peel;
  if (peel)
    return;
  std::vector<std::pair<double, vtkActor*>> translucent;
  for (const auto& organ : organs) {
    if (!organ->drawn() || organ->opacity() >= 1)
      continue;
    const Bounds box = organ->bounds();
    const Vec3 nearest = eye.cwiseMax(box.low).cwiseMin(box.high);
    translucent.emplace_back((eye - nearest).norm(), organ->actor());
  }
  std::stable_sort(translucent.begin(), translucent.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  for (const auto& [distance, actor] : translucent)
    drawLast(renderer, actor);
}

/// While the camera or a handle is moved by the mouse, frames have to come quickly.
void OrganView::Parts::watchMotion(vtkObject* source) {
  source->AddObserver(vtkCommand::StartInteractionEvent, motion);
  source->AddObserver(vtkCommand::EndInteractionEvent, motion);
}

/// Organs first, then what is drawn relative to them.
void OrganView::Parts::orderProps() {
  regions.drawAfterOrgans();
  mirrorPlane.drawAfterOrgans();
  constraint.drawAfterOrgans();
  drawLast(renderer, gizmo);
  for (const auto& organ : organs)
    handles->AddOccluder(organ->actor());
}

/// The widget cannot be enabled without an interactor, but its handles are to be seen.
void OrganView::Parts::putHandlesIntoRenderer() {
  handles->SetRenderer(renderer);
  renderer->AddViewProp(handles);
  orderProps();
}

// The text actors ask the guarded renderer from the beginning.
OrganView::OrganView() : parts_((guardText(), std::make_unique<Parts>())) {
  auto& p = *parts_;
  addLights(p.renderer);
  p.renderer->GradientBackgroundOn();
  p.renderer->SetUseDepthPeeling(true);
  p.renderer->SetOcclusionRatio(0);
  p.beforeRender.setRenderer(p.renderer);
  p.legend.setRenderer(p.renderer);
  p.constraint.setRenderer(p.renderer);
  p.regions.setRenderer(p.renderer);
  p.mirrorPlane.setRenderer(p.renderer);
  p.widget->SetRepresentation(p.handles);
  p.gizmoWidget->SetRepresentation(p.gizmo);
  p.motion->SetClientData(&p);
  p.motion->SetCallback([](vtkObject*, unsigned long event, void* parts, void*) {
    auto& own = *static_cast<Parts*>(parts);
    own.moving = own.held = event == vtkCommand::StartInteractionEvent;
  });
  p.watchMotion(p.widget);
  p.watchMotion(p.gizmoWidget);
  p.beforeWindow->SetClientData(&p);
  p.beforeWindow->SetCallback(
      [](vtkObject*, unsigned long, void* parts, void*) { static_cast<Parts*>(parts)->prepareWindow(); });
  p.putHandlesIntoRenderer();
  setTheme(p.theme);
  lookFrom(StandardView::anterior);
}

OrganView::~OrganView() {
  // Observers may be destroyed already, so a drag that ends here emits no event and is not drawn.
  parts_->widget->RemoveAllObservers();
  parts_->gizmoWidget->RemoveAllObservers();
  parts_->widget->SetRenderOnChange(false);
  setInteractor(nullptr);
  setWindow(nullptr);
}

void OrganView::setWindow(vtkRenderWindow* window) {
  auto& p = *parts_;
  if (p.window) {
    p.window->RemoveObserver(p.beforeWindowTag);
    p.window->RemoveRenderer(p.cube.renderer());
    p.window->RemoveRenderer(p.renderer);
  }
  p.window = window;
  p.knowsGpu = false;
  if (!window)
    return;
  window->SetAlphaBitPlanes(1); // Depth peeling needs them.
  p.beforeWindowTag = window->AddObserver(vtkCommand::StartEvent, p.beforeWindow);
  window->SetNumberOfLayers(2);
  window->AddRenderer(p.renderer);
  window->AddRenderer(p.cube.renderer());
}

vtkRenderWindow* OrganView::window() const {
  return parts_->window;
}

void OrganView::setInteractor(vtkRenderWindowInteractor* interactor) {
  auto& p = *parts_;
  const std::array<vtkAbstractWidget*, 2> widgets = {p.widget, p.gizmoWidget};
  for (auto* widget : widgets) {
    widget->SetEnabled(0);
    widget->SetInteractor(nullptr);
  }
  if (interactor) {
    vtkNew<SlicerLikeStyle> style;
    style->SetDefaultRenderer(p.renderer);
    p.watchMotion(style);
    interactor->SetInteractorStyle(style);
    for (auto* widget : widgets) {
      widget->SetInteractor(interactor);
      widget->SetDefaultRenderer(p.renderer);
      widget->SetCurrentRenderer(p.renderer);
      widget->SetEnabled(1);
    }
  }
  p.putHandlesIntoRenderer();
}

vtkRenderer* OrganView::renderer() const {
  return parts_->renderer;
}

void OrganView::setTheme(const Theme& theme) {
  auto& p = *parts_;
  p.theme = theme;
  p.renderer->SetBackground(theme.backgroundBottom.data());
  p.renderer->SetBackground2(theme.backgroundTop.data());
  p.handles->SetTheme(theme);
  p.constraint.setTheme(theme);
  p.mirrorPlane.setTheme(theme);
  p.gizmo->SetTheme(theme);
  p.legend.setTheme(theme);
  p.cube.setTheme(theme);
  p.scaleBar.setTheme(theme);
}

const Theme& OrganView::theme() const {
  return parts_->theme;
}

void OrganView::add(std::shared_ptr<OrganActor> organ) {
  auto& p = *parts_;
  if (std::find(p.organs.begin(), p.organs.end(), organ) != p.organs.end())
    return;
  p.renderer->AddActor(organ->actor());
  p.organs.push_back(std::move(organ));
  p.orderProps();
}

void OrganView::remove(const std::shared_ptr<OrganActor>& organ) {
  auto& p = *parts_;
  if (std::erase(p.organs, organ) == 0)
    return;
  p.handles->RemoveOccluder(organ->actor());
  p.renderer->RemoveActor(organ->actor());
}

void OrganView::clear() {
  while (!parts_->organs.empty()) {
    const auto last = parts_->organs.back();
    remove(last);
  }
}

const std::vector<std::shared_ptr<OrganActor>>& OrganView::organs() const {
  return parts_->organs;
}

Bounds OrganView::Parts::bounds() const {
  std::optional<Bounds> all = alsoFramed ? alsoFramed() : std::nullopt;
  for (const auto& organ : organs) {
    if (!organ->visible())
      continue;
    const Bounds box = organ->bounds();
    all = all ? Bounds{all->low.cwiseMin(box.low), all->high.cwiseMax(box.high)} : box;
  }
  if (all)
    return *all;
  if (handles->GetNumberOfHandles() > 0)
    return boundsOf(handles->GetPositions());
  return {Vec3::Constant(-kEmptyHalfSize), Vec3::Constant(kEmptyHalfSize)};
}

Bounds OrganView::bounds() const {
  return parts_->bounds();
}

void OrganView::setAlsoFramed(std::function<std::optional<Bounds>()> box) {
  parts_->alsoFramed = std::move(box);
}

void OrganView::lookFrom(StandardView view) {
  lookFrom(view, bounds());
}

void OrganView::lookFrom(StandardView view, const Bounds& bounds) {
  const auto directions = directionsOf(view);
  auto* camera = parts_->renderer->GetActiveCamera();
  const Vec3 position = -directions.forward;
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(position.data());
  camera->SetViewUp(directions.up.data());
  frame(bounds);
}

void OrganView::frame() {
  frame(bounds());
}

void OrganView::frame(const Bounds& bounds) {
  auto* renderer = parts_->renderer.Get();
  auto* camera = renderer->GetActiveCamera();
  const auto view = viewGeometry(renderer);
  const CameraFitter::Shape room = parts_->room(parts_->legend.room());
  const double aspect = room.width > 0 ? room.width / room.height : 1;
  const double tangent = room.height * std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle()) / 2);
  double distance = framingDistance(bounds, {view.forward, view.up}, tangent, aspect, kFramingMargin);
  if (!(distance > 0))
    distance = kEmptyHalfSize;
  const Vec3 center = bounds.center(), position = center - distance * view.forward;
  camera->SetFocalPoint(center.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(view.up.data());
  camera->SetParallelScale(framingScale(bounds, {view.forward, view.up}, aspect, kFramingMargin) /
                           room.height);
  renderer->ResetCameraClippingRange();
  parts_->sight.put(renderer, room);
}

void OrganView::expectLegend() {
  parts_->sight.put(parts_->renderer, parts_->room(parts_->legend.roomWhenShown()));
}

vtkVisceraHandleSetRepresentation* OrganView::handles() const {
  return parts_->handles;
}
vtkVisceraHandleSetWidget* OrganView::handleWidget() const {
  return parts_->widget;
}
vtkVisceraGizmoRepresentation* OrganView::gizmo() const {
  return parts_->gizmo;
}
vtkVisceraGizmoWidget* OrganView::gizmoWidget() const {
  return parts_->gizmoWidget;
}
MirrorPlaneGlyph& OrganView::mirrorPlane() {
  return parts_->mirrorPlane;
}
ConstraintGlyph& OrganView::constraint() {
  return parts_->constraint;
}
RegionHulls& OrganView::regions() {
  return parts_->regions;
}
Legend& OrganView::legend() {
  return parts_->legend;
}
void OrganView::setOrientationCubeShown(bool shown) {
  parts_->cube.setShown(shown);
}
std::optional<StandardView> OrganView::orientationSideAt(double x, double y) const {
  return parts_->cube.sideAt(x, y);
}
bool OrganView::highlightOrientationSide(std::optional<StandardView> side) {
  if (side == parts_->cube.highlighted())
    return false;
  parts_->cube.highlight(side);
  return true;
}
void OrganView::setScaleBarShown(bool shown) {
  parts_->scaleBar.setShown(shown);
}

void OrganView::setDecimalMark(char mark) {
  parts_->decimalMark = mark;
  parts_->legend.setDecimalMark(mark);
  parts_->scaleBar.setDecimalMark(mark);
}

char OrganView::decimalMark() const {
  return parts_->decimalMark;
}

void OrganView::setMoving(bool moving) {
  parts_->moving = moving;
}

bool OrganView::moving() const {
  return parts_->moving;
}

void OrganView::setFastDrawing(bool quick) {
  parts_->quick = quick;
}

void OrganView::setShortcuts(const Shortcuts& shortcuts) {
  parts_->shortcuts = shortcuts;
}

bool OrganView::isSlow() const {
  const auto& p = *parts_;
  return p.software &&
         (p.verticesDrawn() > kAllDrawnInMotion || (p.shortcuts.blending && p.anyTranslucent()));
}

void OrganView::setMeshLook(const MeshLook& look) {
  parts_->meshLook = look;
}

const MeshLook& OrganView::meshLook() const {
  return parts_->meshLook;
}

std::optional<SurfacePick> OrganView::pick(double x, double y) const {
  std::vector<OrganActor*> organs;
  for (const auto& organ : parts_->organs)
    organs.push_back(organ.get());
  return pickSurface(rayThrough(parts_->renderer, x, y), organs);
}

const OrganActor* OrganView::coverOf(const OrganActor& organ) const {
  constexpr Eigen::Index kMostPlaces = 24;
  if (!organ.visible())
    return nullptr;
  std::vector<OrganActor*> solid;
  for (const auto& other : parts_->organs)
    if (other.get() == &organ || other->opacity() >= 1)
      solid.push_back(other.get());
  const ViewGeometry geometry = viewGeometry(parts_->renderer);
  const OrganActor* cover = nullptr;
  const Eigen::Index vertices = organ.points().rows();
  const Eigen::Index places = std::min(kMostPlaces, vertices);
  for (Eigen::Index place = 0; place < places; ++place) {
    const DisplayPoint at = geometry.project(organ.points().row(place * vertices / places).transpose());
    const auto hit = pickSurface(geometry.ray(at.x, at.y), solid);
    if (hit && hit->organ == &organ)
      return nullptr;
    if (hit && !cover)
      cover = hit->organ;
  }
  return cover;
}

} // namespace viscera::scene
