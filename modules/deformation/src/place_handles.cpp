#include "viscera/deformation/place_handles.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "surface_distance.h"
#include "viscera/core/error.h"
#include "viscera/geometry/normals.h"

namespace viscera::deformation {
namespace {

constexpr int kCorners = 8;
constexpr int kLeastWithoutBox = 4;

/// Of the wanted offset: what must remain to every part of the surface, and between two handles. A vertex in
/// a groove can be so deep that its handle would come out on the other side.
constexpr double kClearance = 0.5;

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

void requireEnough(const geometry::TriangleMesh& organ, const Placement& placement) {
  if (organ.points.rows() < kLeastWithoutBox || organ.triangles.rows() < kLeastWithoutBox)
    throw DataError("a surface of " + std::to_string(organ.points.rows()) + " vertices and " +
                        std::to_string(organ.triangles.rows()) + " triangles is too small for handles",
                    "organ", "load a closed surface");
  const int least = placement.enclosing ? kCorners : kLeastWithoutBox;
  if (placement.count < least)
    throw DataError(std::to_string(placement.count) + " handles are too few", "handles",
                    "ask for at least " + std::to_string(least));
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

Points placeHandles(const geometry::TriangleMesh& organ, const Placement& placement) {
  requireEnough(organ, placement);
  const double offset = placement.offsetFraction * boundsOf(organ.points).diagonal();
  const geometry::Normals normals = geometry::vertexNormals(organ);
  const SurfaceDistance distance(organ);
  FarthestVertices vertices(organ.points);

  Points handles(placement.count, 3);
  Eigen::Index placed = 0;
  if (placement.enclosing) {
    handles.topRows(kCorners) = enclosingHandles(organ.points, placement.boxMargin);
    placed = kCorners;
  }
  while (placed < handles.rows()) {
    const std::optional<Eigen::Index> vertex = vertices.next();
    if (!vertex)
      throw DataError("the surface has room for " + std::to_string(placed) + " of " +
                          std::to_string(placement.count) + " handles",
                      "handles", "ask for fewer, or put them nearer to the surface");
    const Vec3 outward = normals.row(*vertex).cast<double>().transpose();
    const Vec3 handle = organ.points.row(*vertex).transpose() + offset * outward;
    if (outward.squaredNorm() > 0 && nearestRow(handles, placed, handle) >= kClearance * offset &&
        distance(handle) >= kClearance * offset) {
      handles.row(placed++) = handle.transpose();
      vertices.accept(*vertex);
    } else {
      vertices.exclude(*vertex, kClearance * offset);
    }
  }
  return handles;
}

} // namespace viscera::deformation
