#include "viscera/scene/measurement_glyphs.h"

#include <algorithm>
#include <cmath>

#include <vtkCellData.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include "viscera/scene/organ_view.h"

#include "before_render.h"
#include "blended_actor.h"
#include "flat_shape.h"
#include "view_geometry.h"

namespace viscera::scene {
namespace {

constexpr int kMeasurementFontSize = 14; ///< Points at 72 DPI: logical pixels.
/// Logical pixels.
constexpr double kLineRadius = 1.25;
constexpr double kMarkRadius = 4.5;
constexpr double kRim = 1.5;
constexpr double kArcRadius = 44;
constexpr double kMouseReach = 10; ///< Of the mouse.
constexpr double kLabelGap = 8;
constexpr double kPadding = 5;
constexpr double kMeasurementMargin = 6;
/// An arc takes no more than this part of the shorter leg.
constexpr double kArcPart = 0.4;
constexpr double kBehindOpacity = 0.45;
constexpr double kBoxOpacity = 0.86;
constexpr int kMarkCorners = 20;
constexpr int kArcSteps = 32;

/// Flat shapes in space that face the eye, each of one colour.
class FacingShapes {
public:
  FacingShapes() {
    colors_->SetNumberOfComponents(3);
    data_->SetPoints(points_);
    data_->SetPolys(cells_);
    data_->GetCellData()->SetScalars(colors_);
  }

  vtkPolyData* data() const { return data_; }
  const ViewGeometry& view() const { return view_; }

  void begin(const ViewGeometry& view) {
    view_ = view;
    points_->Reset();
    cells_->Reset();
    colors_->Reset();
  }

  void end() {
    points_->Modified();
    cells_->Modified();
    colors_->Modified();
    data_->Modified();
  }

  /// `radius` in logical pixels; so much nearer to the eye that a surface at the place does not cut it.
  void addDisc(const Vec3& place, double radius, const Vec3& color) {
    const double size = radius * view_.logicalPixel(place);
    const Vec3 middle = place + size * towardsEye(place);
    vtkIdType corners[kMarkCorners];
    for (int i = 0; i < kMarkCorners; ++i) {
      const double angle = 2 * M_PI * i / kMarkCorners;
      corners[i] = insert(middle + size * (std::cos(angle) * view_.right + std::sin(angle) * view_.up));
    }
    addCell(kMarkCorners, corners, color);
  }

  void addLine(const Vec3& from, const Vec3& to, double radius, const Vec3& color) {
    const Vec3 side = (to - from).cross(towardsEye(0.5 * (from + to)));
    if (!(side.norm() > 0))
      return; // Seen from its end.
    vtkIdType corners[4];
    int count = 0;
    for (const auto& [place, sign] :
         {std::pair{&from, 1.0}, std::pair{&to, 1.0}, std::pair{&to, -1.0}, std::pair{&from, -1.0}}) {
      const double size = radius * view_.logicalPixel(*place);
      corners[count++] = insert(*place + size * (sign * side.normalized() + towardsEye(*place)));
    }
    addCell(4, corners, color);
  }

private:
  Vec3 towardsEye(const Vec3& place) const {
    return view_.parallel ? Vec3(-view_.forward) : Vec3((view_.eye - place).normalized());
  }
  vtkIdType insert(const Vec3& place) { return points_->InsertNextPoint(place.x(), place.y(), place.z()); }
  void addCell(int count, const vtkIdType* corners, const Vec3& color) {
    cells_->InsertNextCell(count, corners);
    const Vec3 bytes = 255 * color;
    colors_->InsertNextTuple3(bytes.x(), bytes.y(), bytes.z());
  }

  ViewGeometry view_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> cells_;
  vtkNew<vtkUnsignedCharArray> colors_;
  vtkNew<vtkPolyData> data_;
};

/// The places of the arc of an angle: around its corner, from one leg to the other.
std::vector<Vec3> arcOf(const std::vector<Vec3>& points, double radius) {
  const Vec3& corner = points[1];
  const double reach = std::min((points[0] - corner).norm(), (points[2] - corner).norm());
  radius = std::min(radius, kArcPart * reach);
  if (!(radius > 0))
    return {};
  const Vec3 a = (points[0] - corner).normalized();
  const Vec3 b = (points[2] - corner).normalized();
  const Vec3 normal = a.cross(b);
  // Legs in one line span no plane: the half circle may lie in any.
  const Vec3 across = normal.norm() > 0 ? Vec3(normal.cross(a).normalized()) : Vec3(a.unitOrthogonal());
  const double angle = std::atan2(normal.norm(), a.dot(b));
  std::vector<Vec3> arc;
  for (int i = 0; i <= kArcSteps; ++i) {
    const double at = angle * i / kArcSteps;
    arc.push_back(corner + radius * (std::cos(at) * a + std::sin(at) * across));
  }
  return arc;
}

bool isBefore(const ViewGeometry& view, const std::vector<Vec3>& points) {
  return !points.empty() && std::all_of(points.begin(), points.end(), [&](const Vec3& point) {
    return (point - view.eye).dot(view.forward) > 0;
  });
}

ScreenBox boxAround(double x, double y, double width, double height) {
  return {x - width / 2, y - height / 2, x + width / 2, y + height / 2};
}

ScreenBox moved(const ScreenBox& box, double x, double y) {
  return {box.left + x, box.bottom + y, box.right + x, box.top + y};
}

} // namespace

struct MeasurementGlyphs::Parts {
  explicit Parts(OrganView& viewIn) : view(viewIn) {}

