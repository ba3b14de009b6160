#include "viscera/medical_io/surface_repairs.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/geometry/clean_surface.h"
#include "viscera/geometry/close_holes.h"
#include "viscera/geometry/connected_pieces.h"
#include "viscera/geometry/decimate_surface.h"
#include "viscera/geometry/self_intersections.h"
#include "viscera/geometry/signed_distance.h"
#include "viscera/geometry/signed_distance_grid.h"
#include "viscera/geometry/surface_check.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/geometry/volume.h"
#include "viscera/medical_io/contour.h"
#include "viscera/medical_io/plausible_size.h"
#include "viscera/medical_io/surface_pieces.h"
#include "windowed_sinc.h"

namespace viscera::medical_io {
namespace {

using geometry::TriangleMesh;

/// Edge of the clusters that triangles are merged to before distances are measured, by the grid's spacing.
constexpr double kClusterScale = 0.5;
constexpr int kSmoothingRounds = 2;
constexpr double kSmallestPiece = 0.01; ///< Of the whole volume.
/// Smoothing of the contour, whose triangles are the grid's, then of the thinned surface: as often as the
/// first says, or as often as the others when triangles cross.
constexpr std::array kFirstIterations = {20, 30, 10}, kSecondIterations = {10, 2, 0};
constexpr double kFirstPassBand = 0.05, kSecondPassBand = 0.1;
/// A piece with fewer cells along its longest side may have no zero level on the smoothed grid.
constexpr double kFewestCells = 4;
constexpr Eigen::Index kVerticesAtOnce = 512;
constexpr int kFewestTriangles = 500, kMostTriangles = 20'000;
constexpr int kUsualCells = 100, kMostCells = 300, kMostFineTriangles = 200'000;
/// Triangles of the area of one cell's side.
constexpr double kTrianglesPerCell = 0.5;
/// Part of the diagonal: a surface that lies farther away has lost a detail.
constexpr double kLostDetail = 0.02;
constexpr double kLeastFactor = 1e-6, kLargestFactor = 1e6, kMostMm = 1e4;

/// A repair that takes no time worth reporting.
template <class Function>
SurfaceRepair quick(std::string id, Text does, Function function) {
  return {std::move(id), std::move(does),
          [function](const TriangleMesh& mesh, Progress& progress, Threads) -> TriangleMesh {
            progress.throwIfCancelled();
            return function(mesh);
          },
          false};
}

/// Turns a model that stands on its y axis and looks along z, as programs for films and prints write it: x
/// goes to the patient's left there too. A quarter turn about x.
TriangleMesh stoodUp(TriangleMesh mesh) {
  const Values up = mesh.points.col(1);
  mesh.points.col(1) = -mesh.points.col(2);
  mesh.points.col(2) = up;
  return mesh;
}

/// Turns a model in RAS that stands on its y axis.
TriangleMesh stoodUpFromRas(TriangleMesh mesh) {
  return geometry::turnedHalf(stoodUp(std::move(mesh)));
}

/// Changes the signs of coordinates; a mirror image's triangles still face outward.
TriangleMesh withSigns(TriangleMesh mesh, const Vec3& signs) {
  if (signs.prod() < 0) {
    mesh = geometry::mirrored(std::move(mesh));
    mesh.points.col(0) *= -1;
  }
  mesh.points.array().rowwise() *= signs.transpose().array();
  return mesh;
}

/// A repair that changes the signs of coordinates.
SurfaceRepair flip(std::string id, Text does, const Vec3& signs) {
  return quick(std::move(id), std::move(does),
               [signs](const TriangleMesh& mesh) { return withSigns(mesh, signs); });
}

SurfaceRepair removal(const FragmentLimit& limit) {
  SurfaceRepair repair =
      quick("remove-fragments", "drops the pieces that are smaller than a size; the largest one stays",
            [limit](const TriangleMesh& mesh) { return SurfacePieces(mesh).part(limit, false); });
  repair.value = RepairValue{FragmentLimit{}.value, 0, kMostMm, {"%", "mm", "ml"}};
  return repair;
}

SurfaceRepair scaling(double factor) {
  SurfaceRepair repair = quick("scale", "multiplies all coordinates by a factor",
                               [factor](const TriangleMesh& mesh) { return geometry::scaled(mesh, factor); });
  repair.value = RepairValue{0, kLeastFactor, kLargestFactor, {}};
  return repair;
}

/// The number at the begin of a text, with nothing but `unit`, which may be left out, behind it.
std::optional<double> numberIn(std::string_view text, std::string_view unit) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view rest = text.substr(static_cast<std::size_t>(end - text.data()));
  if (error != std::errc() || (!rest.empty() && rest != unit))
    return std::nullopt;
  return value;
}

/// The repair with a value in place of what it is without one.
std::optional<SurfaceRepair> withValue(const SurfaceRepair& repair, std::string_view words) {
  if (repair.id == "remove-fragments") {
    const auto limit = fragmentLimit(words);
    return limit ? std::optional(removal(*limit)) : std::nullopt;
  }
  const auto value = numberIn(words, repair.id == "remesh" ? "mm" : "");
  if (!value || !repair.value || !(*value >= repair.value->low && *value <= repair.value->high))
    return std::nullopt;
  if (repair.id == "scale")
    return scaling(*value);
  SurfaceRepair finer = repair;
  finer.apply = [mm = *value](const TriangleMesh& mesh, Progress& progress, Threads threads) {
    return remeshedAt(mesh, mm, 0, progress, threads);
  };
  return finer;
}

std::vector<SurfaceRepair> allRepairs() {
  std::vector<SurfaceRepair> list = {
      quick("orient", "turns triangles around so that all of them face outward",
            [](TriangleMesh mesh) {
              geometry::faceOutward(mesh);
              return mesh;
            }),
      quick("fill-holes", "fills every hole with a cap",
            [](const TriangleMesh& mesh) { return geometry::closeHoles(mesh).mesh; }),
      removal(FragmentLimit{}),
      quick("keep-largest", "keeps the piece with the largest area and drops the others",
            [](const TriangleMesh& mesh) { return geometry::largestPiece(mesh); }),
      {"remesh", "makes a closed surface without intersections near this one; colours are lost",
       [](const TriangleMesh& mesh, Progress& progress, Threads threads) {
         return remeshed(mesh, 0, progress, threads);
       },
       true, RepairValue{0, 0.01, kMostMm, {"mm"}}},
      scaling(1),
      quick("mirror", "exchanges left and right", geometry::mirrored),
      quick("ras-to-lps", "turns the surface by half a turn, as from RAS to LPS", geometry::turnedHalf),
      quick("y-up", "turns the surface by a quarter turn, from a model whose y axis points to the head",
            stoodUp),
      quick("y-up-ras",
            "turns the surface by a quarter and a half turn, from a model in RAS whose y axis points to the "
            "head",
            stoodUpFromRas),
      flip("flip-y", "exchanges front and back, which mirrors the surface", {1, -1, 1}),
      flip("flip-z", "exchanges head and feet, which mirrors the surface", {1, 1, -1}),
      flip("flip-yz", "exchanges head and feet, and front and back, by half a turn", {1, -1, -1}),
      flip("flip-xz", "exchanges head and feet, and right and left, by half a turn", {-1, 1, -1}),
      flip("flip-xyz", "exchanges all three directions, which mirrors the surface", {-1, -1, -1})};
  for (const LengthUnit& unit : lengthUnits())
    if (unit.mm != 1)
      list.push_back(quick("unit-" + std::string(unit.id),
                           phrase("takes the coordinates as %1", named(unit.name)),
                           [mm = unit.mm](const TriangleMesh& mesh) { return geometry::scaled(mesh, mm); }));
  return list;
}

/// Drops what is too small to matter, cavities as well as crumbs.
TriangleMesh withoutCrumbs(TriangleMesh mesh) {
  const auto [count, piece] = geometry::connectedPieces(mesh);
  const Vec3 middle = boundsOf(mesh.points).center();
  std::vector<double> volumes(static_cast<std::size_t>(count), 0.0);
  const auto corner = [&](Eigen::Index t, int k) -> Vec3 {
    return mesh.points.row(mesh.triangles(t, k)).transpose() - middle;
  };
  double total = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const double part = corner(t, 0).dot(corner(t, 1).cross(corner(t, 2))) / 6;
    volumes[static_cast<std::size_t>(piece[static_cast<std::size_t>(mesh.triangles(t, 0))])] += part;
    total += part;
  }
  Eigen::Index kept = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    if (std::abs(volumes[static_cast<std::size_t>(piece[static_cast<std::size_t>(mesh.triangles(t, 0))])]) >=
        kSmallestPiece * std::abs(total))
      mesh.triangles.row(kept++) = mesh.triangles.row(t).eval();
  mesh.triangles.conservativeResize(kept, 3);
  return mesh;
}

