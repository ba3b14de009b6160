#include "viscera/scene/vtkVisceraCutPlaneRepresentation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <vtkActor.h>
#include <vtkArrowSource.h>
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

vtkStandardNewMacro(vtkVisceraCutPlaneRepresentation);

namespace {

/// Logical pixels.
constexpr double kCutArrowLength = 68;
constexpr double kGrabDistance = 8;
constexpr double kCutRimWidth = 1.6;
constexpr double kCutRimHeldWidth = 3;
constexpr double kCutRimOpacity = 0.9;
constexpr double kCutBehindOpacity = 0.35;
constexpr int kCutRimSides = 96;
/// The rim is a little wider than what is cut.
constexpr double kRimScale = 1.08;
/// A normal this nearly along the line of sight cannot be followed by the cursor's ray.
constexpr double kAlongSight = 0.995;

double distanceToSegment(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d ab = b - a;
  const double length = ab.squaredNorm();
  const double part = length > 0 ? std::clamp((p - a).dot(ab) / length, 0.0, 1.0) : 0;
  return (p - a - part * ab).norm();
}

} // namespace

struct vtkVisceraCutPlaneRepresentation::Parts {
  CutPlane plane;
  Vec3 ballCenter = Vec3::Zero();
  double ballRadius = 50;
  CutPlane planeAtStart;
  Vec3 grabbed = Vec3::Zero(); ///< Pushing: on the normal's line. Tilting: unit, from the middle to the rim.
  int state = 0;
  int highlighted = 0;
  Vec3 accent = Vec3::Ones();

  vtkNew<vtkMatrix4x4> rimMatrix;
  vtkNew<vtkMatrix4x4> arrowMatrix;
  std::vector<vtkSmartPointer<vtkActor>> actors; ///< Rim and arrow: what is hidden of them, then they.

  Vec3 middle() const { return ballCenter - plane.normal * plane.normal.dot(ballCenter - plane.origin); }
  double rimRadius() const { return kRimScale * ballRadius; }
};

namespace {

vtkSmartPointer<vtkPolyData> circle() {
  vtkNew<vtkRegularPolygonSource> source;
  source->SetNumberOfSides(kCutRimSides);
  source->SetRadius(1);
  source->SetNormal(1, 0, 0);
  source->GeneratePolygonOff();
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> cutArrow() {
  vtkNew<vtkArrowSource> source;
  source->SetShaftResolution(16);
  source->SetTipResolution(20);
  source->SetShaftRadius(0.022);
  source->SetTipRadius(0.085);
  source->SetTipLength(0.26);
  source->Update();
  return source->GetOutput();
}

} // namespace

vtkVisceraCutPlaneRepresentation::vtkVisceraCutPlaneRepresentation() : Inside(std::make_unique<Parts>()) {
  auto& p = *Inside;
  for (const bool behind : {true, false}) {
    const double opacity = behind ? kCutBehindOpacity : kCutRimOpacity;
    p.actors.push_back(newHelper(circle(), p.rimMatrix, opacity, behind));
    p.actors.push_back(newHelper(cutArrow(), p.arrowMatrix, opacity, behind));
  }
  p.actors.back()->GetProperty()->LightingOn();
  p.actors.back()->GetProperty()->SetAmbient(0.4);
  SetTheme(darkTheme());
  NeedToRenderOn();
}

vtkVisceraCutPlaneRepresentation::~vtkVisceraCutPlaneRepresentation() = default;

void vtkVisceraCutPlaneRepresentation::SetPlane(const CutPlane& plane) {
  Inside->plane = {plane.origin, plane.normal.normalized()};
  Modified();
}

CutPlane vtkVisceraCutPlaneRepresentation::GetPlane() const {
  return Inside->plane;
}

void vtkVisceraCutPlaneRepresentation::SetBall(const Vec3& center, double radius) {
  Inside->ballCenter = center;
  Inside->ballRadius = radius;
  Modified();
}

Vec3 vtkVisceraCutPlaneRepresentation::GetMiddle() const {
  return Inside->middle();
}

Vec3 vtkVisceraCutPlaneRepresentation::GetArrowTip() const {
  const Vec3 middle = Inside->middle();
  return middle - Inside->plane.normal * (kCutArrowLength * viewGeometry(Renderer).logicalPixel(middle));
}

Vec3 vtkVisceraCutPlaneRepresentation::GetRimPoint(double angle) const {
  const Vec3 side = Inside->plane.normal.unitOrthogonal(), third = Inside->plane.normal.cross(side);
  return Inside->middle() + Inside->rimRadius() * (std::cos(angle) * side + std::sin(angle) * third);
}

void vtkVisceraCutPlaneRepresentation::SetTheme(const Theme& theme) {
  Inside->accent = theme.accent;
  Highlight(Inside->highlighted);
}

void vtkVisceraCutPlaneRepresentation::Highlight(int state) {
  auto& p = *Inside;
  p.highlighted = state;
  const Vec3 strong = 0.45 * p.accent + 0.55 * Vec3(1, 0.72, 0.2);
  for (std::size_t i = 0; i < p.actors.size(); ++i)
    setColor(p.actors[i], state == (i % 2 == 0 ? OnRim : OnArrow) ? strong : p.accent);
  Modified();
}

int vtkVisceraCutPlaneRepresentation::GetHighlighted() const {
  return Inside->highlighted;
}

int vtkVisceraCutPlaneRepresentation::ComputeInteractionState(int x, int y, int) {
  InteractionState = Outside;
  if (!Renderer || !GetVisibility())
    return InteractionState;
  const ViewGeometry view = viewGeometry(Renderer);
  const double reach = kGrabDistance * view.pixelRatio;
  const auto onDisplay = [&](const Vec3& point) {
    const auto at = view.project(point);
    return Eigen::Vector2d(at.x, at.y);
  };
  const Eigen::Vector2d cursor(x, y);
  if (distanceToSegment(cursor, onDisplay(GetMiddle()), onDisplay(GetArrowTip())) < reach)
    return InteractionState = OnArrow;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kCutRimSides; ++i)
    nearest = std::min(nearest, distanceToSegment(cursor, onDisplay(GetRimPoint(2 * M_PI * i / kCutRimSides)),
                                                  onDisplay(GetRimPoint(2 * M_PI * (i + 1) / kCutRimSides))));
  if (nearest < reach)
    InteractionState = OnRim;
  return InteractionState;
}

