#include "viscera/coordinates/systems.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "cage/coplanar_groups.h"
#include "same_place.h"
#include "viscera/coordinates/cage/cage.h"
#include "viscera/coordinates/pointwise_system.h"

namespace viscera::coordinates {
namespace {

/// Part of the distance to a face's outline: a point less high over the face's plane lies in it.
constexpr double kInFacePlane = 1e-12;
/// Below this so much cancels that the face is computed with more digits.
constexpr double kNearPlane = 1e-3;

/// Corners in order, counter-clockwise from outside.
using Polygon = std::vector<int>;

/// The single loop around a group of triangles; the triangles themselves where there is none.
std::vector<Polygon> outlineOf(const Triangles& cage, const std::vector<int>& members) {
  std::map<int, int> next;
  std::map<std::pair<int, int>, bool> edges;
  std::vector<Polygon> triangles;
  for (const int t : members) {
    triangles.push_back({cage(t, 0), cage(t, 1), cage(t, 2)});
    for (int i = 0; i < 3; ++i)
      edges[{cage(t, i), cage(t, (i + 1) % 3)}] = true;
  }
  for (const auto& [edge, present] : edges)
    if (!edges.contains({edge.second, edge.first}) && !next.emplace(edge).second)
      return triangles; // The outline touches itself.
  Polygon outline;
  for (int at = next.begin()->first; outline.empty() || at != outline.front(); at = next.at(at))
    outline.push_back(at);
  if (outline.size() != next.size())
    return triangles; // With a hole.
  return {outline};
}

std::vector<Polygon> facesOf(const Points& handles, const Triangles& cage) {
  const std::vector<int> group = coplanarGroups(handles, cage);
  std::map<int, std::vector<int>> members;
  for (std::size_t t = 0; t < group.size(); ++t)
    members[group[t]].push_back(static_cast<int>(t));
  std::vector<Polygon> faces;
  for (const auto& [number, triangles] : members)
    for (Polygon& outline : outlineOf(cage, triangles))
      faces.push_back(std::move(outline));
  return faces;
}

template <class Real>
using Vector = Eigen::Matrix<Real, 3, 1>;

/// Mean value weights of the direction `center` in the polygon of unit vectors, without scale: half tangents
/// of the angles between neighbours, signed around `axis`, over the corners' distances.
template <class Real>
std::vector<Real> polygonWeights(const std::vector<Vector<Real>>& corners, const Vector<Real>& center,
                                 const Vector<Real>& axis, const std::vector<Real>& distances) {
  // w_i = (tan(alpha_i-1 / 2) + tan(alpha_i / 2)) / d_i, with alpha_i the angle from corner i to the next as
  // seen from `center` along `axis`: the mean value coordinates of the plane across `axis`, to which the
  // corners are projected. Their sum of w_i d_i e_i is zero, e_i the unit vectors to the projected corners.
  using std::atan2, std::tan;
  const std::size_t count = corners.size();
  std::vector<Real> halves(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Vector<Real> one = corners[i] - corners[i].dot(axis) * axis - (center - center.dot(axis) * axis);
    const Vector<Real>& following = corners[(i + 1) % count];
    const Vector<Real> two = following - following.dot(axis) * axis - (center - center.dot(axis) * axis);
    halves[i] = tan(atan2(one.cross(two).dot(axis), one.dot(two)) / 2);
  }
  std::vector<Real> weights(count);
  for (std::size_t i = 0; i < count; ++i)
    weights[i] = (halves[(i + count - 1) % count] + halves[i]) / distances[i];
  return weights;
}

/// Adds a face that the point is not in the plane of.
template <class Real>
void addFace(const Polygon& face, const Points& units, Values& weights, const Values& distances) {
  using std::atan2;
  // m = int x dS over the polygon of the unit vectors u_i on the sphere = 1/2 sum_i theta_i n_i, by Stokes:
  // theta_i is the angle between u_i and u_i+1 and n_i the unit normal of their plane. Over the whole sphere
  // it is zero, so that faces whose weights have sum w_i (v_i - p) = m are balanced together.
  std::vector<Vector<Real>> corners;
  Vector<Real> middle = Vector<Real>::Zero(), mean = Vector<Real>::Zero();
  for (const int corner : face) {
    corners.push_back(units.row(corner).transpose().cast<Real>());
    middle += corners.back();
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector<Real> cross = corners[i].cross(corners[(i + 1) % corners.size()]);
    const Real length = cross.norm();
    if (length > 0)
      mean += atan2(length, corners[i].dot(corners[(i + 1) % corners.size()])) / 2 * cross / length;
  }
  const Real size = mean.norm();
  if (!(size > 0))
    return;
  // The direction c = m / |m|, turned to the side where the polygon is: m itself points away from a face that
  // is seen from outside.
  const Vector<Real> center = (mean.dot(middle) < 0 ? -mean : mean) / size;
  // Across c the corner u_i is sin(rho_i) long, rho_i its angle from c. Shares lambda_i of the plane across c
  // with these distances leave sum lambda_i u_i = (sum lambda_i u_i . c) c.
  std::vector<Real> sines;
  for (const auto& corner : corners)
    sines.push_back(corner.cross(center).norm());
  const std::vector<Real> shares = polygonWeights<Real>(corners, center, center, sines);
  Real along = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    along += shares[i] * corners[i].dot(center);
  // Scaled to m: mu_i = lambda_i (m . c) / sum_j lambda_j u_j . c gives sum mu_i u_i = m, and w_i = mu_i /
  // d_i.
  for (std::size_t i = 0; i < corners.size(); ++i)
    weights[face[i]] += static_cast<double>(shares[i] / along * mean.dot(center)) / distances[face[i]];
}

/// The edges of the faces, each once.
std::vector<std::pair<int, int>> edgesOf(const std::vector<Polygon>& faces) {
  std::set<std::pair<int, int>> edges;
  for (const Polygon& face : faces)
    for (std::size_t i = 0; i < face.size(); ++i)
      edges.insert(std::minmax(face[i], face[(i + 1) % face.size()]));
  return {edges.begin(), edges.end()};
}

class SphericalMeanValueSolver final : public PointSolver {
public:
  SphericalMeanValueSolver(const Points& handles, const Triangles& cage)
      : handles_(handles), size_(boundsOf(handles).diagonal()), faces_(facesOf(handles, cage)),
        edges_(edgesOf(faces_)) {
    for (const Polygon& face : faces_) {
      Vec3 area = Vec3::Zero();
      for (std::size_t i = 0; i < face.size(); ++i)
        area +=
            Vec3((handles.row(face[i]) - handles.row(face[0])).transpose())
                .cross(Vec3((handles.row(face[(i + 1) % face.size()]) - handles.row(face[0])).transpose()));
      normals_.push_back(area.normalized());
    }
  }

