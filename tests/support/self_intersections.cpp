#include "self_intersections.h"

#include <stdexcept>
#include <utility>
#include <vector>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/intersection.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Surface_mesh.h>

namespace viscera::tests {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

Surface surfaceOf(const geometry::TriangleMesh& mesh) {
  Surface surface;
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    surface.add_vertex({mesh.points(v, 0), mesh.points(v, 1), mesh.points(v, 2)});
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto corner = [&](int k) {
      return Surface::Vertex_index(static_cast<Surface::size_type>(mesh.triangles(t, k)));
    };
    if (surface.add_face(corner(0), corner(1), corner(2)) == Surface::null_face())
      throw std::invalid_argument("triangle " + std::to_string(t) + " makes the surface not manifold");
  }
  return surface;
}

} // namespace

int selfIntersections(const geometry::TriangleMesh& mesh) {
  std::vector<std::pair<Surface::Face_index, Surface::Face_index>> pairs;
  CGAL::Polygon_mesh_processing::self_intersections(surfaceOf(mesh), std::back_inserter(pairs));
  return static_cast<int>(pairs.size());
}

bool surfacesMeet(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b) {
  return CGAL::Polygon_mesh_processing::do_intersect(surfaceOf(a), surfaceOf(b));
}

} // namespace viscera::tests
