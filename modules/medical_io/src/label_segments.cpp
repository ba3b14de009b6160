#include "label_segments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

#include "file_bytes.h"
#include "image_formats/numbered_values.h"
#include "text_scanner.h"
#include "viscera/anatomy/part.h"
#include "viscera/core/error.h"
#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/text.h"
#include "viscera/medical_io/organ_names.h"

namespace viscera::medical_io {
namespace {

/// Turning by the golden angle keeps the hues of any number of labels apart.
constexpr double kGoldenTurn = 0.61803398874989485;
constexpr double kSaturation = 0.45, kBrightness = 0.85;

Vec3 colorOfHue(double turn) {
  Vec3 color;
  for (int i = 0; i < 3; ++i) {
    const double away = std::abs(std::fmod(6 * turn + 2.0 * i, 6.0) - 3) - 1;
    color[i] = kBrightness * (1 - kSaturation * (1 - std::clamp(away, 0.0, 1.0)));
  }
  return color;
}

/// The colour, 0 to 1, of the organ of that name; for any other name one that depends on the label alone and
/// differs well from its neighbours'.
Vec3 colorOfLabel(std::string_view name, std::int64_t label) {
  const double turns = static_cast<double>(label) * kGoldenTurn;
  return anatomy::colorNamed(name).value_or(colorOfHue(turns - std::floor(turns)));
}

constexpr std::size_t kNamesTold = 12;
constexpr Eigen::Index kSlicesAtOnce = 8;

std::string someNames(const LabelMap& map) {
  std::string list;
  for (std::size_t s = 0; s < std::min(map.segments.size(), kNamesTold); ++s)
    list += (s == 0 ? "" : ", ") + map.segments[s].name;
  return map.segments.size() > kNamesTold
             ? list + " and " + std::to_string(map.segments.size() - kNamesTold) + " more"
             : list;
}

/// The voxels of a segment: how many, the first and the last of them along each axis.
struct Extent {
  std::int64_t voxels = 0;
  std::array<int, 3> low = {}, high = {};

  void add(std::int64_t count, const std::array<int, 3>& first, const std::array<int, 3>& last) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = voxels == 0 ? first[axis] : std::min(low[axis], first[axis]);
      high[axis] = voxels == 0 ? last[axis] : std::max(high[axis], last[axis]);
    }
    voxels += count;
  }
};

/// Adds the runs of the row (j, k), `length` voxels at `row`, to the segments' extents.
template <class Voxel>
void measureRow(std::vector<Extent>& extents, const Voxel* row, int length, int j, int k) {
  const char* bytes = reinterpret_cast<const char*>(row);
  for (std::size_t begin = 0; begin < std::size_t(length);) {
    const std::size_t end = endOfRun<Voxel>(bytes, begin, std::size_t(length));
    if (row[begin] != 0)
      extents[row[begin] - 1U].add(static_cast<std::int64_t>(end - begin), {int(begin), j, k},
                                   {int(end) - 1, j, k});
    begin = end;
  }
}

/// The voxels from the mask's first to its last, most often a small part of all.
struct Span {
  std::size_t begin = 0;
  std::size_t end = 0;
};

Span spanOf(const LabelLayer& mask) {
  return mask.visit([](const auto& voxels) {
    const auto inside = [](auto voxel) { return voxel != 0; };
    const auto first = std::find_if(voxels.begin(), voxels.end(), inside);
    const auto last = std::find_if(voxels.rbegin(), std::make_reverse_iterator(first), inside).base();
    return Span{static_cast<std::size_t>(first - voxels.begin()),
                static_cast<std::size_t>(last - voxels.begin())};
  });
}

bool isFree(const LabelLayer& layer, const LabelLayer& mask, const Span& span) {
  for (std::size_t v = span.begin; v < span.end; ++v)
    if (mask[v] != 0 && layer[v] != 0)
      return false;
  return true;
}

} // namespace

