#include "tetrahedra/tetrahedra_field.h"

#include <utility>

#include "tetrahedra/finite_elements.h"

namespace viscera::coordinates {
namespace {

/// A point this little outside a tetrahedron, in barycentric coordinates, still counts as inside.
constexpr double kInside = -1e-9;

} // namespace

TetrahedraField::TetrahedraField(SolidMesh mesh, const Eigen::MatrixXd& values)
    : mesh_(std::move(mesh)), values_(values),
      cells_(boundsOf(mesh_.points), geometry::cellEdge(boundsOf(mesh_.points), mesh_.points.rows())) {
  cells_.fill(mesh_.tetrahedra.rows(), [&](Eigen::Index t) {
    Points corners(4, 3);
    for (int k = 0; k < 4; ++k)
      corners.row(k) = mesh_.points.row(mesh_.tetrahedra(t, k));
    return boundsOf(corners);
  });
}

std::optional<TetrahedraField::Place> TetrahedraField::locate(const Vec3& point) const {
  Place best{-1, {}};
  double least = kInside;
  cells_.visit(cells_.cellOf(point), [&](std::int32_t t) {
    const Vec3 origin = mesh_.points.row(mesh_.tetrahedra(t, 0)).transpose();
    const Vec3 inner = barycentricGradients(mesh_, t).bottomRows<3>() * (point - origin);
    const Eigen::RowVector4d shares(1 - inner.sum(), inner[0], inner[1], inner[2]);
    if (shares.minCoeff() > least) {
      least = shares.minCoeff();
      best = {t, shares};
    }
  });
  if (best.tetrahedron < 0)
    return std::nullopt;
  return best;
}

void TetrahedraField::addValues(const Place& place, Values& values) const {
  for (int k = 0; k < 4; ++k)
    values.head(values_.cols()) +=
        place.shares[k] * values_.row(mesh_.tetrahedra(place.tetrahedron, k)).transpose();
}

void TetrahedraField::addGradients(const Place& place, Points& gradients) const {
  const auto shares = barycentricGradients(mesh_, place.tetrahedron);
  for (int k = 0; k < 4; ++k)
    gradients.topRows(values_.cols()) +=
        values_.row(mesh_.tetrahedra(place.tetrahedron, k)).transpose() * shares.row(k);
}

} // namespace viscera::coordinates
