#include "label_sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "seen_places.h"

namespace viscera::scene {
namespace {

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
/// A vertex covers that part of the distance to its neighbours.
constexpr double kSpacingPart = 0.6;
/// A part is hidden when something is that much, of the organ's size, nearer to the reader than it is.
constexpr double kHidden = 0.04;
/// The same for what is in a hollow, whose walls run along the view in front of it.
constexpr double kHiddenInHollow = 0.07;
/// A hollow is named where the wall that is drawn is that near to it: it may have a lining, and behind a
/// valve or a vessel's mouth is something else.
constexpr double kOnWallMm = 4;
/// All around the end of a line, that far, is what it names; logical pixels.
constexpr double kAround = 2;
/// What lies in the muscle is in the face of a cut while it is that near to it.
constexpr double kInFaceMm = 4;
/// An opaque part that faces away from the reader by more than that (a cosine) is its organ's back.
constexpr double kBack = 0.3;
/// The line of an organ's own label ends where it faces the reader by that much at least, if it has parts.
constexpr double kFacing = 0.25;
/// A cut organ that faces away by more than that would show its inside without its cut face.
constexpr double kHollow = 0.05;

using Item = OrganLabels::Item;
using Lies = OrganLabels::Lies;

/// What is in front. Where the nearest of the organs that are cut open is the inside of one, or the outside
/// of a hollow one, a cut face hides what is there.
struct Fronts {
  FrontGrid opaque;
  FrontGrid cut;
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
double offParts(const OrganActor& organ, const std::vector<Eigen::Index>& places, const Vec3& point,
                double size) {
  double least = FrontGrid::kNothing;
  for (const Eigen::Index place : places)
    if (place >= 0 && place < organ.points().rows())
      least = std::min(least, (organ.points().row(place).transpose() - point).norm());
  return least / size;
}

/// `item` is the label of the organ as a whole; null for none.
Sighting sight(const OrganActor& organ, const Item* item, std::size_t owner, const ViewGeometry& view,
               Eigen::Index most, Footprint& all, Fronts& fronts) {
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
      front.offParts = turnedAway(organ, i, view) < -kFacing
                           ? offParts(organ, item->places, points.row(i).transpose(), box.norm())
                           : 0;
    if (organ.opacity() >= kOpaque)
      fronts.opaque.add(place, front);
    if (sighting.own)
      sighting.own->add(place, front);
    if (organ.isCut())
      fronts.cut.add(place, {place.depth, owner, turnedAway(organ, i, view) > kHollow});
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

/// A part where its vertex is; nothing while that is cut away, on the far side, or outside of the view.
std::optional<Sighting> sightPart(const Item& item, const Sighting& organ, const ViewGeometry& view) {
  const Points& points = item.points ? *item.points : item.organ->points();
  if (item.vertex >= points.rows())
    return std::nullopt;
  const Vec3 at = points.row(item.vertex).transpose();
  const bool back = !item.points && item.organ->opacity() >= kOpaque && !isHollow(*item.organ) &&
                    turnedAway(*item.organ, item.vertex, view) > kBack;
  if (back || item.organ->cutsAway(at))
    return std::nullopt;
  const DisplayPoint place = view.project(at);
  if (!(place.depth > 0) || !(place.x >= 0) || !(place.y >= 0) || place.x > 2 * view.centerX ||
      place.y > view.pixelHeight)
    return std::nullopt;
  Sighting part = organ;
  part.x = place.x;
  part.y = place.y;
  part.depth = place.depth;
  return part;
}

/// Whether a part is behind something opaque, or behind a cut face.
bool isHidden(const Item& item, const Sighting& part, const Fronts& fronts) {
  const DisplayPoint place{part.x, part.y, part.depth};
  return part.depth > fronts.opaque.depthAt(place) + kHidden * item.organ->bounds().diagonal() ||
         (item.lies == Lies::onSurface && fronts.cut.isInsideAt(place));
}

/// Whether an opaque organ is behind others, all but a few cells.
bool isCovered(const Sighting& organ) {
  return organ.cells > 0 &&
         static_cast<double>(organ.front) < std::max(1.0, kSeenPart * static_cast<double>(organ.cells));
}

/// Finds where the line of an organ's own label ends: where the organ is seen, and on none of its named
/// parts. Nothing while there is no such place. `before` is where it ended, `others` are all organs that are
/// seen.
std::optional<Sighting> placeWhole(const Item& item, std::size_t row, Sighting organ, const Fronts& fronts,
                                   const std::optional<ScreenPlace>& before,
                                   const std::map<const OrganActor*, Sighting>& others) {
  const bool solid = !organ.own;
  const FrontGrid& grid = solid ? fronts.opaque : *organ.own;
  const auto isSeen = [&](std::size_t cell) {
    const FrontGrid::Front& front = grid.at(cell);
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

/// Mends where lines end by what is drawn there, triangle by triangle.
class DrawnCheck {
public:
  DrawnCheck(const std::vector<std::shared_ptr<OrganActor>>& organs, const ViewGeometry& view,
             const FrontGrid& grid, const std::vector<std::optional<Sighting>>& sightings)
      : view_(view), grid_(grid), walls_(view, placesOf(grid, kAround * view.pixelRatio, sightings)),
        hollows_(walls_) {
    for (const auto& organ : organs) {
      if (organ->drawn() && organ->opacity() >= kOpaque && organ->role() != SurfaceRole::filling)
        walls_.look(*organ);
      if (organ->met() && isHollow(*organ))
        hollows_.look(*organ);
    }
  }

  /// `kept`: the line ends where it did before.
  void mend(const Item& item, std::size_t row, bool kept, std::optional<Sighting>& sighting) const {
    const std::size_t place = grid_.cells() + kPlacesOfOne * row;
    if (item.vertex >= 0) {
      if (!showsPart(item, *sighting, place))
        sighting.reset();
      return;
    }
    const bool hollow = isHollow(*item.organ);
    if (sighting->own || ((kept || !hollow) && isRightAround(item, place)))
      return;
    if (const auto to = bestCell(item, hollow ? std::nullopt : std::optional(walls_.placeOf(place)))) {
      sighting->x = walls_.placeOf(*to).x;
      sighting->y = walls_.placeOf(*to).y;
    } else {
      sighting.reset();
    }
  }

private:
  /// Where a line ends, and around it.
  static constexpr std::size_t kPlacesOfOne = 5;

  /// The middles of the grid's cells, and behind them the places of all sightings.
  static std::vector<ScreenPlace> placesOf(const FrontGrid& grid, double around,
                                           const std::vector<std::optional<Sighting>>& sightings) {
    std::vector<ScreenPlace> places;
    for (std::size_t cell = 0; cell < grid.cells(); ++cell)
      places.push_back({grid.centerOf(cell)[0], grid.centerOf(cell)[1]});
    for (const auto& sighting : sightings) {
      const ScreenPlace at = sighting ? ScreenPlace{sighting->x, sighting->y} : ScreenPlace{0, 0};
      for (const auto& [x, y] : {std::pair(0, 0), {-1, 0}, {1, 0}, {0, -1}, {0, 1}})
        places.push_back({at.x + around * x, at.y + around * y});
    }
    return places;
  }

  bool showsPart(const Item& item, const Sighting& part, std::size_t place) const {
    const SeenPlaces::Seen& wall = walls_.at(place);
    if (item.lies == Lies::inFace)
      return wall.isFace() && part.depth <= wall.depth + kInFaceMm;
    if (wall.isFace())
      return false;
    const double slack =
        (isHollow(*item.organ) ? kHiddenInHollow : kHidden) * item.organ->bounds().diagonal();
    return part.depth <= wall.depth + slack;
  }

  /// The hollow into which one looks at a place and sees its wall; null for none.
  const OrganActor* openAt(std::size_t place) const {
    const SeenPlaces::Seen &wall = walls_.at(place), &hollow = hollows_.at(place);
    const bool open = wall.organ && !wall.isFace() && hollow.organ && hollow.inside &&
                      std::abs(wall.depth - hollow.depth) < kOnWallMm;
    return open ? hollow.organ : nullptr;
  }

  /// Whether a place shows an opaque organ, away from its named parts.
  bool isRight(const Item& item, std::size_t place) const {
    const SeenPlaces::Seen& wall = walls_.at(place);
    if (isHollow(*item.organ)) {
      if (openAt(place) != item.organ.get())
        return false;
    } else if (!wall.organ ||
               (item.organ->drawn() ? wall.organ != item.organ.get() : openAt(place) != nullptr)) {
      return false;
    }
    const ScreenPlace& at = walls_.placeOf(place);
    return offParts(*item.organ, item.places, view_.unproject(at.x, at.y, wall.depth),
                    item.organ->bounds().diagonal()) > FrontGrid::kOffParts;
  }

  bool isRightAround(const Item& item, std::size_t place) const {
    for (std::size_t k = 0; k < kPlacesOfOne; ++k)
      if (!isRight(item, place + k))
        return false;
    return true;
  }

  /// The right cell that is nearest to a place, or to their middle: one with such neighbours, so
  /// that it stays right for a while, where there are any.
  std::optional<std::size_t> bestCell(const Item& item, std::optional<ScreenPlace> to) const {
    std::vector<bool> right(grid_.cells());
    for (std::size_t cell = 0; cell < grid_.cells(); ++cell)
      right[cell] = isRight(item, cell);
    std::vector<std::size_t> all, roomy;
    for (std::size_t cell = 0; cell < grid_.cells(); ++cell) {
      if (!right[cell])
        continue;
      all.push_back(cell);
      const auto beside = grid_.beside(cell);
      if (std::all_of(beside.begin(), beside.end(), [&](const auto& next) { return next && right[*next]; }))
        roomy.push_back(cell);
    }
    return nearestOf(roomy.empty() ? all : roomy, to);
  }

  std::optional<std::size_t> nearestOf(const std::vector<std::size_t>& cells,
                                       std::optional<ScreenPlace> to) const {
    if (cells.empty())
      return std::nullopt;
    if (!to) {
      to = ScreenPlace{0, 0};
      for (const std::size_t cell : cells) {
        to->x += walls_.placeOf(cell).x / static_cast<double>(cells.size());
        to->y += walls_.placeOf(cell).y / static_cast<double>(cells.size());
      }
    }
    const auto away = [&](std::size_t cell) {
      return std::hypot(walls_.placeOf(cell).x - to->x, walls_.placeOf(cell).y - to->y);
    };
    return *std::min_element(cells.begin(), cells.end(),
                             [&](std::size_t a, std::size_t b) { return away(a) < away(b); });
  }

  const ViewGeometry& view_;
  const FrontGrid& grid_;
  SeenPlaces walls_;   ///< What is opaque and drawn.
  SeenPlaces hollows_; ///< What is empty, and not drawn.
};

/// Looks at all organs; returns those that are in the view.
std::map<const OrganActor*, Sighting> sightOrgans(const std::vector<std::shared_ptr<OrganActor>>& organs,
                                                  const std::vector<Item>& items, bool parts,
                                                  const ViewGeometry& view, Footprint& all, Fronts& fronts) {
  std::map<const OrganActor*, Sighting> seen;
  for (const auto& organ : organs) {
    if (!organ->met())
      continue;
    const auto named = std::find_if(items.begin(), items.end(),
                                    [&](const Item& item) { return item.organ == organ && item.vertex < 0; });
    const Item* item = named == items.end() ? nullptr : &*named;
    Sighting sighting = sight(*organ, item, static_cast<std::size_t>(named - items.begin()), view,
                              parts ? kMostVerticesForParts : verticesFor(*organ, view), all, fronts);
    if (sighting.seen)
      seen.emplace(organ.get(), std::move(sighting));
  }
  return seen;
}

/// A hollow where its line ended before, or anywhere: the check finds the place.
Sighting placeHollow(Sighting hollow, const std::optional<ScreenPlace>& before) {
  hollow.atPlace = true;
  if (before) {
    hollow.x = before->x;
    hollow.y = before->y;
  }
  return hollow;
}

} // namespace

std::vector<std::optional<Sighting>> sightLabels(const std::vector<std::shared_ptr<OrganActor>>& organs,
                                                 const std::vector<Item>& items, const ViewGeometry& view,
                                                 const std::vector<std::optional<ScreenPlace>>& before,
                                                 Footprint& all) {
  Fronts fronts{FrontGrid(view), FrontGrid(view)};
  const bool parts =
      std::any_of(items.begin(), items.end(), [](const Item& item) { return item.vertex >= 0; });
  const auto seen = sightOrgans(organs, items, parts, view, all, fronts);
  const bool opened = std::any_of(seen.begin(), seen.end(), [](const auto& s) { return isHollow(*s.first); });
  const auto endedAt = [&](std::size_t row) { return before.empty() ? std::nullopt : before[row]; };
  std::vector<std::optional<Sighting>> sightings(items.size());
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto organ = seen.find(items[i].organ.get());
    if (organ == seen.end())
      continue;
    if (items[i].vertex >= 0) {
      sightings[i] = sightPart(items[i], organ->second, view);
      if (!opened && sightings[i] && isHidden(items[i], *sightings[i], fronts))
        sightings[i].reset();
    } else if (isHollow(*items[i].organ)) {
      sightings[i] = placeHollow(organ->second, endedAt(i));
    } else {
      sightings[i] = placeWhole(items[i], i, organ->second, fronts, endedAt(i), seen);
    }
  }
  if (!parts && !opened)
    return sightings;
  const DrawnCheck check(organs, view, fronts.opaque, sightings);
  for (std::size_t i = 0; i < items.size(); ++i)
    if (sightings[i])
      check.mend(items[i], i, endedAt(i).has_value(), sightings[i]);
  return sightings;
}

} // namespace viscera::scene
