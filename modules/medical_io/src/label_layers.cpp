#include "label_layers.h"

#include <algorithm>
#include <iterator>

namespace viscera::medical_io {
namespace {

/// The voxels from the mask's first to its last, most often a small part of all.
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

Span spanOf(const LabelMap::Layer& mask) {
  const auto inside = [](std::uint16_t voxel) { return voxel != 0; };
  const auto first = std::find_if(mask.begin(), mask.end(), inside);
  const auto last = std::find_if(mask.rbegin(), std::make_reverse_iterator(first), inside).base();
  return {static_cast<std::size_t>(first - mask.begin()), static_cast<std::size_t>(last - mask.begin())};
}

bool isFree(const LabelMap::Layer& layer, const LabelMap::Layer& mask, const Span& span) {
  for (std::size_t v = span.begin; v < span.end; ++v)
    if (mask[v] != 0 && layer[v] != 0)
      return false;
  return true;
}

} // namespace

int addToFreeLayer(std::vector<LabelMap::Layer>& layers, const LabelMap::Layer& mask, std::uint16_t number) {
  const Span span = spanOf(mask);
  std::size_t found = 0;
  while (found < layers.size() && !isFree(layers[found], mask, span))
    ++found;
  if (found == layers.size())
    layers.emplace_back(mask.size());
  for (std::size_t v = span.begin; v < span.end; ++v)
    if (mask[v] != 0)
      layers[found][v] = number;
  return static_cast<int>(found);
}

} // namespace viscera::medical_io
