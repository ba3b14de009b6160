#include "implicit/displacement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "implicit/smooth_blend.h"
#include "implicit/value_noise.h"

namespace viscera::sample_organs {

Displacement::Displacement(NodePtr child, const Roughness& roughness)
    : ImplicitNode(child->extent().grown(2 * roughness.amplitude)), child_(std::move(child)),
      roughness_(roughness) {}

double Displacement::bump(const Vec3& point, double distance) const {
  // Away from the surface the noise only costs time; it fades out, because a step would look like another
  // surface.
  const double reach = 4 * roughness_.amplitude;
  const double away = std::abs(distance);
  if (away >= 2 * reach)
    return 0;
  double sum = 0, amplitude = roughness_.amplitude, frequency = 1 / roughness_.wavelength;
  for (int octave = 0; octave < roughness_.octaves; ++octave) {
    sum += amplitude * valueNoise(frequency * point, roughness_.seed + octave);
    amplitude *= 0.5;
    frequency *= 2.03; // not 2: the lattices of two octaves must not lie on each other
  }
  return sum * (1 - smoothStep(reach, 2 * reach, away));
}

double Displacement::distanceUpTo(const Vec3& point, double limit) const {
  const double distance = child_->distanceUpTo(point, limit + 2 * roughness_.amplitude);
  return distance - bump(point, distance);
}

Shade Displacement::shadeUnfinished(const Vec3& point) const {
  Shade shade = child_->shade(point);
  shade.distance -= bump(point, shade.distance);
  return shade;
}

} // namespace viscera::sample_organs
