#pragma once

#include "viscera/core/arrays.h"

namespace viscera::coordinates {

/// Single and double layer potentials of one triangle at the origin (Green's third identity), with gradients.
struct TrianglePotentials {
  Vec3 corners = Vec3::Zero(); ///< Double layer of the corners' hat functions.
  double face = 0;             ///< Single layer of the triangle, mm.
  double solidAngle = 0;       ///< Under which the origin sees the triangle, positive from inside.
  Eigen::Matrix3d cornerGradients = Eigen::Matrix3d::Zero(); ///< A row for each corner, 1/mm.
  Vec3 faceGradient = Vec3::Zero();                          ///< By the point's position.
};

/// A triangle relative to the point. Its corners are counter-clockwise from outside.
class SeenTriangle {
public:
  SeenTriangle(const Vec3& a, const Vec3& b, const Vec3& c);

  /// Barycentric coordinates of the origin's foot in the triangle's plane.
  const Vec3& foot() const { return foot_; }
  /// Height of the plane over the origin along the outward normal, mm: positive from inside.
  double height() const { return height_; }
  /// Whether the origin lies on the triangle, to `tolerance` mm.
  bool touches(double tolerance) const;
  /// Leaves out the gradients, which do not exist on the triangle's edges, where they are not asked for. A
  /// triangle that touches the origin gives its single layer only.
  TrianglePotentials potentials(bool touching, bool wantGradients) const;

private:
  Eigen::Matrix3d corners_; ///< A column for each corner.
  Vec3 normal_;
  double height_;
  Eigen::Matrix3d hats_;     ///< Gradients of the hat functions, a row for each corner.
  Eigen::Matrix3d sideways_; ///< Outward normals of the edges in the plane, a column for each edge.
  Vec3 foot_;
};

} // namespace viscera::coordinates
