#include "viscera/deformation/group_handles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::deformation {
namespace {

/// A part's hull must clear its vertices by this part of its size: coordinates at the very boundary are
/// limits.
constexpr double kLimitClearance = 0.01;
constexpr double kBoxMargin = 0.08;
/// How far a part's face may move to find a gap between handles, and how far behind a handle it is then, as
/// parts of the part's length.
constexpr double kFaceWindow = 0.2;
constexpr double kBehindHandle = 0.02;
/// The column of the longest axis.
constexpr Eigen::Index kAlong = 2;
constexpr double kInfinity = std::numeric_limits<double>::infinity();
/// A point up to this much farther from a second centre than from its nearest belongs to both.
constexpr double kShared = 1.25;
/// A handle this little outside another group's hull joins that group, of the organ's diagonal.
constexpr double kRoom = 0.01;
constexpr int kMeansRounds = 20;
constexpr Eigen::Index kClusteredPoints = 4000;

void requireInput(const Points& organPoints, int count) {
  if (count < 1)
    throw UsageError(misuse("the number of groups must be at least 1, not %1", count));
  if (organPoints.rows() == 0)
    throw DataError(misuse("there are no points to group handles around"));
}

bool holds(const Points& handles, const Points& part) {
  try {
    const geometry::ConvexHull hull(handles);
    return hull.outside(part, -kLimitClearance * boundsOf(part).diagonal()).empty();
  } catch (const DataError&) {
    return false; // Fewer than four handles, or flat.
  }
}

/// Adds a group to `grouping`, with the corners `box` (`8 x 3`) around `part` when `members` alone would not
/// hold it.
void addGroup(Grouping& grouping, const std::string& name, const Points& handles, std::vector<int> members,
              const Points& part, const Points& box) {
  if (part.rows() > 0 && !holds(handles(members, Eigen::all), part)) {
    const Eigen::Index before = grouping.added.rows();
    grouping.added.conservativeResize(before + box.rows(), 3);
    grouping.added.bottomRows(box.rows()) = box;
    for (Eigen::Index i = 0; i < box.rows(); ++i)
      members.push_back(static_cast<int>(handles.rows() + before + i));
  }
  grouping.groups.push_back({name, std::move(members)});
}

/// The organ's principal axes: the third one is the longest.
class AxisFrame {
public:
  explicit AxisFrame(const Points& organ) : center_(organ.colwise().mean()) {
    const Points centered = organ.rowwise() - center_;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(centered.transpose() * centered);
    axes_ = solver.eigenvectors();
  }
  Points coordinates(const Points& points) const { return (points.rowwise() - center_) * axes_; }
  /// The corners of a box that lies along the axes, in the organ's own coordinates.
  Points corners(const Bounds& box) const {
    Points ends(2, 3);
    ends << box.low.transpose(), box.high.transpose();
    return (enclosingHandles(ends, 0) * axes_.transpose()).rowwise() + center_;
  }

private:
  Eigen::RowVector3d center_;
  Eigen::Matrix3d axes_;
};

/// Where a part's face goes that has to lie at `least` or farther on in `direction` (1 or -1): into the
/// widest gap between handles within a fifth of a part's `length`. The handles just beyond a face bound the
/// offset over which regions may blend.
double faceInGap(double least, int direction, const Values& along, double length) {
  const auto gapBeyond = [&](double face) {
    double gap = length;
    for (const double handle : along)
      if ((handle - face) * direction > 0)
        gap = std::min(gap, (handle - face) * direction);
    return gap;
  };
  double best = least, widest = gapBeyond(least);
  for (const double handle : along) {
    const double beyond = (handle - least) * direction;
    if (beyond < 0 || beyond > kFaceWindow * length)
      continue;
    const double face = handle + direction * kBehindHandle * length;
    if (const double gap = gapBeyond(face); gap > widest) {
      widest = gap;
      best = face;
    }
  }
  return best;
}

std::vector<int> rowsBetween(const Values& along, double low, double high) {
  std::vector<int> rows;
  for (Eigen::Index i = 0; i < along.size(); ++i)
    if (along[i] >= low && along[i] <= high)
      rows.push_back(static_cast<int>(i));
  return rows;
}

Points farthestSeeds(const Points& points, int count) {
  Points seeds(count, 3);
  Values distance = (points.rowwise() - points.colwise().mean()).rowwise().squaredNorm();
  for (int k = 0; k < count; ++k) {
    Eigen::Index next = 0;
    distance.maxCoeff(&next);
    seeds.row(k) = points.row(next);
    const Values fresh = (points.rowwise() - seeds.row(k)).rowwise().squaredNorm();
    distance = k == 0 ? fresh : Values(distance.cwiseMin(fresh));
  }
  return seeds;
}

/// Lloyd's iteration for the least sum of squared distances: each point to its nearest centre, each centre to
/// the mean of its points.
Points clusterCenters(const Points& points, int count) {
  Points centers = farthestSeeds(points, count);
  for (int round = 0; round < kMeansRounds; ++round) {
    Points sums = Points::Zero(count, 3);
    Values members = Values::Zero(count);
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
      Eigen::Index nearest = 0;
      (centers.rowwise() - points.row(i)).rowwise().squaredNorm().minCoeff(&nearest);
      sums.row(nearest) += points.row(i);
      members[nearest] += 1;
    }
    for (int k = 0; k < count; ++k)
      if (members[k] > 0)
        centers.row(k) = sums.row(k) / members[k];
  }
  return centers;
}

