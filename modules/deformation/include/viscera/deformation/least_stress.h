#pragma once

#include <memory>

#include "viscera/core/parallel.h"
#include "viscera/deformation/restoration_model.h"
#include "viscera/deformation/witness_gradients.h"

namespace viscera::deformation {

/// A restoration model that restores a volume with the least rotational stress inside the organ (proposed by
/// the thesis, 5.2.1).
///
/// At each witness with deformation gradient M = R S (R the nearest rotation) the stress is nothing but the
/// departure of S from a uniform scaling. So with R held, the sum over the witnesses of
/// `|dev sym(R^T M)|^2 / (tr S / 3)^2` is a quadratic model of the squared stress in the positions of the
/// handles; `dev` takes the mean of the diagonal away. `relaxation` minimises it with the volume kept to
/// first order, as far as the model itself goes down; `direction` is the motion of least added stress that
/// changes the volume. A small share of least displacement keeps handles without influence on any witness
/// still.
///
/// Immutable, thread-safe. O(witnesses x free^2) a call: take some thousands of witnesses.
class LeastStress final : public RestorationModel {
public:
  /// Uses the first `witnesses` points of `gradients`.
  LeastStress(std::shared_ptr<const WitnessGradients> gradients, Eigen::Index witnesses,
              Threads threads = {});

  Points direction(const Points& pose, const Points& gradient, const std::vector<int>& free) const override;
  Points relaxation(const Points& pose, const Points& gradient, const std::vector<int>& free) const override;

  /// The cost at `pose`: the mean over the witnesses of the model's squared stress, about rad^2.
  double cost(const Points& pose) const;

private:
  struct Quadratic;
  Quadratic quadratic(const Points& pose, const std::vector<int>& free) const;

  std::shared_ptr<const WitnessGradients> gradients_;
  Eigen::Index witnesses_;
  Threads threads_;
};

} // namespace viscera::deformation
