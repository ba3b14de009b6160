#include "orientation_cube.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

#include "flat_shape.h"
#include "standard_view.h"
#include "view_furniture.h"
#include "view_geometry.h"

namespace viscera::scene {
namespace {

constexpr double kCameraDistance = 5.2;
constexpr double kViewAngle = 24;
/// Half of the cube's side, and how much of it the bevel takes.
constexpr double kHalf = 0.5;
constexpr double kBevel = 0.1;
/// The cosine between a side's direction and the way to the eye from which on its letter is on the face, and
/// the one at which it is seen no more.
constexpr double kOnFace = 0.42;
constexpr double kGone = -0.25;
constexpr double kFade = 0.12; ///< The cosine on which a letter fades before.
/// How far beside the cube the letter of a side stands that is seen from its edge.
constexpr double kBeside = 0.3;
/// Logical pixels.
constexpr int kLargeLetter = 22;
constexpr int kSmallLetter = 13;
constexpr double kLeastLetter = 10;
constexpr double kLetterReach = 4; ///< Around a letter beside the cube.

constexpr std::array kCubeSides = {StandardView::anterior, StandardView::posterior, StandardView::left,
                                   StandardView::right,    StandardView::superior,  StandardView::inferior};
constexpr std::array kSideLetters = {"A", "P", "L", "R", "S", "I"};

/// The side's direction out of the body, in LPS.
Vec3 outwards(StandardView side) {
  return -directionsOf(side).forward;
}

using Polygon = std::vector<Vec3>;

/// Corners in the order that is counterclockwise from outside.
void addFacing(std::vector<Polygon>& polygons, Polygon corners) {
  const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  if (normal.dot(corners[0]) < 0)
    std::reverse(corners.begin(), corners.end());
  polygons.push_back(std::move(corners));
}

Vec3 along(int axis, double length) {
  Vec3 vector = Vec3::Zero();
  vector[axis] = length;
  return vector;
}

/// Six faces in the order of `kCubeSides`, then twelve edges and eight corners.
std::vector<Polygon> bevelledCube() {
  const double in = kHalf - kBevel;
  std::vector<Polygon> polygons;
  for (const StandardView side : kCubeSides) {
    const Vec3 out = outwards(side), up = directionsOf(side).up, right = up.cross(out);
    const Vec3 middle = kHalf * out;
    addFacing(polygons, {middle - in * right - in * up, middle + in * right - in * up,
                         middle + in * right + in * up, middle - in * right + in * up});
  }
  for (int axis = 0; axis < 3; ++axis) {
    const int first = (axis + 1) % 3, second = (axis + 2) % 3;
    for (const double a : {-1.0, 1.0})
      for (const double b : {-1.0, 1.0}) {
        const Vec3 onFirst = along(first, a * kHalf) + along(second, b * in);
        const Vec3 onSecond = along(first, a * in) + along(second, b * kHalf);
        addFacing(polygons, {onFirst - along(axis, in), onSecond - along(axis, in),
                             onSecond + along(axis, in), onFirst + along(axis, in)});
      }
  }
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    Polygon triangle;
    for (int axis = 0; axis < 3; ++axis)
      triangle.emplace_back(in * sign + along(axis, kBevel * sign[axis]));
    addFacing(polygons, std::move(triangle));
  }
  return polygons;
}

void setPolygons(vtkPolyData* data, const std::vector<Polygon>& polygons) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  for (const Polygon& polygon : polygons) {
    cells->InsertNextCell(static_cast<int>(polygon.size()));
    for (const Vec3& corner : polygon) // Of its own: every polygon is flat.
      cells->InsertCellPoint(points->InsertNextPoint(corner.data()));
  }
  data->SetPoints(points);
  data->SetPolys(cells);
}

/// The side of the cube that a ray enters through.
std::optional<std::size_t> entered(const Ray& ray) {
  double enter = -std::numeric_limits<double>::infinity(), leave = -enter;
  int through = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (-kHalf - ray.origin[axis]) / ray.direction[axis];
    const double b = (kHalf - ray.origin[axis]) / ray.direction[axis];
    if (std::min(a, b) > enter) {
      enter = std::min(a, b);
      through = axis;
    }
    leave = std::min(leave, std::max(a, b));
  }
  if (!(enter < leave))
    return std::nullopt;
  const Vec3 out = along(through, ray.direction[through] > 0 ? -1 : 1);
  for (std::size_t i = 0; i < kCubeSides.size(); ++i)
    if (outwards(kCubeSides[i]).dot(out) > 0.5)
      return i;
  return std::nullopt;
}

} // namespace

OrientationCube::OrientationCube(vtkRenderer* followed)
    : followed_(followed), beforeRender_([this] { follow(); }) {
  const auto polygons = bevelledCube();
  setPolygons(cube_, polygons);
  colors_->SetNumberOfComponents(3);
  colors_->SetNumberOfTuples(static_cast<vtkIdType>(polygons.size()));
  cube_->GetCellData()->SetScalars(colors_);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(cube_);
  actor_->SetMapper(mapper);
  actor_->GetProperty()->SetInterpolationToFlat();
  actor_->GetProperty()->BackfaceCullingOn();
  actor_->GetProperty()->SetAmbient(0.4);
  actor_->GetProperty()->SetDiffuse(0.65);
  renderer_->AddViewProp(actor_);
  for (std::size_t i = 0; i < texts_.size(); ++i) {
    texts_[i] = newText(kLargeLetter);
    texts_[i]->SetInput(kSideLetters[i]);
    texts_[i]->GetTextProperty()->BoldOn();
    texts_[i]->GetTextProperty()->SetJustificationToCentered();
    texts_[i]->GetTextProperty()->SetVerticalJustificationToCentered();
    renderer_->AddActor2D(texts_[i]);
  }
  renderer_->SetLayer(1);
  renderer_->InteractiveOff();
  beforeRender_.setRenderer(followed);
  paint();
}

