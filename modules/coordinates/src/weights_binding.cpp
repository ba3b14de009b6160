#include "viscera/coordinates/weights_binding.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace viscera::coordinates {
namespace {

constexpr Eigen::Index kGrain = 4096;

struct Extremes {
  double identity = 0;
  double unity = 0;
  double least = std::numeric_limits<double>::infinity();

  void add(const Extremes& other) {
    // Written so that a NaN stays visible: it wins every comparison that it takes part in.
    if (!(other.identity <= identity))
      identity = other.identity;
    if (!(other.unity <= unity))
      unity = other.unity;
    if (!(other.least >= least))
      least = other.least;
  }
};

Extremes measurePoint(const TiledWeights& weights, Eigen::Index point, const Points& handles,
                      const Vec3& rest) {
  Vec3 sum = Vec3::Zero();
  double unity = 0;
  Extremes found;
  for (Eigen::Index handle = 0; handle < weights.handles(); ++handle) {
    const double weight = weights(point, handle);
    // Relative to the point, so that an organ far from the origin is not measured by its distance.
    sum += weight * (handles.row(handle).transpose() - rest);
    unity += weight;
    if (!(weight >= found.least))
      found.least = weight;
  }
  found.identity = (sum + (unity - 1) * rest).norm();
  found.unity = std::abs(unity - 1);
  return found;
}

} // namespace

WeightsBinding::WeightsBinding(TiledWeights weights, const Points& restHandles, const Points& restPoints,
                               std::vector<int> failures, double seconds, Threads threads)
    : weights_(std::move(weights)), failedRest_(failures.size(), 3) {
  assert(restPoints.rows() == weights_.points() && restHandles.rows() == weights_.handles());
  assert(std::is_sorted(failures.begin(), failures.end()));
  for (std::size_t index = 0; index < failures.size(); ++index) {
    failedRest_.row(static_cast<Eigen::Index>(index)) = restPoints.row(failures[index]);
    for (Eigen::Index handle = 0; handle < weights_.handles(); ++handle)
      weights_.set(failures[index], handle, 0);
  }
  const Eigen::Index count = weights_.points();
  std::vector<Extremes> ranges(static_cast<std::size_t>((count + kGrain - 1) / kGrain));
  parallelRanges(count, kGrain, threads, [&](Eigen::Index begin, Eigen::Index end) {
    Extremes& range = ranges[static_cast<std::size_t>(begin / kGrain)];
    auto failed = std::lower_bound(failures.begin(), failures.end(), begin);
    for (Eigen::Index point = begin; point < end; ++point) {
      if (failed != failures.end() && *failed == point)
        ++failed;
      else
        range.add(measurePoint(weights_, point, restHandles, restPoints.row(point).transpose()));
    }
  });
  Extremes all;
  for (const Extremes& range : ranges)
    all.add(range);
  const bool anyBound = failures.size() < static_cast<std::size_t>(count);
  report_ = {all.identity,        all.unity, anyBound ? all.least : 0,
             std::move(failures), seconds,   threads.resolved()};
}

void WeightsBinding::deform(const Points& pose, Points& points, Threads threads) const {
  weights_.multiply(pose, points, threads);
  for (std::size_t index = 0; index < report_.failures.size(); ++index)
    points.row(report_.failures[index]) = failedRest_.row(static_cast<Eigen::Index>(index));
}

void WeightsBinding::moveHandle(const Points&, int handle, const Vec3& delta, Points& points,
                                Threads threads) const {
  weights_.addColumn(handle, delta, points, threads);
}

void WeightsBinding::pullBack(const Points&, const Points& pointGradient, Points& handleGradient,
                              Threads threads) const {
  weights_.multiplyTransposed(pointGradient, handleGradient, threads);
}

Values WeightsBinding::influence(int handle) const {
  return weights_.column(handle);
}

} // namespace viscera::coordinates
