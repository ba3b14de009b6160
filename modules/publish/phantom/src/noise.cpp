#include "noise.h"

#include <cmath>
#include <numbers>

namespace viscera::phantom {
namespace {

constexpr double kCoarseMm = 6, kFineMm = 3;
constexpr double kFineShare = 0.5;
/// Deviation of what lies between lattice points, measured; the fine part is added to it.
constexpr double kDeviation = 0.52;

/// SplitMix64.
std::uint64_t scrambled(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

/// A number in (0, 1).
double unitOf(std::uint64_t bits) {
  return (static_cast<double>(bits >> 11U) + 0.5) * 0x1p-53;
}

/// A smooth step from 0 to 1 without kinks at its ends.
double eased(double t) {
  return t * t * t * (t * (6 * t - 15) + 10);
}

double latticeNoise(const Vec3& place, std::uint64_t seed) {
  const Vec3 low = place.array().floor();
  const Vec3 t = (place - low).unaryExpr([](double x) { return eased(x); });
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    double weight = 1;
    std::uint64_t bits = seed;
    for (int axis = 0; axis < 3; ++axis) {
      const int up = corner >> axis & 1;
      weight *= up != 0 ? t[axis] : 1 - t[axis];
      bits = scrambled(bits ^ static_cast<std::uint64_t>(static_cast<std::int64_t>(low[axis]) + up));
    }
    // Uniform with a deviation of 1.
    sum += weight * (2 * unitOf(bits) - 1) * std::numbers::sqrt3;
  }
  return sum;
}

} // namespace

std::uint64_t mixed(std::uint64_t a, std::uint64_t b, std::uint64_t c, std::uint64_t d) {
  return scrambled(scrambled(scrambled(scrambled(a) ^ b) ^ c) ^ d);
}

Eigen::Vector2d normalPair(std::uint64_t seed) {
  const double radius = std::sqrt(-2 * std::log(unitOf(scrambled(seed))));
  const double turn = 2 * std::numbers::pi * unitOf(scrambled(seed ^ 0x5851f42d4c957f2dU));
  return {radius * std::cos(turn), radius * std::sin(turn)};
}

double grainAt(const Vec3& rest, std::uint64_t seed) {
  return (latticeNoise(rest / kCoarseMm, mixed(seed, 1)) +
          kFineShare * latticeNoise(rest / kFineMm, mixed(seed, 2))) /
         kDeviation;
}

double ricianOf(double signal, double deviation, std::uint64_t seed) {
  const Eigen::Vector2d noise = deviation * normalPair(seed);
  return std::hypot(signal + noise.x(), noise.y());
}

} // namespace viscera::phantom