/// Why there is no zero level.
DataError nothingEnclosed(const TriangleMesh& mesh, double spacing) {
  const Bounds largest = boundsOf(geometry::largestPiece(mesh).points);
  if (geometry::connectedPieces(mesh).count > 1 &&
      (largest.high - largest.low).maxCoeff() < kFewestCells * spacing)
    return DataError(phrase("every piece of the surface is smaller than the %1 mm that remeshing resolves",
                            inDigits(kFewestCells * spacing, 2)),
                     "surface", "keep the largest piece first");
  return DataError("the surface encloses nothing", "surface",
                   "check that its triangles face outward and that its holes are small");
}

/// The contour smoothed and thinned out. Collapsed edges near a crease, and smoothing where triangles are
/// large, now and then push one triangle through another: the first way without that is taken, else the one
/// with the fewest.
TriangleMesh smoothAndThin(const TriangleMesh& contour, int triangles, const Progress& progress,
                           Threads threads) {
  TriangleMesh best;
  int fewest = std::numeric_limits<int>::max();
  for (const int first : kFirstIterations) {
    const TriangleMesh thin =
        geometry::decimateClosedSurface(smoothSurface(contour, first, kFirstPassBand), triangles, progress);
    for (const int second : kSecondIterations) {
      progress.throwIfCancelled();
      TriangleMesh tried =
          geometry::cleanSurface(second > 0 ? smoothSurface(thin, second, kSecondPassBand) : thin).mesh;
      Progress ofTheCount;
      const int crossings = geometry::countSelfIntersections(tried, ofTheCount, threads);
      if (crossings < fewest) {
        fewest = crossings;
        best = std::move(tried);
      }
      if (fewest == 0)
        return best;
    }
  }
  return best;
}

} // namespace

