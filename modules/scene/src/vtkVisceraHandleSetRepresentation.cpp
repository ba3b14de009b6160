#include "viscera/scene/vtkVisceraHandleSetRepresentation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "before_render.h"
#include "handle_glyphs.h"
#include "ray_mesh.h"
#include "view_geometry.h"

using viscera::Bounds;
using viscera::Colors;
using viscera::Points;
using viscera::Vec3;
using namespace viscera::scene;

namespace {

/// Logical pixels: the dark line around every handle, and the light rim of a selected one.
constexpr double kOutlinePixels = 1.0;
constexpr double kRimPixels = 3.0;
/// Handles fade from this part of the way from near to far ones on; far ones lose so much of their radius,
/// colour and ghost. The nearest and the farthest of all are this part of them.
constexpr double kOutermost = 0.08;
constexpr double kFadeFrom = 0.3;
constexpr double kSmaller = 0.4;
constexpr double kPaler = 0.5;
constexpr double kThinner = 0.8;
/// Where handles differ in depth by less than this part of their distance, none is far.
constexpr double kLeastDepth = 0.05;
const Vec3 kDefaultColor(0.95, 0.75, 0.25);
/// An actor below this opacity lets the handles behind it be seen.
constexpr double kOpaque = 0.999;

/// How far near and far handles are from the eye, mm.
struct Depths {
  double nearest = 0;
  double farthest = 0;
  /// 0 for a near handle, 1 for a far one.
  double fading(double depth) const {
    const double part = (depth - nearest) / std::max(farthest - nearest, kLeastDepth * std::abs(nearest));
    const double t = std::clamp((part - kFadeFrom) / (1 - kFadeFrom), 0.0, 1.0);
    return t * t * (3 - 2 * t);
  }
};

/// A handle near the cursor.
struct HandleCandidate {
  int handle = -1;
  Vec3 seen = Vec3::Zero(); ///< The point of its ball that is seen there, mm.
};

struct Ranked {
  HandleCandidate candidate;
  bool onBall; ///< The position is on the ball itself, not beside it.
  double rank; ///< Depth on the ball, pixels beside it.
  bool operator<(const Ranked& other) const { return onBall != other.onBall ? onBall : rank < other.rank; }
};

/// The handles that a display position could mean, the likeliest first: those whose ball is under it by their
/// nearness to the eye, then those beside it by their distance on the display. `radii` are the balls' in
/// device pixels (0: not to be picked), `reach` says how far from its centre a handle can be picked at least.
/// Does not ask what is hidden. O(n).
std::vector<HandleCandidate> handlesNear(const ViewGeometry& view, const Points& positions,
                                         const std::vector<double>& radii, double reach, double x, double y) {
  std::vector<Ranked> found;
  for (int i = 0; i < positions.rows(); ++i) {
    const double ball = radii[std::size_t(i)];
    const auto at = view.project(positions.row(i).transpose());
    const double dx = x - at.x, dy = y - at.y, away = std::hypot(dx, dy);
    if (ball <= 0 || at.depth <= 0 || !(away <= std::max(ball, reach)))
      continue;
    // The nearest point of the ball's disc, lifted onto the front of the ball.
    const bool onBall = away <= ball;
    const double inward = onBall ? 1 : ball / away, along = std::min(away, ball);
    const double lift = std::sqrt(ball * ball - along * along) * view.worldPerPixel(at.depth);
    const double depth = std::max(at.depth - lift, 1e-3 * at.depth);
    const Vec3 seen = view.unproject(at.x + inward * dx, at.y + inward * dy, depth);
    found.push_back({{i, seen}, onBall, onBall ? depth : away});
  }
  std::stable_sort(found.begin(), found.end());
  std::vector<HandleCandidate> candidates;
  for (const auto& ranked : found)
    candidates.push_back(ranked.candidate);
  return candidates;
}

/// Whether a visible and opaque actor is between the eye and a point. O(triangles).
bool isHidden(const ViewGeometry& view, const Vec3& point,
              const std::vector<vtkSmartPointer<vtkActor>>& actors) {
  const auto at = view.project(point);
  const Ray ray = view.ray(at.x, at.y);
  const double distance = (point - ray.origin).dot(ray.direction);
  return std::any_of(actors.begin(), actors.end(), [&](const auto& actor) {
    if (!actor->GetVisibility() || actor->GetProperty()->GetOpacity() < kOpaque)
      return false;
    const ActorMesh mesh(actor);
    return nearestHit(ray, mesh.view(), distance).has_value();
  });
}

} // namespace

