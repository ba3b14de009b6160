#include "viscera/geometry/decimate_surface.h"

#include <algorithm>
#include <array>
#include <queue>
#include <tuple>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "viscera/geometry/editable_surface.h"

namespace viscera::geometry {
namespace {

using VertexIndex = EditableSurface::Index;

/// Where planes meet at less than this, relative to the largest of the three directions, no best place is
/// computed: any along them is as good.
constexpr double kFlatSquare = 1e-3;
/// The weight of an edge's length in its cost, so that even flat parts are thinned evenly.
constexpr double kEvenness = 1e-4;
constexpr int kStepsBetweenLooks = 1000; ///< Steps between checks for cancellation.

/// The squared distances from some planes, each times its weight, as a function of the point.
struct Quadric {
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Vec3 b = Vec3::Zero();
  double c = 0;
  double weight = 0;

  void addPlane(const Vec3& unitNormal, const Vec3& point, double area) {
    // area (n.x + d)^2 = x^T (area n n^T) x + 2 (area d n).x + area d^2.
    const double d = -unitNormal.dot(point);
    a += area * unitNormal * unitNormal.transpose();
    b += area * d * unitNormal;
    c += area * d * d;
    weight += area;
  }
  Quadric& operator+=(const Quadric& other) {
    a += other.a;
    b += other.b;
    c += other.c;
    weight += other.weight;
    return *this;
  }
  double at(const Vec3& p) const { return p.dot(a * p) + 2 * b.dot(p) + c; }
};

/// An edge on its way out. `stamps` tell whether an end has changed since.
struct Candidate {
  double cost = 0;
  VertexIndex a = 0, b = 0;
  std::array<int, 2> stamps = {};
  Vec3 place = Vec3::Zero();

  /// The cheapest on top of the queue; of equal ones that with the lower indices.
  bool operator<(const Candidate& other) const {
    return std::tie(cost, a, b) > std::tie(other.cost, other.a, other.b);
  }
};

class Thinner {
public:
  explicit Thinner(const TriangleMesh& mesh)
      : middle_(boundsOf(mesh.points).center()), surface_(mesh),
        quadrics_(static_cast<std::size_t>(mesh.points.rows())), stamps_(quadrics_.size(), 0) {
    for (VertexIndex t = 0; t < static_cast<VertexIndex>(mesh.triangles.rows()); ++t)
      addTriangle(t);
    for (const EditableSurface::Edge& edge : surface_.edges())
      propose(edge.a, edge.b);
  }

  TriangleMesh run(int triangles, const Progress& progress) {
    for (int step = 0; surface_.triangleCount() > triangles && !queue_.empty(); ++step) {
      if (step % kStepsBetweenLooks == 0)
        progress.throwIfCancelled();
      const Candidate next = queue_.top();
      queue_.pop();
      if (next.stamps != std::array{stamp(next.a), stamp(next.b)} ||
          !surface_.collapseTo({next.a, next.b}, next.place))
        continue;
      quadric(next.a) += quadric(next.b);
      ++stamps_[static_cast<std::size_t>(next.a)];
      ++stamps_[static_cast<std::size_t>(next.b)];
      for (const VertexIndex neighbour : surface_.neighbours(next.a))
        propose(std::min(next.a, neighbour), std::max(next.a, neighbour));
    }
    return surface_.mesh();
  }

private:
  Quadric& quadric(VertexIndex vertex) { return quadrics_[static_cast<std::size_t>(vertex)]; }
  int stamp(VertexIndex vertex) const { return stamps_[static_cast<std::size_t>(vertex)]; }

  void addTriangle(VertexIndex triangle) {
    const Vec3 twice = surface_.doubleArea(triangle);
    const double size = twice.norm();
    if (!(size > 0))
      return;
    for (const VertexIndex corner : surface_.corners(triangle))
      quadric(corner).addPlane(twice / size, surface_.point(corner) - middle_, size / 2);
  }

  void propose(VertexIndex a, VertexIndex b) {
    Quadric sum = quadric(a);
    sum += quadric(b);
    Candidate candidate{.a = a, .b = b, .stamps = {stamp(a), stamp(b)}};
    candidate.place = middle_ + bestPlace(sum, surface_.point(a) - middle_, surface_.point(b) - middle_);
    // Cost: Q_a(p) + Q_b(p) + evenness (weight_a + weight_b) |ab|^2.
    candidate.cost =
        std::max(0.0, sum.at(candidate.place - middle_)) + kEvenness * sum.weight * surface_.length2({a, b});
    queue_.push(candidate);
  }

  /// The point of least error, or where that is not determined the best of the edge's ends and its middle.
  static Vec3 bestPlace(const Quadric& quadric, const Vec3& a, const Vec3& b) {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> directions;
    directions.computeDirect(quadric.a, Eigen::EigenvaluesOnly);
    if (directions.eigenvalues()[0] > kFlatSquare * directions.eigenvalues()[2]) {
      // The gradient 2 (A x + b) is zero at x = -A^-1 b.
      const Vec3 best = -quadric.a.ldlt().solve(quadric.b);
      if ((best - 0.5 * (a + b)).squaredNorm() <= 4 * (a - b).squaredNorm())
        return best;
    }
    const std::array<Vec3, 3> places = {0.5 * (a + b), a, b};
    return *std::min_element(places.begin(), places.end(),
                             [&](const Vec3& p, const Vec3& q) { return quadric.at(p) < quadric.at(q); });
  }

  Vec3 middle_; ///< Quadrics are taken relative to it: far from the origin they would lose their digits.
  EditableSurface surface_;
  std::vector<Quadric> quadrics_;
  std::vector<int> stamps_;
  std::priority_queue<Candidate> queue_;
};

} // namespace

TriangleMesh decimateClosedSurface(const TriangleMesh& mesh, int triangles, const Progress& progress) {
  if (mesh.triangles.rows() <= triangles)
    return {mesh.points, mesh.triangles, {}};
  return Thinner(mesh).run(triangles, progress);
}

} // namespace viscera::geometry
