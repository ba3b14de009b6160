#include "viscera/geometry/decimate_surface.h"

#include <algorithm>
#include <array>
#include <optional>
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

/// An edge on its way out. Kept small: most of the time goes into moving candidates within their queue.
struct Candidate {
  double cost = 0;
  VertexIndex a = 0, b = 0;
  int stamps = 0; ///< The sum of both ends' stamps, which only grow: another sum is another edge by now.

  /// The cheapest on top of the queue; of equal ones that with the lower indices.
  bool operator<(const Candidate& other) const {
    return std::tie(cost, a, b) > std::tie(other.cost, other.a, other.b);
  }
};

/// Gives the cheapest candidate first. Most of them never come out: the dearer ones wait unsorted, so that
/// the sorted ones fit into a processor's cache.
class CheapestFirst {
public:
  bool empty() const { return sorted_.empty() && waiting_.empty(); }

  void push(const Candidate& candidate) {
    if (dearestSorted_ && *dearestSorted_ < candidate)
      sorted_.push(candidate);
    else
      waiting_.push_back(candidate);
  }

  Candidate pop() {
    if (sorted_.empty())
      sortSome();
    const Candidate cheapest = sorted_.top();
    sorted_.pop();
    return cheapest;
  }

private:
  static constexpr std::size_t kPart = 16; ///< One of so many waiting candidates is sorted at a time.

  void sortSome() {
    const auto count = static_cast<std::ptrdiff_t>(1 + waiting_.size() / kPart);
    const auto cheaper = [](const Candidate& one, const Candidate& other) { return other < one; };
    std::nth_element(waiting_.begin(), waiting_.begin() + count - 1, waiting_.end(), cheaper);
    dearestSorted_ = waiting_[static_cast<std::size_t>(count - 1)];
    sorted_ = std::priority_queue<Candidate>({}, {waiting_.begin(), waiting_.begin() + count});
    waiting_.erase(waiting_.begin(), waiting_.begin() + count);
  }

  std::priority_queue<Candidate> sorted_;
  std::optional<Candidate> dearestSorted_;
  std::vector<Candidate> waiting_; ///< Each dearer than `dearestSorted_`.
};

class Thinner {
public:
  explicit Thinner(const TriangleMesh& mesh)
      : middle_(boundsOf(mesh.points).center()), surface_(mesh),
        quadrics_(static_cast<std::size_t>(mesh.points.rows())), stamps_(quadrics_.size(), 0) {
    for (VertexIndex t = 0; t < static_cast<VertexIndex>(mesh.triangles.rows()); ++t)
      addTriangle(t);
    for (const EditableSurface::Edge& edge : surface_.edges())
      queue_.push(candidate(edge.a, edge.b));
  }

  TriangleMesh run(int triangles, const Progress& progress) {
    for (int step = 0; surface_.triangleCount() > triangles && !queue_.empty(); ++step) {
      if (step % kStepsBetweenLooks == 0)
        progress.throwIfCancelled();
      const Candidate next = queue_.pop();
      if (next.stamps != stamp(next.a) + stamp(next.b) ||
          !surface_.collapseTo({next.a, next.b}, placeOf(sum(next.a, next.b), next.a, next.b)))
        continue;
      quadric(next.a) += quadric(next.b);
      ++stamps_[static_cast<std::size_t>(next.a)];
      ++stamps_[static_cast<std::size_t>(next.b)];
      for (const VertexIndex neighbour : surface_.neighbours(next.a))
        queue_.push(candidate(std::min(next.a, neighbour), std::max(next.a, neighbour)));
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

  Quadric sum(VertexIndex a, VertexIndex b) const {
    Quadric both = quadrics_[static_cast<std::size_t>(a)];
    return both += quadrics_[static_cast<std::size_t>(b)];
  }

  /// The place of the merged vertex, which stays the same as long as neither end changes.
  Vec3 placeOf(const Quadric& both, VertexIndex a, VertexIndex b) const {
    return middle_ + bestPlace(both, surface_.point(a) - middle_, surface_.point(b) - middle_);
  }

  Candidate candidate(VertexIndex a, VertexIndex b) const {
    const Quadric both = sum(a, b);
    const Vec3 place = placeOf(both, a, b);
    // Cost: Q_a(p) + Q_b(p) + evenness (weight_a + weight_b) |ab|^2.
    const double cost =
        std::max(0.0, both.at(place - middle_)) + kEvenness * both.weight * surface_.length2({a, b});
    return {cost, a, b, stamp(a) + stamp(b)};
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
  CheapestFirst queue_;
};

} // namespace

TriangleMesh decimateClosedSurface(const TriangleMesh& mesh, int triangles, const Progress& progress) {
  if (mesh.triangles.rows() <= triangles)
    return {mesh.points, mesh.triangles, {}};
  return Thinner(mesh).run(triangles, progress);
}

} // namespace viscera::geometry
