#include "surface_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include "file_bytes.h"
#include "text_scanner.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/geometry/winding_number.h"
#include "viscera/medical_io/organ_names.h"

namespace viscera::medical_io {
namespace {

constexpr std::size_t kOrgansListed = 8;
constexpr std::size_t kLongestListed = 30;
constexpr Eigen::Index kPointsTried = 256;
constexpr double kHalfAround = 0.5;
constexpr std::uint32_t kNoPart = std::numeric_limits<std::uint32_t>::max();

std::size_t beginOf(const RawSurface& raw, std::size_t polygon) {
  return polygon == 0 ? 0 : raw.ends[polygon - 1];
}

/// Shortens for a sentence that fits on a line or two.
std::string shortened(const std::string& name) {
  const std::string printable = printableName(name);
  if (printable.size() <= kLongestListed)
    return printable;
  std::size_t end = kLongestListed;
  while (end > 0 && (static_cast<unsigned char>(printable[end]) & 0xC0U) == 0x80U) // Within a character.
    --end;
  return printable.substr(0, end) + "...";
}

/// The first names of a list.
Text someOf(const std::vector<std::string>& names) {
  std::vector<Text> listed;
  for (std::size_t i = 0; i < std::min(names.size(), kOrgansListed); ++i)
    listed.emplace_back(shortened(names[i]));
  if (names.size() > kOrgansListed)
    listed.push_back(phrase("and %1 more", names.size() - kOrgansListed));
  return listOf(std::move(listed));
}

bool hasParts(const RawSurface& raw) {
  return !raw.parts.empty() && raw.polygonCount() > 0 && raw.partOf.size() == raw.polygonCount();
}

/// An edge of a part, between places.
struct PartEdge {
  std::uint32_t part;
  std::int32_t low, high;
  auto operator<=>(const PartEdge&) const = default;
};

/// Says for each part whether it is open: an edge of it has an odd number of polygons.
std::vector<bool> openParts(const RawSurface& raw, const std::vector<std::int32_t>& places) {
  std::vector<PartEdge> edges;
  edges.reserve(raw.corners.size());
  for (std::size_t polygon = 0; polygon < raw.polygonCount(); ++polygon) {
    const std::size_t begin = beginOf(raw, polygon);
    const std::size_t end = raw.ends[polygon];
    for (std::size_t at = begin; at < end; ++at) {
      const std::int32_t a = places[static_cast<std::size_t>(raw.corners[at])];
      const std::int32_t b = places[static_cast<std::size_t>(raw.corners[at + 1 < end ? at + 1 : begin])];
      if (a != b)
        edges.push_back({raw.partOf[polygon], std::min(a, b), std::max(a, b)});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<bool> open(raw.parts.size(), false);
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t next = i;
    while (next < edges.size() && edges[next] == edges[i])
      ++next;
    if ((next - i) % 2 == 1)
      open[edges[i].part] = true;
    i = next;
  }
  return open;
}

/// Joins parts into organs: a forest in which each part leads to the first one of its organ.
class Joined {
public:
  explicit Joined(std::size_t parts) : first_(parts) {
    std::iota(first_.begin(), first_.end(), std::uint32_t{0});
  }
  std::uint32_t firstOf(std::uint32_t part) {
    while (first_[part] != part)
      part = first_[part] = first_[first_[part]];
    return part;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = firstOf(a);
    b = firstOf(b);
    first_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::uint32_t> first_;
};

/// Whether the polygon has three different corners.
bool isArea(const RawSurface& raw, const std::vector<std::int32_t>& places, std::size_t polygon) {
  std::set<std::int32_t> corners;
  for (std::size_t at = beginOf(raw, polygon); at < raw.ends[polygon] && corners.size() < 3; ++at)
    corners.insert(places[static_cast<std::size_t>(raw.corners[at])]);
  return corners.size() >= 3;
}

/// The parts of which something is seen; all that have polygons, when nothing is seen of any.
std::vector<bool> partsWithArea(const RawSurface& raw, const std::vector<std::int32_t>& places) {
  std::vector<bool> used(raw.parts.size(), false);
  for (std::size_t polygon = 0; polygon < raw.polygonCount(); ++polygon)
    if (!used[raw.partOf[polygon]])
      used[raw.partOf[polygon]] = isArea(raw, places, polygon);
  if (std::none_of(used.begin(), used.end(), [](bool u) { return u; }))
    for (const std::uint32_t part : raw.partOf)
      used[part] = true;
  return used;
}

/// The parts of each organ, in the file's order; parts of which nothing is seen are left out.
std::vector<std::vector<std::uint32_t>> groupedParts(const RawSurface& raw,
                                                     const std::vector<std::int32_t>& places) {
  Joined joined(raw.parts.size());
  const std::vector<bool> used = partsWithArea(raw, places);
  if (!raw.partsAreOrgans) {
    const std::vector<bool> open = openParts(raw, places);
    std::vector<std::uint32_t> owner(places.size(), kNoPart); // Of a place: the first open part there.
    for (std::size_t polygon = 0; polygon < raw.polygonCount(); ++polygon) {
      const std::uint32_t part = raw.partOf[polygon];
      for (std::size_t at = beginOf(raw, polygon); at < raw.ends[polygon] && open[part]; ++at) {
        std::uint32_t& first =
            owner[static_cast<std::size_t>(places[static_cast<std::size_t>(raw.corners[at])])];
        if (first == kNoPart)
          first = part;
        else
          joined.join(first, part);
      }
    }
  }
  std::map<std::uint32_t, std::vector<std::uint32_t>> groups;
  for (std::uint32_t part = 0; part < raw.parts.size(); ++part)
    if (used[part])
      groups[joined.firstOf(part)].push_back(part);
  std::vector<std::vector<std::uint32_t>> list;
  for (auto& [first, members] : groups)
    list.push_back(std::move(members));
  return list;
}

std::vector<std::vector<std::uint32_t>> groupedParts(const RawSurface& raw, const std::string& file) {
  std::vector<std::int32_t> places = usedPoints(raw, file);
  std::vector<std::size_t> firstAt;
  numberPlaces(raw, places, firstAt);
  return groupedParts(raw, places);
}

/// A name that a person gave the parts, or what there is. `alone`: the file has no other organ.
std::string nameOf(const RawSurface& raw, const std::vector<std::uint32_t>& members, bool alone) {
  if (alone && (members.size() > 1 || !raw.name.empty()))
    return raw.name;
  const RawPart& first = raw.parts[members.front()];
  if (members.size() == 1 && saysNothing(first.name) && !saysNothing(first.material))
    return first.material;
  return first.name;
}

std::vector<std::string> namesOf(const RawSurface& raw, const std::vector<std::vector<std::uint32_t>>& groups,
                                 const std::filesystem::path& file) {
  std::vector<std::string> names;
  for (const auto& members : groups)
    names.push_back(printableName(nameOf(raw, members, groups.size() == 1)));
  if (groups.size() == 1 || (raw.partsAreOrgans && std::none_of(names.begin(), names.end(),
                                                                [](const auto& n) { return n.empty(); })))
    return names;
  return uniqueNames(std::move(names), stemOf(file));
}

/// A grey that all parts have is what programs write for a surface without a colour.
bool colorsSayNothing(const RawSurface& raw) {
  const std::optional<Vec3> first = raw.parts.front().color;
  return !raw.partsAreOrgans && (!first || first->minCoeff() == first->maxCoeff()) &&
         std::all_of(raw.parts.begin(), raw.parts.end(),
                     [&](const RawPart& part) { return part.color == first; });
}

/// Copies the polygons of some parts, with the points that they use.
class Extraction {
public:
  explicit Extraction(const RawSurface& raw)
      : raw_(raw), polygons_(raw.parts.size()), place_(raw.pointCount(), kUnusedPoint) {
    for (std::size_t polygon = 0; polygon < raw.polygonCount(); ++polygon)
      polygons_[raw.partOf[polygon]].push_back(polygon);
  }

  RawSurface of(const std::vector<std::uint32_t>& members, bool painted) {
    RawSurface part;
    part.space = raw_.space;
    part.pointsAreShared = raw_.pointsAreShared;
    std::vector<std::size_t> taken;
    hasColors_ = raw_.colors.size() == raw_.coordinates.size() &&
                 std::none_of(members.begin(), members.end(),
                              [&](std::uint32_t member) { return raw_.parts[member].plain; });
    for (const std::uint32_t member : members)
      taken.insert(taken.end(), polygons_[member].begin(), polygons_[member].end());
    std::sort(taken.begin(), taken.end());
    copyPoints(taken, part);
    for (const std::size_t polygon : taken) {
      for (std::size_t at = beginOf(raw_, polygon); at < raw_.ends[polygon]; ++at)
        part.corners.push_back(place_[static_cast<std::size_t>(raw_.corners[at])]);
      part.endPolygon();
      part.polygonsInFile.push_back(polygon);
    }
    if (painted && !hasColors_)
      paint(taken, part);
    for (const std::size_t point : points_)
      place_[point] = kUnusedPoint;
    return part;
  }

private:
  /// Copies in the file's order.
  void copyPoints(const std::vector<std::size_t>& taken, RawSurface& part) {
    points_.clear();
    for (const std::size_t polygon : taken)
      for (std::size_t at = beginOf(raw_, polygon); at < raw_.ends[polygon]; ++at) {
        const auto point = static_cast<std::size_t>(raw_.corners[at]);
        if (std::exchange(place_[point], 0) == kUnusedPoint)
          points_.push_back(point);
      }
    std::sort(points_.begin(), points_.end());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      place_[points_[i]] = static_cast<std::int32_t>(i);
      for (std::size_t k = 3 * points_[i]; k < 3 * points_[i] + 3; ++k) {
        part.coordinates.push_back(raw_.coordinates[k]);
        if (hasColors_)
          part.colors.push_back(raw_.colors[k]);
      }
    }
  }

  /// Gives the points the colours of their parts; where parts meet, the first wins.
  void paint(const std::vector<std::size_t>& taken, RawSurface& part) const {
    part.colors.assign(part.coordinates.size(), 0);
    std::vector<bool> done(part.pointCount(), false);
    for (std::size_t i = 0; i < taken.size(); ++i)
      for (std::size_t at = beginOf(part, i); at < part.ends[i]; ++at) {
        const auto point = static_cast<std::size_t>(part.corners[at]);
        const Vec3 color = *raw_.parts[raw_.partOf[taken[i]]].color;
        for (std::size_t k = 0; k < 3 && !done[point]; ++k)
          part.colors[3 * point + k] = static_cast<std::uint8_t>(
              std::lround(255 * std::clamp(color[static_cast<Eigen::Index>(k)], 0.0, 1.0)));
        done[point] = true;
      }
  }

  const RawSurface& raw_;
  std::vector<std::vector<std::size_t>> polygons_; ///< Of every part.
  std::vector<std::int32_t> place_;                ///< Of a point of the file in the part that is copied.
  std::vector<std::size_t> points_;
  bool hasColors_ = false; ///< The points of the organ that is copied.
};

/// The look of an organ: that of its parts where they agree.
void takeLook(const RawSurface& raw, const std::vector<std::uint32_t>& members, RawOrgan& organ) {
  const RawPart& first = raw.parts[members.front()];
  const auto agree = [&](const auto& of) {
    return std::all_of(members.begin(), members.end(),
                       [&](std::uint32_t m) { return of(raw.parts[m]) == of(first); });
  };
  if (agree([](const RawPart& part) { return part.color; }))
    organ.color = first.color;
  if (agree([](const RawPart& part) { return part.opacity; }))
    organ.opacity = first.opacity;
}

/// Whether the parts have different colours, which points can show.
bool isPainted(const RawSurface& raw, const std::vector<std::uint32_t>& members) {
  const auto color = [&](std::uint32_t m) { return raw.parts[m].color; };
  return std::all_of(members.begin(), members.end(), [&](std::uint32_t m) { return color(m).has_value(); }) &&
         std::any_of(members.begin(), members.end(),
                     [&](std::uint32_t m) { return color(m) != color(members.front()); });
}

/// Cavities by the numbers of organs, which are fewer where parts are empty.
void numberCavities(const RawSurface& raw, const std::vector<std::vector<std::uint32_t>>& groups,
                    std::vector<RawOrgan>& organs) {
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const int outer = raw.parts[groups[i].front()].cavityOf;
    for (std::size_t k = 0; k < i && outer >= 0; ++k)
      if (static_cast<int>(groups[k].front()) == outer)
        organs[i].cavityOf = static_cast<int>(k);
  }
}

/// Says which parts with names of their own are one organ; materials are its paint.
void warnOfJoined(const RawSurface& raw, const std::vector<std::uint32_t>& members,
                  std::vector<Text>& warnings) {
  std::vector<std::string> names;
  for (const std::uint32_t member : members)
    if (const RawPart& part = raw.parts[member]; !saysNothing(part.name) && part.name != part.material)
      names.push_back(part.name);
  if (members.size() > 1 && !names.empty())
    warnings.push_back(phrase("%n {open part|open parts} that share points were joined to one organ: %2",
                              members.size(), someOf(names)));
}

std::size_t unusedPoints(const RawSurface& raw) {
  std::vector<bool> used(raw.pointCount(), false);
  for (const std::int64_t corner : raw.corners)
    used[static_cast<std::size_t>(corner)] = true;
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), false));
}

