#include "windowed_sinc.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

#include "viscera/core/parallel.h"

namespace viscera::medical_io {
namespace {

constexpr Eigen::Index kPointsAtOnce = 65'536;
/// A point with more edges hardly moves anyway.
constexpr std::size_t kMostRingEdges = 510;
/// Cosine of the angle by which a border may bend at a point that moves along it.
const double kStraight = std::cos(15 * std::numbers::pi / 180);
/// Newton's steps of the search for the filter's edge.
constexpr int kMostSteps = 500;
constexpr double kPassTolerance = 1e-3;

/// The points that each point follows: those around it, or its two neighbours on a border; none where it
/// stays.
struct Stencils {
  std::vector<std::size_t> begin; ///< Of each point's in `points`.
  std::vector<std::int32_t> points;
  std::vector<std::int32_t> count; ///< Of those that it follows.
};

/// Each point's neighbours, one for each triangle at their edge, in ascending order.
Stencils edgesAround(const geometry::TriangleMesh& mesh) {
  Stencils edges;
  edges.begin.assign(static_cast<std::size_t>(mesh.points.rows()) + 1, 0);
  for (const std::int32_t corner : mesh.triangles.reshaped())
    edges.begin[static_cast<std::size_t>(corner) + 1] += 2;
  std::partial_sum(edges.begin.begin(), edges.begin.end(), edges.begin.begin());
  edges.points.resize(edges.begin.back());
  std::vector<std::size_t> next = edges.begin;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k) {
      std::size_t& at = next[static_cast<std::size_t>(mesh.triangles(t, k))];
      edges.points[at++] = mesh.triangles(t, (k + 1) % 3);
      edges.points[at++] = mesh.triangles(t, (k + 2) % 3);
    }
  return edges;
}

/// Two edges of a kind at one point, and how many there are.
struct EdgePair {
  std::array<std::int32_t, 2> ends{};
  int count = 0;
  void add(std::int32_t end) {
    if (count < 2)
      ends[static_cast<std::size_t>(count)] = end;
    ++count;
  }
};

bool bends(const Points& points, Eigen::Index at, const EdgePair& pair) {
  const Vec3 here = points.row(at);
  const Vec3 before = here - points.row(pair.ends[0]).transpose();
  const Vec3 behind = points.row(pair.ends[1]).transpose() - here;
  return before.normalized().dot(behind.normalized()) < kStraight;
}

/// Takes each neighbour once, or only the two on a border or on an edge of more than two triangles. Says how
/// many it left at the begin of the list.
std::int32_t thinOut(const Points& points, Eigen::Index at, std::int32_t* begin, std::int32_t* end) {
  if (end - begin >= static_cast<std::ptrdiff_t>(kMostRingEdges))
    return 0;
  std::sort(begin, end);
  EdgePair border, folded;
  std::int32_t* kept = begin;
  for (const std::int32_t* next = begin; next != end;) {
    const std::int32_t neighbour = *next;
    const std::int32_t* const first = next;
    next = std::find_if(next, static_cast<const std::int32_t*>(end),
                        [neighbour](std::int32_t other) { return other != neighbour; });
    if (next - first == 1)
      border.add(neighbour);
    else if (next - first > 2)
      folded.add(neighbour);
    *kept++ = neighbour;
  }
  if (border.count == 0 && folded.count == 0)
    return static_cast<std::int32_t>(kept - begin);
  const EdgePair& pair = border.count > 0 ? border : folded;
  if (border.count + folded.count != 2 || pair.count != 2 || bends(points, at, pair))
    return 0;
  std::copy(pair.ends.begin(), pair.ends.end(), begin);
  return 2;
}

Stencils stencilsOf(const geometry::TriangleMesh& mesh) {
  Stencils stencils = edgesAround(mesh);
  stencils.count.resize(static_cast<std::size_t>(mesh.points.rows()));
  parallelRanges(mesh.points.rows(), kPointsAtOnce, {}, [&](Eigen::Index from, Eigen::Index to) {
    for (Eigen::Index v = from; v < to; ++v) {
      const auto i = static_cast<std::size_t>(v);
      stencils.count[i] = thinOut(mesh.points, v, stencils.points.data() + stencils.begin[i],
                                  stencils.points.data() + stencils.begin[i + 1]);
    }
  });
  return stencils;
}

/// The filter's Chebyshev coefficients when its edge is at an angle of 0 to pi, in a Hamming window.
std::vector<double> coefficientsFor(int iterations, double edge) {
  std::vector<double> filter;
  for (int i = 0; i <= iterations; ++i) {
    const double window = 0.54 + 0.46 * std::cos(i * std::numbers::pi / (iterations + 1));
    filter.push_back(i == 0 ? window * edge / std::numbers::pi
                            : 2 * window * std::sin(i * edge) / (i * std::numbers::pi));
  }
  return filter;
}

/// The coefficients of the derivative of a sum of Chebyshev polynomials.
std::vector<double> derivativeOf(const std::vector<double>& filter) {
  const int last = static_cast<int>(filter.size()) - 1;
  std::vector<double> derivative(filter.size(), 0.0);
  for (int i = last - 2; i >= 0; --i) {
    const auto at = static_cast<std::size_t>(i);
    derivative[at] = (i + 2 < last ? derivative[at + 2] : 0.0) + 2.0 * (i + 1) * filter[at + 1];
  }
  return derivative;
}

double valueAt(const std::vector<double>& filter, double angle) {
  double sum = filter[0];
  for (std::size_t i = 1; i < filter.size(); ++i)
    sum += filter[i] * std::cos(static_cast<double>(i) * angle);
  return sum;
}

/// The filter that passes the edge of the pass band whole: Newton's method moves its own edge.
std::vector<double> passingFilter(int iterations, double passBand) {
  const double pass = std::acos(1 - 0.5 * passBand);
  double shift = 0;
  std::vector<double> filter;
  for (int step = 0; step < kMostSteps; ++step) {
    filter = coefficientsFor(iterations, pass + shift);
    const double miss = valueAt(filter, pass) - 1;
    if (iterations <= 1 || std::abs(miss) < kPassTolerance)
      break;
    shift -= miss / valueAt(derivativeOf(filter), pass);
  }
  return filter;
}

class Smoother {
public:
  Smoother(const geometry::TriangleMesh& mesh, std::vector<double> filter)
      : stencils_(stencilsOf(mesh)), filter_(std::move(filter)) {}

