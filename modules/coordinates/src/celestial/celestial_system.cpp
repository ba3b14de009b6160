#include "celestial/celestial_system.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <utility>

#include "celestial/celestial_function.h"
#include "rest_errors.h"
#include "viscera/coordinates/weights_binding.h"

namespace viscera::coordinates {
namespace {

constexpr Eigen::Index kTilesPerSolution = 32;

/// Part of the handles' size: the identity error aimed at, which is about what rounding leaves.
constexpr double kIdentityAimedAt = 1e-13;
/// The rounding of sums over more handles than this grows noticeably.
constexpr double kManyHandles = 500;
/// Part of the handles' size: without softness, a point this near to a handle is at it.
constexpr double kSamePlaceUnsoftened = 1e-14;

const Parameter kLocality{
    .name = "locality", .maximum = 6, .help = "How much nearer handles count more; 0 as in the thesis"};
const Parameter kSoftness{
    .name = "softness",
    .maximum = 1000,
    .unit = "mm",
    .help = "Distance over which the pull of a handle is rounded; 0 passes through the handles"};

SystemDescription completed(SystemDescription description) {
  description.traits = {.positive = true, .interpolates = true, .closedFormGradient = true};
  description.parameters.insert(description.parameters.begin(), {kLocality, kSoftness});
  return description;
}

template <int Dim>
simd::CelestialProblem problemOf(const PointsOf<Dim>& handles,
                                 const Eigen::Matrix<double, Dim, -1, 1>& byAxis,
                                 const CelestialOptions& options) {
  const double size = (handles.colwise().maxCoeff() - handles.colwise().minCoeff()).norm();
  simd::CelestialProblem problem;
  problem.handles = byAxis.data();
  problem.count = handles.rows();
  problem.locality = options.locality;
  problem.softnessSquared = options.softness * options.softness;
  problem.samePlaceSquared = kSamePlaceUnsoftened * size * kSamePlaceUnsoftened * size;
  // Let w_i = beta_i / D_i and g = sum beta_i q_i: the point is missed by sum w_i (v_i - p) / sum w_i =
  // g / sum (beta_i / D_i), at most max D |g| / sum beta_i. Softness lengthens D: max D^2 <= size^2 + e^2.
  problem.tolerance = kIdentityAimedAt * std::max(1.0, static_cast<double>(handles.rows()) / kManyHandles) *
                      size / std::hypot(size, options.softness);
  return problem;
}

/// The 16 points of a tile axis by axis; the last point stands in for those that are missing.
template <int Dim>
void gather(const PointsOf<Dim>& points, Eigen::Index tile, double* byAxis) {
  for (int lane = 0; lane < TiledWeights::kTile; ++lane) {
    const Eigen::Index point = std::min(tile * TiledWeights::kTile + lane, points.rows() - 1);
    for (int axis = 0; axis < Dim; ++axis)
      byAxis[axis * TiledWeights::kTile + lane] = points(point, axis);
  }
}

/// Zero in the tile's columns past the last of the `points`.
void clearPadding(double* numbers, Eigen::Index handles, Eigen::Index tile, Eigen::Index points) {
  for (Eigen::Index lane = std::min<Eigen::Index>(points - tile * TiledWeights::kTile, TiledWeights::kTile);
       lane < TiledWeights::kTile; ++lane)
    for (Eigen::Index handle = 0; handle < handles; ++handle)
      numbers[handle * TiledWeights::kTile + lane] = 0;
}

/// The points whose bits are set, ascending.
std::vector<int> pointsWithBits(const std::vector<std::uint16_t>& failed, Eigen::Index points) {
  std::vector<int> list;
  for (Eigen::Index point = 0; point < points; ++point)
    if (failed[static_cast<std::size_t>(point / TiledWeights::kTile)] >> (point % TiledWeights::kTile) & 1)
      list.push_back(static_cast<int>(point));
  return list;
}

/// Fills `weights` on several threads, and calls `take(tile, numbers, x, failed)` for each tile while it is
/// in the cache: the numbers as they are kept (`handles x 16`), the solutions x (`Dim x 16`) and a bit for
/// each failed point. Gives the failed points, ascending.
template <int Dim, class Take>
std::vector<int> solveTiles(const CelestialFunction& function, const PointsOf<Dim>& handles,
                            const PointsOf<Dim>& points, const CelestialOptions& options, Progress& progress,
                            TiledWeights& weights, const Take& take) {
  const Eigen::Matrix<double, Dim, -1, 1> byAxis = handles.transpose();
  const simd::CelestialProblem problem = problemOf<Dim>(handles, byAxis, options);
  const simd::SolveCelestialTile kernel = Dim == 2 ? function.solve2 : function.solve3;
  const Eigen::Index tiles = weights.tiles();
  std::vector<std::uint16_t> failed(static_cast<std::size_t>(tiles));
  std::atomic<Eigen::Index> done{0};
  progress.throwIfCancelled();
  parallelRanges(tiles, kTilesPerSolution, options.threads, [&](Eigen::Index begin, Eigen::Index end) {
    progress.throwIfCancelled();
    const auto count = static_cast<std::size_t>(problem.count);
    std::vector<double> scratch(count * simd::kCelestialScratch), room(count * TiledWeights::kTile);
    for (Eigen::Index tile = begin; tile < end; ++tile) {
      double in[Dim * TiledWeights::kTile], x[Dim * TiledWeights::kTile];
      gather<Dim>(points, tile, in);
      double* numbers = weights.toFill(tile, room.data());
      // The x that minimise F(x) = sum m_i phi(q_i . x), and beta_i / D_i with beta_i = m_i phi'(q_i . x),
      // normalised (celestial_kernels.h).
      const unsigned without = kernel(problem, in, scratch.data(), numbers, x);
      clearPadding(numbers, problem.count, tile, points.rows());
      weights.filled(tile, numbers);
      failed[static_cast<std::size_t>(tile)] = static_cast<std::uint16_t>(without);
      take(tile, numbers, x, without);
    }
    progress.report(static_cast<double>(done += end - begin) / static_cast<double>(tiles));
  });
  return pointsWithBits(failed, points.rows());
}

CelestialOptions optionsFrom(const CelestialSystem& system, const BindOptions& options) {
  options.parameters.requireWithin(system.parameters());
  return {options.parameters.get(kLocality), options.parameters.get(kSoftness), options.threads};
}

} // namespace

CelestialSystem::CelestialSystem(SystemDescription description, const CelestialFunction& (*function)())
    : DescribedSystem(completed(std::move(description))), function_(function) {}

template <int Dim>
CelestialSolution<Dim> solveCelestial(const CelestialFunction& function, const PointsOf<Dim>& handles,
                                      const PointsOf<Dim>& points, const CelestialOptions& options,
                                      Progress& progress) {
  requireUsableHandles<Dim>(handles);
  CelestialSolution<Dim> solution{
      TiledWeights(points.rows(), handles.rows()), PointsOf<Dim>(points.rows(), Dim), {}};
  const auto keepX = [&](Eigen::Index tile, const double*, const double* x, unsigned) {
    for (Eigen::Index point = tile * TiledWeights::kTile;
         point < std::min((tile + 1) * TiledWeights::kTile, points.rows()); ++point)
      for (int axis = 0; axis < Dim; ++axis)
        solution.x(point, axis) = x[axis * TiledWeights::kTile + point % TiledWeights::kTile];
  };
  solution.failures = solveTiles<Dim>(function, handles, points, options, progress, solution.weights, keepX);
  return solution;
}

template CelestialSolution<2> solveCelestial<2>(const CelestialFunction&, const PointsOf<2>&,
                                                const PointsOf<2>&, const CelestialOptions&, Progress&);
template CelestialSolution<3> solveCelestial<3>(const CelestialFunction&, const PointsOf<3>&,
                                                const PointsOf<3>&, const CelestialOptions&, Progress&);

std::unique_ptr<Binding> CelestialSystem::bind(const HandleSet& handles, const Points& points,
                                               const BindOptions& options, Progress& progress) const {
  const auto start = std::chrono::steady_clock::now();
  const CelestialOptions celestial = optionsFrom(*this, options);
  requireUsableHandles<3>(handles.positions);
  TiledWeights weights(points.rows(), handles.positions.rows(), options.mostBytesInDoubles);
  std::vector<RestErrors> ranges(
      static_cast<std::size_t>((weights.tiles() + kTilesPerSolution - 1) / kTilesPerSolution));
  const auto measure = [&](Eigen::Index tile, const double* numbers, const double*, unsigned failed) {
    RestErrors errors;
    errors.addTile(numbers, handles.positions, points, tile, failed);
    ranges[static_cast<std::size_t>(tile / kTilesPerSolution)].add(errors);
  };
  BindingReport report;
  report.failures =
      solveTiles<3>(function_(), handles.positions, points, celestial, progress, weights, measure);
  tellErrors(ranges, points.rows(), report);
  report.threads = options.threads.resolved();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return std::make_unique<WeightsBinding>(std::move(weights), points, std::move(report));
}

CoordinateGradients CelestialSystem::gradients(const HandleSet& handles, const Points& points,
                                               const BindOptions& options, Progress& progress) const {
  const CelestialOptions celestial = optionsFrom(*this, options);
  auto solution = solveCelestial<3>(function_(), handles.positions, points, celestial, progress);
  return celestialGradients(function_(), handles.positions, points, celestial, solution);
}

} // namespace viscera::coordinates
