#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>

#include "viscera/core/error.h"
#include "viscera/core/inner_job.h"
#include "viscera/deformation/rotational_stress.h"
#include "viscera/elasticity/drag_table.h"
#include "viscera/geometry/convex_hull.h"

namespace viscera::elasticity {
namespace {

/// A hull that does not hold the organ is moved outward by this factor, so often at most.
constexpr double kFartherOut = 1.1;
constexpr int kMostFarther = 60;
constexpr int kMostHalved = 3;

/// Directions spread evenly over the sphere along a spiral (Gonzalez 2010, doi:10.1007/s11004-009-9257-x).
Points evenDirections(int count) {
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  Points directions(count, 3);
  for (int i = 0; i < count; ++i) {
    const double z = 1 - (2 * i + 1.0) / count, r = std::sqrt(1 - z * z);
    directions.row(i) << r * std::cos(golden * i), r * std::sin(golden * i), z;
  }
  return directions;
}

/// One handle in one direction.
struct Drag {
  int handle;
  Vec3 direction;
};

/// A number in [0, 1) that is the same with every standard library.
double drawn(std::mt19937& random) {
  return random() / 4294967296.0;
}

std::vector<Drag> drawnDrags(Eigen::Index handles, int count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<int> order(static_cast<std::size_t>(handles));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(drawn(random) * static_cast<double>(i))]);
  std::vector<Drag> drags;
  for (int d = 0; d < count; ++d) {
    const double z = 2 * drawn(random) - 1, turn = 2 * std::numbers::pi * drawn(random);
    const double r = std::sqrt(1 - z * z);
    drags.push_back(
        {order[static_cast<std::size_t>(d) % order.size()], {r * std::cos(turn), r * std::sin(turn), z}});
  }
  return drags;
}

ElasticDrag solved(const DragScene& scene, const Drag& drag, const DragOptions& options, Progress& progress) {
  SolveOptions solve;
  solve.threads = Threads{1};
  double length = options.dragFraction * scene.diagonalMm;
  const auto begin = std::chrono::steady_clock::now();
  ElasticDrag found;
  for (int halved = 0; halved <= kMostHalved; ++halved, length *= 0.5) {
    Points pose = scene.handles.positions;
    pose.row(drag.handle) += length * drag.direction.transpose();
    try {
      const Grips grips = gripsOf(*scene.elastic, scene.handles.positions, pose, options.grips);
      found =
          readDrag(scene, pose, solveStatic(scene.elastic->body(), {grips.prescribed, {}}, solve, progress));
      found.halved = halved;
      found.dragMm = length;
      break;
    } catch (const NoEquilibrium& none) {
      found.refusal = explanationOf(none).english();
    }
  }
  found.handle = drag.handle;
  found.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return found;
}

} // namespace

std::size_t SolvedScene::solved() const {
  return static_cast<std::size_t>(std::count_if(
      drags.begin(), drags.end(), [](const ElasticDrag& drag) { return drag.refusal.empty(); }));
}

coordinates::HandleSet hullAround(const Points& surface, int handles, double gap) {
  const Points directions = evenDirections(handles);
  Points ends(handles, 3);
  for (Eigen::Index h = 0; h < handles; ++h) {
    Eigen::Index farthest = 0;
    (surface * directions.row(h).transpose()).maxCoeff(&farthest);
    ends.row(h) = surface.row(farthest);
  }
  double away = gap * boundsOf(surface).diagonal();
  const double apart = -0.1 * away;
  for (int farther = 0; farther < kMostFarther; ++farther, away *= kFartherOut) {
    const Points corners = ends + away * directions;
    const geometry::ConvexHull hull(corners);
    if (hull.outside(surface, apart).empty())
      return {corners, hull.triangles(), {}};
  }
  throw DataError("no handles enclose the organ", {}, "take more handles");
}