struct vtkVisceraHandleSetRepresentation::Parts {
  Points positions = Points(0, 3);
  Colors colors = Colors(0, 3);
  std::vector<char> shown;
  std::vector<char> locked;
  std::vector<char> background;
  std::vector<int> selection;
  int active = -1;
  std::vector<vtkSmartPointer<vtkActor>> occluders;

  double radius = 10, activeRadius = 12, pickRadius = 12;
  Theme theme = darkTheme();

  std::vector<int> dragged;
  Points dragStart = Points(0, 3);
  double grabOffset[2] = {0, 0};

  HandleGlyphs glyphs;
  std::unique_ptr<BeforeRender> beforeRender;
  double bounds[6] = {1, -1, 1, -1, 1, -1};

  Vec3 position(int i) const { return positions.row(i).transpose(); }
  bool isSelected(int i) const { return std::binary_search(selection.begin(), selection.end(), i); }
  double radiusPixels(int i, double ratio) const { return ratio * (i == active ? activeRadius : radius); }
  Depths depths(const ViewGeometry& view) const;
  HandleGlyph glyph(const ViewGeometry& view, const Depths& depths, int i) const;
};

/// Depths of the handles that are shown, but for the few farthest out: those of a box around the organ
/// would make all others alike. O(n).
Depths vtkVisceraHandleSetRepresentation::Parts::depths(const ViewGeometry& view) const {
  std::vector<double> all;
  for (int i = 0; i < positions.rows(); ++i)
    if (const double depth = (position(i) - view.eye).dot(view.forward); shown[std::size_t(i)] && depth > 0)
      all.push_back(depth);
  if (all.empty())
    return {};
  const auto at = [&all](double part) {
    const auto place = all.begin() + static_cast<std::ptrdiff_t>(std::lround(part * double(all.size() - 1)));
    std::nth_element(all.begin(), place, all.end());
    return *place;
  };
  return {at(kOutermost), at(1 - kOutermost)};
}

HandleGlyph vtkVisceraHandleSetRepresentation::Parts::glyph(const ViewGeometry& view, const Depths& depths,
                                                            int i) const {
  HandleGlyph glyph;
  glyph.position = position(i);
  const double depth = (glyph.position - view.eye).dot(view.forward);
  if (!shown[std::size_t(i)] || depth <= 0)
    return glyph;
  const double pixel = view.worldPerPixel(depth);
  const bool selected = isSelected(i);
  // Far handles are smaller, so that they do not hide the organ; handles in use have their full size.
  const double faded = selected || i == active ? 0 : background[std::size_t(i)] ? 1 : depths.fading(depth);
  const double ratio = view.pixelRatio, pixels = (1 - kSmaller * faded) * radiusPixels(i, ratio);
  glyph.radius = pixel * pixels;
  glyph.rimRadius = pixel * (pixels + ratio * (selected ? kRimPixels : kOutlinePixels));
  glyph.color = colors.row(i).transpose().cast<double>() / 255;
  glyph.rimColor = selected ? theme.rim : Vec3(0.25 * glyph.color);
  if (i == active)
    glyph.color = (glyph.color + 0.25 * (Vec3::Ones() - glyph.color)).eval();
  const Vec3 air = 0.5 * (theme.backgroundTop + theme.backgroundBottom);
  glyph.color += (kPaler * faded * (air - glyph.color)).eval();
  glyph.rimColor += (kPaler * faded * (air - glyph.rimColor)).eval();
  glyph.ghost = 1 - kThinner * faded;
  return glyph;
}