const std::vector<SurfaceRepair>& surfaceRepairs() {
  static const std::vector<SurfaceRepair> kRepairs = allRepairs();
  return kRepairs;
}

SurfaceRepair surfaceRepair(std::string_view id) {
  const std::size_t end = std::min(id.find('='), id.size());
  std::string known;
  for (const SurfaceRepair& repair : surfaceRepairs()) {
    if (repair.id == id && repair.id != "scale")
      return repair;
    if (repair.id == id.substr(0, end) && repair.value) {
      auto special = withValue(repair, id.substr(std::min(end + 1, id.size())));
      if (!special)
        throw UsageError(misuse("\"%1\" is no value for the repair \"%2\"",
                                std::string(id.substr(std::min(end + 1, id.size()))), repair.id),
                         {}, misuse("for example remove-fragments=5mm, remesh=1.5 or scale=0.1"));
      special->id = id;
      return std::move(*special);
    }
    known += (known.empty() ? "" : ", ") + repair.id;
  }
  throw UsageError(misuse("there is no repair \"%1\"", std::string(id)), {}, misuse("there are: %1", known));
}

TriangleMesh repairSurface(const TriangleMesh& mesh, const RepairOptions& options, Progress& progress,
                           Threads threads) {
  const Bounds box = boundsOf(mesh.points);
  const double spacing = (box.high - box.low).maxCoeff() / options.cells;
  if (mesh.triangles.rows() == 0 || !(spacing > 0))
    throw DataError("the surface has no triangles or no size", "surface");
  const TriangleMesh coarse = geometry::clusterVertices(mesh, kClusterScale * spacing);
  geometry::SignedDistanceGrid grid = geometry::signedDistanceGrid(coarse, spacing, progress, threads);
  geometry::smoothen(grid, kSmoothingRounds, threads);
  progress.throwIfCancelled();
  const TriangleMesh zeroLevel =
      withoutCrumbs(contourOf(grid.values, grid.size, 0, grid.origin, grid.spacing));
  if (zeroLevel.triangles.rows() == 0)
    throw nothingEnclosed(mesh, spacing);
  return smoothAndThin(zeroLevel, options.triangles, progress, threads);
}