  OrganView& view;
  std::vector<Item> items;
  Theme theme = darkTheme();
  bool shown = true;
  FacingShapes cores;
  FacingShapes rims;
  /// Rims first; what is hidden before what is seen.
  std::vector<vtkSmartPointer<BlendedActor>> actors;
  std::vector<vtkSmartPointer<vtkTextActor>> texts; ///< One an item.
  FlatShape boxes;
  std::vector<Drawn> drawn;
  BeforeRender beforeRender{[this] { follow(); }};

  void build();
  ViewGeometry seen() const;
  void follow();
  void drawAfterOrgans();
  void addShapes(const Item& item, FacingShapes& shapes, double rim, const Vec3& color);
  ScreenBox labelBox(const Item& item, const ViewGeometry& geometry, vtkTextActor* text);
  ScreenBox freeBox(ScreenBox box, const ViewGeometry& geometry) const;
  void drawBoxes();
};

void MeasurementGlyphs::Parts::build() {
  for (const bool behind : {true, false})
    for (FacingShapes* shapes : {&rims, &cores}) {
      actors.push_back(newHelper(shapes->data(), nullptr, behind ? kBehindOpacity : 1, behind));
      view.renderer()->AddActor(actors.back());
    }
  boxes.actor->GetProperty()->SetOpacity(kBoxOpacity);
  view.renderer()->AddActor2D(boxes.actor);
  beforeRender.setRenderer(view.renderer());
}

void MeasurementGlyphs::Parts::drawAfterOrgans() {
  if (view.renderer()->GetViewProps()->GetLastProp() != actors.back().Get())
    for (const auto& actor : actors)
      drawLast(view.renderer(), actor);
}

void MeasurementGlyphs::Parts::addShapes(const Item& item, FacingShapes& shapes, double rim,
                                         const Vec3& color) {
  for (std::size_t i = 1; i < item.points.size(); ++i)
    shapes.addLine(item.points[i - 1], item.points[i], kLineRadius + rim, color);
  if (item.path)
    return;
  if (item.points.size() == 3) {
    const std::vector<Vec3> arc = arcOf(item.points, kArcRadius * shapes.view().logicalPixel(item.points[1]));
    for (std::size_t i = 1; i < arc.size(); ++i)
      shapes.addLine(arc[i - 1], arc[i], kLineRadius + rim, color);
  }
  for (const Vec3& point : item.points)
    shapes.addDisc(point, kMarkRadius + rim, color);
}

/// Beside the middle of a line, or behind the arc of an angle.
ScreenBox MeasurementGlyphs::Parts::labelBox(const Item& item, const ViewGeometry& geometry,
                                             vtkTextActor* text) {
  const double ratio = geometry.pixelRatio;
  double size[2] = {0, 0};
  text->GetSize(view.renderer(), size);
  const double width = size[0] + 2 * kPadding * ratio;
  const double height = size[1] + 2 * kPadding * ratio;
  const std::size_t last = item.points.size() - 1;
  Vec3 anchor = 0.5 * (item.points.front() + item.points[std::min<std::size_t>(last, 1)]);
  double x = 0, y = 1; // Where the label is seen from the anchor.
  const DisplayPoint first = geometry.project(item.points.front());
  const DisplayPoint second = geometry.project(item.points[std::min<std::size_t>(last, 1)]);
  if (item.points.size() == 3 && !item.path) {
    const auto arc = arcOf(item.points, kArcRadius * geometry.logicalPixel(item.points[1]));
    anchor = arc.empty() ? item.points[1] : arc[arc.size() / 2];
    const DisplayPoint middle = geometry.project(anchor);
    x = middle.x - second.x;
    y = middle.y - second.y;
  } else if (item.points.size() == 2) {
    x = first.y - second.y;
    y = second.x - first.x;
    if (y < 0 || (y == 0 && x < 0)) {
      x = -x;
      y = -y;
    }
  }
  const double length = std::hypot(x, y);
  x = length > 0 ? x / length : 0;
  y = length > 0 ? y / length : 1;
  const DisplayPoint at = geometry.project(anchor);
  const double away = std::abs(x) * width / 2 + std::abs(y) * height / 2 + kLabelGap * ratio;
  return boxAround(at.x + away * x, at.y + away * y, width, height);
}

/// Inside the view and above the labels that it would lie over.
ScreenBox MeasurementGlyphs::Parts::freeBox(ScreenBox box, const ViewGeometry& geometry) const {
  const double margin = kMeasurementMargin * geometry.pixelRatio;
  const auto inside = [&](const ScreenBox& wanted) {
    const double right = 2 * geometry.centerX - margin, top = geometry.pixelHeight - margin;
    return moved(wanted, std::max(std::min(0.0, right - wanted.right), margin - wanted.left),
                 std::max(std::min(0.0, top - wanted.top), margin - wanted.bottom));
  };
  box = inside(box);
  for (std::size_t round = 0; round < drawn.size(); ++round)
    for (const Drawn& other : drawn)
      if (box.overlaps(other.box))
        box = moved(box, 0, other.box.top + geometry.pixelRatio - box.bottom);
  return box;
}

void MeasurementGlyphs::Parts::drawBoxes() {
  boxes.begin();
  vtkNew<vtkCellArray> cells;
  for (const auto& [text, box] : drawn)
    boxes.addBox(box.left, box.bottom, box.right, box.top, cells);
  boxes.data->SetPolys(cells);
  boxes.end();
  boxes.actor->GetProperty()->SetColor(theme.panel.x(), theme.panel.y(), theme.panel.z());
  boxes.actor->SetVisibility(!drawn.empty());
}

/// Marks, lines and the room around labels grow with the type.
ViewGeometry MeasurementGlyphs::Parts::seen() const {
  ViewGeometry geometry = viewGeometry(view.renderer());
  geometry.pixelRatio *= theme.typeScale;
  return geometry;
}

void MeasurementGlyphs::Parts::follow() {
  const ViewGeometry geometry = seen();
  for (FacingShapes* shapes : {&cores, &rims})
    shapes->begin(geometry);
  drawn.clear();
  for (std::size_t i = 0; i < items.size(); ++i) {
    const Item& item = items[i];
    const bool seen = shown && isBefore(geometry, item.points);
    const Vec3& color = item.highlighted ? theme.accent : theme.text;
    vtkTextActor* text = texts[i];
    text->SetVisibility(seen && !item.text.empty());
    if (!seen)
      continue;
    addShapes(item, rims, kRim, theme.panel);
    addShapes(item, cores, 0, color);
    if (item.text.empty())
      continue;
    text->GetTextProperty()->SetColor(color.x(), color.y(), color.z());
    setTextSize(text, kMeasurementFontSize, theme);
    const ScreenBox box = freeBox(labelBox(item, geometry, text), geometry);
    const double padding = kPadding * geometry.pixelRatio;
    text->SetPosition(box.left + padding, box.bottom + padding);
    drawn.push_back({item.text, box});
  }
  for (FacingShapes* shapes : {&cores, &rims})
    shapes->end();
  for (const auto& actor : actors)
    actor->SetVisibility(shown && !items.empty());
  drawBoxes();
  drawAfterOrgans();
}

MeasurementGlyphs::MeasurementGlyphs(OrganView& view) : parts_(std::make_unique<Parts>(view)) {
  parts_->build();
  setTheme(view.theme());
}

MeasurementGlyphs::~MeasurementGlyphs() {
  setItems({});
  auto& p = *parts_;
  for (const auto& actor : p.actors)
    p.view.renderer()->RemoveActor(actor);
  p.view.renderer()->RemoveActor2D(p.boxes.actor);
}

void MeasurementGlyphs::setItems(std::vector<Item> items) {
  auto& p = *parts_;
  p.items = std::move(items);
  while (p.texts.size() > p.items.size()) {
    p.view.renderer()->RemoveActor2D(p.texts.back());
    p.texts.pop_back();
  }
  while (p.texts.size() < p.items.size()) {
    p.texts.push_back(newText(kMeasurementFontSize));
    p.view.renderer()->AddActor2D(p.texts.back());
  }
  for (std::size_t i = 0; i < p.items.size(); ++i)
    p.texts[i]->SetInput(p.items[i].text.c_str());
}

const std::vector<MeasurementGlyphs::Item>& MeasurementGlyphs::items() const {
  return parts_->items;
}

void MeasurementGlyphs::setTheme(const Theme& theme) {
  parts_->theme = theme;
}

void MeasurementGlyphs::setShown(bool shown) {
  parts_->shown = shown;
}

bool MeasurementGlyphs::shown() const {
  return parts_->shown;
}

std::optional<MeasurementGlyphs::Mark> MeasurementGlyphs::markAt(double x, double y) const {
  const auto& p = *parts_;
  if (!p.shown)
    return std::nullopt;
  const ViewGeometry geometry = p.seen();
  double nearest = kMouseReach * geometry.pixelRatio;
  std::optional<Mark> found;
  for (std::size_t i = 0; i < p.items.size(); ++i)
    for (std::size_t k = 0; k < p.items[i].points.size() && !p.items[i].path; ++k) {
      const DisplayPoint at = geometry.project(p.items[i].points[k]);
      const double away = std::hypot(at.x - x, at.y - y);
      if (!(at.depth > 0) || !(away <= nearest))
        continue;
      nearest = away;
      found = Mark{i, k};
    }
  return found;
}

std::vector<MeasurementGlyphs::Drawn> MeasurementGlyphs::drawn() const {
  return parts_->drawn;
}

} // namespace viscera::scene
