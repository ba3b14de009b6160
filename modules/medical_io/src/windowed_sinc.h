#pragma once

#include "viscera/geometry/triangle_mesh.h"

namespace viscera::medical_io {

/// The surface with its points moved by a windowed sinc filter (Taubin et al. 1996, doi 10.1007/BFb0015551),
/// which takes away what changes faster than `passBand` (0 to 2; smaller is smoother) and hardly shrinks.
/// Points on a border move along it, those where it bends by more than 15 degrees hardly at all. As VTK's
/// filter of that name with normalised coordinates. O(iterations m); bitwise independent of the number of
/// threads.
geometry::TriangleMesh smoothSurface(const geometry::TriangleMesh& mesh, int iterations, double passBand);

} // namespace viscera::medical_io