vtkStandardNewMacro(vtkVisceraHandleSetRepresentation);

vtkVisceraHandleSetRepresentation::vtkVisceraHandleSetRepresentation()
    : Internals(std::make_unique<Parts>()) {
  InteractionState = Outside;
  Internals->beforeRender = std::make_unique<BeforeRender>([this] { BuildRepresentation(); });
}

vtkVisceraHandleSetRepresentation::~vtkVisceraHandleSetRepresentation() {
  SetRenderer(nullptr);
}

// ---- handles

void vtkVisceraHandleSetRepresentation::SetPositions(Points positions) {
  auto& p = *Internals;
  if (positions.rows() != p.positions.rows()) {
    const auto count = std::size_t(positions.rows());
    p.shown.assign(count, 1);
    p.locked.assign(count, 0);
    p.background.assign(count, 0);
    p.selection.clear();
    p.dragged.clear();
    p.dragStart.resize(0, 3);
    p.active = -1;
    InteractionState = Outside;
    p.colors.resize(positions.rows(), 3);
    p.positions = std::move(positions);
    SetColor(kDefaultColor);
    return;
  }
  p.positions = std::move(positions);
  Modified();
}

const Points& vtkVisceraHandleSetRepresentation::GetPositions() const {
  return Internals->positions;
}

void vtkVisceraHandleSetRepresentation::SetPosition(int handle, const Vec3& position) {
  assert(handle >= 0 && handle < GetNumberOfHandles());
  Internals->positions.row(handle) = position.transpose();
  Modified();
}

Vec3 vtkVisceraHandleSetRepresentation::GetPosition(int handle) const {
  assert(handle >= 0 && handle < GetNumberOfHandles());
  return Internals->position(handle);
}

int vtkVisceraHandleSetRepresentation::GetNumberOfHandles() const {
  return static_cast<int>(Internals->positions.rows());
}

void vtkVisceraHandleSetRepresentation::SetColors(const Colors& colors) {
  assert(colors.rows() == GetNumberOfHandles());
  Internals->colors = colors;
  Modified();
}

void vtkVisceraHandleSetRepresentation::SetColor(const Vec3& color) {
  Internals->colors.rowwise() = (255 * color).array().round().cast<std::uint8_t>().matrix().transpose();
  Modified();
}

void vtkVisceraHandleSetRepresentation::SetHandleShown(int handle, bool shown) {
  Internals->shown.at(std::size_t(handle)) = shown;
  Modified();
}

bool vtkVisceraHandleSetRepresentation::GetHandleShown(int handle) const {
  return Internals->shown.at(std::size_t(handle)) != 0;
}

void vtkVisceraHandleSetRepresentation::SetHandleLocked(int handle, bool locked) {
  Internals->locked.at(std::size_t(handle)) = locked;
}

bool vtkVisceraHandleSetRepresentation::GetHandleLocked(int handle) const {
  return Internals->locked.at(std::size_t(handle)) != 0;
}

void vtkVisceraHandleSetRepresentation::SetHandleInBackground(int handle, bool background) {
  char& present = Internals->background.at(std::size_t(handle));
  if ((present != 0) == background)
    return;
  present = background;
  Modified();
}

bool vtkVisceraHandleSetRepresentation::GetHandleInBackground(int handle) const {
  return Internals->background.at(std::size_t(handle)) != 0;
}

void vtkVisceraHandleSetRepresentation::SetSelection(std::vector<int> selection) {
  std::sort(selection.begin(), selection.end());
  selection.erase(std::unique(selection.begin(), selection.end()), selection.end());
  std::erase_if(selection, [this](int i) { return i < 0 || i >= GetNumberOfHandles(); });
  if (selection == Internals->selection)
    return;
  Internals->selection = std::move(selection);
  Modified();
}

const std::vector<int>& vtkVisceraHandleSetRepresentation::GetSelection() const {
  return Internals->selection;
}