DragScene dragScene(const std::string& name, const geometry::TriangleMesh& surface,
                    coordinates::HandleSet handles, const DragOptions& options, Progress& progress) {
  DragScene scene;
  scene.organ = name;
  scene.handles = std::move(handles);
  scene.diagonalMm = boundsOf(surface.points).diagonal();
  scene.surface = surface.points;
  // The modulus is arbitrary: it scales forces, and no displacement.
  scene.elastic = std::make_shared<const ElasticOrgan>(
      surface, options.organ, std::make_shared<const NeoHookean>(1, options.poisson), progress);
  const Eigen::Index all = surface.points.rows(), taken = std::min<Eigen::Index>(options.points, all);
  scene.points.resize(taken, 3);
  for (Eigen::Index i = 0; i < taken; ++i) {
    scene.vertices.push_back(i * all / taken);
    scene.points.row(i) = surface.points.row(scene.vertices.back());
  }
  const QuadraticMesh& mesh = scene.elastic->body().mesh();
  const Eigen::Index cells = mesh.tetrahedra.rows(), seen = std::min<Eigen::Index>(options.witnesses, cells);
  scene.witnesses = Points::Zero(seen, 3);
  for (Eigen::Index i = 0; i < seen; ++i) {
    scene.tetrahedra.push_back(i * cells / seen);
    for (int corner = 0; corner < 4; ++corner)
      scene.witnesses.row(i) += 0.25 * mesh.nodes.row(mesh.tetrahedra(scene.tetrahedra.back(), corner));
  }
  return scene;
}

ElasticDrag readDrag(const DragScene& scene, const Points& pose, const StaticSolution& solution) {
  ElasticDrag drag;
  drag.pose = pose;
  drag.dragMm = (pose - scene.handles.positions).rowwise().norm().maxCoeff();
  drag.smallestJacobian = solution.smallestJacobian;
  const Points everywhere = scene.elastic->atSurface(solution.displacements);
  drag.displacements.resize(scene.points.rows(), 3);
  for (Eigen::Index i = 0; i < scene.points.rows(); ++i)
    drag.displacements.row(i) = everywhere.row(scene.vertices[static_cast<std::size_t>(i)]);
  drag.stress.resize(scene.witnesses.rows());
  for (Eigen::Index i = 0; i < scene.witnesses.rows(); ++i) {
    // The gradient of quadratic displacements is linear in a straight tetrahedron: its mean is that in the
    // middle.
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();
    double weight = 0;
    for (const LocalState& at :
         scene.elastic->body().statesOf(scene.tetrahedra[static_cast<std::size_t>(i)], solution.state)) {
      gradient += at.weightMm3 * at.gradient;
      weight += at.weightMm3;
    }
    drag.stress[i] = deformation::localDistortion(gradient / weight).rotationalStress;
  }
  return drag;
}

std::vector<SolvedScene> solveDrags(std::vector<DragScene> scenes, const DragOptions& options,
                                    Threads threads, Progress& progress) {
  std::vector<SolvedScene> all;
  std::vector<std::vector<Drag>> wanted;
  for (DragScene& scene : scenes) {
    wanted.push_back(drawnDrags(scene.handles.positions.rows(), options.drags, options.seed));
    all.push_back({std::move(scene), std::vector<ElasticDrag>(wanted.back().size())});
  }
  const Eigen::Index count = static_cast<Eigen::Index>(all.size()) * options.drags;
  std::atomic<Eigen::Index> done{0};
  parallelRanges(count, 1, threads, [&](Eigen::Index index, Eigen::Index) {
    progress.throwIfCancelled();
    const auto scene = static_cast<std::size_t>(index / options.drags);
    const auto drag = static_cast<std::size_t>(index % options.drags);
    InnerJob job(progress);
    all[scene].drags[drag] = solved(all[scene].scene, wanted[scene][drag], options, job.progress());
    progress.report(static_cast<double>(++done) / static_cast<double>(count),
                    "Elastic drags of " + all[scene].scene.organ);
  });
  return all;
}

} // namespace viscera::elasticity
