#include "viscera/live/elastic_comparison.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "viscera/core/error.h"

namespace viscera::live {
namespace {

/// A regular tetrahedron with edge h has the volume h^3 / 8.5.
constexpr double kEdgesCubed = 8.485;

/// The value below which a part of the sorted numbers lies.
double apartBelow(const std::vector<double>& sorted, double part) {
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

SurfacesApart summedUp(const Values& distances) {
  std::vector<double> sorted(distances.begin(), distances.end());
  std::sort(sorted.begin(), sorted.end());
  return {apartBelow(sorted, 0.5), apartBelow(sorted, 0.95), sorted.back()};
}

/// Lets the patches move as the posed surface does at their nodes.
void gripPosedSurface(const elasticity::ElasticOrgan& organ, const ElasticQuestion& question,
                      elasticity::Grips& grips) {
  const Points& nodes = organ.body().mesh().nodes;
  std::int32_t last = -1;
  Eigen::Index vertex = 0;
  for (elasticity::Prescribed& one : grips.prescribed) {
    if (one.node != last)
      (question.surface.rowwise() - nodes.row(one.node)).rowwise().squaredNorm().minCoeff(&vertex);
    last = one.node;
    one.displacementMm = question.posed(vertex, one.axis) - question.surface(vertex, one.axis);
  }
}

/// The slope of a straight line through points, by least squares.
double slopeOf(const std::vector<std::pair<double, double>>& points) {
  double x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [at, value] : points) {
    x += at;
    y += value;
    xx += at * at;
    xy += at * value;
  }
  const auto n = static_cast<double>(points.size());
  return (n * xy - x * y) / (n * xx - x * x);
}

double orderOf(const std::vector<MeshOfSize>& meshes) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i + 1 < meshes.size(); ++i)
    if (meshes[i].fromFinest.medianMm > 0)
      points.emplace_back(std::log(meshes[i].edgeMm), std::log(meshes[i].fromFinest.medianMm));
  return points.size() < 2 ? std::numeric_limits<double>::quiet_NaN() : slopeOf(points);
}

} // namespace

SurfacesApart surfacesApart(const Points& a, const Points& b) {
  return summedUp((a - b).rowwise().norm());
}

ElasticComparison besideElasticity(const elasticity::ElasticOrgan& organ, const ElasticQuestion& question,
                                   Progress& progress) {
  ElasticComparison comparison;
  comparison.grips = elasticity::gripsOf(organ, question.rest, question.pose, question.grips);
  if (question.gripSurface)
    gripPosedSurface(organ, question, comparison.grips);
  elasticity::SolveOptions options;
  options.threads = question.threads;
  comparison.solution =
      elasticity::solveStatic(organ.body(), {comparison.grips.prescribed, {}}, options, progress);
  comparison.elastic = question.surface + organ.atSurface(comparison.solution.displacements);
  comparison.distancesMm = (comparison.elastic - question.posed).rowwise().norm();
  comparison.apart = summedUp(comparison.distancesMm);
  return comparison;
}

MeshConvergence meshConvergence(const geometry::TriangleMesh& surface,
                                const std::shared_ptr<const elasticity::Material>& material,
                                const std::vector<int>& sizes, const ElasticQuestion& question,
                                Progress& progress) {
  if (sizes.size() < 2)
    throw UsageError("one mesh says nothing about the others", {}, "give two sizes at least");
  std::vector<std::pair<MeshOfSize, Points>> solved;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const auto part = [&sizes](std::size_t at) {
      return static_cast<double>(at) / static_cast<double>(sizes.size());
    };
    runPart(progress, part(i), part(i + 1), [&](Progress& inner) {
      const auto begin = std::chrono::steady_clock::now();
      elasticity::OrganOptions options;
      options.tetrahedra = sizes[i];
      const elasticity::ElasticOrgan organ(surface, options, material, inner);
      ElasticComparison comparison = besideElasticity(organ, question, inner);
      MeshOfSize mesh;
      mesh.tetrahedra = organ.body().mesh().tetrahedra.rows();
      mesh.edgeMm = std::cbrt(kEdgesCubed * organ.body().volumeMm3() / static_cast<double>(mesh.tetrahedra));
      mesh.fromPose = comparison.apart;
      mesh.smallestJacobian = comparison.solution.smallestJacobian;
      mesh.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      solved.emplace_back(mesh, std::move(comparison.elastic));
    });
  }
  std::stable_sort(solved.begin(), solved.end(),
                   [](const auto& a, const auto& b) { return a.first.tetrahedra < b.first.tetrahedra; });
  MeshConvergence convergence;
  for (auto& [mesh, elastic] : solved) {
    mesh.fromFinest = surfacesApart(elastic, solved.back().second);
    convergence.meshes.push_back(mesh);
  }
  convergence.order = orderOf(convergence.meshes);
  return convergence;
}

} // namespace viscera::live
