#include "viscera/scene/organ_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

#include "viscera/scene/organ_view.h"

#include "before_render.h"
#include "flat_shape.h"
#include "label_sight.h"
#include "view_furniture.h"
#include "view_geometry.h"

namespace viscera::scene {
namespace {

constexpr int kOrganFontSize = 14; ///< Points at 72 DPI: logical pixels.
/// Logical pixels.
constexpr double kDot = 3;
constexpr double kLeaderWidth = 1;
constexpr double kLineGap = 4;
constexpr double kInside = 7; ///< How far inside the edge a line ends.
constexpr double kLabelsBottom = 44;
constexpr double kLegend = 120;
constexpr double kLeaderOpacity = 0.75;
/// The organs that are seen most are named first where there are more.
constexpr std::size_t kFewNames = 12;
constexpr int kDotCorners = 12;
/// How high on an organ the line of a label at the edge starts, as a part of its height.
constexpr double kEdgeHeight = 0.7;

/// The text in two lines of much the same length; as it is, when it is one word.
std::string broken(const std::string& text) {
  const double middle = static_cast<double>(text.size()) / 2;
  std::size_t best = std::string::npos;
  for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at + 1))
    if (best == std::string::npos ||
        std::abs(static_cast<double>(at) - middle) < std::abs(static_cast<double>(best) - middle))
      best = at;
  std::string lines = text;
  if (best != std::string::npos)
    lines[best] = '\n';
  return lines;
}

bool sameView(const ViewGeometry& a, const ViewGeometry& b) {
  return a.eye == b.eye && a.forward == b.forward && a.up == b.up && a.halfHeight == b.halfHeight &&
         a.centerX == b.centerX && a.centerY == b.centerY && a.pixelHeight == b.pixelHeight;
}

} // namespace

/// Where labels are. While something moves before a camera that stands still they stay as long as they fit:
/// each moves for itself, and from all that was covered and named since, so that after a cycle of a motion
/// none moves any more. At rest a picture depends on nothing but what is in it.
struct OrganLabels::Layout {
  ViewGeometry view;
  Footprint swept;                                 ///< Covered since.
  std::vector<std::optional<ScreenBox>> boxes;     ///< One an item; kept for one that is hidden for a moment.
  std::vector<std::optional<ScreenPlace>> targets; ///< In the last frame in which it was seen.
  std::vector<std::optional<ScreenBox>> reaches;   ///< Of all targets since.
  std::vector<bool> leftOut;                       ///< It found no room since.

  Layout(const ViewGeometry& viewIn, const Footprint& covered, std::size_t items)
      : view(viewIn), swept(covered), boxes(items), targets(items), reaches(items), leftOut(items) {}

  void see(std::size_t item, const ScreenPlace& at) {
    const ScreenBox reach = reaches[item].value_or(ScreenBox{at.x, at.y, at.x, at.y});
    reaches[item] = ScreenBox{std::min(reach.left, at.x), std::min(reach.bottom, at.y),
                              std::max(reach.right, at.x), std::max(reach.top, at.y)};
    targets[item] = at;
  }
};

struct OrganLabels::Parts {
  explicit Parts(OrganView& viewIn) : view(viewIn) {}

  OrganView& view;
  std::vector<Item> items;
  std::vector<vtkSmartPointer<vtkTextActor>> texts; ///< One an item.
  FlatShape lines;
  std::vector<Drawn> drawn;
  bool shown = false;
  Theme theme = darkTheme();
  std::optional<Layout> layout;
  BeforeRender beforeRender{[this] { follow(); }};

  void follow();
  void hideAll();
  LabelSpace space(const ViewGeometry& geometry) const;
  bool stillFits(const ViewGeometry& geometry, const std::vector<std::optional<Sighting>>& sightings) const;
  LabelRequest requestFor(std::size_t row, const Sighting& organ, double ratio) const;
  void measure(std::size_t row, LabelRequest& wanted);
  std::vector<std::size_t> rowsByImportance(const std::vector<std::optional<Sighting>>& sightings) const;
  void layOut(const ViewGeometry& geometry, const std::vector<std::optional<Sighting>>& sightings);
  void draw(double ratio, const std::vector<std::optional<Sighting>>& sightings);
  void drawLine(const ScreenBox& box, double x, double y, double ratio, vtkCellArray* segments,
                vtkCellArray* dots);
  void applyTheme();
};

void OrganLabels::Parts::hideAll() {
  for (auto& text : texts)
    text->SetVisibility(false);
  lines.actor->SetVisibility(false);
  drawn.clear();
}

