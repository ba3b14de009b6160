#include "viscera/deformation/group_handles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Eigenvalues>

#include "viscera/core/error.h"
#include "viscera/deformation/place_handles.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::deformation {
namespace {

/// A part's hull must clear its vertices by this part of its size: coordinates at the very boundary are
/// limits.
constexpr double kClearance = 0.01;
constexpr double kBoxMargin = 0.08;
/// A point up to this much farther from a second centre than from its nearest belongs to both.
constexpr double kShared = 1.25;
constexpr int kMeansRounds = 20;

void requireInput(const Points& organPoints, int count) {
  if (count < 1)
    throw UsageError("the number of groups must be at least 1, not " + std::to_string(count));
  if (organPoints.rows() == 0)
    throw DataError("there are no points to group handles around");
}

Points chosenRows(const Points& points, const std::vector<int>& rows) {
  Points chosen(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i)
    chosen.row(static_cast<Eigen::Index>(i)) = points.row(rows[i]);
  return chosen;
}

bool holds(const Points& handles, const Points& part) {
  try {
    const geometry::ConvexHull hull(handles);
    return hull.outside(part, -kClearance * boundsOf(part).diagonal()).empty();
  } catch (const DataError&) {
    return false; // Fewer than four handles, or flat.
  }
}

/// Adds a group to `grouping`, with a box around `part` when `members` alone would not hold it.
void addGroup(Grouping& grouping, const std::string& name, const Points& handles, std::vector<int> members,
              const Points& part) {
  if (part.rows() > 0 && !holds(chosenRows(handles, members), part)) {
    const Points box = enclosingHandles(part, kBoxMargin);
    const Eigen::Index before = grouping.added.rows();
    grouping.added.conservativeResize(before + box.rows(), 3);
    grouping.added.bottomRows(box.rows()) = box;
    for (Eigen::Index i = 0; i < box.rows(); ++i)
      members.push_back(static_cast<int>(handles.rows() + before + i));
  }
  grouping.groups.push_back({name, std::move(members)});
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

std::vector<int> rowsNear(const Points& points, const Points& centers, int center) {
  std::vector<int> rows;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Values distance = (centers.rowwise() - points.row(i)).rowwise().norm();
    if (distance[center] <= kShared * distance.minCoeff())
      rows.push_back(static_cast<int>(i));
  }
  return rows;
}

} // namespace

Grouping groupsAlongAxis(const Points& handles, const Points& organPoints, int count, double overlap) {
  requireInput(organPoints, count);
  if (!(overlap >= 0 && overlap <= 1))
    throw UsageError("the overlap of groups must lie between 0 and 1");
  const Eigen::RowVector3d center = organPoints.colwise().mean();
  const Points centered = organPoints.rowwise() - center;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(centered.transpose() * centered);
  const Vec3 axis = axes.eigenvectors().col(2);
  const Values ofOrgan = centered * axis;
  const Values ofHandles = (handles.rowwise() - center) * axis;
  const double low = ofOrgan.minCoeff(), length = (ofOrgan.maxCoeff() - low) / count;
  const double infinity = std::numeric_limits<double>::infinity();

  Grouping grouping;
  grouping.added.resize(0, 3);
  for (int k = 0; k < count; ++k) {
    // Half of the shared stretch on each side; the outermost parts take all that lies beyond them.
    const double begin = k == 0 ? -infinity : low + (k - overlap / 2) * length;
    const double end = k == count - 1 ? infinity : low + (k + 1 + overlap / 2) * length;
    addGroup(grouping, "part " + std::to_string(k + 1), handles, rowsBetween(ofHandles, begin, end),
             chosenRows(organPoints, rowsBetween(ofOrgan, begin, end)));
  }
  return grouping;
}

Grouping groupsByCluster(const Points& handles, const Points& organPoints, int count) {
  requireInput(organPoints, count);
  if (handles.rows() < count)
    throw DataError(std::to_string(handles.rows()) + " handles cannot form " + std::to_string(count) +
                        " groups",
                    {}, "place more handles");
  const Points centers = clusterCenters(handles, count);
  Grouping grouping;
  grouping.added.resize(0, 3);
  for (int k = 0; k < count; ++k)
    addGroup(grouping, "cluster " + std::to_string(k + 1), handles, rowsNear(handles, centers, k),
             chosenRows(organPoints, rowsNear(organPoints, centers, k)));
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
             organs[k]);
  return grouping;
}

} // namespace viscera::deformation
