#include "viscera/strain/wall_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>

#include <Eigen/Geometry>
#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include "open_surface.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/strain/aha_segments.h"
#include "viscera/strain/valve_caps.h"
#include "viscera/strain/wall_measures.h"

namespace viscera::strain {
namespace {

using deformation::WitnessMesh;

/// The tetrahedra from a little behind the annulus on matter: the axes at the annulus need what is around it.
constexpr double kBehindAnnulus = -0.15;
/// Where no tissue lies behind the annulus, this part of the long axis stands for it.
constexpr double kAnnulusLayer = 0.03;
/// The tip: beyond this height and within this part of the long axis' length from it.
constexpr double kTipHeight = 0.95, kTipRadius = 0.06;
/// The end of a wall that is open at the apex, as a part of its extent.
constexpr double kEndLayer = 0.03;
/// Deeper points lie in the right ventricle's free wall, where both sides have depth 1.
constexpr double kDeepest = 0.985;
/// Tissue that is farther from the cavity than this times the thickness which this part of a segment's wall
/// does not exceed belongs to something else: fat of a groove, the root of a vessel, an auricle.
constexpr double kThickest = 1.1, kThickPart = 0.75;
/// Keeps a piece without boundary values solvable, as a part of the mean stiffness.
constexpr double kRegular = 1e-12;
/// The residual of Laplace's equation as a part of the right-hand side.
constexpr double kResidual = 1e-12;
constexpr Eigen::Index kGrain = 256;
constexpr double kFree = std::numeric_limits<double>::quiet_NaN();

using Corners = std::array<Eigen::Index, 4>;

/// One tetrahedron with the gradients of its four hat functions.
struct Element {
  Corners corners;
  Eigen::Matrix<double, 4, 3> gradients;
  double volume = 0;
};

std::vector<Element> elementsOf(const WitnessMesh& mesh, const Values& heights) {
  std::vector<Element> elements;
  for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t) {
    Element element;
    bool inside = true;
    for (int k = 0; k < 4; ++k) {
      element.corners[static_cast<std::size_t>(k)] = mesh.tetrahedra(t, k);
      inside = inside && heights[mesh.tetrahedra(t, k)] >= kBehindAnnulus;
    }
    if (!inside)
      continue;
    Eigen::Matrix3d edges;
    for (int k = 1; k < 4; ++k)
      edges.row(k - 1) =
          mesh.points.row(element.corners[static_cast<std::size_t>(k)]) - mesh.points.row(element.corners[0]);
    const double determinant = edges.determinant();
    if (!(determinant > 0))
      continue;
    element.volume = determinant / 6;
    const Eigen::Matrix3d inverse = edges.inverse();
    for (int k = 1; k < 4; ++k)
      element.gradients.row(k) = inverse.col(k - 1).transpose();
    element.gradients.row(0) =
        -(element.gradients.row(1) + element.gradients.row(2) + element.gradients.row(3));
    elements.push_back(element);
  }
  return elements;
}

/// Solves Laplace's equation: `given` holds the value at boundary nodes and NaN elsewhere; nodes of no
/// element keep NaN.
Values harmonic(const std::vector<Element>& elements, Values given) {
  std::vector<Eigen::Index> unknown(static_cast<std::size_t>(given.size()), -1);
  Eigen::Index count = 0;
  for (const Element& element : elements)
    for (const Eigen::Index node : element.corners)
      if (std::isnan(given[node]) && unknown[static_cast<std::size_t>(node)] < 0)
        unknown[static_cast<std::size_t>(node)] = count++;
  if (count == 0)
    return given;
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(16 * elements.size());
  Values right = Values::Zero(count);
  double trace = 0;
  for (const Element& element : elements)
    for (int i = 0; i < 4; ++i) {
      const Eigen::Index row =
          unknown[static_cast<std::size_t>(element.corners[static_cast<std::size_t>(i)])];
      if (row < 0)
        continue;
      for (int j = 0; j < 4; ++j) {
        const Eigen::Index node = element.corners[static_cast<std::size_t>(j)];
        const double stiffness = element.volume * element.gradients.row(i).dot(element.gradients.row(j));
        const Eigen::Index column = unknown[static_cast<std::size_t>(node)];
        if (column < 0)
          right[row] -= stiffness * given[node];
        else
          entries.emplace_back(static_cast<int>(row), static_cast<int>(column), stiffness);
        if (row == column)
          trace += stiffness;
      }
    }
  for (Eigen::Index i = 0; i < count; ++i)
    entries.emplace_back(static_cast<int>(i), static_cast<int>(i),
                         kRegular * trace / static_cast<double>(count));
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  // A factor of such a matrix fills up: the iteration takes a tenth of its time.
  Eigen::ConjugateGradient<Eigen::SparseMatrix<double>, Eigen::Lower, Eigen::IncompleteCholesky<double>>
      solver(matrix);
  solver.setTolerance(kResidual);
  const Values solution = solver.solve(right);
  if (solver.info() != Eigen::Success)
    throw DataError("The wall cannot be divided into layers", "heart", "use fewer witness points");
  for (Eigen::Index node = 0; node < given.size(); ++node)
    if (const Eigen::Index row = unknown[static_cast<std::size_t>(node)]; row >= 0)
      given[node] = solution[row];
  return given;
}

/// The gradient of a field at the nodes: the mean of the elements around, by their volumes.
Points nodeGradients(const std::vector<Element>& elements, const Values& field, Eigen::Index nodes) {
  Points sums = Points::Zero(nodes, 3);
  for (const Element& element : elements) {
    Eigen::RowVector3d gradient = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 4; ++k)
      gradient += field[element.corners[static_cast<std::size_t>(k)]] * element.gradients.row(k);
    for (const Eigen::Index node : element.corners)
      sums.row(node) += element.volume * gradient;
  }
  return sums; // The direction alone counts.
}

