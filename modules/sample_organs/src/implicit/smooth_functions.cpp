#include "implicit/smooth_functions.h"

#include <cstdint>

namespace viscera::sample_organs {
namespace {

std::uint32_t mixed(std::uint32_t h) {
  h ^= h >> 16;
  h *= 0x7feb352dU;
  h ^= h >> 15;
  h *= 0x846ca68bU;
  return h ^ (h >> 16);
}

double latticeValue(int x, int y, int z, int seed) {
  std::uint32_t h = mixed(static_cast<std::uint32_t>(seed) + 0x9e3779b9U);
  for (const int c : {x, y, z})
    h = mixed(h + static_cast<std::uint32_t>(c));
  return static_cast<double>(h) / 2147483647.5 - 1;
}

/// 6 t^5 - 15 t^4 + 10 t^3: from 0 to 1, with two derivatives that vanish at both ends.
double quintic(double t) {
  return t * t * t * (t * (6 * t - 15) + 10);
}

double mix(double a, double b, double t) {
  return a + t * (b - a);
}

} // namespace

double valueNoise(const Vec3& point, int seed) {
  // Trilinear between the eight corners of the cell, in quintic(x), quintic(y) and quintic(z) instead of x, y
  // and z: neighbouring cells then meet with two continuous derivatives.
  const Vec3 floor = point.array().floor();
  const int x = static_cast<int>(floor.x()), y = static_cast<int>(floor.y()), z = static_cast<int>(floor.z());
  const double u = quintic(point.x() - floor.x());
  const double v = quintic(point.y() - floor.y());
  const double w = quintic(point.z() - floor.z());
  const auto alongX = [&](int j, int k) {
    return mix(latticeValue(x, y + j, z + k, seed), latticeValue(x + 1, y + j, z + k, seed), u);
  };
  return mix(mix(alongX(0, 0), alongX(1, 0), v), mix(alongX(0, 1), alongX(1, 1), v), w);
}

} // namespace viscera::sample_organs
