#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "viscera/circulation/beat.h"
#include "viscera/circulation/parameters.h"

/// The differential equations of the circulation.
namespace viscera::circulation {

/// dyn/cm^2 in a mmHg, and blood's density, g/cm^3.
inline constexpr double kDynPerMmHg = 1333.22387415;
inline constexpr double kBloodDensity = 1.06;
/// J in a mmHg ml.
inline constexpr double kJoulePerMmHgMl = 1.33322387415e-4;
/// Leaks that a shut valve has in any case, cm^2: 0.005 ml/s at 100 mmHg. Keeps its equation finite.
inline constexpr double kShutArea = 1e-5;

/// An atrium leads the ventricle by no more than this part of the beat at fast rates.
inline constexpr double kAtrialShare = 0.28;

/// The open area of a valve, cm^2.
inline double openArea(const ValveAreas& areas, double opening) {
  const double leak = std::max(areas.leak, kShutArea);
  return leak + (areas.open - leak) * opening;
}

constexpr std::size_t at(Compartment c) {
  return static_cast<std::size_t>(c);
}
constexpr std::size_t at(Valve v) {
  return static_cast<std::size_t>(v);
}

/// The pressures and flows that follow from a state at one instant.
struct Instant {
  std::array<double, kChambers> activation{};
  std::array<double, kCompartments> pressure{}; ///< Of arteries: at the root.
  double pericardium = 0;
  std::array<double, kValves> gradient{};         ///< From upstream to downstream of each valve, mmHg.
  double systemicFlow = 0, pulmonaryFlow = 0;     ///< Through the resistances, ml/s.
  double systemicReturn = 0, pulmonaryReturn = 0; ///< From veins to atria, ml/s.
};

/// The equations of the circulation for one set of parameters. Immutable; thread-safe.
class Circuit {
public:
  /// Prepares a beat that is integrated in `steps` even steps, or in a part of them: the chambers'
  /// activations are computed once at their ends and middles.
  Circuit(const Parameters& parameters, int steps);

  double period() const { return period_; }
  int steps() const { return steps_; }

  /// Pressures and flows at `seconds` after the ventricles began to contract, 0 to a period: an end or a
  /// middle of a step.
  Instant instant(const State& state, double seconds) const;

  /// The state's rate of change. `now` is the instant of the same state.
  void rates(const State& state, const Instant& now, State& rates) const;

  /// The work of the four chambers on the blood, and what valves and vessels dissipate, each second, mmHg ml.
  std::array<double, kChambers + 1> powers(const State& state, const Instant& now, const State& rates) const;

  /// How fast the chambers' pressures change, mmHg/s.
  std::array<double, kChambers> pressureRates(const State& state, double seconds, const State& rates) const;

private:
  /// One chamber with its place in the beat.
  struct Pump {
    Chamber chamber;
    double start = 0;      ///< Of its contraction, s.
    double endSystole = 0; ///< From there to the largest elastance, s.
    double half = 0;       ///< The activation where it begins to fade, all earlier beats included.
  };
  struct Activation {
    double value = 0;
    double rate = 0; ///< 1/s
  };
  /// A valve between two compartments.
  struct Gate {
    ValveAreas areas;
    std::size_t from = 0, to = 0; ///< Compartments.
    double length = 0;            ///< Of the blood that moves with it, cm.
    double impedance = 0;         ///< Behind it, mmHg s/ml.
    double artery = 0;            ///< The area of the artery behind it, cm^2; 0: behind it is a chamber.
  };

  Activation activation(const Pump& pump, double seconds) const;

  double period_;
  int steps_;
  std::vector<std::array<double, kChambers>> activations_; ///< At every half step.
  std::array<Pump, kChambers> pumps_;
  std::array<Gate, kValves> gates_;
  Vessels systemic_, pulmonary_;
  double fluid_, room_, scale_; ///< Of the pericardium.
};

} // namespace viscera::circulation
