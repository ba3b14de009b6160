#include "viscera/geometry/surface_check.h"

#include <algorithm>

#include "edge_uses.h"
#include "smallest_area.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/connected_pieces.h"
#include "viscera/geometry/volume.h"

namespace viscera::geometry {
namespace {

void countEdges(const Triangles& triangles, SurfaceReport& report) {
  forEachEdge(triangles, [&](std::span<const EdgeUse> uses) {
    if (uses.size() == 1)
      ++report.boundaryEdges;
    else if (uses.size() > 2)
      ++report.nonManifoldEdges;
    else if (uses[0].forward == uses[1].forward)
      ++report.misorientedEdges;
  });
}

void countComponents(const TriangleMesh& mesh, SurfaceReport& report) {
  const ConnectedPieces pieces = connectedPieces(mesh);
  report.components = pieces.count;
  report.unusedVertices = static_cast<int>(std::count(pieces.ofVertex.begin(), pieces.ofVertex.end(), -1));
}

int countDegenerate(const TriangleMesh& mesh) {
  const double size = boundsOf(mesh.points).diagonal();
  int count = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto i = mesh.triangles.row(t);
    const bool repeated = i[0] == i[1] || i[1] == i[2] || i[2] == i[0];
    if (repeated || areaOf(mesh.points, mesh.triangles, t) <= kSmallestRelativeArea * size * size)
      ++count;
  }
  return count;
}

} // namespace

SurfaceReport checkSurface(const TriangleMesh& mesh) {
  SurfaceReport report;
  countEdges(mesh.triangles, report);
  countComponents(mesh, report);
  report.degenerateTriangles = countDegenerate(mesh);
  report.volumeMm3 = volume(mesh.points, mesh.triangles);
  report.areaMm2 = area(mesh.points, mesh.triangles);
  return report;
}

std::vector<Text> faults(const SurfaceReport& report) {
  std::vector<Text> list;
  if (report.boundaryEdges > 0)
    list.push_back(
        phrase("%n boundary {edge|edges}: the surface is open and has no volume", report.boundaryEdges));
  if (report.nonManifoldEdges > 0)
    list.push_back(phrase("%n {edge joins|edges join} more than two triangles", report.nonManifoldEdges));
  if (report.misorientedEdges > 0)
    list.push_back(phrase("%n {edge lies|edges lie} between triangles of opposite orientation",
                          report.misorientedEdges));
  if (report.degenerateTriangles > 0)
    list.push_back(phrase("%n {triangle has|triangles have} no area", report.degenerateTriangles));
  if (report.components > 1)
    list.push_back(phrase("the surface consists of %1 separate pieces", report.components));
  if (report.closed() && report.volumeMm3 < 0)
    list.push_back("the surface is inside out");
  return list;
}

bool orientOutward(TriangleMesh& mesh) {
  if (volume(mesh.points, mesh.triangles) >= 0)
    return false;
  mesh.triangles.col(1).swap(mesh.triangles.col(2));
  return true;
}

} // namespace viscera::geometry
