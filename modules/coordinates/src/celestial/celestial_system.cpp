#include "viscera/coordinates/celestial/celestial_system.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <utility>

#include "celestial/celestial_function.h"
#include "viscera/coordinates/weights_binding.h"

namespace viscera::coordinates {
namespace {

constexpr Eigen::Index kTilesPerSolution = 32;

/// Of the handles' size: the identity error aimed at, which is about what rounding leaves.
constexpr double kIdentityAimedAt = 1e-13;
/// The rounding of sums over more handles than this grows noticeably.
constexpr double kManyHandles = 500;
/// Of the handles' size: without softness, a point this near to a handle is at it.
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
  // The error in space is at most the largest D times the relative one, and softness lengthens D.
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

/// Zero in the last tile's columns past the end.
void clearPadding(TiledWeights& weights) {
  for (Eigen::Index point = weights.points(); point < weights.tiles() * TiledWeights::kTile; ++point)
    for (Eigen::Index handle = 0; handle < weights.handles(); ++handle)
      weights.set(point, handle, 0);
}

CelestialOptions optionsFrom(const CelestialSystem& system, const BindOptions& options) {
  options.parameters.requireWithin(system.parameters());
  return {options.parameters.get(kLocality), options.parameters.get(kSoftness), options.threads};
}

} // namespace

CelestialSystem::CelestialSystem(SystemDescription description, const CelestialFunction& (*function)())
    : DescribedSystem(completed(std::move(description))), function_(function) {}

template <int Dim>
CelestialSolution<Dim> CelestialSystem::solve(const PointsOf<Dim>& handles, const PointsOf<Dim>& points,
                                              const CelestialOptions& options, Progress& progress) const {
  requireUsableHandles<Dim>(handles);
  const Eigen::Matrix<double, Dim, -1, 1> byAxis = handles.transpose();
  const simd::CelestialProblem problem = problemOf<Dim>(handles, byAxis, options);
  const simd::SolveCelestialTile kernel = Dim == 2 ? function_().solve2 : function_().solve3;

  CelestialSolution<Dim> solution{
      TiledWeights(points.rows(), handles.rows()), PointsOf<Dim>(points.rows(), Dim), {}};
  std::vector<std::uint16_t> failed(static_cast<std::size_t>(solution.weights.tiles()));
  std::atomic<Eigen::Index> done{0};
  progress.throwIfCancelled();
  parallelRanges(
      solution.weights.tiles(), kTilesPerSolution, options.threads,
      [&](Eigen::Index begin, Eigen::Index end) {
        progress.throwIfCancelled();
        std::vector<double> scratch(static_cast<std::size_t>(problem.count) * simd::kCelestialScratch);
        for (Eigen::Index tile = begin; tile < end; ++tile) {
          double in[Dim * TiledWeights::kTile], x[Dim * TiledWeights::kTile];
          gather<Dim>(points, tile, in);
          failed[static_cast<std::size_t>(tile)] =
              static_cast<std::uint16_t>(kernel(problem, in, scratch.data(), solution.weights.tile(tile), x));
          for (Eigen::Index point = tile * TiledWeights::kTile;
               point < std::min((tile + 1) * TiledWeights::kTile, points.rows()); ++point)
            for (int axis = 0; axis < Dim; ++axis)
              solution.x(point, axis) = x[axis * TiledWeights::kTile + point % TiledWeights::kTile];
        }
        progress.report(static_cast<double>(done += end - begin) /
                        static_cast<double>(solution.weights.tiles()));
      });
  clearPadding(solution.weights);
  for (Eigen::Index point = 0; point < points.rows(); ++point)
    if (failed[static_cast<std::size_t>(point / TiledWeights::kTile)] >> (point % TiledWeights::kTile) & 1)
      solution.failures.push_back(static_cast<int>(point));
  return solution;
}

template CelestialSolution<2> CelestialSystem::solve<2>(const PointsOf<2>&, const PointsOf<2>&,
                                                        const CelestialOptions&, Progress&) const;
template CelestialSolution<3> CelestialSystem::solve<3>(const PointsOf<3>&, const PointsOf<3>&,
                                                        const CelestialOptions&, Progress&) const;

std::unique_ptr<Binding> CelestialSystem::bind(const HandleSet& handles, const Points& points,
                                               const BindOptions& options, Progress& progress) const {
  const auto start = std::chrono::steady_clock::now();
  auto solution = solve<3>(handles.positions, points, optionsFrom(*this, options), progress);
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  return std::make_unique<WeightsBinding>(std::move(solution.weights), handles.positions, points,
                                          std::move(solution.failures), seconds.count(), options.threads);
}

CoordinateGradients CelestialSystem::gradients(const HandleSet& handles, const Points& points,
                                               const BindOptions& options, Progress& progress) const {
  const CelestialOptions celestial = optionsFrom(*this, options);
  auto solution = solve<3>(handles.positions, points, celestial, progress);
  return celestialGradients(function_(), handles.positions, points, celestial, solution);
}

} // namespace viscera::coordinates
