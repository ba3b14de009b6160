#include "viscera/deformation/place_handles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/normals.h"
#include "viscera/geometry/volume.h"

namespace viscera::deformation {
namespace {

constexpr int kCorners = 8;
constexpr int kLeastOfASurface = 4; ///< Vertices, and triangles: a tetrahedron.

/// Part of the offset that must remain to every part of the surface, and between two handles. A vertex in
/// a groove can be so deep that its handle would come out on the other side.
constexpr double kSurfaceClearance = 0.5;

/// Part of the nearest distance: triangles that share the nearest edge or vertex differ by rounding only.
constexpr double kTie = 1e-9;

struct Triangle {
  Vec3 a, b, c;
};

Triangle triangle(const geometry::TriangleMesh& mesh, Eigen::Index index) {
  const auto corner = [&](int k) -> Vec3 { return mesh.points.row(mesh.triangles(index, k)).transpose(); };
  return {corner(0), corner(1), corner(2)};
}

Vec3 nearestOnSegment(const Vec3& a, const Vec3& b, const Vec3& p) {
  const double length2 = (b - a).squaredNorm();
  const double t = length2 > 0 ? std::clamp((p - a).dot(b - a) / length2, 0.0, 1.0) : 0.0;
  return a + t * (b - a);
}

/// Inside the triangle's prism it is the projection, elsewhere on the nearest edge.
Vec3 nearestOnTriangle(const Triangle& t, const Vec3& normal, const Vec3& p) {
  const double length2 = normal.squaredNorm();
  const bool inside = length2 > 0 && (t.b - t.a).cross(p - t.a).dot(normal) >= 0 &&
                      (t.c - t.b).cross(p - t.b).dot(normal) >= 0 &&
                      (t.a - t.c).cross(p - t.c).dot(normal) >= 0;
  if (inside)
    return p - (p - t.a).dot(normal) / length2 * normal;
  Vec3 nearest = nearestOnSegment(t.a, t.b, p);
  for (const Vec3& other : {nearestOnSegment(t.b, t.c, p), nearestOnSegment(t.c, t.a, p)})
    if ((other - p).squaredNorm() < (nearest - p).squaredNorm())
      nearest = other;
  return nearest;
}

/// Distances of single points from a triangle surface. Immutable; may be asked from several threads.
class SurfaceDistance {
public:
  /// Keeps a reference to `mesh`. O(m).
  explicit SurfaceDistance(const geometry::TriangleMesh& mesh);

