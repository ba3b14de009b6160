#pragma once

#include <vtkSmartPointer.h>

#include "viscera/geometry/triangle_mesh.h"

class vtkPolyData;

namespace viscera::medical_io {

/// A copy of the mesh for VTK's writers: double coordinates, triangles, colours as the scalars "Colors". O(n
/// + m).
vtkSmartPointer<vtkPolyData> polyDataOf(const geometry::TriangleMesh& mesh);

/// The surface with its points moved by a windowed sinc filter (Taubin et al. 1996, doi 10.1007/BFb0015551),
/// which takes away what changes faster than `passBand` (0 to 2; smaller is smoother) and hardly shrinks.
/// O(iterations m).
geometry::TriangleMesh smoothSurface(const geometry::TriangleMesh& mesh, int iterations, double passBand);

} // namespace viscera::medical_io
