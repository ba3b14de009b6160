#include "viscera/deformation/witness_gradients.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/deformation/tetrahedralise.h"

namespace viscera::deformation {
namespace {

/// Tiles a thread takes at a time.
constexpr Eigen::Index kTilesATime = 16;

/// Enough points to keep all threads busy, few enough that the portion's own copy does not matter. Systems
/// that fill the handles with tetrahedra first get all points at once: they take longer to prepare than to
/// answer.
constexpr Eigen::Index kWitnessPortion = 8192;

} // namespace

StressStatistics statisticsOf(const StressMap& map, Eigen::Index count) {
  assert(count >= 0 && count <= map.rotationalStress.size());
  StressStatistics statistics;
  Values angles(count);
  Eigen::Index found = 0;
  for (Eigen::Index i = 0; i < count; ++i)
    if (map.volumeRatio[i] <= 0)
      ++statistics.folded;
    else
      angles[found++] = map.rotationalStress[i];
  if (found == 0)
    return statistics;
  auto unfolded = angles.head(found);
  statistics.min = unfolded.minCoeff();
  statistics.mean = unfolded.mean();
  statistics.max = unfolded.maxCoeff();
  const auto rank = static_cast<Eigen::Index>(std::ceil(0.95 * static_cast<double>(found))) - 1;
  std::nth_element(unfolded.data(), unfolded.data() + rank, unfolded.data() + found);
  statistics.percentile95 = angles[rank];
  return statistics;
}

WitnessGradients::WitnessGradients(Eigen::Index witnesses, Eigen::Index handles,
                                   std::shared_ptr<const coordinates::PoseLift> lift)
    : witnesses_(witnesses), handles_(handles), lift_(std::move(lift)),
      rows_(lift_ ? lift_->rowCount() : handles), failed_(static_cast<std::size_t>(witnesses), false),
      data_((witnesses + kTile - 1) / kTile * kTile * 3, rows_) {}

void WitnessGradients::put(Eigen::Index begin, const coordinates::CoordinateGradients& gradients,
                           Eigen::Index count) {
  assert(gradients.values.rows() == count * rows_ && begin + count <= witnesses_);
  closedForm_ = closedForm_ && gradients.closedForm;
  for (const int failure : gradients.failures) {
    failures_.push_back(static_cast<int>(begin) + failure);
    failed_[static_cast<std::size_t>(failures_.back())] = true;
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index w = begin + i;
    for (Eigen::Index row = 0; row < rows_; ++row)
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        data_.set(rowOf(w, axis), row, gradients.values(i * rows_ + row, axis));
  }
}

Eigen::Matrix3d WitnessGradients::deformationGradient(Eigen::Index witness, const Points& pose) const {
  if (failed_[static_cast<std::size_t>(witness)])
    return Eigen::Matrix3d::Identity();
  const Points rows = lifted(pose);
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    for (Eigen::Index row = 0; row < rows_; ++row)
      m.col(axis) += data_(rowOf(witness, axis), row) * rows.row(row).transpose();
  return m;
}

void WitnessGradients::evaluate(const Points& pose, StressMap& map, Threads threads) const {
  evaluate(std::span(&pose, 1), std::span(&map, 1), witnesses_, threads);
}

void WitnessGradients::evaluate(std::span<const Points> poses, std::span<StressMap> maps, Eigen::Index count,
                                Threads threads) const {
  assert(poses.size() == maps.size() && count >= 0 && count <= witnesses_);
  std::vector<Points> local;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    local.push_back(localPose(poses[i]));
    for (Values* values :
         {&maps[i].rotationalStress, &maps[i].volumeRatio, &maps[i].stretchMax, &maps[i].stretchMin})
      values->resize(count);
  }
  parallelRanges((count + kTile - 1) / kTile, kTilesATime, threads,
                 [&](Eigen::Index begin, Eigen::Index end) {
                   for (Eigen::Index tile = begin; tile < end; ++tile)
                     for (std::size_t i = 0; i < local.size(); ++i)
                       evaluateTile(tile, local[i], maps[i]);
                 });
  for (StressMap& map : maps)
    map.folded = static_cast<int>((map.volumeRatio.array() <= 0).count());
}

