#include "viscera/sequences/cavity_fit.h"

#include <algorithm>
#include <string>
#include <utility>

#include <Eigen/LU>

#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

constexpr int kMostSteps = 40;
/// Steps with which the first derivatives are taken, and the largest ones of the search.
constexpr double kProbe = 0.02;
constexpr double kLargestStep = 0.2;

/// The two corrections, and how far the volumes then are from what they should be (ml).
using Pair = Eigen::Vector2d;

/// The handles as `base + gain alongGain + shift alongShift`.
struct AffineHandles {
  Points base, alongGain, alongShift;

  Points at(const Pair& corrections) const {
    return base + corrections[0] * alongGain + corrections[1] * alongShift;
  }
};

AffineHandles affineHandles(const HeartMotion& motion, const PoseCompensation& compensation,
                            const Points& rest, HeartState state) {
  AffineHandles handles;
  const auto posed = [&](double gain, double shift) {
    Points pose;
    state.leftGain = gain;
    state.rightShift = shift;
    motion.pose(state, pose);
    compensation.apply(rest, pose);
    return pose;
  };
  handles.base = posed(0, 0);
  handles.alongGain = posed(1, 0) - handles.base;
  handles.alongShift = posed(0, 1) - handles.base;
  return handles;
}

/// Finds the corrections of one instant.
class Search {
public:
  Search(const AffineHandles& handles, const MeasureCavities& measure, const CavityVolumes& wanted)
      : handles_(handles), measure_(measure), wanted_(wanted) {}

  Pair run() const {
    Pair corrections(1, 0);
    Pair error = errorAt(corrections);
    Eigen::Matrix2d jacobian = Eigen::Matrix2d::Identity();
    for (int step = 0; !fits(error); ++step) {
      if (step == kMostSteps)
        throwUnreached(error);
      if (step % 8 == 0)
        differentiate(corrections, error, jacobian);
      Pair change = -jacobian.partialPivLu().solve(error);
      const double size = change.cwiseAbs().maxCoeff();
      if (!(size < 1e6))
        throwUnreached(error);
      change *= std::min(1.0, kLargestStep / size);
      const Pair next = errorAt(corrections + change);
      corrections += change;
      jacobian += (next - error - jacobian * change) * change.transpose() / change.squaredNorm();
      error = next;
    }
    return corrections;
  }

private:
  static bool fits(const Pair& error) { return error.cwiseAbs().maxCoeff() < CavityFit::kToleranceMl; }

  Pair errorAt(const Pair& corrections) const {
    const CavityVolumes measured = measure_(handles_.at(corrections));
    const Pair error(measured.leftMl - wanted_.leftMl, measured.rightMl - wanted_.rightMl);
    if (!error.allFinite())
      throw DataError("The volume of a cavity is not a number", place(), "check the cavities' surfaces");
    return error;
  }

  void differentiate(const Pair& corrections, const Pair& error, Eigen::Matrix2d& jacobian) const {
    for (int i = 0; i < 2; ++i) {
      Pair probe = corrections;
      probe[i] += kProbe;
      jacobian.col(i) = (errorAt(probe) - error) / kProbe;
    }
  }

  std::string place() const {
    return "heart with " + std::to_string(wanted_.leftMl) + " ml left and " +
           std::to_string(wanted_.rightMl) + " ml right";
  }

  [[noreturn]] void throwUnreached(const Pair& error) const {
    throw DataError("The ventricles cannot be brought to their volumes: left off by " +
                        std::to_string(error[0]) + " ml, right by " + std::to_string(error[1]) + " ml",
                    place(), "check that the cavities lie inside the handles of their walls");
  }

  const AffineHandles& handles_;
  const MeasureCavities& measure_;
  const CavityVolumes& wanted_;
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

CavityFit::CavityFit(HeartMotion motion, PoseCompensation compensation, MeasureCavities measure)
    : motion_(std::move(motion)), compensation_(std::move(compensation)), measure_(std::move(measure)),
      rest_(motion_.rig().restHandles()) {
  compensation_.requireFor(rest_.rows(), "heart", "heartbeat");
}

HeartState CavityFit::pose(const HeartInstant& instant, Points& pose) const {
  const AffineHandles handles = affineHandles(motion_, compensation_, rest_, instant.state);
  const Pair corrections = Search(handles, measure_, instant.volumes).run();
  pose = handles.at(corrections);
  HeartState state = instant.state;
  state.leftGain = corrections[0];
  state.rightShift = corrections[1];
  return state;
}

} // namespace viscera::sequences
