#pragma once

#include <array>

#include <Eigen/Core>

#include "viscera/elasticity/quadratic_mesh.h"

/// Quadrature and shape functions of the tetrahedron with ten nodes and of its faces with six.
namespace viscera::elasticity {

/// A point of a quadrature rule in barycentric coordinates; the weights of a rule add up to 1.
struct RulePoint {
  Eigen::Vector4d at;
  double weight;
};

/// 14 points, exact for polynomials of degree 5 (Walkington 2000).
inline std::array<RulePoint, 14> tetrahedronRule() {
  std::array<RulePoint, 14> rule;
  std::size_t next = 0;
  for (const auto& [a, weight] : {std::array{0.31088591926330060980, 0.11268792571801585080},
                                  std::array{0.092735250310891226402, 0.073493043116361949544}})
    for (int k = 0; k < 4; ++k) {
      Eigen::Vector4d at = Eigen::Vector4d::Constant(a);
      at[k] = 1 - 3 * a;
      rule[next++] = {at, weight};
    }
  constexpr double a = 0.045503704125649649492, weight = 0.042546020777081466438;
  for (const auto& [i, j] : kEdges) {
    Eigen::Vector4d at = Eigen::Vector4d::Constant(0.5 - a);
    at[i] = at[j] = a;
    rule[next++] = {at, weight};
  }
  return rule;
}

/// The ten shape functions at barycentric coordinates `l`.
inline Eigen::Matrix<double, 10, 1> quadraticShapes(const Eigen::Vector4d& l) {
  Eigen::Matrix<double, 10, 1> shapes;
  for (int k = 0; k < 4; ++k)
    shapes[k] = l[k] * (2 * l[k] - 1);
  for (int e = 0; e < 6; ++e)
    shapes[4 + e] = 4 * l[kEdges[std::size_t(e)][0]] * l[kEdges[std::size_t(e)][1]];
  return shapes;
}

/// The shapes' derivatives along the second, third and fourth barycentric coordinate, `10 x 3`.
inline Eigen::Matrix<double, 10, 3> quadraticShapeGradients(const Eigen::Vector4d& l) {
  Eigen::Matrix<double, 10, 4> by = Eigen::Matrix<double, 10, 4>::Zero();
  for (int k = 0; k < 4; ++k)
    by(k, k) = 4 * l[k] - 1;
  for (int e = 0; e < 6; ++e) {
    const auto& [i, j] = kEdges[std::size_t(e)];
    by(4 + e, i) = 4 * l[j];
    by(4 + e, j) = 4 * l[i];
  }
  return by.rightCols<3>().colwise() - by.col(0);
}

/// A point of a triangle's rule: the six shape functions and their derivatives along the second and third
/// barycentric coordinate.
struct FaceRulePoint {
  Eigen::Matrix<double, 6, 1> shapes, alongSecond, alongThird;
  double weight; ///< Together 1/2, the area of the triangle of those coordinates.
};

/// 6 points, exact for polynomials of degree 4 (Dunavant 1985, doi:10.1002/nme.1620210612).
inline std::array<FaceRulePoint, 6> faceRule() {
  std::array<FaceRulePoint, 6> rule;
  std::size_t next = 0;
  for (const auto& [a, weight] :
       {std::array{0.445948490915965, 0.223381589678011}, std::array{0.091576213509771, 0.109951743655322}})
    for (int k = 0; k < 3; ++k) {
      Eigen::Vector3d l = Eigen::Vector3d::Constant(a);
      l[k] = 1 - 2 * a;
      FaceRulePoint& point = rule[next++];
      point.weight = weight / 2;
      Eigen::Matrix<double, 6, 3> by = Eigen::Matrix<double, 6, 3>::Zero();
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        point.shapes[i] = l[i] * (2 * l[i] - 1);
        point.shapes[3 + i] = 4 * l[i] * l[j];
        by(i, i) = 4 * l[i] - 1;
        by(3 + i, i) = 4 * l[j];
        by(3 + i, j) = 4 * l[i];
      }
      point.alongSecond = by.col(1) - by.col(0);
      point.alongThird = by.col(2) - by.col(0);
    }
  return rule;
}

} // namespace viscera::elasticity
