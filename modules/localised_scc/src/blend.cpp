#include "blend.h"

namespace viscera::localised_scc {
namespace {

BlendValue product(const BlendValue& a, const BlendValue& b) {
  return {a.value * b.value, a.value * b.gradient + b.value * a.gradient};
}

BlendValue complement(const BlendValue& a) {
  return {1 - a.value, -a.gradient};
}

} // namespace

BlendValue blendAt(double distance, const Vec3& away, double offset) {
  if (distance <= 0)
    return {1, Vec3::Zero()};
  if (distance >= offset)
    return {0, Vec3::Zero()};
  // rho = (1 - t)^3 + 3 (1 - t)^2 t with t = d / h, so grad rho = -6 t (1 - t) / h grad d; `away` is grad d.
  const double t = distance / offset;
  return {(1 - t) * (1 - t) * (1 + 2 * t), (-6 * t * (1 - t) / offset) * away};
}

std::vector<BlendValue> partition(const std::vector<BlendValue>& zones) {
  // w_k = rho_k prod_{l != k} (1 - rho_l), and for the region itself, behind the zones, prod_l (1 - rho_l).
  std::vector<BlendValue> parts;
  BlendValue sum{0, Vec3::Zero()};
  for (std::size_t k = 0; k <= zones.size(); ++k) {
    BlendValue part = k < zones.size() ? zones[k] : BlendValue{1, Vec3::Zero()};
    for (std::size_t l = 0; l < zones.size(); ++l)
      if (l != k)
        part = product(part, complement(zones[l]));
    sum.value += part.value;
    sum.gradient += part.gradient;
    parts.push_back(part);
  }
  // Divided by their sum W: grad (w / W) = grad w / W - w / W^2 grad W.
  for (auto& part : parts) {
    part.gradient = part.gradient / sum.value - part.value / (sum.value * sum.value) * sum.gradient;
    part.value /= sum.value;
  }
  return parts;
}

} // namespace viscera::localised_scc