void nameSegments(LabelMap& map, const std::vector<StatedSegment>& stated) {
  std::map<std::pair<int, std::int64_t>, const StatedSegment*> known;
  std::map<const StatedSegment*, std::vector<Text>> sharing; // By the first: all names of its voxels.
  for (const StatedSegment& one : stated) {
    const StatedSegment* first = known.try_emplace({one.layer, one.label}, &one).first->second;
    sharing[first].push_back(named(printableName(one.name)));
  }
  for (Segment& segment : map.segments) {
    const auto found = known.find({segment.layer, segment.label});
    if (found == known.end())
      continue;
    segment.name = printableName(found->second->name);
    segment.named = !segment.name.empty();
    segment.colored = found->second->color.has_value();
    segment.color = found->second->color.value_or(segment.color);
    if (const std::vector<Text>& names = sharing[found->second]; names.size() > 1)
      map.warnings.push_back(
          phrase("its segments %1 have the same voxels (label %2 in one layer); they are one "
                 "organ, %3",
                 listOf(names), segment.label, names.front()));
  }
}

void completeSegments(LabelMap& map) {
  std::set<std::string> taken;
  for (Segment& segment : map.segments) {
    if (segment.name.empty())
      segment.name = "label " + std::to_string(segment.label);
    if (!segment.colored)
      segment.color = colorOfLabel(segment.name, segment.label);
    const std::string base = segment.name;
    for (int number = 2; !taken.insert(segment.name).second; ++number)
      segment.name = base + " " + std::to_string(number);
  }
}

void measureSegments(LabelMap& map, Progress& progress) {
  std::vector<Extent> all(map.segments.size());
  for (std::size_t s = 0; s < all.size(); ++s)
    all[s] = {map.segments[s].voxels, map.segments[s].low, map.segments[s].high};
  std::mutex mutex;
  for (const LabelLayer& layer : map.layers)
    parallelRanges(map.size[2], kSlicesAtOnce, {}, [&](Eigen::Index begin, Eigen::Index end) {
      progress.throwIfCancelled();
      std::vector<Extent> own(all.size());
      layer.visit([&](const auto& voxels) {
        for (int k = static_cast<int>(begin); k < static_cast<int>(end); ++k)
          for (int j = 0; j < map.size[1]; ++j)
            measureRow(own, voxels.data() + map.indexOf(0, j, k), map.size[0], j, k);
      });
      const std::lock_guard lock(mutex);
      for (std::size_t s = 0; s < all.size(); ++s)
        if (own[s].voxels > 0)
          all[s].add(own[s].voxels, own[s].low, own[s].high);
    });
  for (std::size_t s = 0; s < all.size(); ++s) {
    map.segments[s].voxels = all[s].voxels;
    map.segments[s].low = all[s].low;
    map.segments[s].high = all[s].high;
  }
}

int addToFreeLayer(std::vector<LabelLayer>& layers, const LabelLayer& mask, std::uint16_t number) {
  const Span span = spanOf(mask);
  std::size_t found = 0;
  while (found < layers.size() && !isFree(layers[found], mask, span))
    ++found;
  if (found == layers.size())
    layers.emplace_back(mask.size());
  for (std::size_t v = span.begin; v < span.end; ++v)
    if (mask[v] != 0)
      layers[found].set(v, number);
  return static_cast<int>(found);
}

std::vector<std::size_t> segmentsNamed(const LabelMap& map, const std::vector<std::string>& names,
                                       const Text& where) {
  std::set<std::size_t> chosen;
  for (const std::string& name : names) {
    const auto number = parseInteger(trimmed(name));
    bool known = false;
    for (std::size_t s = 0; s < map.segments.size(); ++s)
      if (comparableName(map.segments[s].name) == comparableName(name) || number == map.segments[s].label) {
        chosen.insert(s);
        known = true;
      }
    if (!known)
      throw UsageError(misuse("It has no label %1", inQuotes(name)), where,
                       misuse("it has %1", someNames(map)));
  }
  for (std::size_t s = 0; s < map.segments.size() && names.empty(); ++s)
    chosen.insert(s);
  return {chosen.begin(), chosen.end()};
}

} // namespace viscera::medical_io
