#include "viscera/elasticity/elastic_organ.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

#include "tetrahedron_rule.h"
#include "viscera/core/error.h"
#include "viscera/deformation/tetrahedralise.h"
#include "viscera/deformation/witness_interpolation.h"
#include "viscera/geometry/decimate_surface.h"
#include "viscera/geometry/split_edges.h"
#include "viscera/geometry/surface_check.h"

namespace viscera::elasticity {
namespace {

/// A regular tetrahedron with edge h has the volume h^3 / 8.5, a triangle the area 0.433 h^2.
constexpr double kTetrahedra = 8.5, kTriangleArea = 0.433;
constexpr int kFewestTriangles = 60;
/// TetGen's tetrahedra are smaller than the largest volume that it is given by about this factor.
constexpr double kBelowLargest = 0.5;
/// Longer edges of a surface than so many of a tetrahedron are halved, up to so many times the triangles:
/// TetGen keeps the triangles of a surface as they are.
constexpr double kLongEdge = 1.6;
constexpr int kMostSplit = 2;
/// TetGen refuses some simplified surfaces; each further attempt has twice the triangles.
constexpr int kAttempts = 4;

double areaOf(const geometry::TriangleMesh& mesh) {
  double area = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Vec3 a = mesh.points.row(mesh.triangles(t, 0)), b = mesh.points.row(mesh.triangles(t, 1)),
               c = mesh.points.row(mesh.triangles(t, 2));
    area += 0.5 * (b - a).cross(c - a).norm();
  }
  return area;
}

deformation::WitnessMesh filled(const geometry::TriangleMesh& surface, const OrganOptions& options,
                                Progress& progress) {
  const geometry::SurfaceReport report = geometry::checkSurface(surface);
  if (!report.closed())
    throw DataError("the surface is open, so it has no inside", {}, "close its holes first");
  const double volume = std::abs(report.volumeMm3);
  const double edge = std::cbrt(kTetrahedra * volume / std::max(1, options.tetrahedra));
  int triangles =
      std::max(kFewestTriangles, static_cast<int>(areaOf(surface) / (kTriangleArea * edge * edge)));
  std::optional<deformation::TetrahedraError> refusal;
  for (int attempt = 0; attempt < kAttempts; ++attempt, triangles *= 2) {
    const bool simplified = triangles < surface.triangles.rows();
    try {
      deformation::TetrahedraOptions tetgen;
      tetgen.maxVolumeMm3 = volume / std::max(1, options.tetrahedra) / kBelowLargest;
      tetgen.timeLimitSeconds = options.timeLimitSeconds;
      const geometry::TriangleMesh fitting =
          simplified ? geometry::decimateClosedSurface(surface, triangles, progress)
                     : geometry::splitLongEdges(surface, kLongEdge * edge, kMostSplit * triangles);
      return deformation::tetrahedralise(fitting, tetgen, progress);
    } catch (const deformation::TetrahedraError& error) {
      refusal = error;
      if (!simplified || error.reason() != deformation::TetrahedraError::Reason::refused)
        throw;
    }
  }
  throw *refusal;
}

using EdgeNodes = std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t>;

EdgeNodes edgeNodesOf(const QuadraticMesh& mesh) {
  EdgeNodes nodes;
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t)
    for (int e = 0; e < 6; ++e) {
      const auto [low, high] = std::minmax(mesh.tetrahedra(t, kEdges[std::size_t(e)][0]),
                                           mesh.tetrahedra(t, kEdges[std::size_t(e)][1]));
      nodes[{low, high}] = mesh.tetrahedra(t, 4 + e);
    }
  return nodes;
}

/// The node of the skin that is nearest to each handle, `handles x 3`.
Points feetOf(const ElasticOrgan& organ, const Points& handles) {
  const Points& nodes = organ.body().mesh().nodes;
  Points feet(handles.rows(), 3);
  for (Eigen::Index h = 0; h < handles.rows(); ++h) {
    const auto distance = [&](std::int32_t node) { return (nodes.row(node) - handles.row(h)).squaredNorm(); };
    feet.row(h) = nodes.row(*std::min_element(organ.skin().begin(), organ.skin().end(),
                                              [&](auto a, auto b) { return distance(a) < distance(b); }));
  }
  return feet;
}

/// Moved handles, then those at rest that grip: no patch is held within `clear` of a moved one, where the
/// tissue would tear.
std::vector<Eigen::Index> grippingHandles(const Points& rest, const Points& pose, const Points& feet,
                                          const GripOptions& options, double clear) {
  std::vector<Eigen::Index> gripping;
  for (Eigen::Index h = 0; h < rest.rows(); ++h)
    if (pose.row(h) != rest.row(h))
      gripping.push_back(h);
  const std::vector<Eigen::Index> moved = gripping;
  if (!options.holding.empty()) {
    for (const int h : options.holding)
      if (pose.row(h) == rest.row(h))
        gripping.push_back(h);
    return gripping;
  }
  for (Eigen::Index h = 0; h < rest.rows() && options.others == GripOptions::Others::held; ++h)
    if (pose.row(h) == rest.row(h) && std::all_of(moved.begin(), moved.end(), [&](Eigen::Index m) {
          return (feet.row(h) - feet.row(m)).norm() >= clear;
        }))
      gripping.push_back(h);
  return gripping;
}

} // namespace

