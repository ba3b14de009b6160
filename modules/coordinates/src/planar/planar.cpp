#include "viscera/coordinates/planar.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "nspace/direction_solver.h"
#include "same_place.h"
#include "viscera/coordinates/celestial/celestial_solution.h"
#include "viscera/coordinates/systems.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::coordinates {
namespace {

/// Part of a half turn: directions that leave out more do not go all around.
constexpr double kHalfTurn = 1e-12;

using PointWeights = std::function<bool(const Eigen::Vector2d& point, Values& weights)>;

PlanarWeights pointByPoint(const PointsOf<2>& handles, const PointsOf<2>& points, const PointWeights& solve,
                           Threads threads) {
  PlanarWeights result;
  result.weights = Eigen::MatrixXd::Zero(points.rows(), handles.rows());
  std::vector<char> failed(static_cast<std::size_t>(points.rows()));
  parallelRanges(points.rows(), 64, threads, [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i) {
      Values row = Values::Zero(handles.rows());
      if (solve(points.row(i).transpose(), row) && row.allFinite())
        result.weights.row(i) = row.transpose();
      else
        failed[static_cast<std::size_t>(i)] = 1;
    }
  });
  for (std::size_t i = 0; i < failed.size(); ++i)
    if (failed[i])
      result.failures.push_back(static_cast<int>(i));
  return result;
}

/// Whether no half plane holds all directions.
bool allAround(const PointsOf<2>& units) {
  // Inside the hull the largest angle between neighbouring directions is below pi; a half plane without any
  // direction leaves pi or more.
  std::vector<double> angles;
  for (Eigen::Index i = 0; i < units.rows(); ++i)
    angles.push_back(std::atan2(units(i, 1), units(i, 0)));
  std::sort(angles.begin(), angles.end());
  double widest = angles.front() + 2 * std::numbers::pi - angles.back();
  for (std::size_t i = 0; i + 1 < angles.size(); ++i)
    widest = std::max(widest, angles[i + 1] - angles[i]);
  return widest < std::numbers::pi * (1 - kHalfTurn);
}

PointWeights balanced(const PointsOf<2>& handles, BalanceIn<2> balance) {
  const double size = (handles.colwise().maxCoeff() - handles.colwise().minCoeff()).norm();
  return [&handles, size, balance = std::move(balance)](const Eigen::Vector2d& point, Values& weights) {
    Eigen::Index nearest = 0;
    if ((handles.rowwise() - point.transpose()).rowwise().norm().minCoeff(&nearest) <= kSamePlace * size) {
      weights[nearest] = 1;
      return true;
    }
    const HandleDirectionsOf<2> sight = directionsTo<2>(handles, point);
    return allAround(sight.units) && balance(sight, weights) && weigh(sight.distances, weights);
  };
}

/// Part of the polygon's size: a point so near to a corner or an edge lies on it.
constexpr double kOnPolygon = 1e-12;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a[0] * b[1] - a[1] * b[0];
}

/// Mean value coordinates of a point in the polygon of the handles; false where they are not defined.
bool planarMeanValue(const PointsOf<2>& handles, const Eigen::Vector2d& point, Values& weights) {
  const Eigen::Index count = handles.rows();
  const double size = (handles.colwise().maxCoeff() - handles.colwise().minCoeff()).norm();
  const PointsOf<2> ways = handles.rowwise() - point.transpose();
  const Values distances = ways.rowwise().norm();
  // Floater 2003: w_i = (tan(alpha_i-1 / 2) + tan(alpha_i / 2)) / |v_i - p|, with alpha_i the signed angle at
  // p from v_i to v_i+1.
  Values halves(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index next = (i + 1) % count;
    const Eigen::Vector2d a = ways.row(i).transpose(), b = ways.row(next).transpose();
    const Eigen::Vector2d edge = (handles.row(next) - handles.row(i)).transpose();
    const double length = edge.norm(), along = -a.dot(edge) / length;
    // a x b = a x (b - a), which far away keeps the digits of the edge.
    const double across = cross(a, edge), product = distances[i] * distances[next], dot = a.dot(b);
    if (std::abs(across) <= kOnPolygon * size * length && along >= -kOnPolygon * size &&
        along <= length + kOnPolygon * size) {
      weights.setZero();
      weights[i] = 1 - along / length;
      weights[next] = along / length;
      return true;
    }
    // tan(alpha / 2) = sin alpha / (1 + cos alpha) = (1 - cos alpha) / sin alpha: the one that adds.
    halves[i] = dot > 0 ? across / (product + dot) : (product - dot) / across;
  }
  for (Eigen::Index i = 0; i < count; ++i)
    weights[i] = (halves[(i + count - 1) % count] + halves[i]) / distances[i];
  const double sum = weights.sum();
  if (!(std::abs(sum) > 0))
    return false;
  weights /= sum;
  return true;
}

PlanarWeights celestial(const CoordinateSystem& inSpace, const CelestialFunction& function,
                        const PointsOf<2>& handles, const PointsOf<2>& points,
                        const ParameterValues& parameters, Threads threads) {
  parameters.requireWithin(inSpace.parameters());
  CelestialOptions options;
  options.threads = threads;
  for (const Parameter& parameter : inSpace.parameters())
    if (parameter.name == "locality")
      options.locality = parameters.get(parameter);
    else if (parameter.name == "softness")
      options.softness = parameters.get(parameter);
  Progress progress;
  CelestialSolution<2> solution = solveCelestial<2>(function, handles, points, options, progress);
  PlanarWeights result{Eigen::MatrixXd(points.rows(), handles.rows()), std::move(solution.failures)};
  for (Eigen::Index handle = 0; handle < handles.rows(); ++handle)
    result.weights.col(handle) = solution.weights.column(handle);
  return result;
}

} // namespace

std::vector<std::string> planarSystems() {
  return {"s-celestial",     "t-celestial",           "mean-value",   "lagrange-minimisation",
          "gradient-method", "determinants-approach", "wire-approach"};
}

PlanarWeights planarWeights(const std::string& system, const PointsOf<2>& handles, const PointsOf<2>& points,
                            const ParameterValues& parameters, Threads threads) {
  requireUsableHandles<2>(handles);
  const auto checked = [&](const CoordinateSystem& inSpace) {
    parameters.requireWithin(inSpace.parameters());
    return inSpace.id() == system;
  };
  if (system == sCelestial()->id())
    return celestial(*sCelestial(), sFunction(), handles, points, parameters, threads);
  if (system == tCelestial()->id())
    return celestial(*tCelestial(), tFunction(), handles, points, parameters, threads);
  if (system == meanValue()->id() && checked(*meanValue()))
    return pointByPoint(
        handles, points,
        [&](const Eigen::Vector2d& point, Values& weights) {
          return planarMeanValue(handles, point, weights);
        },
        threads);
  const auto balance = [&]() -> BalanceIn<2> {
    if (system == lagrangeMinimisation()->id() && checked(*lagrangeMinimisation()))
      return planeLagrange(parameters);
    if (system == gradientMethod()->id() && checked(*gradientMethod()))
      return planeGradient(handles.rows(), parameters);
    if (system == determinantsApproach()->id() && checked(*determinantsApproach()))
      return planeDeterminants();
    if (system == wireApproach()->id() && checked(*wireApproach()))
      return planeWire(parameters);
    std::string known;
    for (const std::string& id : planarSystems())
      known += (known.empty() ? "" : ", ") + id;
    throw UsageError(misuse("\"%1\" has no planar form", system), {}, misuse("there are: %1", known));
  }();
  return pointByPoint(handles, points, balanced(handles, balance), threads);
}

} // namespace viscera::coordinates