  /// Signed distance in mm: positive outside, by the side of the nearest triangle (of several equally near
  /// ones, the one that faces the point most). O(n + m), of which only triangles near the nearest vertex are
  /// looked at closely.
  double operator()(const Vec3& point) const;

private:
  const geometry::TriangleMesh& mesh_;
  double longestEdge_ = 0;
};

SurfaceDistance::SurfaceDistance(const geometry::TriangleMesh& mesh) : mesh_(mesh) {
  double longest2 = 0;
  for (Eigen::Index index = 0; index < mesh.triangles.rows(); ++index) {
    const auto [a, b, c] = triangle(mesh, index);
    longest2 = std::max({longest2, (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  }
  longestEdge_ = std::sqrt(longest2);
}

double SurfaceDistance::operator()(const Vec3& point) const {
  const Values distances2 = (mesh_.points.rowwise() - point.transpose()).rowwise().squaredNorm();
  double nearestCorner2 = std::numeric_limits<double>::infinity();
  for (Eigen::Index index = 0; index < mesh_.triangles.rows(); ++index)
    nearestCorner2 = std::min(nearestCorner2, distances2[mesh_.triangles(index, 0)]);
  // The nearest triangle is no farther than the nearest corner, and its own first corner at most an edge
  // beyond that.
  const double reach = std::sqrt(nearestCorner2) + longestEdge_;
  double nearest = std::numeric_limits<double>::infinity(), facing = 0;
  for (Eigen::Index index = 0; index < mesh_.triangles.rows(); ++index) {
    if (distances2[mesh_.triangles(index, 0)] > reach * reach)
      continue;
    const Triangle t = triangle(mesh_, index);
    const Vec3 normal = (t.b - t.a).cross(t.c - t.a);
    const Vec3 offset = point - nearestOnTriangle(t, normal, point);
    const double distance = offset.norm();
    const double side = offset.dot(normal.stableNormalized());
    if (distance > nearest * (1 + kTie))
      continue;
    const bool tie = distance >= nearest * (1 - kTie);
    if (!tie || std::abs(side) > std::abs(facing))
      facing = side;
    nearest = std::min(nearest, distance);
  }
  return facing < 0 ? -nearest : nearest;
}

/// Chooses vertices one after another, each the farthest from those before.
class FarthestVertices {
public:
  explicit FarthestVertices(const Points& points) : points_(points), usable_(points.rows()) {
    const Eigen::RowVector3d middle = points_.colwise().mean();
    distance2_ = squaredDistances(middle); // The first is the farthest from the middle.
    usable_.setOnes();
  }

  /// The next vertex, or none when all are used up.
  std::optional<Eigen::Index> next() const {
    Eigen::Index farthest = 0;
    (usable_.array() > 0).select(distance2_, -1.0).maxCoeff(&farthest);
    if (usable_[farthest] == 0)
      return std::nullopt;
    return farthest;
  }

  void accept(Eigen::Index vertex) {
    const Values distances2 = squaredDistances(points_.row(vertex));
    distance2_ = first_ ? distances2 : Values(distance2_.cwiseMin(distances2));
    usable_[vertex] = 0;
    first_ = false;
  }

  /// Leaves out the vertices within `radius` of `vertex`.
  void exclude(Eigen::Index vertex, double radius) {
    usable_ = (squaredDistances(points_.row(vertex)).array() <= radius * radius).select(0, usable_);
  }

private:
  Values squaredDistances(const Eigen::RowVector3d& from) const {
    return (points_.rowwise() - from).rowwise().squaredNorm();
  }

  const Points& points_;
  Values distance2_;
  Values usable_; ///< 1 or 0.
  bool first_ = true;
};

double nearestRow(const Points& points, Eigen::Index rows, const Vec3& to) {
  if (rows == 0)
    return std::numeric_limits<double>::infinity();
  return (points.topRows(rows).rowwise() - to.transpose()).rowwise().norm().minCoeff();
}

bool isLargeEnough(const geometry::TriangleMesh& organ) {
  return organ.points.rows() >= kLeastOfASurface && organ.triangles.rows() >= kLeastOfASurface;
}

void requireEnough(const geometry::TriangleMesh& organ, const Placement& placement) {
  if (!isLargeEnough(organ))
    throw DataError(phrase("a surface of %1 vertices and %2 triangles is too small for handles",
                           organ.points.rows(), organ.triangles.rows()),
                    "organ", "load a closed surface");
  const int least = fewestHandles(placement.enclosing);
  if (placement.count < least)
    throw DataError(phrase("%n {handle is|handles are} too few", placement.count), "handles",
                    phrase("ask for at least %1", least));
}

} // namespace

Points enclosingHandles(const Points& organPoints, double margin) {
  const Bounds box = boundsOf(organPoints);
  const double grow = margin * box.diagonal();
  Points corners(kCorners, 3);
  for (int corner = 0; corner < kCorners; ++corner)
    for (int axis = 0; axis < 3; ++axis)
      corners(corner, axis) = corner >> axis & 1 ? box.high[axis] + grow : box.low[axis] - grow;
  return corners;
}

namespace {

/// An organ around which handles are placed, with what its next handle depends on.
struct Site {
  Site(const geometry::TriangleMesh& organ, double offsetFraction)
      : mesh(organ), normals(geometry::vertexNormals(organ)), box(boundsOf(organ.points)),
        offset(offsetFraction * box.diagonal()), distance(organ), vertices(organ.points) {}

  const geometry::TriangleMesh& mesh;
  geometry::Normals normals;
  Bounds box;
  double offset;
  SurfaceDistance distance;
  FarthestVertices vertices;
  int wanted = 0;
};

/// Whether a place is outside of all organs, with some room to each.
bool isFree(const std::vector<Site>& sites, const Vec3& place, double clearance) {
  for (const Site& site : sites) {
    const Vec3 nearest = place.cwiseMax(site.box.low).cwiseMin(site.box.high);
    if ((place - nearest).norm() < clearance && site.distance(place) < clearance)
      return false;
  }
  return true;
}

/// Writes the next handle of a site into `handles`; false where the surface has no room for another one.
bool placeNext(std::vector<Site>& sites, Site& site, Points& handles, Eigen::Index& placed) {
  const double clearance = kSurfaceClearance * site.offset;
  while (const std::optional<Eigen::Index> vertex = site.vertices.next()) {
    const Vec3 outward = site.normals.row(*vertex).cast<double>().transpose();
    const Vec3 handle = site.mesh.points.row(*vertex).transpose() + site.offset * outward;
    if (outward.squaredNorm() > 0 && nearestRow(handles, placed, handle) >= clearance &&
        isFree(sites, handle, clearance)) {
      handles.row(placed++) = handle.transpose();
      site.vertices.accept(*vertex);
      return true;
    }
    site.vertices.exclude(*vertex, clearance);
  }
  return false;
}

/// Shares `count` handles in proportion to the areas: each organ its whole part, what is left to the largest
/// remainders.
void share(std::vector<Site*>& sites, int count) {
  std::vector<double> parts;
  double all = 0;
  for (const Site* site : sites)
    all += parts.emplace_back(geometry::area(site->mesh.points, site->mesh.triangles));
  int left = count;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    parts[i] = all > 0 ? count * parts[i] / all : double(count) / double(sites.size());
    sites[i]->wanted = static_cast<int>(parts[i]);
    parts[i] -= sites[i]->wanted;
    left -= sites[i]->wanted;
  }
  for (; left > 0; --left) {
    const auto most = std::max_element(parts.begin(), parts.end());
    ++sites[static_cast<std::size_t>(most - parts.begin())]->wanted;
    *most = -1;
  }
}

} // namespace

Points placeHandles(const geometry::TriangleMesh& organ, const Placement& placement) {
  return placeHandles(std::vector{&organ}, placement);
}

Points placeHandles(const std::vector<const geometry::TriangleMesh*>& organs, const Placement& placement) {
  std::vector<Site> sites;
  sites.reserve(organs.size());
  for (const geometry::TriangleMesh* organ : organs)
    if (organs.size() == 1 || isLargeEnough(*organ)) {
      requireEnough(*organ, placement);
      sites.emplace_back(*organ, placement.offsetFraction);
    }
  if (sites.empty())
    throw DataError("There is no organ to enclose", "handles", "load a closed surface");
  Points ends(2 * static_cast<Eigen::Index>(sites.size()), 3);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    ends.row(2 * static_cast<Eigen::Index>(i)) = sites[i].box.low.transpose();
    ends.row(2 * static_cast<Eigen::Index>(i) + 1) = sites[i].box.high.transpose();
  }
  Points handles(placement.count, 3);
  Eigen::Index placed = 0;
  if (placement.enclosing) {
    handles.topRows(kCorners) = enclosingHandles(ends, placement.boxMargin);
    placed = kCorners;
  }
  std::vector<Site*> largestFirst;
  for (Site& site : sites)
    largestFirst.push_back(&site);
  std::stable_sort(largestFirst.begin(), largestFirst.end(), [](const Site* a, const Site* b) {
    return geometry::area(a->mesh.points, a->mesh.triangles) >
           geometry::area(b->mesh.points, b->mesh.triangles);
  });
  share(largestFirst, placement.count - static_cast<int>(placed));
  for (Site* site : largestFirst)
    while (site->wanted > 0 && placeNext(sites, *site, handles, placed))
      --site->wanted;
  for (Site* site : largestFirst) // What others had no room for.
    while (placed < handles.rows() && placeNext(sites, *site, handles, placed)) {
    }
  if (placed < handles.rows())
    throw DataError(phrase("the surface has room for %1 of %2 handles", placed, placement.count), "handles",
                    "ask for fewer, or put them nearer to the surface");
  return handles;
}

} // namespace viscera::deformation