TriangleMesh thinSurface(const TriangleMesh& mesh, int triangles) {
  if (mesh.triangles.rows() <= triangles)
    return mesh;
  const geometry::SurfaceReport report = geometry::checkSurface(mesh);
  if (!report.closed() || !report.manifold())
    return mesh;
  return geometry::cleanSurface(geometry::decimateClosedSurface(mesh, triangles)).mesh;
}

TriangleMesh remeshed(const TriangleMesh& mesh, int triangles, Progress& progress, Threads threads) {
  RepairOptions options;
  options.triangles =
      triangles > 0 ? triangles
                    : std::clamp(static_cast<int>(mesh.triangles.rows()), kFewestTriangles, kMostTriangles);
  return repairSurface(mesh, options, progress, threads);
}

double usualResolutionMm(const TriangleMesh& mesh) {
  const Bounds box = boundsOf(mesh.points);
  return (box.high - box.low).maxCoeff() / kUsualCells;
}

double finestResolutionMm(const TriangleMesh& mesh) {
  return usualResolutionMm(mesh) * kUsualCells / kMostCells;
}

int trianglesAt(const TriangleMesh& mesh, double resolutionMm) {
  const double count =
      kTrianglesPerCell * geometry::area(mesh.points, mesh.triangles) / (resolutionMm * resolutionMm);
  return static_cast<int>(std::clamp(count, double(kFewestTriangles), double(kMostFineTriangles)));
}

TriangleMesh remeshedAt(const TriangleMesh& mesh, double resolutionMm, int triangles, Progress& progress,
                        Threads threads) {
  const double finest = finestResolutionMm(mesh);
  if (!(resolutionMm >= finest * (1 - 1e-9)))
    throw DataError(phrase("details of %1 mm take too much memory; %2 mm is the finest for its size",
                           inDigits(resolutionMm, 2), inDigits(finest, 2)),
                    "surface", "choose a coarser resolution");
  RepairOptions options;
  options.cells = std::max(1, static_cast<int>(std::lround(finest * kMostCells / resolutionMm)));
  options.triangles = triangles > 0 ? triangles : trianglesAt(mesh, resolutionMm);
  return repairSurface(mesh, options, progress, threads);
}

SurfaceChange surfaceChange(const TriangleMesh& before, const TriangleMesh& after, Threads threads) {
  const geometry::SignedDistance distance(std::make_shared<const TriangleMesh>(after));
  std::vector<int> used(before.triangles.data(), before.triangles.data() + before.triangles.size());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  Values distances(static_cast<Eigen::Index>(used.size()));
  parallelRanges(distances.size(), kVerticesAtOnce, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i)
      distances[i] = std::abs(distance(before.points.row(used[static_cast<std::size_t>(i)])));
  });
  const bool any = distances.size() > 0;
  return {before.triangles.rows(), after.triangles.rows(), any ? distances.mean() : 0,
          any ? distances.maxCoeff() : 0, boundsOf(before.points).diagonal()};
}

std::optional<Text> doubtAbout(const SurfaceChange& change) {
  if (change.maximumMm <= kLostDetail * change.diagonalMm)
    return std::nullopt;
  return phrase("remeshing lost a detail: the old surface lies up to %1 mm from the new one",
                inDigits(change.maximumMm, 2));
}

Text inWords(const SurfaceChange& change) {
  return phrase(
      "%1 triangles instead of %2; the old surface lies %3 mm from the new one on average, %4 mm at most",
      change.trianglesAfter, change.trianglesBefore, inDigits(change.meanMm, 2),
      inDigits(change.maximumMm, 2));
}

} // namespace viscera::medical_io