ElasticOrgan::ElasticOrgan(const geometry::TriangleMesh& surface, const OrganOptions& options,
                           std::shared_ptr<const Material> material, Progress& progress) {
  const deformation::WitnessMesh solid = filled(surface, options, progress);
  const QuadraticMesh mesh = quadraticMesh(solid.points, solid.tetrahedra);
  const EdgeNodes middles = edgeNodesOf(mesh);
  const deformation::WitnessInterpolation places(solid, surface.points);
  vertices_.reserve(static_cast<std::size_t>(surface.points.rows()));
  for (Eigen::Index v = 0; v < surface.points.rows(); ++v) {
    Weights weights;
    Eigen::Vector4d at;
    int next = 0;
    places.visitCorners(v, [&](Eigen::Index corner, double weight) {
      weights.nodes[std::size_t(next)] = static_cast<std::int32_t>(corner);
      at[next++] = weight;
    });
    for (int e = 0; e < 6; ++e) {
      const auto [low, high] = std::minmax(weights.nodes[std::size_t(kEdges[std::size_t(e)][0])],
                                           weights.nodes[std::size_t(kEdges[std::size_t(e)][1])]);
      const auto found = middles.find({low, high});
      weights.nodes[std::size_t(4 + e)] = found == middles.end() ? low : found->second;
    }
    weights.shapes = quadraticShapes(at);
    vertices_.push_back(weights);
  }
  for (const Face& face : boundaryFaces(mesh))
    for (const int local : nodesOfFace(face.opposite))
      skin_.push_back(mesh.tetrahedra(face.tetrahedron, local));
  std::sort(skin_.begin(), skin_.end());
  skin_.erase(std::unique(skin_.begin(), skin_.end()), skin_.end());
  body_ = std::make_shared<const ElasticBody>(mesh, std::move(material));
}

Points ElasticOrgan::atSurface(const Points& nodeDisplacements) const {
  Points at = Points::Zero(static_cast<Eigen::Index>(vertices_.size()), 3);
  for (std::size_t v = 0; v < vertices_.size(); ++v)
    for (int a = 0; a < 10; ++a)
      at.row(static_cast<Eigen::Index>(v)) +=
          vertices_[v].shapes[a] * nodeDisplacements.row(vertices_[v].nodes[std::size_t(a)]);
  return at;
}

Grips gripsOf(const ElasticOrgan& organ, const Points& rest, const Points& pose, const GripOptions& options) {
  constexpr std::size_t kFewestNodes = 3; // They hold a body against turning.
  const Points& nodes = organ.body().mesh().nodes;
  const double radius = options.radius * boundsOf(nodes).diagonal();
  const Points feet = feetOf(organ, rest);
  Grips grips;
  std::map<std::int32_t, std::pair<double, Eigen::Index>> owners; // Of each node: distance and handle.
  const std::vector<Eigen::Index> gripping = grippingHandles(rest, pose, feet, options, 2 * radius);
  for (Eigen::Index h = 0; h < rest.rows(); ++h)
    if (std::find(gripping.begin(), gripping.end(), h) == gripping.end())
      grips.loose.push_back(static_cast<int>(h));
  for (const Eigen::Index h : gripping) {
    std::vector<std::pair<double, std::int32_t>> near;
    for (const std::int32_t node : organ.skin())
      near.push_back({(nodes.row(node) - feet.row(h)).norm(), node});
    std::sort(near.begin(), near.end());
    for (std::size_t i = 0; i < near.size() && (i < kFewestNodes || near[i].first <= radius); ++i) {
      const auto [entry, added] = owners.try_emplace(near[i].second, near[i].first, h);
      if (!added && near[i].first < entry->second.first)
        entry->second = {near[i].first, h};
    }
    ++(pose.row(h) != rest.row(h) ? grips.moved : grips.held);
    grips.dragMm = std::max(grips.dragMm, (pose.row(h) - rest.row(h)).norm());
  }
  if (grips.moved == 0)
    throw DataError("the pose moves no handle", {}, "move a handle by hand or by --pose");
  for (const auto& [node, owner] : owners)
    for (int axis = 0; axis < 3; ++axis)
      grips.prescribed.push_back({node, axis, pose(owner.second, axis) - rest(owner.second, axis)});
  return grips;
}

} // namespace viscera::elasticity
