#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "shapes.h"
#include "viscera/medical_io/surface_file.h"

namespace viscera::medical_io::test {

/// A coloured sphere of 50 mm around a point off the origin, whose coordinates have no short decimal form.
inline geometry::TriangleMesh organ(int levels = 2) {
  geometry::TriangleMesh mesh = tests::sphere(levels, 50, {10.1, -20.2, 1.0 / 3.0});
  mesh.colors.resize(mesh.points.rows(), 3);
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    mesh.colors.row(v) << static_cast<std::uint8_t>(v % 256), static_cast<std::uint8_t>(7 * v % 256),
        static_cast<std::uint8_t>(255 - v % 256);
  return mesh;
}

/// The largest distance between equal corners of equal triangles; the points may be numbered differently.
inline double cornerDistance(const geometry::TriangleMesh& a, const geometry::TriangleMesh& b) {
  if (a.triangles.rows() != b.triangles.rows())
    return HUGE_VAL;
  double largest = 0;
  for (Eigen::Index t = 0; t < a.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      largest = std::max(
          largest, (a.points.row(a.triangles(t, k)) - b.points.row(b.triangles(t, k))).cwiseAbs().maxCoeff());
  return largest;
}

inline bool warnsOf(const SurfaceFile& surface, const std::string& words) {
  return std::any_of(surface.warnings.begin(), surface.warnings.end(),
                     [&](const Text& warning) { return warning.english().find(words) != std::string::npos; });
}

} // namespace viscera::medical_io::test
