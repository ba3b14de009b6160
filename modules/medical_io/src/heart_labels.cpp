#include "viscera/medical_io/heart_labels.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "file_bytes.h"
#include "viscera/anatomy/part.h"

namespace viscera::medical_io {
namespace {

constexpr const char* kWhole = "Heart";
constexpr std::string_view kMuscle = "myocardium";

} // namespace

std::optional<HeartLabels> heartAmong(const std::vector<std::string>& names) {
  HeartLabels heart;
  std::vector<std::optional<anatomy::Part>> parts;
  for (const std::string& name : names)
    parts.push_back(anatomy::partNamed(name));
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i] && parts[i]->organ == kMuscle && parts[i]->extent != anatomy::Extent::lesion)
      heart.muscle.push_back(i);
  bool ventricle = false;
  for (const anatomy::Part& chamber :
       {anatomy::kLeftVentricle, anatomy::kRightVentricle, anatomy::kLeftAtrium, anatomy::kRightAtrium}) {
    const auto found = std::find(parts.begin(), parts.end(), chamber);
    if (found == parts.end())
      continue;
    if (std::find(found + 1, parts.end(), chamber) != parts.end())
      return std::nullopt;
    heart.cavities.push_back(
        {std::string(anatomy::abbreviationOf(chamber)), static_cast<std::size_t>(found - parts.begin())});
    ventricle = ventricle || chamber.chamber == anatomy::Chamber::ventricle;
  }
  if (heart.muscle.empty() || !ventricle)
    return std::nullopt;
  return heart;
}

std::optional<HeartLabels> heartLabels(const LabelMap& map) {
  std::vector<std::string> names;
  for (const Segment& segment : map.segments)
    names.push_back(segment.named ? segment.name : std::string());
  return heartAmong(names);
}

std::optional<std::size_t> addWholeHeart(LabelMap& map, const HeartLabels& heart) {
  for (const Segment& segment : map.segments)
    if (lowered(segment.name) == lowered(kWhole))
      return std::nullopt;
  std::vector<std::size_t> parts = heart.muscle;
  for (const HeartLabels::Cavity& cavity : heart.cavities)
    parts.push_back(cavity.segment);
  const std::size_t index = map.segments.size();
  Segment whole = map.segments[parts.front()]; // Its colour is the muscle's.
  whole.name = kWhole;
  whole.label = 0;
  whole.voxels = 0;
  whole.layer = static_cast<int>(map.layers.size());
  LabelLayer layer(map.voxelCount());
  for (const std::size_t part : parts) {
    const Segment& segment = map.segments[part];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      whole.low[axis] = std::min(whole.low[axis], segment.low[axis]);
      whole.high[axis] = std::max(whole.high[axis], segment.high[axis]);
    }
    const LabelLayer& from = map.layers[static_cast<std::size_t>(segment.layer)];
    for (int k = segment.low[2]; k <= segment.high[2]; ++k)
      for (int j = segment.low[1]; j <= segment.high[1]; ++j) {
        const std::size_t first = map.indexOf(segment.low[0], j, k),
                          last = map.indexOf(segment.high[0], j, k);
        for (std::size_t voxel = first; voxel <= last; ++voxel)
          if (from[voxel] == part + 1 && layer[voxel] == 0) {
            layer.set(voxel, static_cast<std::uint16_t>(index + 1));
            ++whole.voxels;
          }
      }
  }
  for (const Segment& segment : map.segments)
    whole.label = std::max(whole.label, segment.label + 1); // One that no voxel of the file has.
  map.layers.push_back(std::move(layer));
  map.segments.push_back(std::move(whole));
  return index;
}

} // namespace viscera::medical_io