LabelSpace OrganLabels::Parts::space(const ViewGeometry& geometry) const {
  LabelSpace room;
  const double ratio = theme.typeScale * geometry.pixelRatio;
  room.width = 2 * geometry.centerX;
  room.height = geometry.pixelHeight;
  room.margin *= ratio;
  room.gap *= ratio;
  room.between *= ratio;
  const double corner = orientationCorner(view.renderer(), theme.typeScale);
  room.reserved = {{0, 0, room.width, kLabelsBottom * ratio}, {0, 0, corner, corner}};
  const LegendRoom legend = view.legend().room();
  if (legend.above > 0)
    room.reserved.push_back({0, room.height - legend.above, room.width, room.height});
  else if (legend.beside > 0)
    room.reserved.push_back({room.width - kLegend * ratio, 0, room.width, room.height});
  return room;
}

bool OrganLabels::Parts::stillFits(const ViewGeometry& geometry,
                                   const std::vector<std::optional<Sighting>>& sightings) const {
  const double ratio = theme.typeScale * geometry.pixelRatio;
  std::vector<LabelRequest> requests;
  std::vector<std::optional<ScreenBox>> boxes;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto& box = layout->boxes[i];
    if (!sightings[i] || layout->leftOut[i])
      continue;
    if (!box || layout->swept.touches(*box))
      return false;
    requests.push_back(requestFor(i, *sightings[i], ratio));
    boxes.push_back(box);
  }
  return linesAreClear(requests, boxes, space(geometry));
}

/// What the label of a row names, without its size.
LabelRequest OrganLabels::Parts::requestFor(std::size_t row, const Sighting& organ, double ratio) const {
  LabelRequest label{organ.x, organ.y};
  if (items[row].atEdge && !organ.atPlace) {
    label.y = organ.bottom + kEdgeHeight * (organ.top - organ.bottom);
    label.edge = &organ.covered;
    label.inside = (kVertexReach + kInside) * ratio;
  } else {
    label.reach = layout->reaches[row];
  }
  return label;
}

/// What the label of a row takes in one line, as which it is left, and in two.
void OrganLabels::Parts::measure(std::size_t row, LabelRequest& wanted) {
  const auto sizeOf = [&](const std::string& text) {
    std::array<double, 2> size{0, 0};
    texts[row]->SetInput(text.c_str());
    texts[row]->GetSize(view.renderer(), size.data());
    return size;
  };
  if (const std::string two = broken(items[row].text); two != items[row].text) {
    const auto size = sizeOf(two);
    wanted.brokenWidth = size[0];
    wanted.brokenHeight = size[1];
  }
  const auto size = sizeOf(items[row].text);
  wanted.width = size[0];
  wanted.height = size[1];
}

/// Labels that are seen, in the order in which they look for a place: as given, among many organs
/// those first of which most is seen, and parts behind organs.
std::vector<std::size_t>
OrganLabels::Parts::rowsByImportance(const std::vector<std::optional<Sighting>>& sightings) const {
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < items.size(); ++i)
    if (sightings[i] && !layout->leftOut[i])
      rows.push_back(i);
  const auto firstPart =
      std::stable_partition(rows.begin(), rows.end(), [&](std::size_t row) { return items[row].vertex < 0; });
  if (static_cast<std::size_t>(firstPart - rows.begin()) > kFewNames)
    std::stable_sort(rows.begin(), firstPart,
                     [&](std::size_t a, std::size_t b) { return sightings[a]->front > sightings[b]->front; });
  return rows;
}

void OrganLabels::Parts::layOut(const ViewGeometry& geometry,
                                const std::vector<std::optional<Sighting>>& sightings) {
  const double ratio = theme.typeScale * geometry.pixelRatio;
  std::vector<LabelRequest> requests;
  LabelSpace room = space(geometry);
  for (std::size_t i = 0; i < items.size(); ++i)
    if (!sightings[i] && layout->boxes[i])
      room.reserved.push_back(*layout->boxes[i]);
  const std::vector<std::size_t> rows = rowsByImportance(sightings);
  for (const std::size_t row : rows) {
    requests.push_back(requestFor(row, *sightings[row], ratio));
    requests.back().kept = layout->boxes[row];
    measure(row, requests.back());
  }
  const auto placed = placeLabels(requests, layout->swept, room);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    layout->boxes[rows[k]] = placed[k];
    layout->leftOut[rows[k]] = !placed[k];
    if (placed[k] && placed[k]->height() > (requests[k].height + requests[k].brokenHeight) / 2)
      texts[rows[k]]->SetInput(broken(items[rows[k]].text).c_str());
  }
}

