#include "viscera/tracking/volume_equality.h"

#include <vector>

#include <Eigen/LU>

#include "viscera/geometry/volume.h"

namespace viscera::tracking {
namespace {

constexpr int kMostSteps = 12;
constexpr double kMetMl = 1e-6, kMetOfVolume = 1e-9;

/// The gradient of one surface's volume by every handle, ml / mm, at these vertices of it.
Points gradientOf(const MotionRig& rig, std::size_t surface, const Points& vertices,
                  const geometry::VertexTriangles& around) {
  Points byVertex;
  // v = W h makes dV/dh = W^T dV/dv.
  geometry::volumeGradient(vertices, rig.surfaces()[surface].triangles, around, byVertex, Threads{1});
  return rig.weights().middleRows(rig.firstRow(surface), rig.rows(surface)).transpose() * byVertex /
         kMm3PerMl;
}

} // namespace

VolumeResidual solveVolumes(const MotionRig& rig, const Values& wantedMl, const Metric& metric,
                            Points& pose) {
  const auto count = static_cast<Eigen::Index>(rig.surfaces().size());
  std::vector<geometry::VertexTriangles> around;
  for (const geometry::TriangleMesh& surface : rig.surfaces())
    around.push_back(geometry::vertexTriangles(surface.points.rows(), surface.triangles));
  VolumeResidual result;
  for (;; ++result.steps) {
    const Points vertices = rig.vertices(pose);
    result.missingMl = wantedMl - rig.volumesMl(vertices);
    result.met = (result.missingMl.array().abs() <= kMetMl).all() ||
                 (result.missingMl.array().abs() <= kMetOfVolume * wantedMl.array().abs()).all();
    if (result.met || result.steps == kMostSteps || !result.missingMl.allFinite())
      return result;
    std::vector<Points> gradients, directions;
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto surface = static_cast<std::size_t>(i);
      gradients.push_back(gradientOf(
          rig, surface, vertices.middleRows(rig.firstRow(surface), rig.rows(surface)), around[surface]));
      directions.push_back(metric(gradients.back()));
    }
    // min u^T N u / 2 with g_i . u = missing_i, N the fit's normal matrix, has u = sum a_j N^-1 g_j with
    // (g_i . N^-1 g_j) a = missing. The volumes are cubic in the pose, so that it takes a few rounds.
    Eigen::MatrixXd system(count, count);
    for (Eigen::Index i = 0; i < count; ++i)
      for (Eigen::Index j = 0; j < count; ++j)
        system(i, j) = gradients[static_cast<std::size_t>(i)]
                           .cwiseProduct(directions[static_cast<std::size_t>(j)])
                           .sum();
    const Values amounts = system.fullPivLu().solve(result.missingMl);
    for (Eigen::Index i = 0; i < count; ++i)
      pose += amounts[i] * directions[static_cast<std::size_t>(i)];
  }
}

} // namespace viscera::tracking