bool vtkVisceraHandleSetRepresentation::IsSelected(int handle) const {
  return Internals->isSelected(handle);
}

void vtkVisceraHandleSetRepresentation::SetActiveHandle(int handle) {
  assert(handle >= -1 && handle < GetNumberOfHandles());
  InteractionState = handle >= 0 ? OnHandle : Outside;
  if (handle == Internals->active)
    return;
  Internals->active = handle;
  Modified();
}

int vtkVisceraHandleSetRepresentation::GetActiveHandle() const {
  return Internals->active;
}

// ---- occluders and picking

void vtkVisceraHandleSetRepresentation::AddOccluder(vtkActor* actor) {
  auto& occluders = Internals->occluders;
  if (std::find(occluders.begin(), occluders.end(), actor) == occluders.end())
    occluders.emplace_back(actor);
  if (Renderer)
    drawLast(Renderer, this); // Ghosts are what lies behind what was drawn before.
}

void vtkVisceraHandleSetRepresentation::RemoveOccluder(vtkActor* actor) {
  std::erase(Internals->occluders, actor);
}

int vtkVisceraHandleSetRepresentation::PickHandle(int x, int y) {
  if (!Renderer || GetNumberOfHandles() == 0)
    return -1;
  const auto& p = *Internals;
  const auto view = viewGeometry(Renderer);
  const double ratio = view.pixelRatio;
  std::vector<double> radii(std::size_t(GetNumberOfHandles()), 0.0);
  for (int i = 0; i < GetNumberOfHandles(); ++i)
    if (p.shown[std::size_t(i)])
      radii[std::size_t(i)] = p.radiusPixels(i, ratio);
  for (const auto& candidate : handlesNear(view, p.positions, radii, ratio * p.pickRadius, x, y))
    if (!isHidden(view, candidate.seen, p.occluders))
      return candidate.handle;
  return -1;
}

bool vtkVisceraHandleSetRepresentation::IsHandleVisible(int handle) {
  if (!Renderer || !GetHandleShown(handle))
    return false;
  const auto view = viewGeometry(Renderer);
  const Vec3 center = GetPosition(handle);
  const double depth = view.project(center).depth;
  return depth > 0 && !isHidden(view, center - GetWorldRadius(handle) * view.forward, Internals->occluders);
}

int vtkVisceraHandleSetRepresentation::ComputeInteractionState(int x, int y, int) {
  SetActiveHandle(PickHandle(x, y));
  return InteractionState;
}

// ---- dragging

void vtkVisceraHandleSetRepresentation::StartWidgetInteraction(double eventPosition[2]) {
  auto& p = *Internals;
  p.dragged.clear();
  if (p.active < 0 || !Renderer)
    return;
  const auto group = p.isSelected(p.active) ? p.selection : std::vector<int>{p.active};
  std::copy_if(group.begin(), group.end(), std::back_inserter(p.dragged),
               [&](int i) { return !p.locked[std::size_t(i)]; });
  p.dragStart.resize(Eigen::Index(p.dragged.size()), 3);
  for (std::size_t k = 0; k < p.dragged.size(); ++k)
    p.dragStart.row(Eigen::Index(k)) = p.positions.row(p.dragged[k]);
  const auto at = viewGeometry(Renderer).project(p.position(p.active));
  p.grabOffset[0] = eventPosition[0] - at.x;
  p.grabOffset[1] = eventPosition[1] - at.y;
}

bool vtkVisceraHandleSetRepresentation::SolveDrag(const double eventPosition[2], Vec3& position) {
  auto& p = *Internals;
  const auto grabbed = std::find(p.dragged.begin(), p.dragged.end(), p.active);
  if (grabbed == p.dragged.end())
    return false;
  const Vec3 start = p.dragStart.row(grabbed - p.dragged.begin()).transpose();
  const auto view = viewGeometry(Renderer);
  const double startDepth = (start - view.eye).dot(view.forward);
  if (startDepth <= 0)
    return false;
  const double x = eventPosition[0] - p.grabOffset[0], y = eventPosition[1] - p.grabOffset[1];
  position = view.unproject(x, y, startDepth);
  return true;
}