  bool solve(const Vec3& point, Values& weights) const override {
    const Points ways = handles_.rowwise() - point.transpose();
    const Values distances = ways.rowwise().norm();
    for (const Polygon& face : faces_)
      for (const int corner : face)
        if (distances[corner] <= kSamePlace * size_) {
          weights[corner] = 1;
          return true;
        }
    if (takeEdge(ways, weights))
      return true;
    const Points units = ways.array().colwise() / distances.array();
    for (std::size_t i = 0; i < faces_.size(); ++i)
      if (addOrTakeFace(i, ways, units, distances, weights))
        return true;
    const double sum = weights.sum();
    if (!(std::abs(sum) > 0))
      return false;
    weights /= sum;
    return true;
  }

private:
  /// Where an edge is nearest to the point.
  struct Foot {
    double share; ///< Of the way along the edge.
    double distance;
  };

  static Foot footOn(const Points& ways, int from, int to) {
    const Eigen::RowVector3d edge = ways.row(to) - ways.row(from);
    const double share = std::clamp(-ways.row(from).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
    return {share, (ways.row(from) + share * edge).norm()};
  }

  /// Linear weights of a point on an edge, where by rounding the edge turns by pi or by -pi around it in each
  /// of its two faces; false, and nothing, when it is on none.
  bool takeEdge(const Points& ways, Values& weights) const {
    for (const auto& [from, to] : edges_) {
      if (ways.row(from).dot(ways.row(to)) >= 0)
        continue; // From a point on it the two ends lie in opposite directions.
      const Foot foot = footOn(ways, from, to);
      if (foot.distance > kSamePlace * size_)
        continue;
      weights[from] = 1 - foot.share;
      weights[to] = foot.share;
      return true;
    }
    return false;
  }

  /// Adds the weights of a face; true when the point lies on it, which leaves that face's weights alone.
  bool addOrTakeFace(std::size_t index, const Points& ways, const Points& units, const Values& distances,
                     Values& weights) const {
    const Polygon& face = faces_[index];
    const auto nearer = [&](int a, int b) { return distances[a] < distances[b]; };
    const auto [nearest, farthest] = std::minmax_element(face.begin(), face.end(), nearer);
    const double height = std::abs(ways.row(*nearest).dot(normals_[index]));
    if (height >= kNearPlane * distances[*farthest]) {
      addFace<double>(face, units, weights, distances);
      return false;
    }
    // Compared with the distance to the outline: next to an edge a face covers much of the sphere around the
    // point however little that is away from its plane. Beside the face it covers nothing.
    if (height > kInFacePlane * distances[*nearest] ||
        height > kInFacePlane * distanceToOutline(face, ways)) {
      addFace<long double>(face, units, weights, distances);
      return false;
    }
    return takeFace(index, ways, distances, weights);
  }

  static double distanceToOutline(const Polygon& face, const Points& ways) {
    double least = ways.row(face[0]).norm();
    for (std::size_t i = 0; i < face.size(); ++i)
      least = std::min(least, footOn(ways, face[i], face[(i + 1) % face.size()]).distance);
    return least;
  }

  /// The plane coordinates of a point in the plane of a face and not on its outline; false, and nothing, when
  /// it is beside the face.
  bool takeFace(std::size_t index, const Points& ways, const Values& distances, Values& weights) const {
    const Polygon& face = faces_[index];
    std::vector<Vec3> corners;
    std::vector<double> lengths;
    double turned = 0;
    for (const int corner : face) {
      corners.emplace_back(ways.row(corner).transpose());
      lengths.push_back(distances[corner]);
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec3& next = corners[(i + 1) % corners.size()];
      turned += std::atan2(corners[i].cross(next).dot(normals_[index]), corners[i].dot(next));
    }
    // The signed angles from corner to corner around the point sum to 2 pi inside the face and to 0 beside
    // it.
    if (turned < 3)
      return false;
    const std::vector<double> shares =
        polygonWeights<double>(corners, Vec3::Zero(), normals_[index], lengths);
    weights.setZero();
    for (std::size_t i = 0; i < face.size(); ++i)
      weights[face[i]] = shares[i];
    weights /= weights.sum();
    return true;
  }

  Points handles_;
  double size_;
  std::vector<Polygon> faces_;
  std::vector<std::pair<int, int>> edges_;
  std::vector<Vec3> normals_;
};

} // namespace

/// Mean value coordinates of a cage with polygons (thesis 2.3; Langer, Belyaev, Seidel 2006, Symposium on
/// Geometry Processing): triangles of the cage that lie in one plane, to 1e-9 of its size, are one face, and
/// its mean vector is shared among its corners by mean value coordinates on the sphere. Over triangles it is
/// the same as mean value coordinates; over a face of four corners the cage's diagonals play no part.
/// O(triangles) a point.
std::shared_ptr<const CoordinateSystem> sphericalMeanValue() {
  return std::make_shared<PointwiseSystem>(
      SystemDescription{.id = "spherical-mean-value",
                        .name = "Spherical mean value",
                        .summary = "Mean value of a cage with flat polygons, whose diagonals play no part",
                        .traits = {.needsCage = true, .interpolates = true}},
      [](const HandleSet& handles, const ParameterValues&) {
        return std::make_unique<SphericalMeanValueSolver>(handles.positions, cageOf(handles));
      });
}

} // namespace viscera::coordinates