namespace {

/// How far along a line the place lies that is nearest to a ray.
double alongLine(const Vec3& origin, const Vec3& direction, const Ray& ray) {
  // |o + s d - (r + t e)| is least at s = (w.d - (d.e)(w.e)) / (1 - (d.e)^2), with w = r - o and unit
  // directions d and e of line and ray.
  const double cosine = direction.dot(ray.direction);
  const Vec3 between = ray.origin - origin;
  return (between.dot(direction) - cosine * between.dot(ray.direction)) / (1 - cosine * cosine);
}

/// The direction from `center` to where a ray meets the ball around it, on the same side of the ball as
/// `before`; where it misses, to the place of the ball that is nearest to it.
Vec3 towardsBall(const Vec3& center, double radius, const Ray& ray, const Vec3& before) {
  // The ray passes the centre at its foot f, and meets the ball at f +- sqrt(r^2 - |f|^2) e.
  const double along = (center - ray.origin).dot(ray.direction);
  const Vec3 foot = ray.origin + along * ray.direction - center;
  const double half = std::sqrt(std::max(radius * radius - foot.squaredNorm(), 0.0));
  const double side = before.dot(ray.direction) > 0 ? 1 : -1;
  return (foot + side * half * ray.direction).normalized();
}

} // namespace

void vtkVisceraCutPlaneRepresentation::StartWidgetInteraction(double at[2]) {
  auto& p = *Inside;
  p.planeAtStart = p.plane;
  p.state = ComputeInteractionState(static_cast<int>(at[0]), static_cast<int>(at[1]));
  const ViewGeometry view = viewGeometry(Renderer);
  const Vec3 middle = p.middle();
  const Ray ray = view.ray(at[0], at[1]);
  if (p.state == OnRim) {
    // The nearer one of the rim's two places near the cursor is grabbed.
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < kCutRimSides; ++i) {
      const Vec3 place = GetRimPoint(2 * M_PI * i / kCutRimSides);
      const auto there = view.project(place);
      const double away = std::hypot(there.x - at[0], there.y - at[1]);
      if (away < nearest) {
        nearest = away;
        p.grabbed = (place - middle).normalized();
      }
    }
    p.grabbed = towardsBall(middle, p.rimRadius(), ray, p.grabbed);
  } else if (std::abs(p.plane.normal.dot(ray.direction)) < kAlongSight) {
    p.grabbed = Vec3(alongLine(middle, p.plane.normal, ray), 0, 0);
  } else {
    p.grabbed = Vec3(0, at[1], 0);
  }
}

