#include "open_surface.h"

#include <memory>

namespace viscera::strain {
namespace {

Triangles chosen(const Triangles& triangles, const std::vector<bool>& flags, bool wanted) {
  Triangles result(triangles.rows(), 3);
  Eigen::Index kept = 0;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    if (flags[static_cast<std::size_t>(t)] == wanted)
      result.row(kept++) = triangles.row(t);
  result.conservativeResize(kept, 3);
  return result;
}

} // namespace

OpenSurface::OpenSurface(const Points& points, const Triangles& triangles, const std::vector<bool>& leftOut)
    : distance_(std::make_shared<const geometry::TriangleMesh>(
          geometry::TriangleMesh{points, withoutMarked(triangles, leftOut), {}})) {}

Triangles withoutMarked(const Triangles& triangles, const std::vector<bool>& leftOut) {
  return leftOut.empty() ? triangles : chosen(triangles, leftOut, false);
}

Triangles onlyMarked(const Triangles& triangles, const std::vector<bool>& marked) {
  return chosen(triangles, marked, true);
}

} // namespace viscera::strain
