#include "viscera/sequences/spread_points.h"

#include <limits>

namespace viscera::sequences {

std::vector<Vec3> spreadPoints(const Points& candidates, const Points& present, double reach) {
  Values nearest2 = Values::Constant(candidates.rows(), std::numeric_limits<double>::infinity());
  const auto consider = [&](const Vec3& point) {
    nearest2 = nearest2.cwiseMin((candidates.rowwise() - point.transpose()).rowwise().squaredNorm());
  };
  for (const auto& row : present.rowwise())
    consider(row.transpose());
  std::vector<Vec3> picks;
  while (candidates.rows() > 0) {
    Eigen::Index farthest = 0;
    if (nearest2.maxCoeff(&farthest) <= reach * reach)
      break;
    picks.push_back(candidates.row(farthest).transpose());
    consider(picks.back());
  }
  return picks;
}

Bounds grownBox(const Points& points, double margin) {
  Bounds box = boundsOf(points);
  const Vec3 grow = Vec3::Constant(margin * box.diagonal());
  box.low -= grow;
  box.high += grow;
  return box;
}

} // namespace viscera::sequences