bool isMarked(const std::vector<bool>& flags) {
  return std::find(flags.begin(), flags.end(), true) != flags.end();
}

/// The depth at the nodes of the solid's skin: by the surface that is nearest; NaN at valves, and in the
/// plane in which an epicardium ends.
Values boundaryDepth(const WitnessMesh& mesh, const Values& heights, const WallSurfaces& surfaces,
                     const HeartAxes& axes, const std::vector<bool>& cap, Threads threads) {
  const OpenSurface inner(surfaces.leftCavity->points, surfaces.leftCavity->triangles, cap);
  const std::vector<bool> outerCap = valveCaps(*surfaces.outer, -axes.down()).triangles;
  std::optional<OpenSurface> valves, plane, right;
  if (isMarked(cap))
    valves.emplace(surfaces.leftCavity->points, onlyMarked(surfaces.leftCavity->triangles, cap));
  if (isMarked(outerCap))
    plane.emplace(surfaces.outer->points, onlyMarked(surfaces.outer->triangles, outerCap));
  if (surfaces.rightCavity)
    right.emplace(surfaces.rightCavity->points, surfaces.rightCavity->triangles);
  const OpenSurface outer(surfaces.outer->points, surfaces.outer->triangles, outerCap);
  std::vector<bool> onSkin(static_cast<std::size_t>(mesh.points.rows()), false);
  const Triangles skin = deformation::skinOf(mesh.tetrahedra);
  for (const std::int32_t corner : skin.reshaped())
    onSkin[static_cast<std::size_t>(corner)] = true;
  Values depth = Values::Constant(mesh.points.rows(), kFree);
  parallelRanges(mesh.points.rows(), kGrain, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index node = begin; node < end; ++node) {
      if (!onSkin[static_cast<std::size_t>(node)] || heights[node] < kBehindAnnulus)
        continue;
      const Vec3 place = mesh.points.row(node).transpose();
      const double toInner = inner.distanceTo(place);
      double toOuter = outer.distanceTo(place);
      if (right)
        toOuter = std::min(toOuter, right->distanceTo(place));
      double toValves = std::numeric_limits<double>::infinity();
      for (const std::optional<OpenSurface>* open : {&valves, &plane})
        if (*open)
          toValves = std::min(toValves, (*open)->distanceTo(place));
      if (toValves < std::min(toInner, toOuter))
        continue;
      depth[node] = toInner <= toOuter ? 0 : 1;
    }
  });
  return depth;
}

/// 1 at the annulus, 0 at the tip, NaN elsewhere.
Values boundaryAlong(const WitnessMesh& mesh, const Values& heights, const HeartAxes& axes,
                     const std::vector<Element>& elements) {
  Values along = Values::Constant(mesh.points.rows(), kFree);
  std::vector<bool> used(static_cast<std::size_t>(mesh.points.rows()), false);
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const Element& element : elements)
    for (const Eigen::Index node : element.corners) {
      used[static_cast<std::size_t>(node)] = true;
      lowest = std::min(lowest, heights[node]);
      highest = std::max(highest, heights[node]);
    }
  const double annulus = lowest < 0 ? 0 : lowest + kAnnulusLayer;
  bool tipFound = false;
  for (Eigen::Index node = 0; node < along.size(); ++node) {
    if (!used[static_cast<std::size_t>(node)])
      continue;
    if (heights[node] <= annulus)
      along[node] = 1;
    else if (heights[node] > kTipHeight &&
             axes.distanceOf(mesh.points.row(node).transpose()) < kTipRadius * axes.length()) {
      along[node] = 0;
      tipFound = true;
    }
  }
  for (Eigen::Index node = 0; !tipFound && node < along.size(); ++node)
    if (used[static_cast<std::size_t>(node)] && heights[node] > highest - kEndLayer * (highest - lowest))
      along[node] = 0;
  return along;
}

} // namespace

