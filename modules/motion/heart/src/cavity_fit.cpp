#include "viscera/heart/cavity_fit.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"

namespace viscera::heart {
namespace {

constexpr int kMostSteps = 40;
/// Steps with which the first derivatives are taken, and the largest ones of the search.
constexpr double kProbe = 0.02;
constexpr double kLargestStep = 0.2;

constexpr int kMost = 4; ///< Corrections.

/// The corrections, or how far the volumes then are from what they should be (ml): left and right ventricle,
/// left and right atrium where they are known.
using Corrections = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMost, 1>;
using Derivatives = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMost, kMost>;

/// The state with these corrections.
HeartState corrected(HeartState state, const Corrections& corrections) {
  state.leftGain = corrections[0];
  state.rightShift = corrections[1];
  if (corrections.size() == kMost) {
    state.atria->leftShift = corrections[2];
    state.atria->rightShift = corrections[3];
  }
  return state;
}

/// The handles as `base + sum of corrections[i] along[i]`.
struct AffineHandles {
  Points base;
  std::vector<Points> along;

  Points at(const Corrections& corrections) const {
    Points pose = base;
    for (std::size_t i = 0; i < along.size(); ++i)
      pose += corrections[static_cast<Eigen::Index>(i)] * along[i];
    return pose;
  }
};

AffineHandles affineHandles(const HeartMotion& motion, const sequences::PoseCompensation& compensation,
                            const Points& rest, const HeartState& state, Eigen::Index count) {
  AffineHandles handles;
  const auto posed = [&](const Corrections& corrections) {
    Points pose;
    motion.pose(corrected(state, corrections), pose);
    compensation.apply(rest, pose);
    return pose;
  };
  // The handles are affine in the corrections: base at zero, and along_i from zero to the i-th unit vector.
  handles.base = posed(Corrections::Zero(count));
  for (Eigen::Index i = 0; i < count; ++i)
    handles.along.push_back(posed(Corrections::Unit(count, i)) - handles.base);
  return handles;
}

/// The wanted volumes of the cavities, and the functions that measure them; one of the two is null where
/// atria are free.
struct Wanted {
  const MeasureCavities& measure;
  const MeasureCavities* measureAtria;
  const HeartInstant& instant;

  Eigen::Index count() const { return measureAtria ? 4 : 2; }
};

/// Finds the corrections of one instant.
class Search {
public:
  Search(const AffineHandles& handles, const Wanted& wanted) : handles_(handles), wanted_(wanted) {}

  /// Starts with `found` where that is of as many cavities.
  FoundCavities run(const FoundCavities* found) const {
    const bool warm = found && found->corrections.size() == wanted_.count();
    Corrections corrections =
        warm ? Corrections(found->corrections) : Corrections(Corrections::Unit(wanted_.count(), 0));
    Corrections error = errorAt(corrections);
    Derivatives jacobian = warm ? Derivatives(found->jacobian) : derivatives(corrections, error);
    for (int step = 0; !fits(error); ++step) {
      if (step == kMostSteps)
        throwUnreached(error);
      if (step > 0 && step % 8 == 0)
        jacobian = derivatives(corrections, error);
      Corrections change = -jacobian.partialPivLu().solve(error);
      const double size = change.cwiseAbs().maxCoeff();
      if (!(size < 1e6))
        throwUnreached(error);
      change *= std::min(1.0, kLargestStep / size);
      const Corrections next = errorAt(corrections + change);
      corrections += change;
      // Broyden: the least change of J with which J s is the change of the error that was seen.
      jacobian += (next - error - jacobian * change) * change.transpose() / change.squaredNorm();
      error = next;
    }
    return {corrections, jacobian};
  }

private:
  static bool fits(const Corrections& error) { return error.cwiseAbs().maxCoeff() < CavityFit::kToleranceMl; }