/// A few thousand of the points, evenly through their order: enough for the middles of clusters.
Points everyFew(const Points& points) {
  const Eigen::Index step = 1 + points.rows() / kClusteredPoints;
  return points(Eigen::seq(0, points.rows() - 1, step), Eigen::all);
}

std::vector<int> rowsNear(const Points& points, const Points& centers, int center) {
  std::vector<int> rows;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Values distance = (centers.rowwise() - points.row(i)).rowwise().norm();
    if (distance[center] <= kShared * distance.minCoeff())
      rows.push_back(static_cast<int>(i));
  }
  return rows;
}

/// The hull of a group; none of one that is flat.
std::optional<geometry::ConvexHull> hullOf(const Points& handles, const std::vector<int>& members) {
  try {
    return geometry::ConvexHull(handles(members, Eigen::all));
  } catch (const DataError&) {
    return std::nullopt;
  }
}

/// Lets handles just outside another group's hull join that group, until each lies in it or `room` away. The
/// nearest handle outside the zones bounds the offset over which regions may blend. It ends, because groups
/// only grow.
void makeRoom(const Points& handles, double room, Grouping& grouping) {
  Points all(handles.rows() + grouping.added.rows(), 3);
  all << handles, grouping.added;
  for (bool changed = true; changed;) {
    changed = false;
    for (auto& group : grouping.groups) {
      const auto hull = hullOf(all, group.handles);
      if (!hull)
        continue;
      const std::size_t before = group.handles.size();
      for (int row = 0; row < static_cast<int>(all.rows()); ++row) {
        const double outside = hull->signedDistance(all.row(row).transpose());
        const auto own = group.handles.begin() + static_cast<std::ptrdiff_t>(before);
        if (outside > 0 && outside < room && std::find(group.handles.begin(), own, row) == own)
          group.handles.push_back(row);
      }
      changed = changed || group.handles.size() > before;
      std::sort(group.handles.begin(), group.handles.end());
    }
  }
}

} // namespace

Grouping groupsAlongAxis(const Points& handles, const Points& organPoints, int count, double overlap) {
  requireInput(organPoints, count);
  if (!(overlap >= 0 && overlap <= 1))
    throw UsageError(misuse("the overlap of groups must lie between 0 and 1"));
  const AxisFrame frame(organPoints);
  const Points organ = frame.coordinates(organPoints), own = frame.coordinates(handles);
  const Bounds box = boundsOf(organ);
  const double margin = kBoxMargin / 2 * box.diagonal();
  const double low = box.low[kAlong], length = (box.high[kAlong] - low) / count;
  const double shared = std::max(overlap / 2 * length, kLimitClearance * box.diagonal());

  Grouping grouping;
  grouping.added.resize(0, 3);
  for (int k = 0; k < count; ++k) {
    const bool first = k == 0, last = k == count - 1;
    const double from = low + k * length, to = from + length;
    Bounds part{box.low.array() - margin, box.high.array() + margin};
    if (!first)
      part.low[kAlong] = faceInGap(from - shared, -1, own.col(kAlong), length);
    if (!last)
      part.high[kAlong] = faceInGap(to + shared, 1, own.col(kAlong), length);
    // The outermost parts take all handles that lie beyond them.
    addGroup(grouping, "part " + std::to_string(k + 1), handles,
             rowsBetween(own.col(kAlong), first ? -kInfinity : part.low[kAlong],
                         last ? kInfinity : part.high[kAlong]),
             organPoints(rowsBetween(organ.col(kAlong), from, to), Eigen::all), frame.corners(part));
  }
  return grouping;
}

Grouping groupsByCluster(const Points& handles, const Points& organPoints, int count) {
  requireInput(organPoints, count);
  if (handles.rows() < count)
    throw DataError(phrase("%n {handle|handles} cannot form %2 groups", handles.rows(), count), {},
                    "place more handles");
  if (organPoints.rows() < count)
    throw DataError(
        phrase("%n {vertex|vertices} cannot be divided among %2 groups", organPoints.rows(), count), {},
        "ask for fewer groups");
  const Points centers = clusterCenters(everyFew(organPoints), count);
  Grouping grouping;
  grouping.added.resize(0, 3);
  for (int k = 0; k < count; ++k) {
    const Points part = organPoints(rowsNear(organPoints, centers, k), Eigen::all);
    addGroup(grouping, "cluster " + std::to_string(k + 1), handles, rowsNear(handles, centers, k), part,
             enclosingHandles(part, kBoxMargin));
  }
  makeRoom(handles, kRoom * boundsOf(organPoints).diagonal(), grouping);
  return grouping;
}

Grouping groupsByOrgan(const Points& handles, const std::vector<Points>& organs,
                       const std::vector<std::string>& names) {
  std::vector<std::vector<int>> members(organs.size());
  for (const auto& organ : organs)
    requireInput(organ, 1);
  for (Eigen::Index i = 0; i < handles.rows(); ++i) {
    std::size_t nearest = 0;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < organs.size(); ++k) {
      const double distance = (organs[k].rowwise() - handles.row(i)).rowwise().squaredNorm().minCoeff();
      if (distance < best) {
        best = distance;
        nearest = k;
      }
    }
    if (!organs.empty())
      members[nearest].push_back(static_cast<int>(i));
  }
  Grouping grouping;
  grouping.added.resize(0, 3);
  for (std::size_t k = 0; k < organs.size(); ++k)
    addGroup(grouping, k < names.size() ? names[k] : "organ " + std::to_string(k + 1), handles, members[k],
             organs[k], enclosingHandles(organs[k], kBoxMargin));
  return grouping;
}

} // namespace viscera::deformation
