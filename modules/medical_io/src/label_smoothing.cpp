#include "label_smoothing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "viscera/geometry/normals.h"
#include "windowed_sinc.h"

namespace viscera::medical_io {
namespace {

using geometry::TriangleMesh;

/// How much smoother one unit makes the surface.
constexpr int kFewestIterations = 20, kIterationsPerUnit = 20;
constexpr double kPassBandPerUnit = 0.01;
/// The narrowest pass band: thin vessels cross themselves with a narrower one.
constexpr double kNarrowestPassBand = 0.01;
/// Passes so far, a filter leaves vessels of few voxels as thick as they are.
constexpr double kGentle = 0.5;
/// The last filter.
constexpr int kLastIterations = 20;
constexpr double kLastPassBand = 0.1;
/// Part of a voxel's extent along the normal by which 1 may move a place that a gentle filter has smoothed.
constexpr double kMostShift = 0.25;
/// A filter passes all of its pass band but for this.
constexpr double kPassError = 1e-3;
/// The filter's edge is looked for in steps of that part of a half wave of its last polynomial.
constexpr double kEdgeStep = 0.02;

/// What is added up of each Chebyshev polynomial of the surface's Laplacian.
using Coefficients = std::vector<double>;

/// The vertices around each vertex.
struct VertexRings {
  std::vector<std::size_t> begin; ///< Of each vertex's in `vertices`; one more at the end.
  std::vector<std::int32_t> vertices;
};

/// Each vertex around another one of a closed oriented surface follows it in exactly one triangle.
VertexRings ringsOf(const TriangleMesh& mesh) {
  VertexRings rings;
  rings.begin.assign(static_cast<std::size_t>(mesh.points.rows()) + 1, 0);
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      ++rings.begin[static_cast<std::size_t>(mesh.triangles(t, k)) + 1];
  std::partial_sum(rings.begin.begin(), rings.begin.end(), rings.begin.begin());
  rings.vertices.resize(rings.begin.back());
  std::vector<std::size_t> next = rings.begin;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      rings.vertices[next[static_cast<std::size_t>(mesh.triangles(t, k))]++] = mesh.triangles(t, (k + 1) % 3);
  return rings;
}

/// The low-pass filter whose edge is at `cut` (0 to pi, as all angles here), in a Hamming window.
Coefficients windowedSinc(int iterations, double cut) {
  Coefficients filter{cut / std::numbers::pi};
  for (int i = 1; i <= iterations; ++i) {
    const double window = 0.54 + 0.46 * std::cos(i * std::numbers::pi / (iterations + 1));
    filter.push_back(2 * window * std::sin(i * cut) / (i * std::numbers::pi));
  }
  return filter;
}

double gain(const Coefficients& filter, double angle) {
  double sum = 0;
  for (std::size_t i = 0; i < filter.size(); ++i)
    sum += filter[i] * std::cos(static_cast<double>(i) * angle);
  return sum;
}

/// The filter whose edge lies so far beyond the pass band that this passes whole.
Coefficients filterOf(int iterations, double passBand) {
  const double pass = std::acos(1 - passBand / 2);
  const double step = kEdgeStep * std::numbers::pi / (iterations + 1);
  double cut = pass;
  Coefficients filter = windowedSinc(iterations, cut);
  while (gain(filter, pass) < 1 - kPassError && cut + step < std::numbers::pi)
    filter = windowedSinc(iterations, cut += step);
  // Else the surface would be scaled about the origin of the patient's space.
  const double whole = gain(filter, 0);
  for (double& part : filter)
    part /= whole;
  return filter;
}

int iterationsOf(double smoothing) {
  return kFewestIterations + static_cast<int>(kIterationsPerUnit * smoothing);
}

double passBandOf(double smoothing) {
  return std::max(kNarrowestPassBand, std::pow(kPassBandPerUnit, smoothing));
}

Coefficients filterOf(double smoothing) {
  return filterOf(iterationsOf(smoothing), passBandOf(smoothing));
}

/// A row a vertex. Three coordinates stand in four columns, so that a row is whole registers.
template <int Columns>
using Field = Eigen::Array<double, Eigen::Dynamic, Columns, Columns == 1 ? Eigen::ColMajor : Eigen::RowMajor>;

Field<4> fieldOf(const Points& points) {
  Field<4> field = Field<4>::Zero(points.rows(), 4);
  field.leftCols<3>() = points.array();
  return field;
}

/// The mean of `field` around a vertex; at one that has none around it, its own value.
template <int Columns>
Eigen::Array<double, 1, Columns> meanAround(const Field<Columns>& field, const VertexRings& rings,
                                            Eigen::Index vertex) {
  const std::size_t begin = rings.begin[static_cast<std::size_t>(vertex)];
  const std::size_t end = rings.begin[static_cast<std::size_t>(vertex) + 1];
  if (begin == end)
    return field.row(vertex);
  Eigen::Array<double, 1, Columns> sum = Eigen::Array<double, 1, Columns>::Zero();
  for (std::size_t i = begin; i < end; ++i)
    sum += field.row(rings.vertices[i]);
  return sum / static_cast<double>(end - begin);
}

/// `field` after each of the filters: all of them share the polynomials, which take the time.
template <int Columns>
std::vector<Field<Columns>> filtered(const Field<Columns>& field, const VertexRings& rings,
                                     const std::vector<Coefficients>& filters) {
  std::vector<Field<Columns>> results;
  std::size_t count = 0;
  for (const Coefficients& filter : filters) {
    results.emplace_back(filter[0] * field);
    count = std::max(count, filter.size());
  }
  Field<Columns> before = field, now = field;
  for (Eigen::Index v = 0; v < field.rows(); ++v)
    now.row(v) = 0.5 * (field.row(v) + meanAround(field, rings, v));
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t f = 0; f < filters.size(); ++f)
      if (i < filters[f].size())
        results[f] += filters[f][i] * now;
    // The Chebyshev recurrence of (1 + mean) / 2, in the place of the polynomial before the last.
    for (Eigen::Index v = 0; v < field.rows(); ++v)
      before.row(v) = now.row(v) + meanAround(now, rings, v) - before.row(v);
    before.swap(now);
  }
  return results;
}

