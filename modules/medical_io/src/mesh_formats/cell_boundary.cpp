#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <unordered_map>
#include <utility>

#include "mesh_formats/cell_mesh.h"
#include "viscera/core/disjoint_sets.h"
#include "viscera/core/phrase.h"

// The surface around the cells of a volume mesh: every face that belongs to one cell only.
namespace viscera::medical_io {
namespace {

constexpr std::size_t kMostListedRegions = 8;
/// A cavity below this part of the outer volume is a gap of the mesh rather than a part of an organ.
constexpr double kSmallestCavity = 1e-4;

using CornerKey = std::array<std::int32_t, 8>; ///< Sorted; unused places are -1 and come first.

struct CornerKeyHash {
  std::size_t operator()(const CornerKey& key) const {
    std::uint64_t hash = 0;
    for (const std::int32_t corner : key) {
      hash = (hash ^ static_cast<std::uint32_t>(corner)) * 0x9E3779B97F4A7C15ULL;
      hash ^= hash >> 29U;
    }
    return static_cast<std::size_t>(hash);
  }
};

/// One face of one cell, by its sorted corners.
struct FaceUse {
  std::array<std::int32_t, 4> key; ///< -1 first for a triangle.
  std::uint32_t cell;
  std::uint32_t face;

  bool sameFace(const FaceUse& other) const { return key == other.key; }
  friend bool operator<(const FaceUse& a, const FaceUse& b) { return a.key < b.key; }
};

using Polygon = std::vector<std::int32_t>; ///< At most four corners.

class BoundaryFinder {
public:
  BoundaryFinder(CellMesh& mesh, const FileBytes& file) : mesh_(mesh), file_(file) {}

  void run() {
    checkCorners();
    mergeEqualPoints();
    collectFaces();
    takeSingleFaces();
    measureComponents(joinedPolygons());
    countLooseFlatCells();
  }

  const std::vector<Polygon>& polygons() const { return polygons_; }
  /// The component of a polygon.
  std::size_t componentOf(std::size_t polygon) const { return component_[polygon]; }
  /// The volumes of the components, mm^3 if the file is in mm; negative for a cavity.
  const std::vector<double>& volumes() const { return volumes_; }
  std::uint64_t looseFlatCells() const { return looseFlatCells_; }
  std::uint64_t repeatedCells() const { return repeatedCells_; }
  std::uint64_t crowdedFaces() const { return crowdedFaces_; }

  Vec3 point(std::int32_t number) const {
    return Eigen::Map<const Vec3>(mesh_.surface.coordinates.data() + 3 * static_cast<std::size_t>(number));
  }

  /// The cells, each once, cut into tetrahedra from its lowest corner, so that neighbours agree on the
  /// diagonals of the faces between them (Dompierre et al. 1999, "How to subdivide pyramids, prisms and
  /// hexahedra into tetrahedra"). Positive; what a warped cell turns inside out is left out.
  std::vector<std::array<std::int32_t, 4>> tetrahedra() const {
    std::vector<bool> used(mesh_.shapes.size());
    for (const FaceUse& use : faces_)
      used[use.cell] = true;
    std::vector<std::array<std::int32_t, 4>> list;
    for (std::size_t cell = 0; cell < used.size(); ++cell)
      if (used[cell])
        cut(cell, list);
    return list;
  }

private:
  void cut(std::size_t cell, std::vector<std::array<std::int32_t, 4>>& list) const {
    const bool inside = volumeOf(mesh_.shapes[cell], cornersOfCell(cell), mesh_.surface.coordinates) < 0;
    std::int32_t apex = std::numeric_limits<std::int32_t>::max();
    for (const std::int64_t corner : cornersOfCell(cell))
      apex = std::min(apex, same_[static_cast<std::size_t>(corner)]);
    for (std::size_t face = 0; face < facesOf(mesh_.shapes[cell]).size(); ++face) {
      Polygon polygon = faceOf(cell, face);
      if (polygon.size() < 3 || std::find(polygon.begin(), polygon.end(), apex) != polygon.end())
        continue;
      if (inside)
        std::reverse(polygon.begin(), polygon.end());
      std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end()), polygon.end());
      for (std::size_t k = 2; k < polygon.size(); ++k) {
        const Vec3 a = point(polygon[0]), b = point(polygon[k]), c = point(polygon[k - 1]);
        if ((b - a).cross(c - a).dot(point(apex) - a) > 0)
          list.push_back({polygon[0], polygon[k], polygon[k - 1], apex});
      }
    }
  }

