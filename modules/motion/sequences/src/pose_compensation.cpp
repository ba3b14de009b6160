#include "viscera/sequences/pose_compensation.h"

#include <cassert>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::sequences {
namespace {
/// Unity of the coordinates, with room for those of thousands of handles.
constexpr double kUnityTolerance = 1e-9;
} // namespace

PoseCompensation::PoseCompensation(const Eigen::MatrixXd& selfWeights, int terms) {
  assert(terms >= 0 && terms <= 16);
  const Eigen::Index n = selfWeights.rows();
  if (selfWeights.cols() != n || !selfWeights.allFinite())
    throw DataError(misuse("the coordinates of the handles are not a finite square matrix"),
                    misuse("pose compensation"));
  for (Eigen::Index row = 0; row < n; ++row)
    if (std::abs(selfWeights.row(row).sum() - 1) > kUnityTolerance)
      throw DataError(misuse("the coordinates do not sum to 1"), phrase("handle %1", row + 1));
  // M_k+1 = I + (I - W) M_k sums the series of W^-1 = (I - (I - W))^-1, term by term: few of them bring the
  // points at the handles nearly to where the handles were meant, and stay tame where W is close to singular.
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(n, n);
  matrix_ = identity;
  for (int term = 0; term < terms; ++term)
    matrix_ = (identity + matrix_ - selfWeights * matrix_).eval();
}

void PoseCompensation::apply(const Points& rest, Points& pose) const {
  if (handleCount() == 0)
    return;
  assert(rest.rows() == handleCount() && pose.rows() == handleCount());
  const Points displacement = pose - rest;
  pose.noalias() = rest + matrix_ * displacement;
}

void PoseCompensation::requireFor(Eigen::Index handles, const std::string& organ,
                                  const std::string& sequence) const {
  if (handleCount() != 0 && handleCount() != handles)
    throw DataError(misuse("the compensation is for %n {handle|handles}, the organ (%2) has %3",
                           handleCount(), named(organ), handles),
                    named(sequence));
}

} // namespace viscera::sequences
