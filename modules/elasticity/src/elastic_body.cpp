#include "viscera/elasticity/elastic_body.h"

#include <algorithm>
#include <utility>

#include <Eigen/LU>

#include "tetrahedron_rule.h"
#include "viscera/core/error.h"

namespace viscera::elasticity {
namespace {

const std::array<RulePoint, 14> kTetrahedronRule = tetrahedronRule();

/// The cofactors of `f`, d det / dF.
Eigen::Matrix3d cofactorsOf(const Eigen::Matrix3d& f) {
  Eigen::Matrix3d cofactors;
  for (int i = 0; i < 3; ++i)
    cofactors.row(i) = f.row((i + 1) % 3).cross(f.row((i + 2) % 3));
  return cofactors;
}

/// Adds the second derivative of `factor det F`: `factor e(ikm) e(JLN) F(m, N)`.
void addDeterminantTangent(const Eigen::Matrix3d& f, double factor, Tangent& tangent) {
  for (int i = 0; i < 3; ++i)
    for (const int turn : {1, 2}) {
      const int k = (i + turn) % 3, m = 3 - i - k;
      const Vec3 row = (turn == 1 ? factor : -factor) * f.row(m).transpose();
      auto block = tangent.block<3, 3>(3 * i, 3 * k);
      block(0, 1) += row[2];
      block(1, 2) += row[0];
      block(2, 0) += row[1];
      block(1, 0) -= row[2];
      block(2, 1) -= row[0];
      block(0, 2) -= row[1];
    }
}

/// The part of the bulk modulus that works on displacements alone: so many shear moduli, at most half of it.
constexpr double kDirectShears = 1, kDirectPart = 0.5;

using Displacements = Eigen::Matrix<double, 3, 10>;

Displacements displacementsOf(const ElasticBody& body, Eigen::Index tetrahedron, const Values& state) {
  Displacements u;
  for (int a = 0; a < 10; ++a)
    u.col(a) = state.segment<3>(3 * Eigen::Index(body.mesh().tetrahedra(tetrahedron, a)));
  return u;
}

Eigen::Vector4d pressuresOf(const ElasticBody& body, Eigen::Index tetrahedron, const Values& state) {
  Eigen::Vector4d p;
  for (int k = 0; k < 4; ++k)
    p[k] = state[body.unknown(tetrahedron, 30 + k)];
  return p;
}

} // namespace

ElasticBody::ElasticBody(QuadraticMesh mesh, std::shared_ptr<const Material> material)
    : mesh_(std::move(mesh)), material_(std::move(material)),
      direct_(std::min(kDirectShears * material_->shear(), kDirectPart * material_->bulk())) {
  samples_.reserve(static_cast<std::size_t>(mesh_.tetrahedra.rows()) * kTetrahedronRule.size());
  for (Eigen::Index t = 0; t < mesh_.tetrahedra.rows(); ++t) {
    Eigen::Matrix<double, 3, 10> nodes;
    for (int a = 0; a < 10; ++a)
      nodes.col(a) = mesh_.nodes.row(mesh_.tetrahedra(t, a)).transpose();
    for (const RulePoint& point : kTetrahedronRule) {
      const Eigen::Matrix<double, 10, 3> reference = quadraticShapeGradients(point.at);
      const Eigen::Matrix3d jacobian = nodes * reference;
      const double determinant = jacobian.determinant();
      if (!(determinant > 0))
        throw DataError(misuse("tetrahedron %1 is turned around or has no volume", t));
      samples_.push_back({reference * jacobian.inverse(), point.weight * determinant / 6});
      volume_ += samples_.back().weight;
    }
  }
}

void ElasticBody::shareOf(Eigen::Index tetrahedron, const Values& state, ElementShare& share) const {
  const Displacements u = displacementsOf(*this, tetrahedron, state);
  const Eigen::Vector4d pressures = pressuresOf(*this, tetrahedron, state);
  const double bulk = material_->bulk() - direct_;
  share.energy = 0;
  share.smallestJacobian = 1e300;
  share.force.setZero();
  share.stiffness.setZero();
  for (std::size_t s = 0; s < kTetrahedronRule.size(); ++s) {
    const Sample& sample = samples_[std::size_t(tetrahedron) * kTetrahedronRule.size() + s];
    const Eigen::Matrix3d f = Eigen::Matrix3d::Identity() + u * sample.gradients;
    const double j = f.determinant();
    share.smallestJacobian = std::min(share.smallestJacobian, j);
    if (!(j > 0))
      continue;
    const Eigen::Vector4d& shapes = kTetrahedronRule[s].at; // Those of the pressure.
    const double p = shapes.dot(pressures), all = p + direct_ * (j - 1), w = sample.weight;
    Response response = material_->respond(f);
    const Eigen::Matrix3d cofactors = cofactorsOf(f);
    addDeterminantTangent(f, all, response.tangent);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        response.tangent.block<3, 3>(3 * i, 3 * k) +=
            direct_ * cofactors.row(i).transpose() * cofactors.row(k);
    share.energy += w * (response.energy + 0.5 * (p + all) * (j - 1) - 0.5 * p * p / bulk);
    const Eigen::Matrix<double, 10, 3> forces =
        w * sample.gradients * (response.stress + all * cofactors).transpose();
    const Eigen::Matrix<double, 10, 3> spread = w * sample.gradients * cofactors.transpose();
    for (int i = 0; i < 3; ++i) {
      share.force.segment<10>(10 * i) += forces.col(i);
      share.stiffness.block<10, 4>(10 * i, 30) += spread.col(i) * shapes.transpose();
      for (int k = i; k < 3; ++k)
        share.stiffness.block<10, 10>(10 * i, 10 * k).noalias() +=
            (w * sample.gradients * response.tangent.block<3, 3>(3 * i, 3 * k)) *
            sample.gradients.transpose();
    }
    share.force.tail<4>() += w * (j - 1 - p / bulk) * shapes;
    share.stiffness.bottomRightCorner<4, 4>() -= w / bulk * shapes * shapes.transpose();
  }
  share.stiffness.triangularView<Eigen::StrictlyLower>() = share.stiffness.transpose();
}

std::vector<LocalState> ElasticBody::statesOf(Eigen::Index tetrahedron, const Values& state) const {
  const Displacements u = displacementsOf(*this, tetrahedron, state);
  const Eigen::Vector4d pressures = pressuresOf(*this, tetrahedron, state);
  std::vector<LocalState> states;
  for (std::size_t s = 0; s < kTetrahedronRule.size(); ++s) {
    const Sample& sample = samples_[std::size_t(tetrahedron) * kTetrahedronRule.size() + s];
    LocalState local;
    const auto shapes = quadraticShapes(kTetrahedronRule[s].at);
    for (int a = 0; a < 10; ++a)
      local.place += shapes[a] * mesh_.nodes.row(mesh_.tetrahedra(tetrahedron, a)).transpose();
    local.gradient += u * sample.gradients;
    local.pressureKpa = kTetrahedronRule[s].at.dot(pressures) + direct_ * (local.gradient.determinant() - 1);
    local.weightMm3 = sample.weight;
    states.push_back(local);
  }
  return states;
}

} // namespace viscera::elasticity
