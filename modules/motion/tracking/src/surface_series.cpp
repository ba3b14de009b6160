#include "viscera/tracking/surface_series.h"

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/geometry/clean_surface.h"
#include "viscera/geometry/close_holes.h"
#include "viscera/geometry/signed_distance.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/volume.h"

namespace viscera::tracking {
namespace {

constexpr double kSamePlaceMm = 1e-6;

void requireAlike(const SurfaceSeries& series) {
  if (series.phases.empty())
    throw DataError(misuse("It has no phase"), series.name, misuse("name one surface for each phase"));
  const Eigen::Index points = series.phases.front().rows();
  for (std::size_t phase = 0; phase < series.phases.size(); ++phase) {
    if (series.phases[phase].rows() != points)
      throw DataError(phrase("Phase %1 has %2 points and the first has %3", phase + 1,
                             series.phases[phase].rows(), points),
                      series.name, "export all phases with the same triangles");
    geometry::requireValid(series.at(phase), phrase("%1, phase %2", series.name, phase + 1));
  }
}

/// The first point at the place of each, in the first phase.
std::vector<std::int32_t> firstAtPlace(const Points& points) {
  std::map<std::array<std::int64_t, 3>, std::int32_t> places;
  std::vector<std::int32_t> first;
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    std::array<std::int64_t, 3> place{};
    for (int axis = 0; axis < 3; ++axis)
      place[static_cast<std::size_t>(axis)] = std::llround(points(i, axis) / kSamePlaceMm);
    first.push_back(places.try_emplace(place, static_cast<std::int32_t>(i)).first->second);
  }
  return first;
}

/// Leaves out repeated points, triangles that lose a corner by it, and points of no triangle.
void mergePoints(TidySeries& tidy) {
  SurfaceSeries& series = tidy.series;
  const std::vector<std::int32_t> first = firstAtPlace(series.phases.front());
  std::vector<bool> used(first.size(), false);
  Eigen::Index kept = 0;
  for (Eigen::Index t = 0; t < series.triangles.rows(); ++t) {
    Eigen::Matrix<std::int32_t, 1, 3> corners = series.triangles.row(t);
    for (std::int32_t& corner : corners.reshaped())
      corner = first[static_cast<std::size_t>(corner)];
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
      continue;
    series.triangles.row(kept++) = corners;
    for (const std::int32_t corner : corners.reshaped())
      used[static_cast<std::size_t>(corner)] = true;
  }
  series.triangles.conservativeResize(kept, 3);
  std::vector<std::int32_t> name(first.size(), -1);
  std::int32_t next = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (used[i])
      name[i] = next++;
    const auto row = static_cast<Eigen::Index>(i), same = static_cast<Eigen::Index>(first[i]);
    if (row == same)
      continue;
    ++tidy.mergedPoints;
    for (const Points& phase : series.phases)
      tidy.mergedApartMm = std::max(tidy.mergedApartMm, (phase.row(row) - phase.row(same)).norm());
  }
  for (Points& phase : series.phases) {
    for (std::size_t i = 0; i < name.size(); ++i)
      if (name[i] >= 0)
        phase.row(name[i]) = phase.row(static_cast<Eigen::Index>(i)).eval();
    phase.conservativeResize(next, 3);
  }
  for (std::int32_t& corner : series.triangles.reshaped())
    corner = name[static_cast<std::size_t>(corner)];
  for (const std::int32_t same : first)
    series.rowOfGiven.push_back(name[static_cast<std::size_t>(same)]);
}

/// Closes the holes of the first phase, and the same ones in the others.
void closeAll(TidySeries& tidy) {
  SurfaceSeries& series = tidy.series;
  const Eigen::Index points = series.phases.front().rows(), triangles = series.triangles.rows();
  const geometry::ClosedSurface closed = geometry::closeHoles(series.at(0));
  tidy.closedHoles = closed.holes;
  series.triangles = closed.mesh.triangles;
  std::map<std::int32_t, std::set<std::int32_t>> rims; // By the number of the middle.
  for (Eigen::Index t = triangles; t < series.triangles.rows(); ++t)
    for (int k = 0; k < 3; ++k)
      if (series.triangles(t, k) >= points)
        for (int other = 1; other < 3; ++other)
          rims[series.triangles(t, k)].insert(series.triangles(t, (k + other) % 3));
  for (Points& phase : series.phases) {
    phase.conservativeResize(closed.mesh.points.rows(), 3);
    for (const auto& [middle, rim] : rims) {
      phase.row(middle).setZero();
      for (const std::int32_t point : rim)
        phase.row(middle) += phase.row(point) / static_cast<double>(rim.size());
    }
  }
}

} // namespace

TidySeries tidySeries(SurfaceSeries series) {
  requireAlike(series);
  TidySeries tidy{std::move(series)};
  mergePoints(tidy);
  if (tidy.series.triangles.rows() == 0)
    throw DataError("It has no triangle with three different corners", tidy.series.name,
                    "export the surface again");
  geometry::TriangleMesh reference = tidy.series.at(0);
  tidy.turnedTriangles = geometry::faceOutward(reference);
  tidy.series.triangles = reference.triangles;
  closeAll(tidy);
  reference = tidy.series.at(0);
  if (geometry::orientOutward(reference))
    tidy.series.triangles = reference.triangles;
  if (const geometry::SurfaceReport report = geometry::checkSurface(reference);
      !report.closed() || !report.manifold())
    throw DataError(phrase("It is not a closed surface, even with its holes filled: %1",
                           geometry::faults(report).front()),
                    tidy.series.name, "repair the surfaces in the program that made them");
  return tidy;
}

std::size_t outerOf(const std::vector<geometry::TriangleMesh>& surfaces) {
  if (surfaces.empty())
    throw DataError(misuse("There is no surface"), "series", misuse("name one at least"));
  std::size_t outer = 0;
  double largest = -1;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
    if (const double volume = geometry::volume(surfaces[i].points, surfaces[i].triangles); volume > largest) {
      largest = volume;
      outer = i;
    }
  return outer;
}

double partOutside(const geometry::TriangleMesh& inner,
                   const std::shared_ptr<const geometry::TriangleMesh>& outer, double toleranceMm) {
  const geometry::SignedDistance distance(outer);
  const Values areas = vertexAreas(inner.points, inner.triangles);
  double outside = 0;
  for (Eigen::Index v = 0; v < inner.points.rows(); ++v)
    if (distance(inner.points.row(v).transpose()) > toleranceMm)
      outside += areas[v];
  return outside / areas.sum();
}

Values vertexAreas(const Points& points, const Triangles& triangles) {
  Values areas = Values::Zero(points.rows());
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const Vec3 a = points.row(triangles(t, 0)), b = points.row(triangles(t, 1)),
               c = points.row(triangles(t, 2));
    const double third = (b - a).cross(c - a).norm() / 6;
    for (int k = 0; k < 3; ++k)
      areas[triangles(t, k)] += third;
  }
  return areas;
}

} // namespace viscera::tracking
