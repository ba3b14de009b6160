#pragma once

#include <cmath>
#include <numbers>
#include <optional>

#include "build_paths.h"
#include "shared_organs.h"
#include "viscera/deformation/place_handles.h"

/// Surfaces for benchmarks, with the sizes that the thesis and other programs use.
namespace viscera::bench {

/// A lumpy closed surface of `rings * segments + 2` vertices, about 100 mm across.
inline geometry::TriangleMesh blob(int rings, int segments) {
  geometry::TriangleMesh mesh;
  mesh.points.resize(rings * segments + 2, 3);
  const auto radius = [](double theta, double phi) {
    return 50 *
           (1 + 0.12 * std::sin(3 * theta) * std::cos(2 * phi) + 0.05 * std::sin(theta) * std::sin(7 * phi));
  };
  for (int ring = 0; ring < rings; ++ring)
    for (int segment = 0; segment < segments; ++segment) {
      const double theta = std::numbers::pi * (ring + 1) / (rings + 1);
      const double phi = 2 * std::numbers::pi * segment / segments;
      mesh.points.row(ring * segments + segment)
          << radius(theta, phi) * Eigen::RowVector3d(std::sin(theta) * std::cos(phi),
                                                     std::sin(theta) * std::sin(phi), std::cos(theta));
    }
  const int north = rings * segments, south = north + 1;
  mesh.points.row(north) << 0, 0, radius(0, 0);
  mesh.points.row(south) << 0, 0, -radius(std::numbers::pi, 0);

  mesh.triangles.resize(2 * rings * segments, 3);
  Eigen::Index next = 0;
  for (int segment = 0; segment < segments; ++segment) {
    const int right = (segment + 1) % segments, last = (rings - 1) * segments;
    mesh.triangles.row(next++) << north, segment, right;
    mesh.triangles.row(next++) << south, last + right, last + segment;
    for (int ring = 0; ring + 1 < rings; ++ring) {
      const int above = ring * segments, below = above + segments;
      mesh.triangles.row(next++) << above + segment, below + segment, below + right;
      mesh.triangles.row(next++) << above + segment, below + right, above + right;
    }
  }
  return mesh;
}

/// Of the largest model of the thesis's tables.
inline constexpr Eigen::Index kMostVertices = 172974;

/// A blob of `kMostVertices` vertices and 345,944 triangles.
inline geometry::TriangleMesh largeBlob() {
  return blob(332, 521);
}

/// The Stanford bunny, or a blob of about as many vertices where it is absent.
inline geometry::TriangleMesh bunnyOrBlob() {
  const auto bunny = tests::bunny(VISCERA_SHARED_ORGANS);
  return bunny ? *bunny : blob(155, 232);
}

/// 30 handles, placed as by the program.
inline Points handlesFor(const geometry::TriangleMesh& mesh) {
  return deformation::placeHandles(mesh);
}

} // namespace viscera::bench
