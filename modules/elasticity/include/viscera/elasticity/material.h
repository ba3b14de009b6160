#pragma once

#include <Eigen/Core>

/// Hyperelastic materials: what a deformation gradient costs, and the stress that it makes.
namespace viscera::elasticity {

/// A 9 x 9 derivative; row and column of the entry `(i, J)` of a 3 x 3 matrix are `3 i + J`.
using Tangent = Eigen::Matrix<double, 9, 9>;

/// The answer of a material to a deformation gradient F, without the pressure that keeps its volume.
struct Response {
  double energy = 0;                                ///< Per volume at rest, kPa (= mJ/ml).
  Eigen::Matrix3d stress = Eigen::Matrix3d::Zero(); ///< First Piola-Kirchhoff, dW/dF, kPa.
  Tangent tangent = Tangent::Zero();                ///< d stress / dF, kPa; symmetric.
};

/// A nearly incompressible hyperelastic material. The energy of a deformation gradient F with J = det F is
/// `W(F) + bulk (J - 1)^2 / 2`; `respond` gives W. Immutable, thread-safe.
class Material {
public:
  virtual ~Material() = default;

  /// W, its first and its second derivative at `f`, whose determinant is positive. Closed form.
  virtual Response respond(const Eigen::Matrix3d& f) const = 0;

  /// The factor of `(J - 1)^2 / 2`, kPa.
  virtual double bulk() const = 0;
  /// The resistance to shear at rest, kPa: the largest of an anisotropic material.
  virtual double shear() const = 0;
};

/// A neo-Hookean material: `W = mu / 2 (|F|^2 - 3) - mu ln J`, with `bulk` the first Lame constant lambda.
/// For small strains it is Hooke's law with Young's modulus and Poisson's ratio (Bonet and Wood 2008,
/// section 6.4, doi:10.1017/CBO9780511755446, with `lambda (J - 1)^2 / 2` in place of `lambda (ln J)^2 / 2`).
class NeoHookean final : public Material {
public:
  /// `youngKpa` above 0, `poisson` above 0 and below 0.5: 0.499 is usual for soft tissue. Throws
  /// `UsageError` for other values.
  NeoHookean(double youngKpa, double poisson);

  Response respond(const Eigen::Matrix3d& f) const override;
  double bulk() const override { return lambda_; }
  double shear() const override { return mu_; }

private:
  double mu_;
  double lambda_;
};

/// Guccione's transversely isotropic material, W = C / 2 (exp Q - 1) with
/// Q = bf E11^2 + bt (E22^2 + E33^2 + 2 E23^2) + 2 bfs (E12^2 + E13^2), E the Green-Lagrange strain along the
/// fibre (1) and across it (Guccione et al. 1991, doi:10.1115/1.2894084; as in Land et al. 2015,
/// doi:10.1098/rspa.2015.0641).
class Guccione final : public Material {
public:
  /// The constants of the material; `stiffnessKpa` is C.
  struct Constants {
    double stiffnessKpa = 1;
    double fibre = 1, across = 1, shear = 1; ///< bf, bt and bfs, without unit.
  };
  /// `axes` is a rotation whose first column is the fibre's direction. Throws `UsageError` for constants and
  /// a `bulkKpa` that are not positive.
  Guccione(const Constants& constants, double bulkKpa,
           const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity());

  Response respond(const Eigen::Matrix3d& f) const override;
  double bulk() const override { return bulk_; }
  double shear() const override { return 0.5 * stiffness_ * exponents_.maxCoeff(); }

private:
  double stiffness_;
  Eigen::Matrix3d exponents_; ///< The factor of each E(I, J)^2 in Q.
  double bulk_;
  Eigen::Matrix3d axes_;
};

} // namespace viscera::elasticity
