#include "viscera/strain/wall_means.h"

#include <limits>
#include <utility>

#include <Eigen/LU>

#include "viscera/strain/strain_curve.h"

namespace viscera::strain {
namespace {

constexpr double kNoPoint = std::numeric_limits<double>::quiet_NaN();

} // namespace

WallReference::WallReference(const WallPoints& points, std::vector<Eigen::Matrix3d> gradients)
    : points_(points), axes_(points.axes.size()), usable_(points.axes.size()),
      inverse_(std::move(gradients)) {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    axes_[i] = carriedAxes(points.axes[i], inverse_[i]);
    usable_[i] = inverse_[i].determinant() > 0;
    inverse_[i] = usable_[i] ? Eigen::Matrix3d(inverse_[i].inverse()) : Eigen::Matrix3d::Identity();
  }
}

WallMeans WallReference::meansAt(const std::vector<Eigen::Matrix3d>& gradients) const {
  WallMeans means;
  std::array<double, kSegments + 1> volumes{};
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    if (!usable_[i])
      continue;
    const WallStrain strain = strainAlong(gradients[i] * inverse_[i], axes_[i]);
    const double volume = points_.volumes[static_cast<Eigen::Index>(i)];
    for (const int place : {points_.segments[i], 0}) {
      const auto k = static_cast<std::size_t>(place);
      volumes[k] += volume;
      means.longitudinal[k] += volume * engineering(strain.longitudinal);
      means.circumferential[k] += volume * engineering(strain.circumferential);
      means.radial[k] += volume * engineering(strain.radial);
    }
  }
  for (std::size_t k = 0; k < volumes.size(); ++k)
    for (auto* values : {&means.longitudinal, &means.circumferential, &means.radial})
      (*values)[k] = volumes[k] > 0 ? (*values)[k] / volumes[k] : kNoPoint;
  return means;
}

WallMeans deviationsOfMeans(const WallPoints& points, const DrawnGradients& gradients, int draws,
                            Progress& progress, Threads threads) {
  std::vector<WallMeans> drawn(static_cast<std::size_t>(draws));
  parallelRanges(draws, 1, threads, [&](Eigen::Index begin, Eigen::Index) {
    progress.throwIfCancelled();
    std::vector<Eigen::Matrix3d> reference, now;
    gradients(static_cast<int>(begin), reference, now);
    drawn[static_cast<std::size_t>(begin)] = WallReference(points, std::move(reference)).meansAt(now);
  });
  WallMeans deviations;
  for (const auto values : {&WallMeans::longitudinal, &WallMeans::circumferential, &WallMeans::radial})
    for (std::size_t k = 0; k <= kSegments; ++k) {
      std::vector<double> each;
      for (const WallMeans& means : drawn)
        each.push_back((means.*values)[k]);
      (deviations.*values)[k] = deviationOf(each); // NaN where they are.
    }
  return deviations;
}

} // namespace viscera::strain
