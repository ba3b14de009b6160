#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "shapes.h"
#include "viscera/tracking/mask.h"
#include "viscera/tracking/surface_series.h"

/// A beating organ with a cavity whose motion is known in full.
namespace viscera::tests {

/// The cavity of a shell of muscle, `part` of the way through its beat: it becomes narrower, while the
/// outside moves little, as in a heart.
inline Points cavityAt(const Points& rest, double part) {
  const double squeeze = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * part);
  Points moved = rest;
  moved.leftCols<2>() *= 1 - 0.3 * squeeze;
  moved.col(2) *= 1 - 0.1 * squeeze;
  return moved;
}

inline Points outsideAt(const Points& rest, double part) {
  const double squeeze = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * part);
  Points moved = rest;
  moved.leftCols<2>() *= 1 - 0.06 * squeeze;
  moved.col(2) *= 1 - 0.08 * squeeze;
  return moved;
}

/// "outer", a ball of 40 mm, and "cavity", one of 25 mm, in `phases` phases.
inline std::vector<tracking::SurfaceSeries> beatingShell(std::size_t phases, int levels = 3) {
  const geometry::TriangleMesh outer = sphere(levels, 40), cavity = sphere(levels, 25);
  std::vector<tracking::SurfaceSeries> series = {{"outer", outer.triangles, {}},
                                                 {"cavity", cavity.triangles, {}}};
  for (std::size_t phase = 0; phase < phases; ++phase) {
    const double part = static_cast<double>(phase) / static_cast<double>(phases);
    series[0].phases.push_back(outsideAt(outer.points, part));
    series[1].phases.push_back(cavityAt(cavity.points, part));
  }
  return series;
}

/// An empty grid around the shell.
inline tracking::Mask gridAround(const Vec3& spacing, double halfMm = 50) {
  tracking::Mask grid;
  for (int axis = 0; axis < 3; ++axis)
    grid.size[static_cast<std::size_t>(axis)] = static_cast<int>(2 * halfMm / spacing[axis]);
  grid.indexToLps = Eigen::Translation3d(Vec3::Constant(-halfMm) + spacing / 2) * Eigen::Scaling(spacing);
  grid.inside.assign(std::size_t(grid.size[0]) * std::size_t(grid.size[1]) * std::size_t(grid.size[2]), 0);
  return grid;
}

} // namespace viscera::tests
