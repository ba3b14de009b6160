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

double quintic(double t) {
  return t * t * t * (t * (6 * t - 15) + 10);
}

double mix(double a, double b, double t) {
  return a + t * (b - a);
}

} // namespace

double valueNoise(const Vec3& point, int seed) {
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