void vtkVisceraCutPlaneRepresentation::WidgetInteraction(double at[2]) {
  if (Inside->state == OnArrow)
    Push(at[0], at[1]);
  else if (Inside->state == OnRim)
    Tilt(at[0], at[1]);
  Modified();
}

void vtkVisceraCutPlaneRepresentation::Push(double x, double y) {
  auto& p = *Inside;
  const Vec3& normal = p.planeAtStart.normal;
  const Vec3 middle = p.ballCenter - normal * normal.dot(p.ballCenter - p.planeAtStart.origin);
  const ViewGeometry view = viewGeometry(Renderer);
  const Ray ray = view.ray(x, y);
  double moved = 0;
  if (p.grabbed.y() == 0 && std::abs(normal.dot(ray.direction)) < kAlongSight)
    moved = alongLine(middle, normal, ray) - p.grabbed.x();
  else // The normal is seen end on: up pushes away from the reader.
    moved = (y - p.grabbed.y()) * view.worldPerPixel(std::max((middle - view.eye).dot(view.forward), 0.0)) *
            (normal.dot(view.forward) > 0 ? 1 : -1);
  // The plane stays where there is something to cut.
  const double from = normal.dot(middle - p.ballCenter);
  moved = std::clamp(moved, -p.ballRadius - from, p.ballRadius - from);
  p.plane = {middle + moved * normal, normal};
}

void vtkVisceraCutPlaneRepresentation::Tilt(double x, double y) {
  auto& p = *Inside;
  const Vec3& normal = p.planeAtStart.normal;
  const Vec3 middle = p.ballCenter - normal * normal.dot(p.ballCenter - p.planeAtStart.origin);
  const Vec3 to = towardsBall(middle, p.rimRadius(), viewGeometry(Renderer).ray(x, y), p.grabbed);
  const auto turn = Eigen::Quaterniond::FromTwoVectors(p.grabbed, to);
  p.plane = {middle, (turn * normal).normalized()};
}

void vtkVisceraCutPlaneRepresentation::RestoreDrag() {
  Inside->plane = Inside->planeAtStart;
  Modified();
}

void vtkVisceraCutPlaneRepresentation::BuildRepresentation() {
  if (!Renderer)
    return;
  auto& p = *Inside;
  const ViewGeometry view = viewGeometry(Renderer);
  const Vec3 middle = p.middle();
  placeAlong(p.rimMatrix, middle, p.plane.normal, p.rimRadius());
  placeAlong(p.arrowMatrix, middle, -p.plane.normal, kCutArrowLength * view.logicalPixel(middle));
  const double width = (p.highlighted == OnRim ? kCutRimHeldWidth : kCutRimWidth) * view.pixelRatio;
  for (const auto& actor : p.actors)
    actor->GetProperty()->SetLineWidth(static_cast<float>(width));
}

void vtkVisceraCutPlaneRepresentation::GetActors(vtkPropCollection* actors) {
  for (const auto& actor : Inside->actors)
    actor->GetActors(actors);
}

void vtkVisceraCutPlaneRepresentation::ReleaseGraphicsResources(vtkWindow* window) {
  for (const auto& actor : Inside->actors)
    actor->ReleaseGraphicsResources(window);
}

int vtkVisceraCutPlaneRepresentation::RenderOpaqueGeometry(vtkViewport* viewport) {
  if (!GetVisibility())
    return 0;
  BuildRepresentation();
  int drawn = 0;
  for (const auto& actor : Inside->actors)
    drawn += actor->RenderOpaqueGeometry(viewport);
  return drawn;
}

double* vtkVisceraCutPlaneRepresentation::GetBounds() {
  return nullptr; // Not a part of what is framed.
}
