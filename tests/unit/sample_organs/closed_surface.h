#pragma once

#include <gtest/gtest.h>

#include "self_intersections.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/self_intersections.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::tests {

/// Expects one closed, coloured surface in order, which does not meet itself, and returns its report.
inline geometry::SurfaceReport expectClosedSurface(const geometry::TriangleMesh& mesh) {
  const geometry::SurfaceReport report = geometry::checkSurface(mesh);
  EXPECT_EQ(report.boundaryEdges, 0);
  EXPECT_EQ(report.nonManifoldEdges, 0);
  EXPECT_EQ(report.misorientedEdges, 0);
  EXPECT_EQ(report.degenerateTriangles, 0);
  EXPECT_EQ(report.unusedVertices, 0);
  EXPECT_EQ(report.components, 1);
  EXPECT_EQ(mesh.colors.rows(), mesh.points.rows());
  EXPECT_EQ(selfIntersections(mesh), 0);
  Progress progress;
  EXPECT_EQ(geometry::countSelfIntersections(mesh, progress), 0) << "what the program says of it";
  return report;
}

} // namespace viscera::tests
