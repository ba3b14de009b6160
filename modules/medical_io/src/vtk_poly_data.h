#pragma once

#include <vtkSmartPointer.h>

#include "viscera/geometry/triangle_mesh.h"

class vtkPolyData;

namespace viscera::medical_io {

/// A copy of the mesh for VTK's writers: double coordinates, triangles, colours as the scalars "Colors". O(n
/// + m).
vtkSmartPointer<vtkPolyData> polyDataOf(const geometry::TriangleMesh& mesh);

} // namespace viscera::medical_io