  Corrections errorAt(const Corrections& corrections) const {
    const Points pose = handles_.at(corrections);
    const CavityVolumes measured = wanted_.measure(pose);
    const CavityVolumes& ventricles = wanted_.instant.volumes;
    Corrections error(wanted_.count());
    error[0] = measured.leftMl - ventricles.leftMl;
    error[1] = measured.rightMl - ventricles.rightMl;
    if (wanted_.measureAtria) {
      const CavityVolumes atria = (*wanted_.measureAtria)(pose);
      error[2] = atria.leftMl - wanted_.instant.atria->leftMl;
      error[3] = atria.rightMl - wanted_.instant.atria->rightMl;
    }
    if (!error.allFinite())
      throw DataError(misuse("The volume of a cavity is not a number"), place(),
                      misuse("check the cavities' surfaces"));
    return error;
  }

  Derivatives derivatives(const Corrections& corrections, const Corrections& error) const {
    Derivatives jacobian(error.size(), error.size());
    for (Eigen::Index i = 0; i < error.size(); ++i) {
      Corrections probe = corrections;
      probe[i] += kProbe;
      jacobian.col(i) = (errorAt(probe) - error) / kProbe;
    }
    return jacobian;
  }

  Text place() const {
    const auto ml = [](double volume) { return inFixed(volume, 1); };
    const CavityVolumes& ventricles = wanted_.instant.volumes;
    if (!wanted_.measureAtria)
      return phrase("heart with %1 ml left and %2 ml right", ml(ventricles.leftMl), ml(ventricles.rightMl));
    const CavityVolumes& atria = *wanted_.instant.atria;
    return phrase("heart with %1 ml left and %2 ml right, atria with %3 ml left and %4 ml right",
                  ml(ventricles.leftMl), ml(ventricles.rightMl), ml(atria.leftMl), ml(atria.rightMl));
  }

  [[noreturn]] void throwUnreached(const Corrections& error) const {
    const auto ml = [&](Eigen::Index cavity) { return inFixed(error[cavity], 2); };
    throw DataError(
        wanted_.measureAtria
            ? phrase("The ventricles cannot be brought to their volumes: left off by %1 ml, right by %2 ml; "
                     "atria: left off by %3 ml, right by %4 ml",
                     ml(0), ml(1), ml(2), ml(3))
            : phrase("The ventricles cannot be brought to their volumes: left off by %1 ml, right by %2 ml",
                     ml(0), ml(1)),
        place(), "check that the cavities lie inside the handles of their walls");
  }

  const AffineHandles& handles_;
  const Wanted wanted_;
};

} // namespace

HeartInstant heartInstant(const CardiacCycle& cycle, const CardiacInstant& now) {
  HeartInstant instant;
  instant.volumes = now.volumes;
  instant.state.emptying = now.leftEmptying;
  instant.state.rightEmptying = now.rightEmptying;
  instant.state.leftPart = now.volumes.leftMl / cycle.endDiastole().leftMl;
  instant.state.rightPart = now.volumes.rightMl / cycle.endDiastole().rightMl;
  instant.state.twist = now.twist;
  instant.state.atrialContraction = now.atrialContraction;
  return instant;
}

CavityFit::CavityFit(HeartMotion motion, sequences::PoseCompensation compensation, MeasureCavities measure,
                     MeasureCavities measureAtria)
    : motion_(std::move(motion)), compensation_(std::move(compensation)), measure_(std::move(measure)),
      measureAtria_(std::move(measureAtria)), rest_(motion_.rig().restHandles()) {
  compensation_.requireFor(rest_.rows(), "heart", "heartbeat");
}

HeartState CavityFit::pose(const HeartInstant& instant, Points& pose, FoundCavities* found) const {
  const bool atria = measureAtria_ && instant.atria && instant.state.atria;
  const Wanted wanted{measure_, atria ? &measureAtria_ : nullptr, instant};
  const AffineHandles handles = affineHandles(motion_, compensation_, rest_, instant.state, wanted.count());
  const Search search(handles, wanted);
  FoundCavities now;
  try {
    now = search.run(found);
  } catch (const DataError&) { // The start may be unsuitable.
    if (!found)
      throw;
    now = search.run(nullptr);
  }
  pose = handles.at(now.corrections);
  const HeartState state = corrected(instant.state, now.corrections);
  if (found)
    *found = std::move(now);
  return state;
}

} // namespace viscera::heart
