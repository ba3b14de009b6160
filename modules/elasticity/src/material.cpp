#include "viscera/elasticity/material.h"

#include <cmath>

#include <Eigen/LU>

#include "viscera/core/error.h"

namespace viscera::elasticity {

NeoHookean::NeoHookean(double youngKpa, double poisson)
    : mu_(youngKpa / (2 * (1 + poisson))), lambda_(youngKpa * poisson / ((1 + poisson) * (1 - 2 * poisson))) {
  if (!(youngKpa > 0) || !std::isfinite(youngKpa))
    throw UsageError("Young's modulus has to be above 0 kPa");
  if (!(poisson > 0 && poisson < 0.5))
    throw UsageError("Poisson's ratio has to be above 0 and below 0.5");
}

Response NeoHookean::respond(const Eigen::Matrix3d& f) const {
  const double j = f.determinant();
  const Eigen::Matrix3d inverse = f.inverse();
  Response response;
  response.energy = 0.5 * mu_ * (f.squaredNorm() - 3) - mu_ * std::log(j);
  response.stress = mu_ * (f - inverse.transpose());
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      response.tangent.block<3, 3>(3 * i, 3 * k) = mu_ * inverse.col(k) * inverse.col(i).transpose();
  response.tangent.diagonal().array() += mu_;
  return response;
}

Guccione::Guccione(const Constants& constants, double bulkKpa, const Eigen::Matrix3d& axes)
    : stiffness_(constants.stiffnessKpa), bulk_(bulkKpa), axes_(axes) {
  const auto& [c, f, t, s] = constants;
  if (!(c > 0 && f > 0 && t > 0 && s > 0 && bulkKpa > 0))
    throw UsageError("The constants of a Guccione material have to be above 0");
  exponents_ << f, s, s, s, t, t, s, t, t;
}

Response Guccione::respond(const Eigen::Matrix3d& f) const {
  const Eigen::Matrix3d along = f * axes_; // Columns are images of the material's axes.
  const Eigen::Matrix3d strain = 0.5 * (along.transpose() * along - Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d scaled = exponents_.cwiseProduct(strain);
  const double growth = stiffness_ * std::exp(scaled.cwiseProduct(strain).sum());
  const Eigen::Matrix3d second = growth * scaled; // Second Piola-Kirchhoff along the axes.
  const Eigen::Matrix3d turned = along * scaled;
  Response response;
  response.energy = 0.5 * (growth - stiffness_);
  response.stress = along * second * axes_.transpose();
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) {
      Eigen::Matrix3d block = 2 * growth * turned.row(i).transpose() * turned.row(k);
      for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b)
          block(a, b) += 0.5 * growth * exponents_(a, b) * along(i, b) * along(k, a);
        block(a, a) += 0.5 * growth * along.row(i).cwiseProduct(along.row(k)).dot(exponents_.row(a));
      }
      if (i == k)
        block += second;
      response.tangent.block<3, 3>(3 * i, 3 * k) = axes_ * block * axes_.transpose();
    }
  return response;
}

} // namespace viscera::elasticity
