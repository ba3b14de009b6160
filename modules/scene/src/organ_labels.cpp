#include "viscera/scene/organ_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>

#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

#include "viscera/scene/organ_view.h"

#include "before_render.h"
#include "flat_shape.h"
#include "front_grid.h"
#include "view_furniture.h"
#include "view_geometry.h"

namespace viscera::scene {
namespace {

constexpr int kOrganFontSize = 14; ///< Points at 72 DPI: logical pixels.
/// Logical pixels.
/// A vertex that is looked at stands for that much around it, or for more.
constexpr double kVertexReach = 6;
constexpr double kDot = 3;
constexpr double kLeaderWidth = 1;
constexpr double kLineGap = 4;
constexpr double kInside = 7; ///< How far inside the edge a line ends.
constexpr double kLabelsBottom = 44;
constexpr double kLegend = 120;
constexpr double kLeaderOpacity = 0.75;
/// Organs that let less than this through hide what is behind them.
constexpr double kOpaque = 0.9;
/// Vertices of an organ that are looked at in a frame; more where its parts are named, so that no cell of the
/// front is empty for lack of vertices.
constexpr Eigen::Index kMostVertices = 3000, kMostVerticesForParts = 30'000;
/// So many in each cell of the front that an organ covers, or what it hides would seem to lie between them.
constexpr double kVerticesInCell = 6;
/// An opaque organ of which less than that is in front is hidden: some of its vertices always lie between
/// those of what covers it.
constexpr double kSeenPart = 0.1;
/// Of more organs, those that are seen most are named first.
constexpr std::size_t kFewNames = 12;
/// A vertex covers that part of the distance to its neighbours.
constexpr double kSpacingPart = 0.6;
constexpr int kDotCorners = 12;
/// A part is hidden when something is that much, of the organ's size, nearer to the reader than it is.
constexpr double kHidden = 0.04;
/// In a hollow, whose walls that run along the view are in front of what is beside them, that much.
constexpr double kHiddenInHollow = 0.15;
/// An opaque part that faces away from the reader by more than that (a cosine) is its organ's back.
constexpr double kBack = 0.3;
/// The line of an organ's own label ends where it faces the reader by that much at least, if it has parts.
constexpr double kFacing = 0.25;
/// A cut organ that faces away by more than that would show its inside without its cut face.
constexpr double kHollow = 0.05;
/// How high on an organ the line of a label at the edge starts, as a part of its height.
constexpr double kEdgeHeight = 0.7;

/// What is in front. Where the nearest of the organs that are cut open is the inside of one, or the outside
/// of a hollow one, a cut face hides what is there.
struct Fronts {
  FrontGrid opaque;
  FrontGrid cut;
};

/// One organ on the display.
struct Sighting {
  Footprint covered;
  double x = 0, y = 0; ///< The middle of its vertices.
  double bottom = std::numeric_limits<double>::infinity();
  double top = -std::numeric_limits<double>::infinity();
  std::size_t cells = 0; ///< Of the front that its vertices lie in ...
  std::size_t front = 0; ///< ... and those of them in which it is in front; all where it is translucent.
  bool seen = false;
  /// Of a translucent organ that has a label: its own cells, whatever is before them.
  std::shared_ptr<FrontGrid> own = nullptr;
  bool atPlace = false; ///< The line ends at (x, y), also of an organ that is labelled at its edge.
};

/// How many vertices of an organ are looked at for its size in the view.
Eigen::Index verticesFor(const OrganActor& organ, const ViewGeometry& view) {
  const Bounds box = organ.bounds();
  const double depth = view.project(box.center()).depth;
  if (!(depth > 0))
    return kMostVertices;
  const double across = box.diagonal() / (view.worldPerPixel(depth) * FrontGrid::kCell * view.pixelRatio);
  const double wanted = kVerticesInCell * across * across / 2;
  return static_cast<Eigen::Index>(
      std::clamp(wanted, static_cast<double>(kMostVertices), static_cast<double>(kMostVerticesForParts)));
}

bool isHollow(const OrganActor& organ) {
  return organ.role() == SurfaceRole::hollow;
}

/// How much a vertex faces away from the reader: 1 entirely, -1 looks at him. A hollow is looked at from
/// inside.
double turnedAway(const OrganActor& organ, Eigen::Index vertex, const ViewGeometry& view) {
  const double away = organ.normals().row(vertex).cast<double>().dot(view.forward.transpose());
  return isHollow(organ) ? -away : away;
}

/// How far a point of an organ is from its named parts, of the organ's size; infinite where it has none.
double offParts(const OrganActor& organ, const std::vector<Eigen::Index>& places, Eigen::Index vertex,
                double size) {
  double least = FrontGrid::kNothing;
  for (const Eigen::Index place : places)
    if (place >= 0 && place < organ.points().rows())
      least = std::min(least, (organ.points().row(place) - organ.points().row(vertex)).norm());
  return least / size;
}

/// `item` is the label of the organ as a whole; null for none.
Sighting sight(const OrganActor& organ, const OrganLabels::Item* item, std::size_t owner,
               const ViewGeometry& view, Eigen::Index most, Footprint& all, Fronts& fronts) {
  Sighting sighting{Footprint(view.pixelHeight)};
  if (item && organ.opacity() < kOpaque)
    sighting.own = std::make_shared<FrontGrid>(view);
  const Points& points = organ.points();
  const Eigen::Index stride = std::max<Eigen::Index>(1, points.rows() / most);
  // What lies between the vertices that are looked at is covered, too.
  const Vec3 box = boundsOf(points).high - boundsOf(points).low;
  const double area = 2 * (box.x() * box.y() + box.y() * box.z() + box.z() * box.x());
  const double spacing = std::sqrt(area * static_cast<double>(stride) / static_cast<double>(points.rows()));
  Eigen::Index count = 0;
  std::vector<bool> met(fronts.opaque.cells());
  for (Eigen::Index i = 0; i < points.rows(); i += stride) {
    if (organ.cutsAway(points.row(i).transpose()))
      continue;
    const DisplayPoint place = view.project(points.row(i).transpose());
    if (!(place.depth > 0) || !std::isfinite(place.x) || !std::isfinite(place.y))
      continue;
    const double reach =
        std::max(kVertexReach * view.pixelRatio, kSpacingPart * spacing / view.worldPerPixel(place.depth));
    sighting.covered.cover(place.x, place.y, reach);
    all.cover(place.x, place.y, reach);
    if (const auto cell = fronts.opaque.cellOf(place); cell && !met[*cell]) {
      met[*cell] = true;
      ++sighting.cells;
    }
    FrontGrid::Front front{place.depth, owner};
    front.x = place.x;
    front.y = place.y;
    if (item && !item->places.empty())
      front.offParts =
          turnedAway(organ, i, view) < -kFacing ? offParts(organ, item->places, i, box.norm()) : 0;
    if (organ.opacity() >= kOpaque)
      fronts.opaque.add(place, front);
    if (sighting.own)
      sighting.own->add(place, front);
    if (organ.isCut())
      fronts.cut.add(place, {place.depth, owner, turnedAway(organ, i, view) > kHollow, isHollow(organ)});
    sighting.x += place.x;
    sighting.y += place.y;
    sighting.bottom = std::min(sighting.bottom, place.y);
    sighting.top = std::max(sighting.top, place.y);
    ++count;
  }
  sighting.seen = count > 0;
  sighting.front = sighting.cells;
  sighting.x /= static_cast<double>(std::max<Eigen::Index>(1, count));
  sighting.y /= static_cast<double>(std::max<Eigen::Index>(1, count));
  return sighting;
}

/// A part where its vertex is; nothing while that is cut away, behind something opaque, or outside of the
/// view.
std::optional<Sighting> sightPart(const OrganLabels::Item& item, const Sighting& organ,
                                  const ViewGeometry& view, const Fronts& fronts) {
  const Points& points = item.points ? *item.points : item.organ->points();
  if (item.vertex >= points.rows())
    return std::nullopt;
  const Vec3 at = points.row(item.vertex).transpose();
  const bool back =
      !item.points && item.organ->opacity() >= kOpaque && turnedAway(*item.organ, item.vertex, view) > kBack;
  if (back || item.organ->cutsAway(at))
    return std::nullopt;
  const DisplayPoint place = view.project(at);
  if (isHollow(*item.organ) && !item.inHollow && !fronts.cut.isOpenAt(place))
    return std::nullopt;
  const double slack = (isHollow(*item.organ) ? kHiddenInHollow : kHidden) * item.organ->bounds().diagonal();
  if (!(place.depth > 0) || !(place.x >= 0) || !(place.y >= 0) || place.x > 2 * view.centerX ||
      place.y > view.pixelHeight || place.depth > fronts.opaque.depthAt(place) + slack ||
      (!item.inHollow && fronts.cut.isInsideAt(place)))
    return std::nullopt;
  Sighting part = organ;
  part.x = place.x;
  part.y = place.y;
  return part;
}

/// Whether an opaque organ is behind others, all but a few cells.
bool isCovered(const Sighting& organ) {
  return organ.cells > 0 &&
         static_cast<double>(organ.front) < std::max(1.0, kSeenPart * static_cast<double>(organ.cells));
}

/// Finds where the line of an organ's own label ends: where the organ is seen, and on none of its named
/// parts. Nothing while there is no such place. `before` is where it ended, `others` are all organs that are
/// seen.
std::optional<Sighting> placeWhole(const OrganLabels::Item& item, std::size_t row, Sighting organ,
                                   const Fronts& fronts, const std::optional<ScreenPlace>& before,
                                   const std::map<const OrganActor*, Sighting>& others) {
  const bool solid = !organ.own;
  const FrontGrid& grid = solid ? fronts.opaque : *organ.own;
  const auto isSeen = [&](std::size_t cell) {
    const FrontGrid::Front& front = grid.at(cell);
    if (isHollow(*item.organ) && fronts.cut.at(cell).inside)
      return false;
    return front.any() && front.owner == row && (solid || front.depth < fronts.opaque.at(cell).depth);
  };
  organ.front = 0;
  for (std::size_t cell = 0; cell < grid.cells(); ++cell)
    organ.front += isSeen(cell) ? 1 : 0;
  if (isCovered(organ))
    return std::nullopt;
  // What is in a translucent organ would seem to be meant.
  const auto isClear = [&](std::size_t cell) {
    if (!isSeen(cell) || solid || !item.atEdge)
      return isSeen(cell);
    const FrontGrid::Front& opaque = fronts.opaque.at(cell);
    return !opaque.any() && std::none_of(others.begin(), others.end(), [&](const auto& other) {
      return other.first != item.organ.get() && other.second.own && other.second.own->at(cell).any();
    });
  };
  const auto move = [&](const std::array<double, 2>& to) {
    organ.x = to[0];
    organ.y = to[1];
  };
  const auto cellBefore = before ? grid.cellOf({before->x, before->y, 0}) : std::nullopt;
  if (!item.places.empty()) {
    organ.atPlace = true;
    if (cellBefore && isClear(*cellBefore) && grid.at(*cellBefore).offParts > FrontGrid::kOffParts)
      move({before->x, before->y});
    else if (const auto cell = grid.farthestOffParts(isClear))
      move({grid.at(*cell).x, grid.at(*cell).y});
    else
      return std::nullopt;
  } else if (solid && cellBefore && isSeen(*cellBefore)) {
    move({before->x, before->y});
  } else if (const auto middle = grid.cellOf({organ.x, organ.y, 0}); solid || !middle || !isSeen(*middle)) {
    if (const auto seen = grid.middleWhere(isSeen))
      move(*seen);
  }
  return organ;
}

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
  void checkOrgans(const ViewGeometry& geometry, bool going, Footprint& all,
                   std::vector<std::optional<Sighting>>& sightings) const;
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

/// `going`: the layout goes on, and lines end where they did while that is on their organ.
void OrganLabels::Parts::checkOrgans(const ViewGeometry& geometry, bool going, Footprint& all,
                                     std::vector<std::optional<Sighting>>& sightings) const {
  sightings.assign(items.size(), std::nullopt);
  Fronts fronts{FrontGrid(geometry), FrontGrid(geometry)};
  std::map<const OrganActor*, Sighting> seen;
  const bool parts =
      std::any_of(items.begin(), items.end(), [](const Item& item) { return item.vertex >= 0; });
  for (const auto& organ : view.organs()) {
    if (!organ->met())
      continue;
    const auto named = std::find_if(items.begin(), items.end(),
                                    [&](const Item& item) { return item.organ == organ && item.vertex < 0; });
    const Item* item = named == items.end() ? nullptr : &*named;
    Sighting sighting = sight(*organ, item, static_cast<std::size_t>(named - items.begin()), geometry,
                              parts ? kMostVerticesForParts : verticesFor(*organ, geometry), all, fronts);
    if (sighting.seen)
      seen.emplace(organ.get(), std::move(sighting));
  }
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto organ = seen.find(items[i].organ.get());
    if (organ == seen.end())
      continue;
    if (items[i].vertex >= 0) {
      sightings[i] = sightPart(items[i], organ->second, geometry, fronts);
      continue;
    }
    std::optional<ScreenPlace> before;
    if (going)
      before = layout->targets[i];
    sightings[i] = placeWhole(items[i], i, organ->second, fronts, before, seen);
  }
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

/// Those that are seen, in the order in which they look for a place: as they were given, among many organs
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
  std::vector<std::optional<Sighting>> sightings;
  const bool going = view.moving() && layout && sameView(layout->view, geometry);
  checkOrgans(geometry, going, all, sightings);
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