  void checkCorners() const {
    const std::size_t count = mesh_.surface.pointCount();
    if (count > std::numeric_limits<std::int32_t>::max() ||
        mesh_.shapes.size() > std::numeric_limits<std::uint32_t>::max())
      file_.fail(phrase("It is too large: %1 points", count), "reduce the mesh first");
    for (const auto* list : {&mesh_.corners, &mesh_.surface.corners})
      for (const std::int64_t corner : *list)
        requirePoint(corner, count);
  }

  void requirePoint(std::int64_t corner, std::size_t count) const {
    if (corner < 0 || static_cast<std::uint64_t>(corner) >= count)
      file_.fail(diagnostic("a cell refers to point %1, but there are %2 (counted from 0)", corner, count));
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (!std::isfinite(mesh_.surface.coordinates[3 * static_cast<std::size_t>(corner) + axis]))
        file_.fail(diagnostic("point %1 has a coordinate that is not a finite number", corner));
  }

  /// Cells of several pieces, and those with points of their own, meet only where points are equal.
  void mergeEqualPoints() {
    const std::size_t count = mesh_.surface.pointCount();
    std::vector<std::int32_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    const double* at = mesh_.surface.coordinates.data();
    const auto place = [at](std::int32_t point) {
      const double* p = at + 3 * static_cast<std::size_t>(point);
      const auto part = [](double value) { return std::isfinite(value) ? value : HUGE_VAL; };
      return std::array<double, 3>{part(p[0]), part(p[1]), part(p[2])};
    };
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
      const auto first = place(a), second = place(b);
      return first != second ? first < second : a < b;
    });
    same_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const bool repeats = i > 0 && place(order[i]) == place(order[i - 1]);
      same_[static_cast<std::size_t>(order[i])] =
          repeats ? same_[static_cast<std::size_t>(order[i - 1])] : order[i];
    }
  }

  std::span<const std::int64_t> cornersOfCell(std::size_t cell) const {
    return std::span(mesh_.corners).subspan(first_[cell], cornerCountOf(mesh_.shapes[cell]));
  }

  /// The corners of a face in their order, each once: cells may be collapsed.
  Polygon faceOf(std::size_t cell, std::size_t face) const {
    const auto corners = cornersOfCell(cell);
    Polygon polygon;
    for (const int local : facesOf(mesh_.shapes[cell])[face])
      if (local >= 0) {
        const std::int32_t corner = same_[static_cast<std::size_t>(corners[static_cast<std::size_t>(local)])];
        if (polygon.empty() || (polygon.back() != corner && polygon.front() != corner))
          polygon.push_back(corner);
      }
    return polygon;
  }

  double volumeBelow(const Polygon& polygon, const Vec3& origin) const {
    std::array<Vec3, 4> points;
    for (std::size_t k = 0; k < polygon.size(); ++k)
      points[k] = point(polygon[k]);
    return sixVolumesBelow(std::span(points).first(polygon.size()), origin) / 6;
  }

  void collectFaces() {
    const std::size_t cells = mesh_.shapes.size();
    first_.resize(cells);
    std::unordered_map<CornerKey, bool, CornerKeyHash> known;
    known.reserve(cells);
    std::size_t at = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
      first_[cell] = at;
      at += cornerCountOf(mesh_.shapes[cell]);
      CornerKey key;
      key.fill(-1);
      std::size_t filled = 0;
      for (const std::int64_t corner : cornersOfCell(cell))
        key[filled++] = same_[static_cast<std::size_t>(corner)];
      std::sort(key.begin(), key.end());
      if (!known.try_emplace(key, true).second) {
        ++repeatedCells_;
        continue;
      }
      addFaces(cell);
    }
    std::sort(faces_.begin(), faces_.end());
  }

  void addFaces(std::size_t cell) {
    for (std::size_t face = 0; face < facesOf(mesh_.shapes[cell]).size(); ++face) {
      const Polygon polygon = faceOf(cell, face);
      if (polygon.size() < 3)
        continue;
      FaceUse use{{-1, -1, -1, -1}, static_cast<std::uint32_t>(cell), static_cast<std::uint32_t>(face)};
      std::copy(polygon.begin(), polygon.end(), use.key.begin());
      std::sort(use.key.begin(), use.key.end());
      faces_.push_back(use);
    }
  }

  void takeSingleFaces() {
    for (std::size_t i = 0; i < faces_.size();) {
      std::size_t end = i + 1;
      while (end < faces_.size() && faces_[end].sameFace(faces_[i]))
        ++end;
      if (end - i > 2)
        ++crowdedFaces_;
      if ((end - i) % 2 == 1) {
        Polygon polygon = faceOf(faces_[i].cell, faces_[i].face);
        const std::size_t cell = faces_[i].cell;
        if (volumeOf(mesh_.shapes[cell], cornersOfCell(cell), mesh_.surface.coordinates) < 0)
          std::reverse(polygon.begin(), polygon.end());
        polygons_.push_back(std::move(polygon));
      }
      i = end;
    }
  }

  /// Polygons that share an edge with one other only are of one component. Where more meet at an edge, as
  /// where a cavity touches the outer surface, each component goes its way unless that would leave it open.
  DisjointSets joinedPolygons() const {
    struct EdgeOfPolygon {
      std::int32_t low, high;
      std::size_t polygon;
      bool operator<(const EdgeOfPolygon& other) const {
        return std::pair(low, high) < std::pair(other.low, other.high);
      }
    };
    DisjointSets sets(polygons_.size());
    std::vector<EdgeOfPolygon> edges;
    for (std::size_t p = 0; p < polygons_.size(); ++p)
      for (std::size_t k = 0; k < polygons_[p].size(); ++k) {
        const auto [low, high] = std::minmax({polygons_[p][k], polygons_[p][(k + 1) % polygons_[p].size()]});
        edges.push_back({low, high, p});
      }
    std::sort(edges.begin(), edges.end());
    const auto forEachSharedEdge = [&](const auto& visit) {
      for (std::size_t i = 0, end = 0; i < edges.size(); i = end) {
        for (end = i + 1; end < edges.size() && !(edges[i] < edges[end]);)
          ++end;
        visit(std::span(edges).subspan(i, end - i));
      }
    };
    forEachSharedEdge([&](std::span<const EdgeOfPolygon> uses) {
      if (uses.size() == 2)
        sets.join(uses[0].polygon, uses[1].polygon);
    });
    forEachSharedEdge([&](std::span<const EdgeOfPolygon> uses) {
      if (uses.size() <= 2)
        return;
      const bool open = std::any_of(uses.begin(), uses.end(), [&](const EdgeOfPolygon& use) {
        return std::count_if(uses.begin(), uses.end(),
                             [&](const EdgeOfPolygon& other) {
                               return sets.root(other.polygon) == sets.root(use.polygon);
                             }) %
                   2 ==
               1;
      });
      for (std::size_t k = 1; open && k < uses.size(); ++k)
        sets.join(uses[0].polygon, uses[k].polygon);
    });
    return sets;
  }

  void measureComponents(DisjointSets sets) {
    std::unordered_map<std::size_t, std::size_t> numbers;
    std::vector<std::size_t> number(polygons_.size());
    for (std::size_t p = 0; p < polygons_.size(); ++p)
      number[p] = numbers.try_emplace(sets.root(p), numbers.size()).first->second;
    component_ = std::move(number);
    volumes_.assign(numbers.size(), 0);
    const Vec3 origin = polygons_.empty() ? Vec3::Zero() : point(polygons_.front().front());
    for (std::size_t p = 0; p < polygons_.size(); ++p)
      volumes_[component_[p]] += volumeBelow(polygons_[p], origin);
  }

  /// Flat cells usually repeat faces of the others, to name a part of the surface.
  void countLooseFlatCells() {
    std::size_t at = 0;
    for (const std::size_t end : mesh_.surface.ends) {
      FaceUse use{{-1, -1, -1, -1}, 0, 0};
      const std::size_t size = end - at;
      for (std::size_t k = 0; k < size && size <= 4; ++k)
        use.key[k] = same_[static_cast<std::size_t>(mesh_.surface.corners[at + k])];
      std::sort(use.key.begin(), use.key.end());
      at = end;
      if (size > 4 || !std::binary_search(faces_.begin(), faces_.end(), use))
        ++looseFlatCells_;
    }
  }

  CellMesh& mesh_;
  const FileBytes& file_;
  std::vector<std::int32_t> same_; ///< For every point the first one at its place.
  std::vector<std::size_t> first_; ///< For every cell where its corners begin.
  std::vector<FaceUse> faces_;     ///< Sorted.
  std::vector<Polygon> polygons_;  ///< The faces of one cell, outward from it.
  std::vector<std::size_t> component_;
  std::vector<double> volumes_;
  std::uint64_t looseFlatCells_ = 0;
  std::uint64_t repeatedCells_ = 0;
  std::uint64_t crowdedFaces_ = 0;
};

