#include "viscera/coordinates/systems.h"

#include <algorithm>
#include <array>
#include <map>
#include <numbers>

#include <Eigen/Geometry>

#include "mean_value/triangle_share.h"
#include "nspace/direction_solver.h"
#include "viscera/coordinates/pointwise_system.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::coordinates {
namespace {

const Parameter kBlend{.name = "blend",
                       .maximum = 40,
                       .unit = "degrees",
                       .help = "How near to a flip the two triangulations are blended; 0 for not"};

/// Two triangles (a, b, c) and (b, a, d) of the triangulation, and how far they are from flipping, rad.
struct Quad {
  int a, b, c, d;
  double slack = 0;
  double share = 0; ///< Of the flipped pair, before neighbours are looked at.
};

using Edge = std::pair<int, int>;

double angleAt(const Points& units, int apex, int from, int to) {
  const Vec3 one = (units.row(from) - units.row(apex)).transpose();
  const Vec3 two = (units.row(to) - units.row(apex)).transpose();
  return std::atan2(one.cross(two).norm(), one.dot(two));
}

bool facesOut(const Points& units, int i, int j, int k) {
  const Vec3 first = units.row(i).transpose(), second = units.row(j).transpose();
  return first.cross(second).dot(units.row(k).transpose()) > kInPlane;
}

/// The edges that are nearer to a flip than `width`, rad.
std::map<Edge, Quad> quadsNearFlip(const Points& units, const Triangles& triangles, double width) {
  std::map<Edge, int> opposite;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int i = 0; i < 3; ++i)
      opposite[{triangles(t, i), triangles(t, (i + 1) % 3)}] = triangles(t, (i + 2) % 3);
  std::map<Edge, Quad> quads;
  for (const auto& [edge, c] : opposite) {
    const auto other = opposite.find({edge.second, edge.first});
    if (edge.first > edge.second || other == opposite.end())
      continue;
    // The four lie on one circle at a flip: the angles at c and d, opposite to the edge ab, sum up to pi
    // (thesis 3.1.1). slack = pi - (angle at c + angle at d).
    Quad quad{edge.first, edge.second, c, other->second};
    quad.slack = std::max(0.0, std::numbers::pi - angleAt(units, c, quad.a, quad.b) -
                                   angleAt(units, quad.d, quad.a, quad.b));
    if (quad.slack >= width || !facesOut(units, quad.a, quad.d, c) || !facesOut(units, quad.d, quad.b, c))
      continue;
    // mu = 1 - (3 t^2 - 2 t^3): 0 at slack = width, 1/2 at the flip.
    const double t = (1 + quad.slack / width) / 2;
    quad.share = 1 - t * t * (3 - 2 * t);
    quads[edge] = quad;
  }
  return quads;
}

void blend(const Points& units, const std::map<Edge, Quad>& quads, Values& beta) {
  // (1 - mu) A' + mu A'' = A' + mu (A'' - A'), with A' of the pair that is there and A'' of the flipped one
  // (thesis 3.1.1); a neighbour with mu' and slack' multiplies mu by 1 - 2 mu' slack / (slack + slack').
  for (const auto& [edge, quad] : quads) {
    double share = quad.share;
    for (const auto& side : {std::minmax(quad.a, quad.c), std::minmax(quad.b, quad.c),
                             std::minmax(quad.a, quad.d), std::minmax(quad.b, quad.d)})
      if (const auto rival = quads.find({side.first, side.second}); rival != quads.end()) {
        const double both = quad.slack + rival->second.slack;
        share *= both > 0 ? 1 - 2 * rival->second.share * quad.slack / both : 0.5;
      }
    Values change = Values::Zero(beta.size());
    addTriangleShare(units, {quad.a, quad.b, quad.c}, change);
    addTriangleShare(units, {quad.b, quad.a, quad.d}, change);
    change = -change;
    addTriangleShare(units, {quad.a, quad.d, quad.c}, change);
    addTriangleShare(units, {quad.d, quad.b, quad.c}, change);
    beta += share * change;
  }
}

/// `width`: how near to a flip is blended, rad.
bool balance(const HandleDirections& sight, double width, Values& beta) {
  const auto facets = geometry::hullFacets(sight.units);
  if (!facets)
    return false;
  for (Eigen::Index t = 0; t < facets->triangles.rows(); ++t)
    addTriangleShare(sight.units, facets->triangles.row(t), beta);
  if (width > 0)
    blend(sight.units, quadsNearFlip(sight.units, facets->triangles, width), beta);
  beta = beta.cwiseMax(0);
  return true;
}

} // namespace

/// Mean value coordinates over the Delaunay triangulation of the handles on the sphere around each point
/// (thesis 3.1.1). They jump where an edge of the triangulation flips. `blend` (degrees, 0 for none) mixes in
/// the flipped pair of triangles from where the two angles across an edge sum up to 180 degrees less `blend`,
/// with a share that rises from 0 to one half at the flip by a cubic without slope at its ends. (The thesis's
/// control points of that cubic do not meet in the middle; these do.) If several edges are near a flip at
/// once, the shares of those that are farther from it are reduced, so that the coordinates are continuous at
/// a flip and all shares stay positive. A wide blend may still jump where more flips coincide. One hull of n
/// points a point.
std::shared_ptr<const CoordinateSystem> delaunayApproach() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{
          .id = "delaunay-approach",
          .name = "Delaunay triangulation approach",
          .summary = "Mean value over the Delaunay triangles of the handles as each point sees them; jumps "
                     "where triangles flip, which blending reduces",
          .traits = {.positive = true, .interpolates = true, .continuous = false, .smooth = false},
          .parameters = {kBlend}},
      [](const HandleSet& handles, const ParameterValues& parameters) {
        return std::make_unique<DirectionSolver>(handles.positions,
                                                 [width = parameters.get(kBlend) * std::numbers::pi /
                                                          180](const HandleDirections& sight, Values& beta) {
                                                   return balance(sight, width, beta);
                                                 });
      });
}

} // namespace viscera::coordinates
