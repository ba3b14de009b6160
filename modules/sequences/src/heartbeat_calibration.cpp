#include "viscera/sequences/heartbeat_calibration.h"

#include <algorithm>
#include <cassert>
#include <string>

#include <Eigen/LU>

#include "viscera/core/error.h"

namespace viscera::sequences {
namespace {

constexpr int kMostSteps = 40;
/// Steps with which the first derivatives are taken, and the largest ones of the search.
constexpr double kProbe = 0.02;
constexpr double kLargestStep = 0.2;

/// The two corrections of one phase, and how far the volumes then are from what they should be (ml).
using Pair = Eigen::Vector2d;

class PhaseSolver {
public:
  PhaseSolver(const HeartMotion& motion, const PoseCompensation& compensation, const MeasureCavities& measure)
      : motion_(motion), compensation_(compensation), measure_(measure), rest_(motion.rig().restHandles()) {}

  /// Improves `corrections` until the volumes fit.
  void solve(const CourseInstant& instant, double phase, Pair& corrections) {
    instant_ = &instant;
    phase_ = phase;
    Pair error = errorAt(corrections);
    for (int step = 0; !fits(error); ++step) {
      if (step == kMostSteps)
        throwUnreached(error);
      if (step % 8 == 0 && (step > 0 || !haveJacobian_))
        differentiate(corrections, error);
      Pair change = -jacobian_.partialPivLu().solve(error);
      const double size = change.cwiseAbs().maxCoeff();
      if (!(size < 1e6))
        throwUnreached(error);
      change *= std::min(1.0, kLargestStep / size);
      const Pair next = errorAt(corrections + change);
      corrections += change;
      jacobian_ += (next - error - jacobian_ * change) * change.transpose() / change.squaredNorm();
      error = next;
    }
  }

private:
  static bool fits(const Pair& error) {
    return std::abs(error[0]) < kLeftToleranceMl && std::abs(error[1]) < kRightToleranceMl;
  }

  Pair errorAt(const Pair& corrections) {
    HeartState state = instant_->state;
    state.leftGain = corrections[0];
    state.rightShift = corrections[1];
    motion_.pose(state, pose_);
    compensation_.apply(rest_, pose_);
    const CavityVolumes measured = measure_(pose_);
    const CavityVolumes& wanted = instant_->volumes;
    const Pair error(measured.leftMl - wanted.leftMl, measured.rightMl - wanted.rightMl);
    if (!error.allFinite())
      throw DataError("the volume of a cavity is not a number", place(), "check the cavities' surfaces");
    return error;
  }

  void differentiate(const Pair& corrections, const Pair& error) {
    for (int i = 0; i < 2; ++i) {
      Pair probe = corrections;
      probe[i] += kProbe;
      jacobian_.col(i) = (errorAt(probe) - error) / kProbe;
    }
    haveJacobian_ = true;
  }

  std::string place() const { return "heartbeat at phase " + std::to_string(phase_); }

  [[noreturn]] void throwUnreached(const Pair& error) const {
    throw DataError("the ventricles cannot be brought to their volumes: left off by " +
                        std::to_string(error[0]) + " ml, right by " + std::to_string(error[1]) + " ml",
                    place(), "check that the cavities lie inside the handles of their walls");
  }

  const HeartMotion& motion_;
  const PoseCompensation& compensation_;
  const MeasureCavities& measure_;
  Points rest_;
  Points pose_;
  Eigen::Matrix2d jacobian_ = Eigen::Matrix2d::Identity();
  const CourseInstant* instant_ = nullptr;
  double phase_ = 0;
  bool haveJacobian_ = false;
};

} // namespace

HeartState uncorrectedState(const CardiacCycle& cycle, double phase) {
  const CavityVolumes volumes = cycle.volumes(phase);
  HeartState state;
  state.emptying = cycle.emptying(phase);
  state.leftPart = volumes.leftMl / cycle.endDiastole().leftMl;
  state.rightPart = volumes.rightMl / cycle.endDiastole().rightMl;
  state.twist = cycle.twist(phase);
  state.atrialContraction = cycle.atrialContraction(phase);
  return state;
}

HeartbeatCalibration calibrateHeartbeat(const HeartMotion& motion, const CardiacCycle& cycle,
                                        const PoseCompensation& compensation, const MeasureCavities& measure,
                                        Progress& progress, int phases) {
  const auto course = [&cycle](double phase) {
    return CourseInstant{uncorrectedState(cycle, phase), cycle.volumes(phase)};
  };
  return calibrateCourse(motion, course, compensation, measure, progress, phases);
}

HeartbeatCalibration calibrateCourse(const HeartMotion& motion, const CourseOverPhase& course,
                                     const PoseCompensation& compensation, const MeasureCavities& measure,
                                     Progress& progress, int phases) {
  assert(phases >= 8);
  PhaseSolver solver(motion, compensation, measure);
  HeartbeatCalibration calibration;
  Pair corrections(1, 0);
  for (int i = 0; i < phases; ++i) {
    progress.throwIfCancelled();
    progress.report(static_cast<double>(i) / phases, "calibrating the heartbeat");
    const double phase = static_cast<double>(i) / phases;
    const CourseInstant instant = course(phase);
    solver.solve(instant, phase, corrections);
    calibration.leftGain.push_back(corrections[0]);
    calibration.rightShift.push_back(corrections[1]);
  }
  progress.report(1);
  return calibration;
}

} // namespace viscera::sequences