/// Computes on one thread: labels are what is done in parallel.
Points normalsOf(const TriangleMesh& mesh) {
  geometry::Normals normals;
  geometry::vertexNormals(mesh.points, mesh.triangles,
                          geometry::vertexTriangles(mesh.points.rows(), mesh.triangles), normals, Threads{1});
  return normals.cast<double>();
}

/// A number that stays what it is while small and never reaches `limit`, without a bend on the way.
double limited(double number, double limit) {
  return number / std::hypot(1, number / limit);
}

} // namespace

TriangleMesh smoothSteps(const TriangleMesh& contour, const Eigen::Matrix3d& voxel, double smoothing) {
  TriangleMesh mesh = contour;
  if (smoothing <= 0)
    return mesh;
  if (smoothing <= kGentle)
    return smoothSurface(contour, iterationsOf(smoothing), passBandOf(smoothing));
  const VertexRings rings = ringsOf(contour);
  const Coefficients strong = filterOf(smoothing);
  const std::vector<Field<4>> both = filtered(fieldOf(contour.points), rings, {filterOf(kGentle), strong});
  mesh.points = both[0].leftCols<3>();
  const Points normals = normalsOf(mesh);
  const Points moved = (both[1] - both[0]).leftCols<3>();
  const Field<1> outward = moved.cwiseProduct(normals).rowwise().sum().array();
  const Field<1> around = filtered(outward, rings, {strong}).front();
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
    // A vertex between degenerate triangles has no normal, and nothing along it is moved.
    const double extent = std::max((normals.row(v) * voxel).lpNorm<1>(), std::numeric_limits<double>::min());
    const double wanted = limited(outward[v] - around[v], kMostShift * smoothing * extent);
    mesh.points.row(v) += moved.row(v) + (wanted - outward[v]) * normals.row(v);
  }
  const std::vector<Coefficients> last = {filterOf(kLastIterations, kLastPassBand)};
  mesh.points = filtered(fieldOf(mesh.points), rings, last).front().leftCols<3>();
  return mesh;
}

} // namespace viscera::medical_io
