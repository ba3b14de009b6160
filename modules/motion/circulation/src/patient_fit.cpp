#include "viscera/circulation/patient_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include <Eigen/Dense>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"

namespace viscera::circulation {
namespace {

constexpr double kVolumeToleranceMl = 0.5;
constexpr double kFractionTolerance = 0.002;
constexpr double kPressureToleranceMmHg = 0.5;

// The limits of plausible measurements.
constexpr double kSmallestEdvMl = 30, kLargestEdvMl = 500;
constexpr double kSmallestEf = 0.05, kLargestEf = 0.85;
constexpr double kLowestMmHg = 30, kHighestMmHg = 200;

constexpr int kMostSteps = 25;
constexpr double kLargestStep = 0.4; ///< Of a logarithm.
constexpr double kProbe = 0.01;      ///< The same, for a derivative.
/// Below this the weighted errors count as none: a tenth of what `met` allows.
constexpr double kEnough = 0.1;

using Unknowns = Eigen::Vector3d;

const std::array<const char*, 3> kSought = {"lvEes", "stressedVolume", "systemicResistance"};

const ParameterInfo& infoOf(std::string_view name) {
  const auto& infos = parameterInfos();
  return *std::find_if(infos.begin(), infos.end(), [&](const auto& info) { return info.name == name; });
}

double withinRange(const std::string& name, double value) {
  const ParameterInfo& info = infoOf(name);
  return std::clamp(value, info.lowest, info.highest);
}

void requireWithin(double value, double low, double high, const Text& what, const Text& hint) {
  if (!(value >= low && value <= high))
    throw UsageError(phrase("%1 lies between %2 and %3", what, inDigits(low, 3), inDigits(high, 3)),
                     inDigits(value, 4), hint);
}

void check(const MeasuredVentricle& measured) {
  requireWithin(measured.edvMl, kSmallestEdvMl, kLargestEdvMl, "An end-diastolic volume in ml",
                "give the largest volume of the left ventricle");
  requireWithin(measured.ef, kSmallestEf, kLargestEf, "An ejection fraction", "give 55 % as 0.55");
  if (measured.meanAorticMmHg != 0)
    requireWithin(measured.meanAorticMmHg, kLowestMmHg, kHighestMmHg, "A mean aortic pressure in mmHg",
                  "about a third of the way from the diastolic to the systolic one");
}

/// A ventricle of another size: each pressure belongs to a volume that is `ratio` times as large.
void resize(Parameters& parameters, const std::string& side, double ratio) {
  const auto scale = [&](const std::string& name, double factor) {
    setParameter(parameters, name, withinRange(name, factor * parameter(parameters, name)));
  };
  scale(side + "V0", ratio);
  scale(side + "B", 1 / ratio);
  scale(side + "Ees", 1 / ratio);
}

/// The search: errors, weighed by what is allowed of each, over the logarithms of what is sought.
class Search {
public:
  Search(const MeasuredVentricle& measured, Parameters parameters, double pressure, Progress& progress)
      : measured_(measured), parameters_(std::move(parameters)), pressure_(pressure), progress_(progress) {}

  PatientFit run() {
    Unknowns at = logarithms();
    Eigen::Vector3d errors = errorsAt(at);
    double damping = 0;
    for (int step = 0; step < kMostSteps && errors.norm() > kEnough; ++step) {
      progress_.report(static_cast<double>(step) / kMostSteps, "fitting the circulation");
      const Eigen::Matrix3d slope = slopeAt(at, errors);
      const Unknowns next = clamped(at + stepFor(slope, errors, at, damping));
      const Eigen::Vector3d found = errorsAt(next);
      if (found.norm() < errors.norm()) {
        const bool still = errors.norm() - found.norm() < 1e-6 * errors.norm();
        at = next;
        errors = found;
        damping *= 0.2;
        if (still)
          break;
      } else {
        damping = std::max(4 * damping, 0.05);
      }
    }
    errorsAt(at);
    progress_.report(1);
    return result(at);
  }

private:
  Unknowns logarithms() const {
    Unknowns at;
    for (std::size_t i = 0; i < kSought.size(); ++i)
      at[static_cast<Eigen::Index>(i)] = std::log(parameter(parameters_, kSought[i]));
    return at;
  }

  static Unknowns clamped(Unknowns at) {
    for (std::size_t i = 0; i < kSought.size(); ++i) {
      double& value = at[static_cast<Eigen::Index>(i)];
      value = std::log(withinRange(kSought[i], std::exp(value)));
    }
    return at;
  }

  Eigen::Vector3d errorsAt(const Unknowns& at) {
    for (std::size_t i = 0; i < kSought.size(); ++i)
      setParameter(parameters_, kSought[i],
                   withinRange(kSought[i], std::exp(at[static_cast<Eigen::Index>(i)])));
    progress_.throwIfCancelled();
    Progress quiet;
    state_ = findPeriodicState(parameters_, quiet, {}, start_ ? &*start_ : nullptr);
    if (!state_.converged)
      throw DataError(state_.failureReason, "the circulation of that heart");
    start_ = state_.start;
    indices_ = indicesOf(parameters_, state_.beat);
    const ChamberIndices& lv = indices_.of(Compartment::lv);
    return {(lv.edvMl - measured_.edvMl) / kVolumeToleranceMl, (lv.ef - measured_.ef) / kFractionTolerance,
            (indices_.aorta.mean - pressure_) / kPressureToleranceMmHg};
  }