Points WitnessGradients::localPose(const Points& pose) const {
  if (pose.rows() != handles_)
    throw DataError(misuse("a pose of %1 handles does not fit witness points of %2", pose.rows(), handles_));
  Points local = lifted(pose);
  local.topRows(handles_).rowwise() -= pose.row(0);
  return local;
}

void WitnessGradients::deformationGradients(const Points& pose, std::vector<Eigen::Matrix3d>& gradients,
                                            Threads threads) const {
  const Points local = localPose(pose);
  gradients.resize(static_cast<std::size_t>(witnesses_));
  parallelRanges((witnesses_ + kTile - 1) / kTile, kTilesATime, threads,
                 [&](Eigen::Index begin, Eigen::Index end) {
                   for (Eigen::Index tile = begin; tile < end; ++tile)
                     gradientsOfTile(tile, local, witnesses_,
                                     [&](Eigen::Index witness, const Eigen::Matrix3d& gradient) {
                                       gradients[static_cast<std::size_t>(witness)] = gradient;
                                     });
                 });
}

/// The thesis' `M = sum_i v'_i (grad a_i)^T` for 16 witnesses: what an axis' weights make of the pose is the
/// matrix' column of that axis.
template <class Take>
void WitnessGradients::gradientsOfTile(Eigen::Index tile, const Points& local, Eigen::Index count,
                                       const Take& take) const {
  double columns[3][3 * kTile];
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    data_.multiplyTile(3 * tile + axis, local, columns[axis]);
  for (Eigen::Index lane = 0; lane < kTile && tile * kTile + lane < count; ++lane) {
    const Eigen::Index w = tile * kTile + lane;
    Eigen::Matrix3d gradient = Eigen::Matrix3d::Identity();
    if (!failed_[static_cast<std::size_t>(w)])
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        gradient.col(axis) = Eigen::Map<const Vec3>(columns[axis] + 3 * lane);
    take(w, gradient);
  }
}

void WitnessGradients::evaluateTile(Eigen::Index tile, const Points& local, StressMap& map) const {
  gradientsOfTile(tile, local, map.rotationalStress.size(),
                  [&map](Eigen::Index w, const Eigen::Matrix3d& gradient) {
                    const LocalDistortion distortion = localDistortion(gradient);
                    map.rotationalStress[w] = distortion.rotationalStress;
                    map.volumeRatio[w] = distortion.volumeRatio;
                    map.stretchMax[w] = distortion.stretchMax;
                    map.stretchMin[w] = distortion.stretchMin;
                  });
}

std::shared_ptr<const WitnessGradients>
bindWitnesses(const coordinates::CoordinateSystem& system, const coordinates::HandleSet& handles,
              const Points& points, const coordinates::BindOptions& options, Progress& progress) {
  const coordinates::BindOptions own = withTetgen(options);
  const Eigen::Index portion = system.traits().needsTetrahedra ? points.rows() : kWitnessPortion;
  std::shared_ptr<WitnessGradients> result;
  const auto partOf = [&](Eigen::Index done) {
    return static_cast<double>(done) / static_cast<double>(points.rows());
  };
  for (Eigen::Index begin = 0; begin < points.rows(); begin += portion) {
    const Eigen::Index count = std::min(portion, points.rows() - begin);
    progress.report(partOf(begin), "derivatives at the witness points");
    runPart(progress, partOf(begin), partOf(begin + count), [&](Progress& part) {
      const auto gradients = system.gradients(handles, points.middleRows(begin, count), own, part);
      if (!result)
        result = std::make_shared<WitnessGradients>(points.rows(), handles.positions.rows(), gradients.lift);
      result->put(begin, gradients, count);
    });
  }
  if (!result)
    result = std::make_shared<WitnessGradients>(0, handles.positions.rows());
  progress.throwIfCancelled();
  progress.report(1);
  return result;
}

} // namespace viscera::deformation