void warnOfRegions(CellMesh& mesh) {
  const std::vector<std::int64_t>& numbers = mesh.shapes.empty() ? mesh.flatRegions : mesh.regions;
  const std::set<std::int64_t> regions(numbers.begin(), numbers.end());
  if (regions.size() < 2)
    return;
  std::vector<Text> list;
  for (const std::int64_t region : regions) {
    if (list.size() == kMostListedRegions) {
      list.emplace_back(std::string("..."));
      break;
    }
    const auto name = mesh.regionNames.find(region);
    list.push_back(name == mesh.regionNames.end() ? Text(region) : Text(name->second));
  }
  mesh.surface.warnings.push_back(phrase("its %1 regions (%2) were joined to one surface around all of them",
                                         regions.size(), listOf(std::move(list))));
}

void warnOfCells(CellMesh& mesh, const BoundaryFinder& boundary) {
  auto& warnings = mesh.surface.warnings;
  if (boundary.repeatedCells() > 0)
    warnings.push_back(
        phrase("%n {cell that repeats|cells that repeat} another left out", boundary.repeatedCells()));
  if (boundary.crowdedFaces() > 0)
    warnings.push_back(phrase("%n {face belongs|faces belong} to more than two cells, which overlap",
                              boundary.crowdedFaces()));
  if (boundary.looseFlatCells() > 0)
    warnings.push_back(
        phrase("%n {flat cell that bounds|flat cells that bound} no cell with a volume left out",
               boundary.looseFlatCells()));
}

