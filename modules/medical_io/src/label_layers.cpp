#include "label_layers.h"

namespace viscera::medical_io {
namespace {

bool isFree(const LabelMap::Layer& layer, const LabelMap::Layer& mask) {
  for (std::size_t v = 0; v < mask.size(); ++v)
    if (mask[v] != 0 && layer[v] != 0)
      return false;
  return true;
}

} // namespace

int addToFreeLayer(std::vector<LabelMap::Layer>& layers, const LabelMap::Layer& mask, std::uint16_t number) {
  std::size_t found = 0;
  while (found < layers.size() && !isFree(layers[found], mask))
    ++found;
  if (found == layers.size())
    layers.emplace_back(mask.size());
  for (std::size_t v = 0; v < mask.size(); ++v)
    if (mask[v] != 0)
      layers[found][v] = number;
  return static_cast<int>(found);
}

} // namespace viscera::medical_io