  /// Adds up the filter's polynomials of the mean around each point.
  Points run(Points before) const {
    Points now(before.rows(), 3), sum(before.rows(), 3), after(before.rows(), 3);
    forPoints(before.rows(), [&](Eigen::Index v) {
      now.row(v) = before.row(v) - 0.5 * laplacian(before, v);
      sum.row(v) = filter_[0] * before.row(v) + filter_[1] * now.row(v);
    });
    for (std::size_t i = 2; i < filter_.size(); ++i) {
      forPoints(before.rows(), [&](Eigen::Index v) {
        after.row(v) = now.row(v) - before.row(v) + now.row(v) - laplacian(now, v);
        sum.row(v) += filter_[i] * after.row(v);
      });
      before.swap(now);
      now.swap(after);
    }
    return sum;
  }

private:
  using Row = Eigen::RowVector3d;

  template <class Function>
  static void forPoints(Eigen::Index count, const Function& function) {
    parallelRanges(count, kPointsAtOnce, {}, [&](Eigen::Index begin, Eigen::Index end) {
      for (Eigen::Index v = begin; v < end; ++v)
        function(v);
    });
  }

  /// The point less the mean of those that it follows.
  Row laplacian(const Points& points, Eigen::Index v) const {
    const auto i = static_cast<std::size_t>(v);
    const std::int32_t* followed = stencils_.points.data() + stencils_.begin[i];
    const std::int32_t count = stencils_.count[i];
    const Row here = points.row(v);
    Row sum = Row::Zero();
    for (std::int32_t n = 0; n < count; ++n)
      sum += (here - points.row(followed[n])) / static_cast<double>(count);
    return sum;
  }

  Stencils stencils_;
  std::vector<double> filter_;
};

} // namespace

geometry::TriangleMesh smoothSurface(const geometry::TriangleMesh& mesh, int iterations, double passBand) {
  geometry::TriangleMesh smooth{mesh.points, mesh.triangles, {}};
  if (mesh.triangles.rows() == 0)
    return smooth;
  const Bounds box = boundsOf(mesh.points);
  const double length = box.diagonal();
  const Eigen::RowVector3d center = ((box.high + box.low) / 2).transpose();
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    smooth.points.row(v) = (mesh.points.row(v) - center) / length;
  smooth.points = Smoother(mesh, passingFilter(iterations, passBand)).run(std::move(smooth.points));
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
    smooth.points.row(v) = smooth.points.row(v) * length + center;
  return smooth;
}

} // namespace viscera::medical_io