bool contains(const Bounds& outer, const Bounds& inner) {
  return (inner.low.array() >= outer.low.array()).all() && (inner.high.array() <= outer.high.array()).all();
}

/// Whether points, evenly chosen, are all inside a surface, which is outward or inward.
bool isInside(const Points& points, const geometry::WindingNumber& surface) {
  const Eigen::Index step = std::max<Eigen::Index>(1, points.rows() / kPointsTried);
  for (Eigen::Index i = 0; i < points.rows(); i += step)
    if (std::abs(surface(points.row(i))) <= kHalfAround)
      return false;
  return true;
}

} // namespace

std::vector<RawOrgan> organsOf(RawSurface&& raw, const std::filesystem::path& file) {
  if (!hasParts(raw)) {
    std::vector<RawOrgan> one(1);
    if (raw.parts.size() == 1 && !colorsSayNothing(raw))
      takeLook(raw, {0}, one.front());
    one.front().surface = std::move(raw);
    return one;
  }
  const auto groups = groupedParts(raw, file.string());
  const std::vector<std::string> names = namesOf(raw, groups, file);
  if (colorsSayNothing(raw))
    for (RawPart& part : raw.parts)
      part.color.reset();
  std::vector<RawOrgan> organs(groups.size());
  Extraction extraction(raw);
  for (std::size_t i = 0; i < groups.size(); ++i) {
    organs[i].surface = extraction.of(groups[i], isPainted(raw, groups[i]));
    organs[i].surface.name = names[i];
    takeLook(raw, groups[i], organs[i]);
  }
  for (std::size_t i = 0; i < groups.size(); ++i)
    warnOfJoined(raw, groups[i], organs[i].surface.warnings);
  numberCavities(raw, groups, organs);
  RawSurface& first = organs.front().surface;
  first.warnings.insert(first.warnings.begin(), raw.warnings.begin(), raw.warnings.end());
  first.ignoredCells = raw.ignoredCells;
  std::size_t dropped = raw.polygonCount();
  for (const RawOrgan& organ : organs)
    dropped -= organ.surface.polygonCount();
  if (dropped > 0)
    first.warnings.push_back(phrase("%n {triangle|triangles} with a repeated corner dropped", dropped));
  if (const std::size_t unused = unusedPoints(raw); unused > 0)
    first.warnings.push_back(phrase("%n {point|points} without a triangle dropped", unused));
  return organs;
}

