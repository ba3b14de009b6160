#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "viscera/core/arrays.h"
#include "viscera/elasticity/material.h"
#include "viscera/elasticity/quadratic_mesh.h"

namespace viscera::elasticity {

/// The share of one tetrahedron in the forces. Local unknowns: the displacements of its ten nodes, all x
/// first, then y and z (`10 axis + node`), then the pressures of its four corners.
struct ElementShare {
  static constexpr int kUnknowns = 34;
  using Vector = Eigen::Matrix<double, kUnknowns, 1>;
  using Matrix = Eigen::Matrix<double, kUnknowns, kUnknowns>;

  double energy = 0;           ///< The mixed energy, kPa mm^3 (uJ).
  Vector force;                ///< Its gradient.
  Matrix stiffness;            ///< Its second derivative.
  double smallestJacobian = 1; ///< Of the deformation, at the quadrature points.
};

/// What the deformation is at one point.
struct LocalState {
  Vec3 place = Vec3::Zero();                              ///< At rest, mm.
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Identity(); ///< Of the deformation.
  double pressureKpa = 0; ///< `p + g (J - 1)`, positive where tissue is stretched.
  double weightMm3 = 0;   ///< The volume at rest that the point stands for.
};

/// An elastic body: quadratic displacements and linear, continuous pressures on tetrahedra (Taylor and Hood
/// 1973, doi:10.1016/0045-7930(73)90027-3), which do not lock when the material hardly changes its volume.
/// The mixed energy is the integral of `W(F) + g (J - 1)^2 / 2 + p (J - 1) - p^2 / (2 (bulk - g))` over the
/// body at rest. A part g of the bulk modulus, as large as the shear modulus, works on displacements alone:
/// it keeps J near 1 between the corners, too, and the stiffness of the displacements positive (Olshanskii et
/// al. 2009, doi:10.1016/j.cma.2009.09.005, for fluids). Without g the exact solution is the same. Immutable,
/// thread-safe.
class ElasticBody {
public:
  /// Throws `DataError` that names a tetrahedron which is turned around.
  ElasticBody(QuadraticMesh mesh, std::shared_ptr<const Material> material);

  const QuadraticMesh& mesh() const { return mesh_; }
  const Material& material() const { return *material_; }
  double volumeMm3() const { return volume_; }  ///< At rest.
  double directBulk() const { return direct_; } ///< g, kPa.

  /// The number of unknowns: the displacements of all nodes (`3 node + axis`), then the pressures of all
  /// corners.
  Eigen::Index unknowns() const { return 3 * mesh_.nodes.rows() + mesh_.corners; }
  /// The unknown of a tetrahedron's local one.
  Eigen::Index unknown(Eigen::Index tetrahedron, int local) const {
    return local < 30 ? 3 * Eigen::Index(mesh_.tetrahedra(tetrahedron, local % 10)) + local / 10
                      : 3 * mesh_.nodes.rows() + mesh_.tetrahedra(tetrahedron, local - 30);
  }

  /// The share of a tetrahedron at `state` (`unknowns()` numbers, mm and kPa). Where the deformation turns it
  /// around, only `smallestJacobian` is filled in. About 50 us.
  void shareOf(Eigen::Index tetrahedron, const Values& state, ElementShare& share) const;

  /// The states at the quadrature points of a tetrahedron.
  std::vector<LocalState> statesOf(Eigen::Index tetrahedron, const Values& state) const;

private:
  struct Sample {
    Eigen::Matrix<double, 10, 3> gradients; ///< Of the nodes' shape functions, 1/mm.
    double weight = 0;                      ///< mm^3.
  };

  QuadraticMesh mesh_;
  std::shared_ptr<const Material> material_;
  std::vector<Sample> samples_; ///< `kTetrahedronRule.size()` for each tetrahedron.
  double volume_ = 0;
  double direct_;
};

} // namespace viscera::elasticity