std::array<double, kSegments + 1> reachOfSegments(const WallSurfaces& surfaces, const HeartAxes& axes,
                                                  const std::vector<bool>& cap, Threads threads) {
  const OpenSurface outer(surfaces.outer->points, surfaces.outer->triangles,
                          valveCaps(*surfaces.outer, -axes.down()).triangles);
  std::optional<OpenSurface> right;
  if (surfaces.rightCavity)
    right.emplace(surfaces.rightCavity->points, surfaces.rightCavity->triangles);
  const Points& endocardium = surfaces.leftCavity->points;
  const std::vector<bool> onWall = verticesOf(endocardium.rows(), surfaces.leftCavity->triangles, cap);
  Values thickness(endocardium.rows());
  parallelRanges(endocardium.rows(), kGrain, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index row = begin; row < end; ++row) {
      const Vec3 place = endocardium.row(row).transpose();
      thickness[row] = outer.distanceTo(place);
      if (right)
        thickness[row] = std::min(thickness[row], right->distanceTo(place));
    }
  });
  std::array<std::vector<double>, kSegments + 1> found;
  for (Eigen::Index row = 0; row < thickness.size(); ++row)
    if (onWall[static_cast<std::size_t>(row)])
      found[static_cast<std::size_t>(segmentOf(axes, endocardium.row(row).transpose()))].push_back(
          thickness[row]);
  std::array<double, kSegments + 1> reach;
  reach.fill(std::numeric_limits<double>::infinity());
  for (std::size_t segment = 1; segment < found.size(); ++segment)
    if (!found[segment].empty()) {
      const auto thick = found[segment].begin() +
                         static_cast<std::ptrdiff_t>(kThickPart * static_cast<double>(found[segment].size()));
      std::nth_element(found[segment].begin(), thick, found[segment].end());
      reach[segment] = kThickest * *thick;
    }
  return reach;
}

namespace {

/// The segment of each node within the reach of its wall, 0 elsewhere.
std::vector<int> segmentsOfWall(const WitnessMesh& mesh, const WallSurfaces& surfaces, const HeartAxes& axes,
                                const std::vector<bool>& cap, Threads threads) {
  const OpenSurface inner(surfaces.leftCavity->points, surfaces.leftCavity->triangles, cap);
  const std::array<double, kSegments + 1> reach = reachOfSegments(surfaces, axes, cap, threads);
  std::vector<int> segments(static_cast<std::size_t>(mesh.points.rows()), 0);
  parallelRanges(mesh.points.rows(), kGrain, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index node = begin; node < end; ++node) {
      const Vec3 place = mesh.points.row(node).transpose();
      const int segment = segmentOf(axes, place);
      if (segment != 0 && inner.distanceTo(place) <= reach[static_cast<std::size_t>(segment)])
        segments[static_cast<std::size_t>(node)] = segment;
    }
  });
  return segments;
}

} // namespace

WallPoints wallPoints(const WitnessMesh& mesh, const WallSurfaces& surfaces, const HeartAxes& axes,
                      const std::vector<bool>& cap, Progress& progress, Threads threads) {
  Values heights(mesh.points.rows());
  for (Eigen::Index node = 0; node < heights.size(); ++node)
    heights[node] = axes.heightOf(mesh.points.row(node).transpose());
  const std::vector<Element> elements = elementsOf(mesh, heights);
  const Values given = boundaryDepth(mesh, heights, surfaces, axes, cap, threads);
  if ((given.array() == 0).count() == 0 || (given.array() == 1).count() == 0)
    throw DataError("The tissue does not reach from the cavity to the outer surface", "heart",
                    "choose the surfaces of one heart");
  progress.report(0.2, "layers of the wall");
  const Values depth = harmonic(elements, given);
  progress.throwIfCancelled();
  progress.report(0.6, "layers of the wall");
  const Values along = harmonic(elements, boundaryAlong(mesh, heights, axes, elements));
  progress.throwIfCancelled();
  const Points radial = nodeGradients(elements, depth, mesh.points.rows());
  const Points towardsBase = nodeGradients(elements, along, mesh.points.rows());
  Values volumes = Values::Zero(mesh.points.rows());
  for (const Element& element : elements)
    for (const Eigen::Index node : element.corners)
      volumes[node] += element.volume / 4;
  const std::vector<int> segments = segmentsOfWall(mesh, surfaces, axes, cap, threads);
  WallPoints wall;
  std::vector<double> depths, shares;
  for (Eigen::Index node = 0; node < mesh.witnesses; ++node) {
    const bool inWall =
        given.size() > node && std::isnan(given[node]) && depth[node] > 0 && depth[node] < kDeepest;
    const int segment = inWall ? segments[static_cast<std::size_t>(node)] : 0;
    const Vec3 across = radial.row(node).transpose();
    if (segment == 0 || !(across.norm() > 0))
      continue;
    const Vec3 up = towardsBase.row(node).transpose();
    wall.rows.push_back(static_cast<std::int32_t>(node));
    wall.axes.push_back(localAxes(across, up.norm() > 0 ? up : Vec3(-axes.down())));
    wall.segments.push_back(segment);
    depths.push_back(depth[node]);
    shares.push_back(volumes[node]);
  }
  wall.depth = Eigen::Map<const Values>(depths.data(), static_cast<Eigen::Index>(depths.size()));
  wall.volumes = Eigen::Map<const Values>(shares.data(), static_cast<Eigen::Index>(shares.size()));
  progress.report(1);
  return wall;
}

} // namespace viscera::strain
