#include <array>

#include <Eigen/Geometry>

#include "tetrahedron_rule.h"
#include "viscera/elasticity/static_solution.h"

namespace viscera::elasticity {
namespace {

/// The matrix of `x -> v x x`.
Eigen::Matrix3d crossWith(const Vec3& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v[2], v[1], v[2], 0, -v[0], -v[1], v[0], 0;
  return matrix;
}

} // namespace

void addPressure(const ElasticBody& body, const Face& face, double kpa, const Values& state,
                 ElementShare& share) {
  static const std::array<FaceRulePoint, 6> rule = faceRule();
  const std::array<int, 6> local = nodesOfFace(face.opposite);
  Eigen::Matrix<double, 3, 6> places;
  for (int a = 0; a < 6; ++a) {
    const Eigen::Index node = body.mesh().tetrahedra(face.tetrahedron, local[std::size_t(a)]);
    places.col(a) = body.mesh().nodes.row(node).transpose() + state.segment<3>(3 * node);
  }
  for (const FaceRulePoint& point : rule) {
    const Vec3 second = places * point.alongSecond, third = places * point.alongThird;
    const double weight = kpa * point.weight;
    const Vec3 force = weight * second.cross(third); // Inward pressure is the gradient's positive normal.
    const Eigen::Matrix3d bySecond = weight * crossWith(second), byThird = weight * crossWith(third);
    for (int a = 0; a < 6; ++a)
      for (int i = 0; i < 3; ++i) {
        const int row = 10 * i + local[std::size_t(a)];
        share.force[row] += point.shapes[a] * force[i];
        for (int b = 0; b < 6; ++b)
          for (int k = 0; k < 3; ++k) {
            const int column = 10 * k + local[std::size_t(b)];
            const double half = 0.5 * point.shapes[a] *
                                (bySecond(i, k) * point.alongThird[b] - byThird(i, k) * point.alongSecond[b]);
            share.stiffness(row, column) += half;
            share.stiffness(column, row) += half;
          }
      }
  }
}

} // namespace viscera::elasticity
