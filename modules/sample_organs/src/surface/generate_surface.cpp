#include "surface/generate_surface.h"

#include <algorithm>
#include <cmath>

#include "surface/polygonise.h"
#include "surface/remesh.h"
#include "viscera/core/error.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/volume.h"

namespace viscera::sample_organs {
namespace {

using geometry::TriangleMesh;

constexpr double kSpacingPerEdge =
    1.05; // a raw mesh about as fine as the result keeps what the result can show
constexpr int kTries = 4;
constexpr double kFiner = 0.93; // a grid that is not aligned with the one before
constexpr Eigen::Index kProjectedAtOnce = 512;

/// Two sheets that pass through one cell can touch along an edge; another spacing tells them apart.
TriangleMesh manifoldRaw(const ImplicitNode& node, double spacing, Threads threads, Progress& progress) {
  for (int attempt = 0; attempt < kTries; ++attempt) {
    TriangleMesh raw = polygonise(node, spacing, threads, progress);
    const geometry::SurfaceReport report = geometry::checkSurface(raw);
    if (report.closed() && report.manifold())
      return raw;
    spacing *= kFiner;
  }
  throw DataError("the implicit surface touches itself", {}, "keep parts apart by twice the \"spacing\"");
}

TriangleMesh rawSurface(const ImplicitNode& node, const SurfaceGoal& goal, Threads threads,
                        Progress& progress) {
  TriangleMesh raw;
  const auto make = [&](double from, double to, double spacing) {
    runPart(progress, from, to, [&](Progress& part) { raw = manifoldRaw(node, spacing, threads, part); });
  };
  make(0, 0.5, goal.largestSpacing);
  const double edge = std::sqrt(geometry::area(raw.points, raw.triangles) / (kTriangleArea * goal.triangles));
  if (kSpacingPerEdge * edge < goal.largestSpacing)
    make(0.5, 1, kSpacingPerEdge * edge);
  return raw;
}

} // namespace

void paintSurface(const ImplicitNode& node, TriangleMesh& mesh, Threads threads) {
  mesh.colors.resize(mesh.points.rows(), 3);
  parallelRanges(mesh.points.rows(), kProjectedAtOnce, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index v = begin; v < end; ++v) {
      const Vec3 color = node.shade(mesh.points.row(v)).color;
      for (int k = 0; k < 3; ++k)
        mesh.colors(v, k) = static_cast<std::uint8_t>(std::lround(255 * std::clamp(color[k], 0.0, 1.0)));
    }
  });
}

TriangleMesh generateSurface(const ImplicitNode& node, const SurfaceGoal& goal, Threads threads,
                             Progress& progress) {
  TriangleMesh mesh;
  runPart(progress, 0, 0.4, [&](Progress& part) { mesh = rawSurface(node, goal, threads, part); });
  runPart(progress, 0.4, 0.98,
          [&](Progress& part) { mesh = remesh(mesh, node, goal.triangles, threads, part); });
  paintSurface(node, mesh, threads);
  progress.report(1);
  return mesh;
}

} // namespace viscera::sample_organs
