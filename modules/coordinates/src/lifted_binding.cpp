#include "lifted_binding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace viscera::coordinates {

LiftedBinding::LiftedBinding(std::shared_ptr<const PoseLift> lift, TiledWeights weights,
                             const Points& restHandles, const Points& restPoints, std::vector<int> failures,
                             double seconds, Threads threads, std::vector<Text> notes)
    : lift_(std::move(lift)), handles_(restHandles.rows()),
      rows_(std::move(weights), lift_->lift(restHandles), restPoints, std::move(failures), seconds, threads,
            std::move(notes)),
      report_(rows_.report()) {
  report_.unityError = 0;
  report_.minWeight = std::numeric_limits<double>::infinity();
  const TiledWeights& own = rows_.weights();
  auto failed = report_.failures.begin();
  for (Eigen::Index point = 0; point < own.points(); ++point) {
    if (failed != report_.failures.end() && *failed == point) {
      ++failed;
      continue;
    }
    double sum = 0;
    for (Eigen::Index handle = 0; handle < handles_; ++handle) {
      sum += own(point, handle);
      report_.minWeight = std::min(report_.minWeight, own(point, handle));
    }
    report_.unityError = std::max(report_.unityError, std::abs(sum - 1));
  }
  if (!std::isfinite(report_.minWeight))
    report_.minWeight = 0; // No point has weights.
}

PiecesOfWork LiftedBinding::deformInPieces(const Points& pose, Points& points) const {
  const auto lifted = std::make_shared<const Points>(lift_->lift(pose));
  PiecesOfWork work = rows_.deformInPieces(*lifted, points);
  return {work.count, [lifted, run = std::move(work.run)](Eigen::Index piece) { run(piece); }};
}

PiecesOfWork LiftedBinding::moveHandleInPieces(const Points& pose, int handle, const Vec3& delta,
                                               Points& points) const {
  Points moved = pose;
  moved.row(handle) += delta.transpose();
  const Points before = lift_->lift(pose), after = lift_->lift(moved);
  // The handle's own row even where it stays: with one work at least there are as many pieces as always.
  std::vector<PiecesOfWork> rows;
  for (Eigen::Index row = 0; row < after.rows(); ++row)
    if (row == handle || after.row(row) != before.row(row))
      rows.push_back(rows_.moveHandleInPieces(before, static_cast<int>(row),
                                              (after.row(row) - before.row(row)).transpose(), points));
  return inTurn(std::move(rows));
}

void LiftedBinding::deform(const Points& pose, Points& points, Threads threads) const {
  parallelPieces({deformInPieces(pose, points)}, threads);
}

void LiftedBinding::moveHandle(const Points& pose, int handle, const Vec3& delta, Points& points,
                               Threads threads) const {
  parallelPieces({moveHandleInPieces(pose, handle, delta, points)}, threads);
}

void LiftedBinding::pullBack(const Points& pose, const Points& pointGradient, Points& handleGradient,
                             Threads threads) const {
  Points ofRows;
  rows_.pullBack(pose, pointGradient, ofRows, threads);
  handleGradient = lift_->pullBack(pose, ofRows);
}

} // namespace viscera::coordinates
