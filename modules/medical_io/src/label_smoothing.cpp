#include "label_smoothing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "viscera/geometry/normals.h"
#include "vtk_poly_data.h"

namespace viscera::medical_io {
namespace {

using geometry::TriangleMesh;

/// How much smoother one unit makes the surface.
constexpr int kFewestIterations = 20, kIterationsPerUnit = 20;
constexpr double kPassBandPerUnit = 0.01;
/// With a narrower one thin vessels cross themselves.
constexpr double kNarrowestPassBand = 0.01;
/// As far as that a filter leaves vessels of few voxels as thick as they are.
constexpr double kGentle = 0.5;
/// The last filter.
constexpr int kLastIterations = 20;
constexpr double kLastPassBand = 0.1;
/// By how much of a voxel's extent along the normal 1 may move a place that a gentle filter has smoothed.
constexpr double kMostShift = 0.25;
/// A filter passes all of its pass band but for this.
constexpr double kPassError = 1e-3;
/// Its edge is looked for in steps of that part of a half wave of its last polynomial.
constexpr double kEdgeStep = 0.02;

/// What is added up of each Chebyshev polynomial of the surface's Laplacian.
using Coefficients = std::vector<double>;

/// The vertices around each vertex.
struct VertexRings {
  std::vector<std::size_t> begin; ///< Of each vertex's in `vertices`; one more at the end.
  std::vector<std::int32_t> vertices;
};

/// In a closed oriented surface each vertex around another one follows it in exactly one triangle.
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

/// The mean of `field`, a row a vertex, around each vertex.
template <class Field>
Field meansAround(const Field& field, const VertexRings& rings) {
  Field means = Field::Zero(field.rows(), field.cols());
  for (Eigen::Index v = 0; v < field.rows(); ++v) {
    const std::size_t begin = rings.begin[static_cast<std::size_t>(v)];
    const std::size_t end = rings.begin[static_cast<std::size_t>(v) + 1];
    if (begin == end) {
      means.row(v) = field.row(v);
      continue;
    }
    for (std::size_t i = begin; i < end; ++i)
      means.row(v) += field.row(rings.vertices[i]);
    means.row(v) /= static_cast<double>(end - begin);
  }
  return means;
}

/// `field` after each of the filters: all of them share the polynomials, which take the time.
template <class Field>
std::vector<Field> filtered(const Field& field, const VertexRings& rings,
                            const std::vector<Coefficients>& filters) {
  std::vector<Field> results;
  std::size_t count = 0;
  for (const Coefficients& filter : filters) {
    results.emplace_back(filter[0] * field);
    count = std::max(count, filter.size());
  }
  Field before = field;
  Field now = 0.5 * (field + meansAround(field, rings));
  for (std::size_t i = 1; i < count; ++i) {
    for (std::size_t f = 0; f < filters.size(); ++f)
      if (i < filters[f].size())
        results[f] += filters[f][i] * now;
    before = now + meansAround(now, rings) - before;
    before.swap(now);
  }
  return results;
}

/// On one thread: labels are what is done in parallel.
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
  const std::vector<Points> both = filtered(contour.points, rings, {filterOf(kGentle), strong});
  mesh.points = both[0];
  const Points normals = normalsOf(mesh);
  const Values outward = (both[1] - both[0]).cwiseProduct(normals).rowwise().sum();
  const Values around = filtered(outward, rings, {strong}).front();
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) {
    // A vertex between degenerate triangles has no normal, and nothing along it is moved.
    const double extent = std::max((normals.row(v) * voxel).lpNorm<1>(), std::numeric_limits<double>::min());
    const double wanted = limited(outward[v] - around[v], kMostShift * smoothing * extent);
    mesh.points.row(v) = both[1].row(v) + (wanted - outward[v]) * normals.row(v);
  }
  mesh.points = filtered(mesh.points, rings, {filterOf(kLastIterations, kLastPassBand)}).front();
  return mesh;
}

} // namespace viscera::medical_io
