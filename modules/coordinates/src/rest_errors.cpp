#include "rest_errors.h"

#include <algorithm>
#include <cmath>

#include "simd/usable_kernels.h"
#include "viscera/coordinates/tiled_weights.h"

namespace viscera::coordinates {
namespace {

/// A NaN stays visible: it replaces every number and is replaced by none.
void keepExtreme(double& extreme, double value, bool isMore) {
  if (isMore || std::isnan(value))
    extreme = value;
}

} // namespace

void RestErrors::add(double identityError, double unityError, double weight) {
  keepExtreme(identity, identityError, identityError > identity);
  keepExtreme(unity, unityError, unityError > unity);
  keepExtreme(least, weight, weight < least);
}

void RestErrors::add(const RestErrors& other) {
  add(other.identity, other.unity, other.least);
}

void RestErrors::addTile(const double* weights, const Points& handles, const Points& rest, Eigen::Index tile,
                         unsigned failed) {
  constexpr int kTile = TiledWeights::kTile;
  const Eigen::Index first = tile * kTile, count = std::min<Eigen::Index>(kTile, rest.rows() - first);
  double points[3 * kTile] = {}, found[5 * kTile];
  for (Eigen::Index lane = 0; lane < count; ++lane)
    for (int axis = 0; axis < 3; ++axis)
      points[axis * kTile + lane] = rest(first + lane, axis);
  simd::tileKernels().measure(weights, handles.data(), handles.rows(), points, found);
  for (Eigen::Index lane = 0; lane < count; ++lane) {
    if (failed >> lane & 1)
      continue;
    const double unityOff = found[3 * kTile + lane] - 1;
    // The sums are relative to the point, so that an organ far from the origin is not measured by its
    // distance.
    Vec3 error;
    for (int axis = 0; axis < 3; ++axis)
      error[axis] = found[axis * kTile + lane] + unityOff * points[axis * kTile + lane];
    add(error.norm(), std::abs(unityOff), found[4 * kTile + lane]);
  }
}

void tellErrors(const std::vector<RestErrors>& ranges, Eigen::Index points, BindingReport& report) {
  RestErrors all;
  for (const RestErrors& range : ranges)
    all.add(range);
  const bool anyBound = report.failures.size() < static_cast<std::size_t>(points);
  report.identityError = all.identity;
  report.unityError = all.unity;
  report.minWeight = anyBound ? all.least : 0;
}

} // namespace viscera::coordinates