std::vector<std::string> organNames(const RawSurface& raw, const std::filesystem::path& file) {
  if (!hasParts(raw))
    return {raw.name};
  return namesOf(raw, groupedParts(raw, file.string()), file);
}

void requireOneOrgan(const RawSurface& raw, const std::filesystem::path& file) {
  const std::vector<std::string> names = organNames(raw, file);
  if (names.size() > 1)
    throw UsageError(
        phrase("It holds %n {organ|organs}: %2", names.size(), someOf(names)), file.string(),
        phrase("name one of them behind a slash: %1", file.string() + "/" + shortened(names.front())));
}

UsageError noSuchOrgan(const std::string& name, const std::vector<std::string>& names, const Text& where) {
  return UsageError(misuse("It has no organ %1", inQuotes(name)), where, misuse("it has %1", someOf(names)));
}

void warnOfNested(std::vector<SurfacePart>& parts) {
  std::vector<Bounds> boxes;
  for (const SurfacePart& part : parts)
    boxes.push_back(boundsOf(part.surface.mesh.points));
  std::vector<std::size_t> bySize(parts.size()); // The nearest around another is the smallest.
  std::iota(bySize.begin(), bySize.end(), std::size_t{0});
  std::stable_sort(bySize.begin(), bySize.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(parts[a].surface.report.volumeMm3) < std::abs(parts[b].surface.report.volumeMm3);
  });
  std::map<std::size_t, geometry::WindingNumber> windings;
  for (std::size_t i = 0; i < bySize.size(); ++i) {
    SurfacePart& inner = parts[bySize[i]];
    const auto surrounds = [&](std::size_t outer) {
      const SurfaceFile& around = parts[outer].surface;
      if (!around.report.closed() || inner.cavityOf >= 0 || parts[outer].cavityOf >= 0 ||
          !contains(boxes[outer], boxes[bySize[i]]))
        return false;
      const auto winding = windings.try_emplace(outer, around.mesh).first;
      return isInside(inner.surface.mesh.points, winding->second);
    };
    const auto found =
        inner.surface.report.closed()
            ? std::find_if(bySize.begin() + static_cast<std::ptrdiff_t>(i) + 1, bySize.end(), surrounds)
            : bySize.end();
    if (found != bySize.end())
      inner.surface.warnings.push_back(phrase("%1 lies inside %2, whose volume contains its volume",
                                              named(inner.surface.name), named(parts[*found].surface.name)));
  }
}

