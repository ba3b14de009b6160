#pragma once

#include <cmath>
#include <numbers>

#include "viscera/geometry/clean_surface.h"
#include "viscera/geometry/close_holes.h"
#include "viscera/geometry/triangle_mesh.h"

/// A ball with a round opening, whose wall glides over the ball as the opening widens: its shape hardly
/// tells.
namespace viscera::tests {

inline constexpr double kOpenBallMm = 40;

/// The opening reaches `opening` radians down from the ball's top; `around` vertices on each of `rings`
/// rings. Its cap is flat. The first ring is the rim, and rings are spread evenly from there to the bottom.
inline geometry::ClosedSurface openBall(double opening, int rings, int around, double turn = 0) {
  geometry::TriangleMesh mesh;
  mesh.points.resize(rings * around + 1, 3);
  mesh.triangles.resize((2 * rings - 1) * around, 3);
  const auto at = [around](int ring, int place) {
    return static_cast<std::int32_t>(ring * around + place % around);
  };
  Eigen::Index triangle = 0;
  for (int ring = 0; ring < rings; ++ring)
    for (int place = 0; place < around; ++place) {
      const double down = opening + (std::numbers::pi - opening) * ring / rings;
      const double angle = turn + 2 * std::numbers::pi * place / around;
      mesh.points.row(at(ring, place)) << kOpenBallMm * std::sin(down) * std::cos(angle),
          kOpenBallMm * std::sin(down) * std::sin(angle), kOpenBallMm * std::cos(down);
      if (ring + 1 == rings) {
        mesh.triangles.row(triangle++) << at(ring, place), at(rings, 0), at(ring, place + 1);
        continue;
      }
      mesh.triangles.row(triangle++) << at(ring, place), at(ring + 1, place), at(ring, place + 1);
      mesh.triangles.row(triangle++) << at(ring, place + 1), at(ring + 1, place), at(ring + 1, place + 1);
    }
  mesh.points.row(at(rings, 0)) << 0, 0, -kOpenBallMm;
  geometry::faceOutward(mesh);
  geometry::ClosedSurface closed = geometry::closeHoles(mesh);
  geometry::faceOutward(closed.mesh);
  return closed;
}

} // namespace viscera::tests
