#include "viscera/geometry/surface_check.h"

#include <algorithm>
#include <cstdint>

#include "viscera/geometry/connected_pieces.h"
#include "viscera/geometry/volume.h"

namespace viscera::geometry {
namespace {

constexpr double kSmallestRelativeArea = 1e-12;

/// An edge as a sortable number, smaller vertex first; `forward` says how its triangle runs through it.
struct EdgeUse {
  std::uint64_t edge;
  bool forward;
};

std::vector<EdgeUse> sortedEdgeUses(const Triangles& triangles) {
  std::vector<EdgeUse> uses;
  uses.reserve(static_cast<std::size_t>(triangles.size()));
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      const auto a = static_cast<std::uint64_t>(triangles(t, k));
      const auto b = static_cast<std::uint64_t>(triangles(t, (k + 1) % 3));
      uses.push_back({std::min(a, b) << 32 | std::max(a, b), a < b});
    }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& x, const EdgeUse& y) { return x.edge < y.edge; });
  return uses;
}

void countEdges(const Triangles& triangles, SurfaceReport& report) {
  const auto uses = sortedEdgeUses(triangles);
  for (std::size_t begin = 0; begin < uses.size();) {
    std::size_t end = begin + 1;
    while (end < uses.size() && uses[end].edge == uses[begin].edge)
      ++end;
    const auto count = end - begin;
    if (count == 1)
      ++report.boundaryEdges;
    else if (count > 2)
      ++report.nonManifoldEdges;
    else if (uses[begin].forward == uses[begin + 1].forward)
      ++report.misorientedEdges;
    begin = end;
  }
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
    const Vec3 a = mesh.points.row(i[0]).transpose();
    const Vec3 b = mesh.points.row(i[1]).transpose();
    const Vec3 c = mesh.points.row(i[2]).transpose();
    const bool repeated = i[0] == i[1] || i[1] == i[2] || i[2] == i[0];
    if (repeated || (b - a).cross(c - a).norm() / 2 <= kSmallestRelativeArea * size * size)
      ++count;
  }
  return count;
}

std::string counted(int count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
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

std::vector<std::string> faults(const SurfaceReport& report) {
  std::vector<std::string> list;
  if (report.boundaryEdges > 0)
    list.push_back(counted(report.boundaryEdges, "boundary edge", "boundary edges") +
                   ": the surface is open and has no volume");
  if (report.nonManifoldEdges > 0)
    list.push_back(counted(report.nonManifoldEdges, "edge joins", "edges join") + " more than two triangles");
  if (report.misorientedEdges > 0)
    list.push_back(counted(report.misorientedEdges, "edge lies", "edges lie") +
                   " between triangles of opposite orientation");
  if (report.degenerateTriangles > 0)
    list.push_back(counted(report.degenerateTriangles, "triangle has", "triangles have") + " no area");
  if (report.components > 1)
    list.push_back("the surface consists of " + std::to_string(report.components) + " separate pieces");
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
