#pragma once

#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {

/// Harmonic coordinates (Joshi et al. 2007, doi 10.1145/1276377.1276466; thesis 2.3): inside a closed cage of
/// any shape each coordinate is the solution of Laplace's equation that is linear on the cage's triangles, 1
/// at its handle and 0 at the others.
///
/// By linear finite elements on tetrahedra whose edges are about a `resolution`-th of the cage's diagonal;
/// the error falls with its square. Linear functions are among the elements, so identity and unity are exact
/// on any tetrahedra. True harmonic coordinates are positive in any cage; on tetrahedra with obtuse angles
/// the elements may fall below zero by a little, which is why the traits do not promise it. Derivatives are
/// those of the elements: constant in each tetrahedron. Points outside the cage have no coordinates.
/// A factorisation of about `resolution^3 / 2` unknowns, then O(handles) a point.
class Harmonic final : public PointwiseSystem {
public:
  Harmonic();
};

} // namespace viscera::coordinates
