#include "viscera/geometry/editable_surface.h"

#include <algorithm>

namespace viscera::geometry {
namespace {

constexpr double kLeastTurn = 0.5;      // cosine: a collapse may turn a triangle by 60 degrees
constexpr double kFlattestFlip = 0.86;  // cosine of the bend across an edge that may be flipped, 30 degrees
constexpr double kLeastAgreement = 0.3; // cosine between a flipped triangle and the old pair
constexpr double kDegenerate = 1e-12;   // mm^2, rounding of an area of triangles of about 1 mm

int square(int x) {
  return x * x;
}

bool agree(const Vec3& area, const Vec3& normal, double cosine) {
  const double size = area.norm();
  return size > kDegenerate && area.dot(normal) >= cosine * size;
}

} // namespace

EditableSurface::EditableSurface(const TriangleMesh& mesh)
    : points_(at(mesh.points.rows())), triangles_(at(mesh.triangles.rows())), around_(points_.size()),
      triangleCount_(static_cast<int>(mesh.triangles.rows())) {
  for (std::size_t v = 0; v < points_.size(); ++v)
    points_[v] = mesh.points.row(static_cast<Eigen::Index>(v));
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      triangles_[t][at(k)] = mesh.triangles(static_cast<Eigen::Index>(t), k);
      around_[at(triangles_[t][at(k)])].push_back(static_cast<Index>(t));
    }
}

Vec3 EditableSurface::doubleArea(Index triangle) const {
  const auto& [a, b, c] = corners(triangle);
  return (point(b) - point(a)).cross(point(c) - point(a));
}

std::vector<EditableSurface::Edge> EditableSurface::edges() const {
  std::vector<Edge> list;
  list.reserve(at(triangleCount_) * 3 / 2);
  // Both triangles of an edge run through it, in opposite directions: one of them from the lower to the
  // higher index.
  for (const auto& corner : triangles_)
    for (std::size_t k = 0; k < 3; ++k)
      if (corner[k] < corner[(k + 1) % 3])
        list.push_back({corner[k], corner[(k + 1) % 3]});
  return list;
}

EditableSurface::Wings EditableSurface::wings(Index a, Index b) const {
  Wings found;
  for (const Index t : around_[at(a)]) {
    const auto& corner = corners(t);
    if (corner[0] != b && corner[1] != b && corner[2] != b)
      continue;
    if (found.count < 2)
      found.triangle[at(found.count)] = t;
    ++found.count;
  }
  return found;
}

EditableSurface::Index EditableSurface::opposite(Index triangle, Index a, Index b) const {
  const auto& corner = corners(triangle);
  return *std::find_if(corner.begin(), corner.end(), [&](Index v) { return v != a && v != b; });
}

std::vector<EditableSurface::Index> EditableSurface::neighbours(Index vertex) const {
  std::vector<Index> list;
  list.reserve(around_[at(vertex)].size());
  for (const Index t : around_[at(vertex)])
    for (const Index v : corners(t))
      if (v != vertex && std::find(list.begin(), list.end(), v) == list.end())
        list.push_back(v);
  return list;
}

void EditableSurface::detach(Index triangle, Index vertex) {
  auto& list = around_[at(vertex)];
  const auto found = std::find(list.begin(), list.end(), triangle);
  *found = list.back();
  list.pop_back();
}

EditableSurface::Index EditableSurface::split(const Edge& edge) {
  const Wings wing = wings(edge.a, edge.b);
  if (wing.count != 2)
    return -1;
  const auto middle = vertexCount();
  points_.push_back(0.5 * (point(edge.a) + point(edge.b)));
  around_.emplace_back();
  for (const Index t : wing.triangle) {
    const Index tip = opposite(t, edge.a, edge.b);
    const auto added = static_cast<Index>(triangles_.size());
    triangles_.push_back(triangles_[at(t)]);
    std::replace(triangles_[at(t)].begin(), triangles_[at(t)].end(), edge.b, middle);
    std::replace(triangles_.back().begin(), triangles_.back().end(), edge.a, middle);
    detach(t, edge.b);
    around_[at(middle)].push_back(t);
    for (const Index v : {middle, edge.b, tip})
      around_[at(v)].push_back(added);
  }
  triangleCount_ += 2;
  return middle;
}

bool EditableSurface::linkAllowsCollapse(const Edge& edge, const Wings& wing) const {
  const std::vector<Index> ofA = neighbours(edge.a), ofB = neighbours(edge.b);
  const auto shared = std::count_if(
      ofA.begin(), ofA.end(), [&](Index v) { return std::find(ofB.begin(), ofB.end(), v) != ofB.end(); });
  if (shared != 2)
    return false;
  // The tips lose a triangle, the merged vertex keeps the others: none may be left with fewer than three.
  for (const Index t : wing.triangle)
    if (around_[at(opposite(t, edge.a, edge.b))].size() <= 3)
      return false;
  return ofA.size() + ofB.size() >= 7;
}

bool EditableSurface::staysUnfolded(Index moved, const Vec3& to, const Wings& gone) const {
  for (const Index t : around_[at(moved)]) {
    if (t == gone.triangle[0] || t == gone.triangle[1])
      continue;
    const Vec3 before = doubleArea(t);
    std::array<Vec3, 3> corner;
    for (std::size_t k = 0; k < 3; ++k)
      corner[k] = corners(t)[k] == moved ? to : point(corners(t)[k]);
    const Vec3 after = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    if (after.norm() < kDegenerate)
      return false;
    // A triangle that is degenerate already has no direction to keep.
    if (before.norm() > kDegenerate && !agree(after, before.normalized(), kLeastTurn))
      return false;
  }
  return true;
}