std::uint32_t PartList::add(RawPart part) {
  parts_.push_back(std::move(part));
  return static_cast<std::uint32_t>(parts_.size() - 1);
}

std::uint32_t PartList::add(std::string name) {
  RawPart part;
  part.name = std::move(name);
  return add(std::move(part));
}

std::uint32_t PartList::named(const std::string& name) {
  const auto [found, isNew] = byName_.try_emplace(name, static_cast<std::uint32_t>(parts_.size()));
  if (isNew)
    add(name);
  return found->second;
}

bool PartList::allPlain() const {
  return std::all_of(parts_.begin(), parts_.end(), [](const RawPart& part) { return part.plain; });
}

void PartList::begin(std::uint32_t part, std::size_t polygons) {
  if (!runs_.empty() && runs_.back().first == polygons)
    runs_.back().part = part;
  else if (runs_.empty() || runs_.back().part != part)
    runs_.push_back({part, polygons});
}

void PartList::moveTo(RawSurface& raw) {
  std::vector<bool> used(parts_.size(), false);
  for (std::size_t i = 0; i < runs_.size(); ++i)
    if (runs_[i].first < (i + 1 < runs_.size() ? runs_[i + 1].first : raw.polygonCount()))
      used[runs_[i].part] = true;
  const auto count = std::count(used.begin(), used.end(), true);
  if (count == 1) {
    raw.parts = {parts_[static_cast<std::size_t>(std::find(used.begin(), used.end(), true) - used.begin())]};
    if (raw.parts.front().plain)
      raw.colors.clear();
  }
  if (count < 2)
    return;
  raw.parts = std::move(parts_);
  raw.partOf.reserve(raw.polygonCount());
  for (std::size_t i = 0; i < runs_.size(); ++i)
    raw.partOf.resize(i + 1 < runs_.size() ? runs_[i + 1].first : raw.polygonCount(), runs_[i].part);
}

} // namespace viscera::medical_io
