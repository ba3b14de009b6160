#include "implicit/tube_relief.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "implicit/smooth_blend.h"
#include "implicit/value_noise.h"

namespace viscera::sample_organs {
namespace {

using std::numbers::pi;

// The constrictions are |sin| with its crease rounded: folds are sharper than pouches, but not edges.
constexpr double kCrease = 0.0036;
constexpr double kPouchPower = 0.3;

double pouch(double phase) {
  const double s = std::sin(pi * phase);
  return std::pow((s * s + kCrease) / (1 + kCrease), kPouchPower);
}

/// 1 between `from` and `to`, 0 outside, with slopes of `fade` mm inside.
double presence(double from, double to, double fade, double arc) {
  return std::min(smoothStep(from, from + fade, arc), 1 - smoothStep(to - fade, to, arc));
}

double foldedFactor(const Folds& f, double arc, double angle) {
  const double present = presence(f.from, f.to, f.wavelength, arc);
  if (present <= 0)
    return 1;
  // The noise runs on a circle round the tube, so that the folds close.
  const Vec3 place(1.5 * std::cos(angle), 1.5 * std::sin(angle), arc / f.wavelength);
  const double stray = f.wander * valueNoise(place, f.seed);
  const double strength = 0.6 + 0.4 * valueNoise(0.7 * place, f.seed + 1);
  return 1 + present * strength * f.depth * std::cos(f.count * angle + 2 * pi * stray);
}

double haustralFactor(const Haustra& h, double arc, double angle) {
  const double present = presence(h.from, h.to, h.period, arc);
  if (present <= 0)
    return 1;
  const double turn = angle / (2 * pi) - std::floor(angle / (2 * pi));
  const double row = std::floor(turn * h.taeniae);
  const double withinRow = turn * h.taeniae - row;
  const double fromTaenia = std::min(withinRow, 1 - withinRow) / h.taeniae * 2 * pi;
  const double taenia = std::exp(-std::pow(fromTaenia / h.taeniaWidth, 2));
  const double irregular =
      h.jitter * valueNoise({0.7 * arc / h.period + 17 * row, 7.3 * row, 0.5 * h.seed}, h.seed);
  const double phase = arc / h.period + h.stagger * row / h.taeniae + irregular;
  const double wall = 1 - h.depth * (1 - pouch(phase));
  const double factor = wall + taenia * (1 - h.taeniaDepth - wall);
  return 1 + (factor - 1) * present;
}

} // namespace

double TubeRelief::factor(double arc, double angle) const {
  double result = 1;
  if (waves)
    result *= 1 + waves->amplitude * std::sin(2 * pi * (arc / waves->period + waves->phase));
  if (haustra)
    result *= haustralFactor(*haustra, arc, angle);
  if (folds)
    result *= foldedFactor(*folds, arc, angle);
  return result;
}

} // namespace viscera::sample_organs
