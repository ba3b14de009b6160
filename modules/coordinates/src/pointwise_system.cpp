#include "viscera/coordinates/pointwise_system.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <stdexcept>
#include <utility>

#include "lifted_binding.h"
#include "viscera/coordinates/handle_checks.h"
#include "viscera/coordinates/weights_binding.h"

namespace viscera::coordinates {
namespace {

/// Points that a thread takes at once: whole tiles, so that no two threads write into the same one.
constexpr Eigen::Index kPointsAtOnce = 4 * TiledWeights::kTile;
/// A report after every point would cost more than many points do.
constexpr std::chrono::milliseconds kReportEvery{100};

/// Calls `solve(point)` for every point, on several threads; the points for which it is false, ascending.
std::vector<int> failuresOf(Eigen::Index count, Threads threads, Progress& progress,
                            const std::function<bool(Eigen::Index point)>& solve) {
  std::vector<char> failed(static_cast<std::size_t>(count));
  std::atomic<Eigen::Index> done{0};
  progress.throwIfCancelled();
  const auto report = [&] { progress.report(static_cast<double>(done) / static_cast<double>(count)); };
  parallelRanges(count, kPointsAtOnce, threads, [&](Eigen::Index begin, Eigen::Index end) {
    auto reported = std::chrono::steady_clock::now();
    for (Eigen::Index point = begin; point < end; ++point) {
      progress.throwIfCancelled();
      failed[static_cast<std::size_t>(point)] = solve(point) ? 0 : 1;
      ++done;
      const auto now = std::chrono::steady_clock::now();
      if (now - reported >= kReportEvery && point + 1 < end) { // Some systems take seconds a point.
        reported = now;
        report();
      }
    }
    report();
  });
  std::vector<int> failures;
  for (std::size_t point = 0; point < failed.size(); ++point)
    if (failed[point])
      failures.push_back(static_cast<int>(point));
  return failures;
}

} // namespace

bool PointSolver::solveGradients(const Vec3&, Values&, Points&) const {
  throw std::logic_error("a closed form is promised, but there is none");
}

PointwiseSystem::PointwiseSystem(SystemDescription description, Prepare prepare)
    : PointwiseSystem(
          std::move(description),
          [prepare = std::move(prepare)](const HandleSet& handles, const Points&, const BindOptions& options,
                                         Progress&) { return prepare(handles, options.parameters); }) {}

/// After the checks that every system asks for.
std::shared_ptr<const PointSolver> PointwiseSystem::solverFor(const HandleSet& handles, const Points& points,
                                                              const BindOptions& options,
                                                              Progress& progress) const {
  options.parameters.requireWithin(parameters());
  requireUsableHandles<3>(handles.positions);
  return prepare_(handles, points, options, progress);
}

std::unique_ptr<Binding> PointwiseSystem::bind(const HandleSet& handles, const Points& points,
                                               const BindOptions& options, Progress& progress) const {
  const auto start = std::chrono::steady_clock::now();
  const auto solver = solverFor(handles, points, options, progress);
  const auto lift = solver->lift();
  const Eigen::Index count = lift ? lift->rowCount() : handles.positions.rows();
  // The rows of a lifted pose are not only positions, whose sum of weights is worth keeping.
  TiledWeights weights = lift ? TiledWeights(points.rows(), count)
                              : TiledWeights(points.rows(), count, options.mostBytesInDoubles);
  auto failures = failuresOf(points.rows(), options.threads, progress, [&](Eigen::Index point) {
    Values row = Values::Zero(count);
    const bool found = solver->solve(points.row(point).transpose(), row) && row.allFinite();
    if (found)
      weights.setRow(point, row);
    return found;
  });
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (lift)
    return std::make_unique<LiftedBinding>(lift, std::move(weights), handles.positions, points,
                                           std::move(failures), seconds.count(), options.threads,
                                           solver->notes());
  return std::make_unique<WeightsBinding>(std::move(weights), handles.positions, points, std::move(failures),
                                          seconds.count(), options.threads, solver->notes());
}

CoordinateGradients PointwiseSystem::gradients(const HandleSet& handles, const Points& points,
                                               const BindOptions& options, Progress& progress) const {
  if (!traits().closedFormGradient)
    return CoordinateSystem::gradients(handles, points, options, progress);
  const auto solver = solverFor(handles, points, options, progress);
  CoordinateGradients result;
  result.closedForm = true;
  result.lift = solver->lift();
  const Eigen::Index count = result.lift ? result.lift->rowCount() : handles.positions.rows();
  result.values = Points::Zero(points.rows() * count, 3);
  result.failures = failuresOf(points.rows(), options.threads, progress, [&](Eigen::Index point) {
    Values weights = Values::Zero(count);
    Points own = Points::Zero(count, 3);
    if (!solver->solveGradients(points.row(point).transpose(), weights, own) || !own.allFinite())
      return false;
    result.values.middleRows(point * count, count) = own;
    return true;
  });
  return result;
}

} // namespace viscera::coordinates
