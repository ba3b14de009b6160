#include "surface_clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#if __has_include(<CGAL/AABB_traits_3.h>) // Since CGAL 6.
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

namespace viscera::tests {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Primitive = CGAL::AABB_face_graph_triangle_primitive<Surface>;
#if __has_include(<CGAL/AABB_traits_3.h>)
using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
#else
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
#endif

Surface surfaceFrom(const geometry::TriangleMesh& mesh) {
  Surface surface;
  std::vector<Surface::Vertex_index> vertices;
  for (Eigen::Index i = 0; i < mesh.points.rows(); ++i)
    vertices.push_back(surface.add_vertex(Point(mesh.points(i, 0), mesh.points(i, 1), mesh.points(i, 2))));
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto vertex = [&](int corner) {
      return vertices[static_cast<std::size_t>(mesh.triangles(t, corner))];
    };
    surface.add_face(vertex(0), vertex(1), vertex(2));
  }
  return surface;
}

double clearance(const geometry::TriangleMesh& mesh, const Points& points, CGAL::Bounded_side wanted) {
  const Surface surface = surfaceFrom(mesh);
  Tree tree(faces(surface).first, faces(surface).second, surface);
  tree.accelerate_distance_queries();
  const CGAL::Side_of_triangle_mesh<Surface, Kernel> sideOf(tree);
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    const Point point(points(i, 0), points(i, 1), points(i, 2));
    const double distance = std::sqrt(tree.squared_distance(point));
    least = std::min(least, sideOf(point) == wanted ? distance : -distance);
  }
  return least;
}

} // namespace

double clearanceInsideOf(const geometry::TriangleMesh& surface, const Points& points) {
  return clearance(surface, points, CGAL::ON_BOUNDED_SIDE);
}

double clearanceOutsideOf(const geometry::TriangleMesh& surface, const Points& points) {
  return clearance(surface, points, CGAL::ON_UNBOUNDED_SIDE);
}

} // namespace viscera::tests