OrientationCube::~OrientationCube() = default;

void OrientationCube::setTheme(const Theme& theme) {
  theme_ = theme;
  paint();
}

void OrientationCube::setShown(bool shown) {
  shown_ = shown;
  actor_->SetVisibility(shown);
}

void OrientationCube::highlight(std::optional<StandardView> side) {
  if (side == highlighted_)
    return;
  highlighted_ = side;
  paint();
}

void OrientationCube::paint() {
  const Vec3 face = theme_.dark ? Vec3(0.38, 0.43, 0.47) : Vec3(0.95, 0.97, 0.98);
  const Vec3 bevel = theme_.dark ? Vec3(0.52, 0.57, 0.61) : Vec3(0.72, 0.77, 0.8);
  const Vec3 bright = theme_.dark ? theme_.accent : Vec3(0.45 * theme_.accent + 0.55 * Vec3::Ones());
  for (vtkIdType i = 0; i < colors_->GetNumberOfTuples(); ++i) {
    const bool isFace = i < vtkIdType(kCubeSides.size());
    const bool lit = isFace && highlighted_ == kCubeSides[std::size_t(i)];
    const Vec3 color = 255 * (lit ? bright : isFace ? face : bevel);
    colors_->SetTuple3(i, color.x(), color.y(), color.z());
  }
  colors_->Modified();
  cube_->Modified();
}

OrientationCube::Letter OrientationCube::letterOf(StandardView side, const Vec3& eye) const {
  const Vec3 out = outwards(side);
  const double facing = out.dot((eye - kHalf * out).normalized());
  Letter letter;
  if (facing < kGone)
    return letter;
  const double part = std::clamp(facing / kOnFace, 0.0, 1.0);
  const double on = part * part * (3 - 2 * part);
  letter.place = (kHalf + (1 - on) * kBeside) * out;
  const double size = scale_ * (kSmallLetter + on * (kLargeLetter - kSmallLetter));
  letter.size = static_cast<int>(std::lround(std::max(kLeastLetter, size)));
  letter.onFace = on > 0.5;
  letter.opacity = std::clamp((facing - kGone) / kFade, 0.0, 1.0);
  return letter;
}

void OrientationCube::placeLetters() {
  const auto view = viewGeometry(renderer_);
  const int* origin = renderer_->GetOrigin();
  for (std::size_t i = 0; i < texts_.size(); ++i) {
    const Letter& letter = letters_[i] = letterOf(kCubeSides[i], view.eye);
    vtkTextActor* text = texts_[i];
    text->SetVisibility(shown_ && letter.size > 0);
    if (letter.size == 0)
      continue;
    const auto at = view.project(letter.place);
    text->SetPosition(at.x - origin[0], at.y - origin[1]);
    const bool lit = highlighted_ == kCubeSides[i] && !letter.onFace;
    const Vec3& color = lit ? theme_.accent : theme_.text;
    setTextSize(text, letter.size, theme_);
    text->GetTextProperty()->SetColor(color.x(), color.y(), color.z());
    text->GetTextProperty()->SetOpacity(letter.opacity);
  }
}

void OrientationCube::follow() {
  auto* window = followed_->GetRenderWindow();
  const int* size = window->GetSize();
  const double corner = orientationCorner(followed_, theme_.typeScale);
  scale_ = corner / (theme_.typeScale * kOrientationCorner * pixelRatioOf(window));
  renderer_->SetViewport(0, 0, std::min(1.0, corner / std::max(1, size[0])),
                         std::min(1.0, corner / std::max(1, size[1])));
  auto* from = followed_->GetActiveCamera();
  auto* camera = renderer_->GetActiveCamera();
  const Vec3 direction(from->GetDirectionOfProjection());
  const Vec3 position = -kCameraDistance * direction;
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(position.data());
  camera->SetViewUp(from->GetViewUp());
  camera->SetViewAngle(kViewAngle);
  renderer_->ResetCameraClippingRange();
  placeLetters();
}

std::optional<StandardView> OrientationCube::sideAt(double x, double y) const {
  if (!shown_ || !renderer_->GetRenderWindow() || !renderer_->IsInViewport(int(x), int(y)))
    return std::nullopt;
  const auto view = viewGeometry(renderer_);
  if (const auto side = entered(view.ray(x, y)))
    return kCubeSides[*side];
  const double reach = theme_.typeScale * view.pixelRatio;
  for (std::size_t i = 0; i < letters_.size(); ++i) {
    if (letters_[i].size == 0)
      continue;
    const auto at = view.project(letters_[i].place);
    if (std::hypot(x - at.x, y - at.y) <= reach * (0.5 * letters_[i].size + kLetterReach))
      return kCubeSides[i];
  }
  return std::nullopt;
}

} // namespace viscera::scene