bool EditableSurface::spokesFit(const Edge& edge, const Vec3& place, double longest) const {
  for (const Index end : {edge.a, edge.b})
    for (const Index t : around_[at(end)])
      for (const Index v : corners(t))
        if (v != edge.a && v != edge.b && (point(v) - place).squaredNorm() > longest * longest)
          return false;
  return true;
}

bool EditableSurface::collapse(const Edge& edge, double longest) {
  if (!exists(edge.a) || !exists(edge.b))
    return false;
  const Wings wing = wings(edge.a, edge.b);
  if (wing.count != 2 || !linkAllowsCollapse(edge, wing))
    return false;
  // The middle folds over a sharp rim what an end of the edge does not.
  const std::array<Vec3, 3> places = {0.5 * (point(edge.a) + point(edge.b)), point(edge.a), point(edge.b)};
  const auto fits = [&](const Vec3& place) {
    return spokesFit(edge, place, longest) && staysUnfolded(edge.a, place, wing) &&
           staysUnfolded(edge.b, place, wing);
  };
  const auto place = std::find_if(places.begin(), places.end(), fits);
  if (place == places.end())
    return false;
  merge(edge, wing, *place);
  return true;
}

bool EditableSurface::collapseTo(const Edge& edge, const Vec3& place) {
  if (!exists(edge.a) || !exists(edge.b))
    return false;
  const Wings wing = wings(edge.a, edge.b);
  if (wing.count != 2 || !linkAllowsCollapse(edge, wing) || !staysUnfolded(edge.a, place, wing) ||
      !staysUnfolded(edge.b, place, wing))
    return false;
  merge(edge, wing, place);
  return true;
}

void EditableSurface::merge(const Edge& edge, const Wings& wing, const Vec3& place) {
  points_[at(edge.a)] = place;
  for (const Index t : wing.triangle) {
    for (const Index v : corners(t))
      detach(t, v);
    triangles_[at(t)] = {-1, -1, -1};
  }
  for (const Index t : around_[at(edge.b)]) {
    std::replace(triangles_[at(t)].begin(), triangles_[at(t)].end(), edge.b, edge.a);
    around_[at(edge.a)].push_back(t);
  }
  around_[at(edge.b)].clear();
  triangleCount_ -= 2;
}

bool EditableSurface::flip(const Edge& edge) {
  const Wings wing = wings(edge.a, edge.b);
  if (wing.count != 2)
    return false;
  const auto [t0, t1] = wing.triangle;
  const Index c = opposite(t0, edge.a, edge.b), d = opposite(t1, edge.a, edge.b);
  if (c == d || wings(c, d).count != 0)
    return false;
  const auto valence = [&](Index v) { return static_cast<int>(around_[at(v)].size()); };
  if (valence(edge.a) <= 3 || valence(edge.b) <= 3)
    return false;
  const auto excess = [&](int ofEdge, int ofTips) {
    return square(valence(edge.a) + ofEdge - 6) + square(valence(edge.b) + ofEdge - 6) +
           square(valence(c) + ofTips - 6) + square(valence(d) + ofTips - 6);
  };
  if (excess(-1, 1) >= excess(0, 0))
    return false;

  const Vec3 n0 = doubleArea(t0).normalized(), n1 = doubleArea(t1).normalized();
  if (n0.dot(n1) < kFlattestFlip)
    return false;
  // t0 runs from one end of the edge to the other; name the ends in its direction.
  const auto& corner = corners(t0);
  const auto here = std::find(corner.begin(), corner.end(), edge.a) - corner.begin();
  const bool forward = corner[at((here + 1) % 3)] == edge.b;
  const Index a = forward ? edge.a : edge.b, b = forward ? edge.b : edge.a;
  const Vec3 mean = (n0 + n1).normalized();
  const Vec3 first = (point(d) - point(a)).cross(point(c) - point(a));
  const Vec3 second = (point(c) - point(b)).cross(point(d) - point(b));
  if (!agree(first, mean, kLeastAgreement) || !agree(second, mean, kLeastAgreement))
    return false;

  triangles_[at(t0)] = {a, d, c};
  triangles_[at(t1)] = {b, c, d};
  detach(t0, b);
  detach(t1, a);
  around_[at(d)].push_back(t0);
  around_[at(c)].push_back(t1);
  return true;
}

std::vector<EditableSurface::Index> EditableSurface::vertices() const {
  std::vector<Index> list;
  for (Index v = 0; v < vertexCount(); ++v)
    if (exists(v))
      list.push_back(v);
  return list;
}

TriangleMesh EditableSurface::mesh() const {
  TriangleMesh mesh;
  const std::vector<Index> kept = vertices();
  std::vector<Index> renamed(points_.size(), -1);
  mesh.points.resize(static_cast<Eigen::Index>(kept.size()), 3);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    renamed[at(kept[i])] = static_cast<Index>(i);
    mesh.points.row(static_cast<Eigen::Index>(i)) = point(kept[i]);
  }
  mesh.triangles.resize(triangleCount_, 3);
  Eigen::Index row = 0;
  for (const auto& corner : triangles_) {
    if (corner[0] < 0)
      continue;
    for (std::size_t k = 0; k < 3; ++k)
      mesh.triangles(row, static_cast<Eigen::Index>(k)) = renamed[at(corner[k])];
    ++row;
  }
  return mesh;
}

} // namespace viscera::geometry
