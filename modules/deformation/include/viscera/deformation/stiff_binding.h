#pragma once

#include <memory>

#include "viscera/coordinates/binding.h"
#include "viscera/geometry/triangle_mesh.h"

/// Bindings of organs that do not bend, such as bones. They stand in for the binding of a coordinate system
/// wherever one is used: pose, volume, lock and gradients follow.
namespace viscera::deformation {

/// A binding whose organ moves as a rigid body among tissue that bends: `soft` says where the handles would
/// take its vertices, and the organ takes the rotation and translation that fit them best (least squares over
/// the area of its surface; Kabsch, doi 10.1107/S0567739476001873, without reflections). At rest it is where
/// it was. `rest` is the surface that `soft` was bound to. A pose costs one of `soft` and O(points); a single
/// handle costs as much. Immutable, thread-safe.
std::shared_ptr<const coordinates::Binding> rigidBinding(std::shared_ptr<const coordinates::Binding> soft,
                                                         const geometry::TriangleMesh& rest);

/// A binding whose organ stays at rest in every pose of that many handles. `rest` is `n x 3`, mm.
std::shared_ptr<const coordinates::Binding> fixedBinding(Eigen::Index handles, Points rest);

} // namespace viscera::deformation
