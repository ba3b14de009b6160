#include "viscera/scene/vtkVisceraGizmoRepresentation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <vtkAppendPolyData.h>
#include <vtkCubeSource.h>
#include <vtkLineSource.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRegularPolygonSource.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "blended_actor.h"
#include "view_geometry.h"

using viscera::Vec3;
using namespace viscera::scene;

vtkStandardNewMacro(vtkVisceraGizmoRepresentation);

namespace {

/// Logical pixels, as the shapes are made: of the rings, and to the ends of the arms, which begin beside the
/// cube in the middle.
constexpr double kRadius = 78;
constexpr double kGizmoArm = 104;
constexpr double kGizmoCube = 5;
constexpr double kGap = 12;
constexpr int kGizmoRingSides = 96;
constexpr double kRingReach = 7;
constexpr double kCubeReach = 10;
constexpr double kLineWidth = 2.2;
constexpr double kActiveLineWidth = 4;
constexpr double kGizmoOpacity = 0.95;
/// The factor of opacity for parts behind an organ.
constexpr double kGizmoBehind = 0.35;
constexpr int kRingSamples = 64;
/// Below this sine of the angle between the line of sight and a ring's plane the ring is seen from its side.
constexpr double kFromTheSide = 0.3;
/// Pixels of the mouse for a factor of e.
constexpr double kPixelsOfScale = 110;
/// An axis that is shorter than this on the screen points at the eye: the mouse goes up and down instead.
constexpr double kShortestAxis = 12;
constexpr double kSmallestFactor = 0.05;
constexpr double kLargestFactor = 20;

constexpr int kParts = 7;
const std::array<Vec3, 3> kAxisColors = {Vec3(0.91, 0.40, 0.36), Vec3(0.45, 0.75, 0.38),
                                         Vec3(0.36, 0.62, 0.95)};

bool isRing(int part) {
  return part >= vtkVisceraGizmoRepresentation::RingX && part <= vtkVisceraGizmoRepresentation::RingZ;
}
int axisOf(int part) {
  return (part - vtkVisceraGizmoRepresentation::RingX) % 3;
}

/// The gizmo's parts about the origin, of lines and flat cubes.
vtkSmartPointer<vtkPolyData> cube(const Vec3& at) {
  vtkNew<vtkCubeSource> source;
  source->SetXLength(2 * kGizmoCube);
  source->SetYLength(2 * kGizmoCube);
  source->SetZLength(2 * kGizmoCube);
  source->SetCenter(at.x(), at.y(), at.z());
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> ring(int axis) {
  const Vec3 normal = Vec3::Unit(axis);
  vtkNew<vtkRegularPolygonSource> source;
  source->SetNumberOfSides(kGizmoRingSides);
  source->SetRadius(kRadius);
  source->SetNormal(normal.x(), normal.y(), normal.z());
  source->GeneratePolygonOff();
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> arm(int axis) {
  const Vec3 end = kGizmoArm * Vec3::Unit(axis), begin = kGap * Vec3::Unit(axis);
  vtkNew<vtkLineSource> line;
  line->SetPoint1(begin.x(), begin.y(), begin.z());
  line->SetPoint2(end.x(), end.y(), end.z());
  vtkNew<vtkAppendPolyData> both;
  line->Update();
  both->AddInputData(line->GetOutput());
  both->AddInputData(cube(end));
  both->Update();
  return both->GetOutput();
}

vtkSmartPointer<vtkPolyData> shapeOf(int part) {
  if (part == vtkVisceraGizmoRepresentation::Middle)
    return cube(Vec3::Zero());
  return isRing(part) ? ring(axisOf(part)) : arm(axisOf(part));
}

/// The angle in (-pi, pi].
double wrapped(double angle) {
  return std::remainder(angle, 2 * std::numbers::pi);
}

} // namespace

struct vtkVisceraGizmoRepresentation::Parts {
  Vec3 center = Vec3::Zero();
  Theme theme = darkTheme();
  int active = Nothing;
  vtkNew<vtkMatrix4x4> matrix;
  std::vector<vtkSmartPointer<vtkActor>> actors; ///< The hidden parts first, then the visible ones.
  double bounds[6] = {1, -1, 1, -1, 1, -1};

  GizmoEvent motion;
  double grab[2] = {0, 0};
  bool fromTheSide = false;
  Vec3 grabbedAt = Vec3::Zero(); ///< Of a ring: from the centre to where it was grabbed, mm.
  double tangent[2] = {0, 0};    ///< Of a ring seen from its side: pixels for a radian.

  void color();
  Vec3 ringPoint(int axis, double angle, double radius) const;
  void startRing(const ViewGeometry& view, int axis, double radius);
  void turn(const ViewGeometry& view, double x, double y);
  void stretch(const ViewGeometry& view, double x, double y);
};

void vtkVisceraGizmoRepresentation::Parts::color() {
  for (int i = 0; i < kParts; ++i) {
    const int part = i + 1;
    const bool lit = part == active;
    const Vec3 base = part == Middle ? theme.text : kAxisColors[std::size_t(axisOf(part))];
    const Vec3 shown = lit ? Vec3(0.35 * base + 0.65 * theme.rim) : base;
    for (const int layer : {0, kParts})
      setColor(actors[std::size_t(layer + i)], shown);
  }
}

Vec3 vtkVisceraGizmoRepresentation::Parts::ringPoint(int axis, double angle, double radius) const {
  return center + radius * (std::cos(angle) * Vec3::Unit((axis + 1) % 3) +
                            std::sin(angle) * Vec3::Unit((axis + 2) % 3));
}

/// Where the ring was grabbed, and whether its plane is seen well enough to go by the angle in it.
void vtkVisceraGizmoRepresentation::Parts::startRing(const ViewGeometry& view, int axis, double radius) {
  double best = std::numeric_limits<double>::infinity(), angle = 0;
  for (int i = 0; i < kRingSamples; ++i) {
    const double at = 2 * std::numbers::pi * i / kRingSamples;
    const auto seen = view.project(ringPoint(axis, at, radius));
    // The place nearer to the eye counts of two under the cursor.
    const double distance = std::hypot(seen.x - grab[0], seen.y - grab[1]) + 1e-3 * seen.depth;
    if (distance < best) {
      best = distance;
      angle = at;
    }
  }
  constexpr double kStep = 1e-3;
  const auto before = view.project(ringPoint(axis, angle - kStep, radius));
  const auto after = view.project(ringPoint(axis, angle + kStep, radius));
  tangent[0] = (after.x - before.x) / (2 * kStep);
  tangent[1] = (after.y - before.y) / (2 * kStep);
  const auto middle = view.project(center);
  const Ray sight = view.ray(middle.x, middle.y);
  fromTheSide = std::abs(sight.direction[axis]) < kFromTheSide;
  const Ray ray = view.ray(grab[0], grab[1]);
  const double along = (center - ray.origin)[axis] / ray.direction[axis];
  grabbedAt = fromTheSide || !std::isfinite(along) ? Vec3(ringPoint(axis, angle, radius) - center)
                                                   : Vec3(ray.origin + along * ray.direction - center);
}

void vtkVisceraGizmoRepresentation::Parts::turn(const ViewGeometry& view, double x, double y) {
  const int axis = axisOf(active);
  if (fromTheSide) {
    // The cursor's way d along the ring's tangent t, in pixels for a radian: d . t / |t|^2.
    const double squared = tangent[0] * tangent[0] + tangent[1] * tangent[1];
    if (squared > 0)
      motion.angle = ((x - grab[0]) * tangent[0] + (y - grab[1]) * tangent[1]) / squared;
    return;
  }
  const Ray ray = view.ray(x, y);
  const double along = (center - ray.origin)[axis] / ray.direction[axis];
  if (!std::isfinite(along) || along <= 0)
    return;
  const Vec3 now = ray.origin + along * ray.direction - center;
  const double angle = std::atan2(grabbedAt.cross(now)[axis], grabbedAt.dot(now));
  // Full turns count: the angle goes on from where it was.
  motion.angle += wrapped(angle - motion.angle);
}

void vtkVisceraGizmoRepresentation::Parts::stretch(const ViewGeometry& view, double x, double y) {
  const double size = kGizmoArm * view.logicalPixel(center), ratio = view.pixelRatio;
  const double dx = x - grab[0], dy = y - grab[1];
  const double evenly = std::exp((dx + dy) / (kPixelsOfScale * ratio));
  motion.factors = Vec3::Ones();
  if (active == Middle) {
    motion.factors.setConstant(std::clamp(evenly, kSmallestFactor, kLargestFactor));
    return;
  }
  const int axis = axisOf(active);
  // 1 + d . a / |a|^2: the cube follows the cursor along its arm a as it is seen.
  const auto from = view.project(center), to = view.project(center + size * Vec3::Unit(axis));
  const double ax = to.x - from.x, ay = to.y - from.y, length = std::hypot(ax, ay);
  const double factor = length < kShortestAxis * ratio ? std::exp(dy / (kPixelsOfScale * ratio))
                                                       : 1 + (dx * ax + dy * ay) / (length * length);
  motion.factors[axis] = std::clamp(factor, kSmallestFactor, kLargestFactor);
}

vtkVisceraGizmoRepresentation::vtkVisceraGizmoRepresentation() : Internals(std::make_unique<Parts>()) {
  auto& p = *Internals;
  for (const bool behind : {true, false})
    for (int part = 1; part <= kParts; ++part)
      p.actors.push_back(
          newHelper(shapeOf(part), p.matrix, (behind ? kGizmoBehind : 1) * kGizmoOpacity, behind));
  p.color();
  Visibility = 0;
}

vtkVisceraGizmoRepresentation::~vtkVisceraGizmoRepresentation() = default;

void vtkVisceraGizmoRepresentation::SetCenter(const Vec3& center) {
  Internals->center = center;
  Modified();
}

const Vec3& vtkVisceraGizmoRepresentation::GetCenter() const {
  return Internals->center;
}

void vtkVisceraGizmoRepresentation::SetTheme(const Theme& theme) {
  Internals->theme = theme;
  Internals->color();
  Modified();
}

void vtkVisceraGizmoRepresentation::SetActivePart(int part) {
  Internals->active = part;
  InteractionState = part;
  Internals->color();
  Modified();
}

int vtkVisceraGizmoRepresentation::GetActivePart() const {
  return Internals->active;
}

int vtkVisceraGizmoRepresentation::PickPart(double x, double y) const {
  if (!Renderer)
    return Nothing;
  const auto& p = *Internals;
  const auto view = viewGeometry(Renderer);
  const double pixel = view.logicalPixel(p.center), ratio = view.pixelRatio;
  const auto distance = [&](const Vec3& point) {
    const auto at = view.project(point);
    return std::hypot(at.x - x, at.y - y);
  };
  int nearest = Nothing;
  double best = kCubeReach * ratio;
  for (const int part : {Middle, CubeX, CubeY, CubeZ})
    if (const double there = distance(GetGrabPoint(part)); there < best) {
      best = there;
      nearest = part;
    }
  if (nearest != Nothing)
    return nearest;
  best = kRingReach * ratio;
  for (const int part : {RingX, RingY, RingZ})
    for (int i = 0; i < kRingSamples; ++i) {
      const double angle = 2 * std::numbers::pi * i / kRingSamples;
      const double there = distance(p.ringPoint(axisOf(part), angle, kRadius * pixel));
      if (there < best) {
        best = there;
        nearest = part;
      }
    }
  return nearest;
}

Vec3 vtkVisceraGizmoRepresentation::GetGrabPoint(int part) const {
  const auto& p = *Internals;
  if (!Renderer || part == Middle || part == Nothing)
    return p.center;
  const auto view = viewGeometry(Renderer);
  const double pixel = view.logicalPixel(p.center);
  if (!isRing(part))
    return p.center + kGizmoArm * pixel * Vec3::Unit(axisOf(part));
  Vec3 nearest = p.center;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kRingSamples; ++i) {
    // Between the arms, where nothing else can be meant.
    const double angle = 2 * std::numbers::pi * (i + 0.5) / kRingSamples;
    const Vec3 point = p.ringPoint(axisOf(part), angle, kRadius * pixel);
    if (const double depth = view.project(point).depth;
        depth < least && PickPart(view.project(point).x, view.project(point).y) == part) {
      least = depth;
      nearest = point;
    }
  }
  return nearest;
}

const GizmoEvent& vtkVisceraGizmoRepresentation::GetMotion() const {
  return Internals->motion;
}

void vtkVisceraGizmoRepresentation::StartWidgetInteraction(double eventPosition[2]) {
  auto& p = *Internals;
  p.motion = GizmoEvent{isRing(p.active), p.center, Vec3::UnitX(), 0, Vec3::Ones()};
  p.grab[0] = eventPosition[0];
  p.grab[1] = eventPosition[1];
  if (!Renderer || !p.motion.rotates)
    return;
  p.motion.axis = Vec3::Unit(axisOf(p.active));
  const auto view = viewGeometry(Renderer);
  p.startRing(view, axisOf(p.active), kRadius * view.logicalPixel(p.center));
}

void vtkVisceraGizmoRepresentation::WidgetInteraction(double eventPosition[2]) {
  auto& p = *Internals;
  if (!Renderer || p.active == Nothing)
    return;
  const auto view = viewGeometry(Renderer);
  if (p.motion.rotates)
    p.turn(view, eventPosition[0], eventPosition[1]);
  else
    p.stretch(view, eventPosition[0], eventPosition[1]);
}

int vtkVisceraGizmoRepresentation::ComputeInteractionState(int x, int y, int) {
  SetActivePart(Visibility ? PickPart(x, y) : Nothing);
  return InteractionState;
}

void vtkVisceraGizmoRepresentation::BuildRepresentation() {
  if (!Renderer)
    return;
  auto& p = *Internals;
  const auto view = viewGeometry(Renderer);
  const double pixel = view.logicalPixel(p.center);
  for (int row = 0; row < 3; ++row) {
    p.matrix->SetElement(row, row, pixel);
    p.matrix->SetElement(row, 3, p.center[row]);
  }
  for (std::size_t i = 0; i < p.actors.size(); ++i) {
    const bool active = static_cast<int>(i % kParts) + 1 == p.active;
    const double width = view.pixelRatio * (active ? kActiveLineWidth : kLineWidth);
    p.actors[i]->GetProperty()->SetLineWidth(static_cast<float>(width));
  }
  BuildTime.Modified();
}

double* vtkVisceraGizmoRepresentation::GetBounds() {
  auto& p = *Internals;
  if (!Visibility || !Renderer)
    return nullptr;
  const double size = (kGizmoArm + kGizmoCube) * viewGeometry(Renderer).logicalPixel(p.center);
  for (int c = 0; c < 3; ++c) {
    p.bounds[2 * c] = p.center[c] - size;
    p.bounds[2 * c + 1] = p.center[c] + size;
  }
  return p.bounds;
}

void vtkVisceraGizmoRepresentation::GetActors(vtkPropCollection* collection) {
  for (const auto& actor : Internals->actors)
    actor->GetActors(collection);
}

void vtkVisceraGizmoRepresentation::ReleaseGraphicsResources(vtkWindow* window) {
  for (const auto& actor : Internals->actors)
    actor->ReleaseGraphicsResources(window);
}

int vtkVisceraGizmoRepresentation::RenderOpaqueGeometry(vtkViewport* viewport) {
  BuildRepresentation();
  int drawn = 0;
  for (const auto& actor : Internals->actors)
    drawn += actor->RenderOpaqueGeometry(viewport);
  return drawn;
}
