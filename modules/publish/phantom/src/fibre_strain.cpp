#include "fibre_strain.h"

#include <array>

#include "viscera/geometry/normals.h"

namespace viscera::phantom {
namespace {

constexpr double kDepthMm = 4;    ///< Of the points in the wall.
constexpr double kHighestMm = 15; ///< Below the mitral valve; above it the wall ends.
constexpr double kLowestMm = 65;  ///< Nearer to the apex no direction runs around the axis.
constexpr double kHalfStepMm = 0.5;

} // namespace

WallPoints::WallPoints(const PhantomBody& body) {
  const geometry::TriangleMesh& cavity = body.surfaceOf("left ventricle").mesh;
  const geometry::Normals normals = geometry::vertexNormals(cavity);
  std::array<std::vector<Vec3>, 3> directions;
  std::vector<Vec3> points;
  for (Eigen::Index v = 0; v < cavity.points.rows(); ++v) {
    const Vec3 point = cavity.points.row(v).transpose();
    const double below = body.heart.toLocal(point).z();
    if (below < kHighestMm || below > kLowestMm)
      continue;
    const Vec3 radial = normals.row(v).transpose().cast<double>();
    const Vec3 around = body.heart.towardsApex().cross(radial).normalized();
    points.push_back(point + kDepthMm * radial);
    directions[0].push_back(radial.cross(around));
    directions[1].push_back(around);
    directions[2].push_back(radial);
  }
  points_ = pointsOf(points);
  for (const std::vector<Vec3>& list : directions)
    directions_.push_back(pointsOf(list));
}

WallStrain WallPoints::strainAt(const PhantomMotion& motion) const {
  std::array<double, 3> means{};
  for (std::size_t d = 0; d < means.size(); ++d) {
    const Points ahead = motion.moved(points_ + kHalfStepMm * directions_[d]);
    const Points behind = motion.moved(points_ - kHalfStepMm * directions_[d]);
    means[d] = ((ahead - behind).rowwise().norm() / (2 * kHalfStepMm)).mean() - 1;
  }
  return {means[0], means[1], means[2]};
}

} // namespace viscera::phantom
