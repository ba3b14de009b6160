#pragma once

#include <optional>

#include "viscera/coordinates/tetrahedraliser.h"
#include "viscera/geometry/cell_lists.h"

namespace viscera::coordinates {

/// A piecewise linear function given by values at the corners of tetrahedra. Immutable; may be evaluated from
/// several threads.
class TetrahedraField {
public:
  /// `values` has a row for every point of `mesh`.
  TetrahedraField(SolidMesh mesh, const Eigen::MatrixXd& values);

  /// A tetrahedron and the barycentric coordinates of a point in it.
  struct Place {
    Eigen::Index tetrahedron;
    Eigen::RowVector4d shares;
  };

  /// The tetrahedron that holds `point`; nothing outside of all (by more than rounding).
  std::optional<Place> locate(const Vec3& point) const;

  /// Adds the values at `place` to the first ones of `values`.
  void addValues(const Place& place, Values& values) const;

  /// Adds the gradients there, which are those of the tetrahedron, to the first rows of `gradients`.
  void addGradients(const Place& place, Points& gradients) const;

private:
  SolidMesh mesh_;
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> values_;
  geometry::CellLists cells_;
};

} // namespace viscera::coordinates
