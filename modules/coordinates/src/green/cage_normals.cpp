#include "green/cage_normals.h"

#include <cmath>
#include <utility>

#include <Eigen/Geometry>

namespace viscera::coordinates {

CageNormals::CageNormals(Points rest, Triangles cage)
    : rest_(std::move(rest)), cage_(std::move(cage)), products_(cage_.rows(), 3), squares_(cage_.rows()) {
  for (Eigen::Index t = 0; t < cage_.rows(); ++t) {
    const Vec3 u = (rest_.row(cage_(t, 1)) - rest_.row(cage_(t, 0))).transpose();
    const Vec3 v = (rest_.row(cage_(t, 2)) - rest_.row(cage_(t, 0))).transpose();
    products_.row(t) << u.dot(u), u.dot(v), v.dot(v);
    squares_[t] = 2 * u.cross(v).squaredNorm();
  }
}

CageNormals::Face CageNormals::face(const Points& pose, Eigen::Index t) const {
  Face face;
  face.u = (pose.row(cage_(t, 1)) - pose.row(cage_(t, 0))).transpose();
  face.v = (pose.row(cage_(t, 2)) - pose.row(cage_(t, 0))).transpose();
  face.area = face.u.cross(face.v);
  // s^2 = (|u'|^2 |v|^2 - 2 (u'.v')(u.v) + |v'|^2 |u|^2) / (8 A^2), primes for the pose, A the triangle's
  // area at rest: the mean of the squares of the two principal stretches.
  const double square = face.u.dot(face.u) * products_(t, 2) - 2 * face.u.dot(face.v) * products_(t, 1) +
                        face.v.dot(face.v) * products_(t, 0);
  face.stretch = std::sqrt(square / squares_[t]);
  return face;
}

Points CageNormals::lift(const Points& pose) const {
  // Below the pose the rows s n, n = u' x v' / |u' x v'|.
  Points rows = Points::Zero(rowCount(), 3);
  rows.topRows(pose.rows()) = pose;
  for (Eigen::Index t = 0; t < cage_.rows(); ++t) {
    const Face now = face(pose, t);
    if (const double twice = now.area.norm(); twice > 0)
      rows.row(pose.rows() + t) = now.stretch / twice * now.area.transpose();
  }
  return rows;
}

Points CageNormals::pullBack(const Points& pose, const Points& rowGradient) const {
  Points result = rowGradient.topRows(pose.rows());
  for (Eigen::Index t = 0; t < cage_.rows(); ++t) {
    const Face now = face(pose, t);
    const double twice = now.area.norm();
    if (!(twice > 0))
      continue;
    const Vec3 gradient = rowGradient.row(pose.rows() + t).transpose(), normal = now.area / twice;
    // Let g be the derivative by the row s n: g . d(s n) = (g.n) ds + s g . dn, where ds = ((|v|^2 u' - (u.v)
    // v') . du' + (|u|^2 v' - (u.v) u') . dv') / (8 A^2 s) and dn = (I - n n^T)(du' x v' + u' x dv') / |u' x
    // v'|.
    const double along = gradient.dot(normal) / (squares_[t] * now.stretch);
    const Vec3 across = now.stretch / twice * (gradient - gradient.dot(normal) * normal);
    const Vec3 ofU = along * (products_(t, 2) * now.u - products_(t, 1) * now.v) + now.v.cross(across);
    const Vec3 ofV = along * (products_(t, 0) * now.v - products_(t, 1) * now.u) + across.cross(now.u);
    result.row(cage_(t, 0)) -= (ofU + ofV).transpose();
    result.row(cage_(t, 1)) += ofU.transpose();
    result.row(cage_(t, 2)) += ofV.transpose();
  }
  return result;
}

} // namespace viscera::coordinates
