#pragma once

#include "viscera/coordinates/pose_lift.h"

namespace viscera::coordinates {

/// Lifts a pose by the normals of the cage's triangles, each scaled by the stretch of its triangle (Lipman,
/// Levin and Cohen-Or 2008, section 4). A triangle without area has no normal and gives a zero row.
class CageNormals final : public PoseLift {
public:
  CageNormals(Points rest, Triangles cage);

  Eigen::Index rowCount() const override { return rest_.rows() + cage_.rows(); }
  Points lift(const Points& pose) const override;
  Points pullBack(const Points& pose, const Points& rowGradient) const override;

private:
  /// A triangle's two edges from its first corner, in a pose.
  struct Face {
    Vec3 u, v, area; ///< `area = u x v`.
    double stretch;
  };
  Face face(const Points& pose, Eigen::Index triangle) const;

  Points rest_;
  Triangles cage_;
  Points products_; ///< Of each triangle at rest: u.u, u.v and v.v.
  Values squares_;  ///< Eight times its squared area.
};

} // namespace viscera::coordinates