void OrganLabels::Parts::drawLine(const ScreenBox& box, double x, double y, double ratio,
                                  vtkCellArray* segments, vtkCellArray* dots) {
  const ScreenPlace start = leaderStart(box, {x, y}, kLineGap * ratio);
  segments->InsertNextCell({lines.add(start.x, start.y), lines.add(x, y)});
  lines.addDisc(x, y, kDot * ratio, kDotCorners, dots);
}

void OrganLabels::Parts::draw(double ratio, const std::vector<std::optional<Sighting>>& sightings) {
  drawn.clear();
  lines.begin();
  vtkNew<vtkCellArray> segments;
  vtkNew<vtkCellArray> dots;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const bool seen = sightings[i] && layout->boxes[i];
    texts[i]->SetVisibility(seen);
    if (!seen)
      continue;
    const ScreenBox& box = *layout->boxes[i];
    const ScreenPlace end = leaderEnd(requestFor(i, *sightings[i], ratio), box);
    texts[i]->SetPosition(box.left, box.bottom);
    drawLine(box, end.x, end.y, ratio, segments, dots);
    drawn.push_back({items[i].text, box, end.x, end.y});
  }
  lines.data->SetLines(segments);
  lines.data->SetPolys(dots);
  lines.end();
  lines.actor->GetProperty()->SetLineWidth(static_cast<float>(kLeaderWidth * ratio));
  lines.actor->SetVisibility(!drawn.empty());
}

void OrganLabels::Parts::follow() {
  if (!shown || items.empty())
    return hideAll();
  const ViewGeometry geometry = viewGeometry(view.renderer());
  Footprint all(geometry.pixelHeight);
  const bool going = view.moving() && layout && sameView(layout->view, geometry);
  // Lines end where they did while that is right.
  const auto sightings =
      sightLabels(view.organs(), items, geometry, going ? layout->targets : decltype(layout->targets)(), all);
  if (going)
    layout->swept.cover(all);
  else
    layout.emplace(geometry, all, items.size());
  for (std::size_t i = 0; i < items.size(); ++i)
    if (sightings[i])
      layout->see(i, {sightings[i]->x, sightings[i]->y});
  if (!going || !stillFits(geometry, sightings))
    layOut(geometry, sightings);
  draw(theme.typeScale * geometry.pixelRatio, sightings);
}

void OrganLabels::Parts::applyTheme() {
  const Vec3& color = theme.text;
  for (auto& text : texts) {
    text->GetTextProperty()->SetColor(color.x(), color.y(), color.z());
    setTextSize(text, kOrganFontSize, theme);
  }
  lines.actor->GetProperty()->SetColor(color.x(), color.y(), color.z());
  lines.actor->GetProperty()->SetOpacity(kLeaderOpacity);
}

OrganLabels::OrganLabels(OrganView& view) : parts_(std::make_unique<Parts>(view)) {
  auto& p = *parts_;
  p.lines.actor->SetVisibility(false);
  view.renderer()->AddActor2D(p.lines.actor);
  p.beforeRender.setRenderer(view.renderer());
  setTheme(view.theme());
}

OrganLabels::~OrganLabels() {
  setItems({});
  parts_->view.renderer()->RemoveActor2D(parts_->lines.actor);
}

void OrganLabels::setItems(std::vector<Item> items) {
  auto& p = *parts_;
  for (auto& text : p.texts)
    p.view.renderer()->RemoveActor2D(text);
  p.texts.clear();
  p.items = std::move(items);
  for (const Item& item : p.items) {
    auto text = newText(kOrganFontSize);
    text->SetInput(item.text.c_str());
    text->SetVisibility(false);
    p.view.renderer()->AddActor2D(text);
    p.texts.push_back(std::move(text));
  }
  p.layout.reset();
  p.hideAll();
  p.applyTheme();
}

void OrganLabels::setTheme(const Theme& theme) {
  if (theme.typeScale != parts_->theme.typeScale)
    parts_->layout.reset();
  parts_->theme = theme;
  parts_->applyTheme();
}

void OrganLabels::setShown(bool shown) {
  parts_->shown = shown;
}

bool OrganLabels::shown() const {
  return parts_->shown;
}

std::vector<OrganLabels::Drawn> OrganLabels::drawn() const {
  return parts_->drawn;
}

} // namespace viscera::scene