void warnOfCurvedCells(CellMesh& mesh) {
  if (mesh.curvedCells > 0)
    mesh.surface.warnings.push_back(phrase(
        "%n curved {cell was|cells were} read as straight between {its|their} corners", mesh.curvedCells));
}

/// The polygons of the components that `chosen` takes, with only their points; turned where `turned`.
template <class Chosen>
RawSurface chosenSurface(const BoundaryFinder& boundary, const Chosen& chosen, bool turned) {
  RawSurface raw;
  std::unordered_map<std::int32_t, std::int64_t> places;
  for (std::size_t p = 0; p < boundary.polygons().size(); ++p) {
    if (!chosen(boundary.componentOf(p)))
      continue;
    const std::size_t begin = raw.corners.size();
    for (const std::int32_t corner : boundary.polygons()[p]) {
      const auto [place, isNew] = places.try_emplace(corner, static_cast<std::int64_t>(raw.pointCount()));
      if (isNew) {
        const Vec3 point = boundary.point(corner);
        raw.addPoint(point.x(), point.y(), point.z());
      }
      raw.corners.push_back(place->second);
    }
    if (turned)
      std::reverse(raw.corners.begin() + static_cast<std::ptrdiff_t>(begin), raw.corners.end());
    raw.endPolygon();
  }
  return raw;
}

/// What the file says beside its cells.
void moveHead(RawSurface& from, RawSurface& to) {
  to.name = from.name;
  to.space = from.space;
  to.warnings = std::move(from.warnings);
  to.ignoredCells = from.ignoredCells;
}

} // namespace

RawSurface boundaryOf(CellMesh&& mesh, const FileBytes& file) {
  warnOfRegions(mesh);
  warnOfCurvedCells(mesh);
  if (mesh.shapes.empty())
    return std::move(mesh.surface);
  BoundaryFinder boundary(mesh, file);
  boundary.run();
  warnOfCells(mesh, boundary);
  const auto cavities = std::count_if(boundary.volumes().begin(), boundary.volumes().end(),
                                      [](double volume) { return volume < 0; });
  if (cavities > 0)
    mesh.surface.warnings.push_back(
        phrase("it has %n {cavity|cavities}: its volume is that of the wall around {it|them}", cavities));
  RawSurface raw = chosenSurface(
      boundary, [](std::size_t) { return true; }, false);
  moveHead(mesh.surface, raw);
  return raw;
}