  Eigen::Matrix3d slopeAt(const Unknowns& at, const Eigen::Vector3d& errors) {
    Eigen::Matrix3d slope;
    for (Eigen::Index i = 0; i < 3; ++i) {
      Unknowns beside = at;
      beside[i] += kProbe;
      if (clamped(beside)[i] < beside[i])
        beside[i] = at[i] - kProbe;
      slope.col(i) = (errorsAt(beside) - errors) / (beside[i] - at[i]);
    }
    return slope;
  }

  /// Least squares; an unknown that would leave its range stays, and the others make up for it.
  static Unknowns stepFor(Eigen::Matrix3d slope, const Eigen::Vector3d& errors, const Unknowns& at,
                          double damping) {
    for (int pass = 0; pass < 3; ++pass) {
      // Levenberg and Marquardt: (J^T J + damping diag(J^T J) + 1e-9 I) step = -J^T e.
      Eigen::Matrix3d normal = slope.transpose() * slope;
      normal.diagonal() += (damping * normal.diagonal()).eval() + Eigen::Vector3d::Constant(1e-9);
      Unknowns step = -normal.ldlt().solve(slope.transpose() * errors);
      step *= std::min(1.0, kLargestStep / std::max(step.cwiseAbs().maxCoeff(), 1e-12));
      const Unknowns stopped = clamped(at + step) - at;
      bool free = true;
      for (Eigen::Index i = 0; i < 3; ++i)
        if (std::abs(stopped[i]) < 1e-9 && std::abs(step[i]) > 1e-9) {
          slope.col(i).setZero();
          free = false;
        }
      if (free)
        return step;
    }
    return Unknowns::Zero();
  }

  PatientFit result(const Unknowns& at) const {
    PatientFit fit{parameters_, state_, indices_};
    const ChamberIndices& lv = indices_.of(Compartment::lv);
    fit.edvErrorMl = lv.edvMl - measured_.edvMl;
    fit.efError = lv.ef - measured_.ef;
    fit.pressureErrorMmHg = indices_.aorta.mean - pressure_;
    for (std::size_t i = 0; i < kSought.size(); ++i) {
      const ParameterInfo& info = infoOf(kSought[i]);
      const double value = std::exp(at[static_cast<Eigen::Index>(i)]);
      if (!fit.met() && (value <= info.lowest * (1 + 1e-9) || value >= info.highest * (1 - 1e-9)))
        fit.atLimit.push_back(info.name);
    }
    return fit;
  }

  const MeasuredVentricle& measured_;
  Parameters parameters_;
  double pressure_;
  Progress& progress_;
  PeriodicState state_;
  Indices indices_;
  std::optional<State> start_;
};

} // namespace

bool PatientFit::met() const {
  return std::abs(edvErrorMl) <= kVolumeToleranceMl && std::abs(efError) <= kFractionTolerance &&
         std::abs(pressureErrorMmHg) <= kPressureToleranceMmHg;
}

Text PatientFit::remark() const {
  const ChamberIndices& lv = indices.of(Compartment::lv);
  const Text ml = inDigits(lv.edvMl, 4), ef = inDigits(lv.ef, 3), pressure = inDigits(indices.aorta.mean, 3);
  if (met())
    return phrase("The circulation has the measured ventricle: %1 ml, ejection fraction %2, mean aortic "
                  "pressure %3 mmHg",
                  ml, ef, pressure);
  if (atLimit.empty())
    return phrase("No circulation has just that ventricle; the nearest one found: %1 ml, ejection fraction "
                  "%2, mean aortic pressure %3 mmHg",
                  ml, ef, pressure);
  std::string limits;
  for (const std::string& name : atLimit)
    limits += (limits.empty() ? "" : ", ") + name;
  return phrase("No circulation has just that ventricle; the nearest one found: %1 ml, ejection fraction "
                "%2, mean aortic pressure %3 mmHg; at the limit of its range: %4",
                ml, ef, pressure, limits);
}

const std::vector<std::string>& fittedParameters() {
  static const std::vector<std::string> names = {
      "rate", "stressedVolume", "systemicResistance", "lvEes", "lvV0", "lvB", "rvEes", "rvV0", "rvB"};
  return names;
}

PatientFit fitToVentricle(const MeasuredVentricle& measured, Progress& progress, const Parameters& start) {
  check(measured);
  Parameters parameters = start;
  setParameter(parameters, "rate", measured.ratePerMinute);
  Progress quiet;
  const PeriodicState before = findPeriodicState(start, quiet);
  if (!before.converged)
    throw DataError(before.failureReason, "the circulation to start with");
  const Indices indices = indicesOf(start, before.beat);
  const ChamberIndices& lv = indices.of(Compartment::lv);
  resize(parameters, "lv", measured.edvMl / lv.edvMl);
  resize(parameters, "rv", measured.edvMl * measured.ef / lv.svMl);
  const double pressure = measured.meanAorticMmHg > 0 ? measured.meanAorticMmHg : indices.aorta.mean;
  // Start: Ees = 1.1 P / (ESV - V0) and R = 0.95 P / (EDV EF rate / 60).
  // What a windkessel and an elastance alone would need: a start, not the answer.
  const double esvMl = measured.edvMl * (1 - measured.ef);
  const double flowMlS = measured.edvMl * measured.ef * measured.ratePerMinute / 60;
  setParameter(parameters, "lvEes",
               withinRange("lvEes", 1.1 * pressure / std::max(5.0, esvMl - parameters.lv.v0)));
  setParameter(parameters, "systemicResistance",
               withinRange("systemicResistance", 0.95 * pressure / flowMlS));
  return Search(measured, std::move(parameters), pressure, progress).run();
}

} // namespace viscera::circulation
