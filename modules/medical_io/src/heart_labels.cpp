#include "viscera/medical_io/heart_labels.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "file_bytes.h"

namespace viscera::medical_io {
namespace {

constexpr const char* kWhole = "Heart";

/// A chamber and the words that its label has.
struct Chamber {
  const char* name;
  std::string_view kind, side;
};
constexpr std::array<Chamber, 4> kChambers = {{{"LV", "ventricle", "left"},
                                               {"RV", "ventricle", "right"},
                                               {"LA", "atrium", "left"},
                                               {"RA", "atrium", "right"}}};

bool has(const std::string& text, std::string_view word) {
  return text.find(word) != std::string::npos;
}

/// Whether the label is of the heart's muscle, which may be named after the chamber that it is around; not of
/// muscles anywhere else.
bool isMuscle(const std::string& name) {
  return has(name, "myocard") ||
         (has(name, "muscle") && (has(name, "heart") || has(name, "cardiac") || has(name, "ventric")));
}

} // namespace

std::optional<HeartLabels> heartAmong(const std::vector<std::string>& names) {
  HeartLabels heart;
  bool ventricle = false;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (isMuscle(lowered(names[i])))
      heart.muscle.push_back(i);
  for (const Chamber& chamber : kChambers) {
    bool found = false;
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string name = lowered(names[i]);
      if (isMuscle(name) || !has(name, chamber.kind) || !has(name, chamber.side))
        continue;
      if (found)
        return std::nullopt;
      found = true;
      heart.cavities.push_back({chamber.name, i});
    }
    ventricle = ventricle || (found && chamber.kind == "ventricle");
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
  LabelMap::Layer layer(map.voxelCount(), 0);
  for (const std::size_t part : parts) {
    const Segment& segment = map.segments[part];
    const LabelMap::Layer& from = map.layers[static_cast<std::size_t>(segment.layer)];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      whole.low[axis] = std::min(whole.low[axis], segment.low[axis]);
      whole.high[axis] = std::max(whole.high[axis], segment.high[axis]);
    }
    for (std::size_t voxel = 0; voxel < layer.size(); ++voxel)
      if (from[voxel] == part + 1 && layer[voxel] == 0) {
        layer[voxel] = static_cast<std::uint16_t>(index + 1);
        ++whole.voxels;
      }
  }
  for (const Segment& segment : map.segments)
    whole.label = std::max(whole.label, segment.label + 1); // One that no voxel of the file has.
  map.layers.push_back(std::move(layer));
  map.segments.push_back(std::move(whole));
  return index;
}

} // namespace viscera::medical_io