void vtkVisceraHandleSetRepresentation::WidgetInteraction(double eventPosition[2]) {
  if (Vec3 position; SolveDrag(eventPosition, position))
    DragTo(position);
}

void vtkVisceraHandleSetRepresentation::DragTo(const Vec3& position) {
  auto& p = *Internals;
  const auto grabbed = std::find(p.dragged.begin(), p.dragged.end(), p.active) - p.dragged.begin();
  if (grabbed == std::ptrdiff_t(p.dragged.size()))
    return;
  const Vec3 delta = position - p.dragStart.row(grabbed).transpose();
  for (std::size_t k = 0; k < p.dragged.size(); ++k)
    p.positions.row(p.dragged[k]) = p.dragStart.row(Eigen::Index(k)) + delta.transpose();
  Modified();
}

const std::vector<int>& vtkVisceraHandleSetRepresentation::GetDraggedHandles() const {
  return Internals->dragged;
}

const Points& vtkVisceraHandleSetRepresentation::GetDragStart() const {
  return Internals->dragStart;
}

void vtkVisceraHandleSetRepresentation::RestoreDrag() {
  auto& p = *Internals;
  for (std::size_t k = 0; k < p.dragged.size(); ++k)
    p.positions.row(p.dragged[k]) = p.dragStart.row(Eigen::Index(k));
  Modified();
}

// ---- looks

void vtkVisceraHandleSetRepresentation::SetHandleRadius(double pixels) {
  Internals->radius = pixels;
  Modified();
}
double vtkVisceraHandleSetRepresentation::GetHandleRadius() const {
  return Internals->radius;
}

void vtkVisceraHandleSetRepresentation::SetActiveRadius(double pixels) {
  Internals->activeRadius = pixels;
  Modified();
}

void vtkVisceraHandleSetRepresentation::SetPickRadius(double pixels) {
  Internals->pickRadius = pixels;
}

void vtkVisceraHandleSetRepresentation::SetTheme(const Theme& theme) {
  Internals->theme = theme;
  Modified();
}

double vtkVisceraHandleSetRepresentation::GetWorldRadius(int handle) {
  if (!Renderer)
    return 0;
  const auto view = viewGeometry(Renderer);
  return Internals->glyph(view, Internals->depths(view), handle).radius;
}

// ---- drawing

void vtkVisceraHandleSetRepresentation::SetRenderer(vtkRenderer* renderer) {
  Superclass::SetRenderer(renderer);
  Internals->beforeRender->setRenderer(renderer);
}

void vtkVisceraHandleSetRepresentation::BuildRepresentation() {
  if (!Renderer)
    return;
  const auto view = viewGeometry(Renderer);
  const Depths depths = Internals->depths(view);
  std::vector<HandleGlyph> glyphs;
  glyphs.reserve(std::size_t(GetNumberOfHandles()));
  for (int i = 0; i < GetNumberOfHandles(); ++i)
    glyphs.push_back(Internals->glyph(view, depths, i));
  Internals->glyphs.set(glyphs);
  BuildTime.Modified();
}

double* vtkVisceraHandleSetRepresentation::GetBounds() {
  auto& p = *Internals;
  if (p.positions.rows() == 0)
    return nullptr;
  const Bounds box = viscera::boundsOf(p.positions);
  for (int c = 0; c < 3; ++c) {
    p.bounds[2 * c] = box.low[c];
    p.bounds[2 * c + 1] = box.high[c];
  }
  return p.bounds;
}

void vtkVisceraHandleSetRepresentation::GetActors(vtkPropCollection* collection) {
  Internals->glyphs.actor()->GetActors(collection);
}

void vtkVisceraHandleSetRepresentation::ReleaseGraphicsResources(vtkWindow* window) {
  Internals->glyphs.release(window);
}

int vtkVisceraHandleSetRepresentation::RenderOpaqueGeometry(vtkViewport* viewport) {
  return Internals->glyphs.render(viewport);
}
