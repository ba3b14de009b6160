#include "viscera/coordinates/systems.h"

#include <algorithm>
#include <map>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "choice_parameter.h"
#include "mean_value/triangle_share.h"
#include "nspace/direction_solver.h"
#include "sphere/plane_neighbours.h"
#include "viscera/coordinates/pointwise_system.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::coordinates {
namespace {

enum class Transfer { naturalNeighbour, sphericalBarycentric, laguerre };

const Parameter kTransfer = choiceParameter("transfer", "How the Voronoi vertices' weights reach the handles",
                                            {"natural-neighbour", "spherical-barycentric", "laguerre"});

/// Part of the largest distance: nearer handles weigh no more in the Laguerre diagram.
constexpr double kNearest = 1e-6;
/// Cosine from -1: a handle right behind the vertex has no place in the plane.
constexpr double kBehind = 1e-9;

struct Regions {
  Transfer transfer;

  bool operator()(const HandleDirections& sight, Values& beta) const {
    const Values nearness = sight.distances / sight.distances.maxCoeff();
    Points sites = sight.units;
    if (transfer == Transfer::laguerre)
      sites.array().colwise() /= nearness.array().max(kNearest);
    const auto facets = geometry::hullFacets(sites);
    if (!facets)
      return false;
    const Eigen::Index count = beta.size();
    Points corners(count + facets->planes.rows(), 3); // The handles, then the Voronoi vertices.
    corners << sight.units, facets->planes.leftCols<3>();
    Values weights = Values::Zero(corners.rows());
    addRegions(corners, facets->triangles, weights);
    beta = weights.head(count);
    Values shares(count);
    for (Eigen::Index vertex = 0; vertex < facets->planes.rows(); ++vertex) {
      if (weights[count + vertex] == 0)
        continue;
      const Vec3 at = corners.row(count + vertex).transpose();
      // omega_i = omega_V,i + sum over the vertices of share_i omega_V,vertex (thesis 3.1.2).
      const bool found = transfer == Transfer::sphericalBarycentric
                             ? amongThree(sight.units, facets->triangles.row(vertex), at, shares)
                             : amongNeighbours(sight.units, nearness, at, shares);
      if (!found)
        return false;
      beta += weights[count + vertex] * shares;
    }
    return true;
  }

  /// Each edge between two handles is crossed by one between two Voronoi vertices: two triangles.
  static void addRegions(const Points& corners, const Triangles& triangles, Values& weights) {
    const auto count = static_cast<int>(corners.rows() - triangles.rows());
    std::map<std::pair<int, int>, int> left;
    for (int t = 0; t < static_cast<int>(triangles.rows()); ++t)
      for (int i = 0; i < 3; ++i)
        left[{triangles(t, i), triangles(t, (i + 1) % 3)}] = t;
    for (const auto& [edge, t] : left)
      if (const auto right = left.find({edge.second, edge.first}); right != left.end())
        addTriangleShare(corners, {edge.first, count + right->second, count + t}, weights);
  }

  static bool amongThree(const Points& units, const Eigen::RowVector3i& triangle, const Vec3& at,
                         Values& shares) {
    Eigen::Matrix3d frame, inverse;
    for (int i = 0; i < 3; ++i)
      frame.col(i) = units.row(triangle[i]).transpose();
    double volume = 0;
    bool invertible = false;
    frame.computeInverseAndDetWithCheck(inverse, volume, invertible, kInPlane);
    if (!invertible)
      return false;
    const Vec3 own = inverse * at; // at = b_i u_i + b_j u_j + b_k u_k.
    shares.setZero();
    for (int i = 0; i < 3; ++i)
      shares[triangle[i]] = own[i];
    return true;
  }

  /// Projects from the opposite of `at` onto the plane that touches the sphere there (thesis 3.9).
  bool amongNeighbours(const Points& units, const Values& nearness, const Vec3& at, Values& shares) const {
    // The line from -at through u_i meets the plane at s_i u_i + (s_i - 1) at with s_i = 2 / (1 + u_i . at):
    // the thesis's 1 + delta_i is s_i.
    const Vec3 x = at.unitOrthogonal(), y = at.cross(x);
    const Values ahead = ((units * at).array() + 1).max(kBehind);
    const Values stretch = 2 / ahead.array();
    PlanePoints sites(units.rows(), 2);
    sites.col(0) = (units * x).cwiseProduct(stretch);
    sites.col(1) = (units * y).cwiseProduct(stretch);
    const Values powers = transfer == Transfer::laguerre ? Values(-nearness) : Values::Zero(units.rows());
    if (!planeNeighbours(sites, powers, shares))
      return false;
    // The plane's neighbours with sum l_i = 1 meet at `at`: sum l_i s_i u_i = (2 - sum l_i s_i) at (3.10).
    const double left = 2 - shares.dot(stretch); // One less the thesis's sum of shares times delta.
    shares = shares.cwiseProduct(stretch) / left;
    return left > kBehind;
  }
};

} // namespace

/// Mean value coordinates over the triangulated Voronoi regions of the handles on the sphere around each
/// point; the weights of the Voronoi vertices are passed on to the handles (thesis 3.1.2). `transfer`:
/// * `spherical-barycentric`: to the three handles whose triangle the vertex belongs to; jumps at flips.
/// * `natural-neighbour`: to the natural neighbours in the plane that touches the sphere at the vertex, by a
///   polar projection; jumps where the point is in line with two handles (a sword).
/// * `laguerre`: natural neighbours again, with the diagrams weighted by distance. The thesis does not print
///   its weights. Ours: a handle lies at `q_i D / d_i` (D the largest distance) instead of q_i for the
///   diagram on the sphere, and has the power `-d_i / D` in the plane. Power diagrams keep the linear
///   precision (Aurenhammer 1988, doi 10.1137/0401036).
///
/// Points at which a vertex has no natural neighbours all around have no coordinates. A hull of n points and
/// O(n^3) for the transfer a point.
std::shared_ptr<const CoordinateSystem> voronoiRegions() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{
          .id = "voronoi-regions",
          .name = "Voronoi regions triangulation",
          .summary =
              "Mean value over the Voronoi regions of the handles as each point sees them; jumps, or slow",
          .traits = {.interpolates = true, .everywhere = false, .continuous = false, .smooth = false},
          .parameters = {kTransfer}},
      [](const HandleSet& handles, const ParameterValues& parameters) {
        return std::make_unique<DirectionSolver>(handles.positions,
                                                 Regions{chosen<Transfer>(parameters, kTransfer)});
      });
}

} // namespace viscera::coordinates