std::vector<RawOrgan> boundaryOrgansOf(CellMesh&& mesh, const FileBytes& file) {
  std::vector<RawOrgan> parts;
  if (mesh.shapes.empty()) {
    parts.push_back({boundaryOf(std::move(mesh), file), {}, 1, -1});
    return parts;
  }
  warnOfRegions(mesh);
  warnOfCurvedCells(mesh);
  BoundaryFinder boundary(mesh, file);
  boundary.run();
  warnOfCells(mesh, boundary);
  const std::vector<double>& volumes = boundary.volumes();
  double outer = 0;
  for (const double volume : volumes)
    outer += std::max(volume, 0.0);
  std::vector<std::size_t> cavities;
  std::size_t gaps = 0;
  for (std::size_t component = 0; component < volumes.size(); ++component) {
    if (volumes[component] < -kSmallestCavity * outer)
      cavities.push_back(component);
    else if (volumes[component] < 0)
      ++gaps;
  }
  if (gaps > 0)
    mesh.surface.warnings.push_back(phrase("%n small {gap|gaps} between its cells filled", gaps));
  parts.push_back({chosenSurface(
                       boundary, [&](std::size_t component) { return !(volumes[component] < 0); }, false),
                   {},
                   1,
                   -1});
  for (std::size_t i = 0; i < cavities.size(); ++i) {
    RawSurface cavity = chosenSurface(
        boundary, [&](std::size_t component) { return component == cavities[i]; }, true);
    cavity.name = cavities.size() == 1 ? "Cavity" : "Cavity " + std::to_string(i + 1);
    cavity.space = mesh.surface.space;
    parts.push_back({std::move(cavity), {}, 1, 0});
  }
  moveHead(mesh.surface, parts.front().surface);
  return parts;
}

std::optional<deformation::WitnessMesh> witnessMeshOf(CellMesh&& mesh, const FileBytes& file) {
  if (mesh.shapes.empty())
    return std::nullopt;
  BoundaryFinder boundary(mesh, file);
  boundary.run();
  const auto tetrahedra = boundary.tetrahedra();
  enum class Place : std::uint8_t { unused, inside, skin };
  std::vector<Place> places(mesh.surface.pointCount(), Place::unused);
  const auto placeOf = [&](std::int32_t number) -> Place& {
    return places[static_cast<std::size_t>(number)];
  };
  for (const auto& corners : tetrahedra)
    for (const std::int32_t corner : corners)
      placeOf(corner) = Place::inside;
  for (const Polygon& polygon : boundary.polygons())
    for (const std::int32_t corner : polygon)
      if (placeOf(corner) == Place::inside)
        placeOf(corner) = Place::skin;
  deformation::WitnessMesh result;
  result.witnesses = std::count(places.begin(), places.end(), Place::inside);
  if (result.witnesses == 0)
    return std::nullopt;
  result.points.resize(result.witnesses + std::count(places.begin(), places.end(), Place::skin), 3);
  std::vector<std::int32_t> rows(places.size(), -1);
  std::int32_t row = 0;
  const double sign = mesh.surface.space == Space::ras ? -1 : 1;
  for (const Place wanted : {Place::inside, Place::skin})
    for (std::size_t number = 0; number < places.size(); ++number)
      if (places[number] == wanted) {
        const Vec3 point = boundary.point(static_cast<std::int32_t>(number));
        result.points.row(row) << sign * point.x(), sign * point.y(), point.z();
        rows[number] = row++;
      }
  result.tetrahedra.resize(static_cast<Eigen::Index>(tetrahedra.size()), 4);
  for (std::size_t t = 0; t < tetrahedra.size(); ++t)
    for (std::size_t k = 0; k < 4; ++k)
      result.tetrahedra(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(k)) =
          rows[static_cast<std::size_t>(tetrahedra[t][k])];
  return result;
}

} // namespace viscera::medical_io
