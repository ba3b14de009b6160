#include "carried_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include <Eigen/Cholesky>

#include "viscera/geometry/carried_points.h"

namespace viscera::lesson {
namespace {

using Index = Eigen::Index;

constexpr int kCarriers = CarriedParts::kCarriers;
/// What handles do counts as if each were dragged so far, mm,
constexpr double kDragMm = 5;
/// places at rest count by this part, so that also a motion that is not in the lesson is followed,
constexpr double kRestPart = 0.1;
/// and that the weights' sum is 1 by as many mm.
constexpr double kSumMm = 20;
constexpr double kRidge = 0.02; ///< Keeps weights small; mm squared.
/// Vertices that may carry a point: the nearest ones, and every so many of those that follow.
constexpr std::size_t kNear = 12, kFar = 72, kEvery = 6;
constexpr double kFirstReachMm = 6;
constexpr Index kPointsAtOnce = 64;

/// The fields that a point has to follow, one row each; the last three columns are its place.
struct Fields {
  Eigen::MatrixXd of; ///< `points x fields`.
  Points rest;
};

/// Three columns at a time: each mode, then the handles' weights.
template <class At>
void addFields(const Lesson& lesson, Index rows, const At& at, Fields& fields) {
  const auto modes = static_cast<Index>(lesson.modes.size());
  const Index handles = lesson.weights.rows(), triples = (handles + 2) / 3;
  fields.of.resize(rows, 3 * (modes + triples));
  for (Index k = 0; k < modes; ++k)
    fields.of.middleCols(3 * k, 3) =
        at(Points(lesson.modes[static_cast<std::size_t>(k)].topRows(lesson.vertexCount())));
  for (Index triple = 0; triple < triples; ++triple) {
    Points some = Points::Zero(lesson.vertexCount(), 3);
    for (Index i = 0; i < 3 && 3 * triple + i < handles; ++i)
      some.col(i) = kDragMm * lesson.weights.row(3 * triple + i).transpose();
    fields.of.middleCols(3 * (modes + triple), 3) = at(some);
  }
}

/// The vertices of the lesson that may carry a point.
std::vector<std::int32_t> candidatesFor(const Eigen::RowVector3d& point, const Points& vertices,
                                        const std::vector<std::int32_t>& rows) {
  const Eigen::VectorXd squared = (vertices.rowwise() - point).rowwise().squaredNorm();
  const std::size_t wanted = std::min(kNear + kFar, rows.size());
  std::vector<Index> near;
  for (double reach = kFirstReachMm; near.size() < wanted; reach *= 1.5) {
    near.clear();
    for (Index i = 0; i < squared.size(); ++i)
      if (squared[i] < reach * reach)
        near.push_back(i);
  }
  std::sort(near.begin(), near.end(),
            [&](Index a, Index b) { return std::pair(squared[a], a) < std::pair(squared[b], b); });
  std::vector<std::int32_t> chosen;
  for (std::size_t i = 0; i < wanted; i += i < kNear ? 1 : kEvery)
    chosen.push_back(rows[static_cast<std::size_t>(near[i])]);
  return chosen;
}

/// The best weights of some candidates, and how much of the squared fields they explain.
struct Fit {
  Eigen::VectorXd weights;
  double gain = -1;
};

Fit fitOf(const Eigen::MatrixXd& gram, const Eigen::VectorXd& right, const std::vector<Index>& chosen) {
  const auto count = static_cast<Index>(chosen.size());
  Eigen::MatrixXd matrix(count, count);
  Eigen::VectorXd side(count);
  for (Index i = 0; i < count; ++i) {
    side[i] = right[chosen[static_cast<std::size_t>(i)]];
    for (Index j = 0; j < count; ++j)
      matrix(i, j) = gram(chosen[static_cast<std::size_t>(i)], chosen[static_cast<std::size_t>(j)]);
    matrix(i, i) += kRidge;
  }
  Fit fit;
  fit.weights = matrix.ldlt().solve(side);
  fit.gain = side.dot(fit.weights);
  return fit;
}

/// Rounds to whole steps whose sum is 1: the largest takes what rounding leaves.
Eigen::VectorXd inSteps(Eigen::VectorXd weights) {
  weights = (weights / kCarriedStep).array().round() * kCarriedStep;
  Index largest = 0;
  weights.cwiseAbs().maxCoeff(&largest);
  weights[largest] += 1 - weights.sum();
  return weights;
}

/// Chooses carriers one after the other, each as the one with which all explain the most.
void choose(const Fields& wanted, const Fields& given, const std::vector<std::int32_t>& candidates,
            Index point, CarriedParts& parts) {
  const auto count = static_cast<Index>(candidates.size());
  const Index fields = given.of.cols();
  Eigen::MatrixXd rows(count, fields + 4);
  for (Index i = 0; i < count; ++i) {
    const Index vertex = candidates[static_cast<std::size_t>(i)];
    rows.row(i) << given.of.row(vertex), kRestPart * (given.rest.row(vertex) - wanted.rest.row(point)),
        kSumMm;
  }
  Eigen::VectorXd target = Eigen::VectorXd::Zero(fields + 4);
  target.head(fields) = wanted.of.row(point).transpose();
  target[fields + 3] = kSumMm;
  const Eigen::MatrixXd gram = rows * rows.transpose();
  const Eigen::VectorXd right = rows * target;
  std::vector<Index> chosen;
  Fit best;
  for (int k = 0; k < std::min<int>(kCarriers, static_cast<int>(count)); ++k) {
    Index found = -1;
    best = {};
    for (Index i = 0; i < count; ++i) {
      if (std::find(chosen.begin(), chosen.end(), i) != chosen.end())
        continue;
      chosen.push_back(i);
      if (Fit fit = fitOf(gram, right, chosen); fit.gain > best.gain) {
        best = std::move(fit);
        found = i;
      }
      chosen.pop_back();
    }
    chosen.push_back(found);
  }
  const Eigen::VectorXd weights = inSteps(best.weights);
  std::vector<std::pair<std::int32_t, double>> sorted;
  for (std::size_t k = 0; k < static_cast<std::size_t>(kCarriers);
       ++k) // A surface of few vertices repeats one.
    sorted.emplace_back(candidates[static_cast<std::size_t>(chosen[std::min(k, chosen.size() - 1)])],
                        k < chosen.size() ? weights[static_cast<Index>(k)] : 0.0);
  std::sort(sorted.begin(), sorted.end());
  for (int k = 0; k < kCarriers; ++k) {
    parts.vertices(point, k) = sorted[static_cast<std::size_t>(k)].first;
    parts.weights(point, k) = sorted[static_cast<std::size_t>(k)].second;
  }
}

} // namespace

CarriedParts carriedParts(const PartsToCarry& parts, const Lesson& lesson, Progress& progress,
                          Threads threads) {
  std::vector<std::int32_t> rows;
  for (const std::size_t surface : parts.surfaces)
    for (Index i = 0; i < lesson.surfaces[surface].vertexCount; ++i)
      rows.push_back(static_cast<std::int32_t>(lesson.surfaces[surface].firstVertex + i));
  Points carriers(static_cast<Index>(rows.size()), 3);
  Index first = 0;
  for (const Points* mesh : parts.meshes) {
    carriers.middleRows(first, mesh->rows()) = *mesh;
    first += mesh->rows();
  }
  const geometry::CarriedPoints exact(parts.rest, carriers, threads);
  Fields wanted{{}, parts.rest}, given{{}, lesson.rest.topRows(lesson.vertexCount())};
  addFields(
      lesson, parts.rest.rows(),
      [&](const Points& field) {
        Points own(carriers.rows(), 3), out;
        for (std::size_t i = 0; i < rows.size(); ++i)
          own.row(static_cast<Index>(i)) = field.row(rows[i]);
        exact.at(own, out, threads);
        return out;
      },
      wanted);
  addFields(
      lesson, lesson.vertexCount(), [](const Points& field) { return field; }, given);
  progress.throwIfCancelled();
  CarriedParts made;
  made.rest = parts.rest;
  made.vertices.resize(parts.rest.rows(), kCarriers);
  made.weights.resize(parts.rest.rows(), kCarriers);
  parallelRanges(parts.rest.rows(), kPointsAtOnce, threads, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i)
      choose(wanted, given, candidatesFor(parts.rest.row(i), carriers, rows), i, made);
  });
  return made;
}

} // namespace viscera::lesson
