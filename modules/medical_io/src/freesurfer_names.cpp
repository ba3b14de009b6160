#include "freesurfer_names.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

struct KnownLabel {
  std::int64_t label;
  std::string_view name;
  std::array<int, 3> color; ///< 0 to 255.
};

/// FreeSurferColorLUT.txt: what a segmentation of the whole brain has.
constexpr std::array<KnownLabel, 43> kFreeSurferLabels = {{
    {2, "Left-Cerebral-White-Matter", {245, 245, 245}},
    {3, "Left-Cerebral-Cortex", {205, 62, 78}},
    {4, "Left-Lateral-Ventricle", {120, 18, 134}},
    {5, "Left-Inf-Lat-Vent", {196, 58, 250}},
    {7, "Left-Cerebellum-White-Matter", {220, 248, 164}},
    {8, "Left-Cerebellum-Cortex", {230, 148, 34}},
    {10, "Left-Thalamus", {0, 118, 14}},
    {11, "Left-Caudate", {122, 186, 220}},
    {12, "Left-Putamen", {236, 13, 176}},
    {13, "Left-Pallidum", {12, 48, 255}},
    {14, "3rd-Ventricle", {204, 182, 142}},
    {15, "4th-Ventricle", {42, 204, 164}},
    {16, "Brain-Stem", {119, 159, 176}},
    {17, "Left-Hippocampus", {220, 216, 20}},
    {18, "Left-Amygdala", {103, 255, 255}},
    {24, "CSF", {60, 60, 60}},
    {26, "Left-Accumbens-area", {255, 165, 0}},
    {28, "Left-VentralDC", {165, 42, 42}},
    {30, "Left-vessel", {160, 32, 240}},
    {31, "Left-choroid-plexus", {0, 200, 200}},
    {41, "Right-Cerebral-White-Matter", {245, 245, 245}},
    {42, "Right-Cerebral-Cortex", {205, 62, 78}},
    {43, "Right-Lateral-Ventricle", {120, 18, 134}},
    {44, "Right-Inf-Lat-Vent", {196, 58, 250}},
    {46, "Right-Cerebellum-White-Matter", {220, 248, 164}},
    {47, "Right-Cerebellum-Cortex", {230, 148, 34}},
    {49, "Right-Thalamus", {0, 118, 14}},
    {50, "Right-Caudate", {122, 186, 220}},
    {51, "Right-Putamen", {236, 13, 176}},
    {52, "Right-Pallidum", {13, 48, 255}},
    {53, "Right-Hippocampus", {220, 216, 20}},
    {54, "Right-Amygdala", {103, 255, 255}},
    {58, "Right-Accumbens-area", {255, 165, 0}},
    {60, "Right-VentralDC", {165, 42, 42}},
    {62, "Right-vessel", {160, 32, 240}},
    {63, "Right-choroid-plexus", {0, 200, 221}},
    {77, "WM-hypointensities", {200, 70, 255}},
    {85, "Optic-Chiasm", {234, 169, 30}},
    {251, "CC_Posterior", {0, 0, 64}},
    {252, "CC_Mid_Posterior", {0, 0, 112}},
    {253, "CC_Central", {0, 0, 160}},
    {254, "CC_Mid_Anterior", {0, 0, 208}},
    {255, "CC_Anterior", {0, 0, 255}},
}};

/// Left and right of the structures that the segmentations of all versions have.
constexpr std::array<std::array<std::int64_t, 2>, 7> kBothSides = {
    {{4, 43}, {10, 49}, {11, 50}, {12, 51}, {13, 52}, {17, 53}, {18, 54}}};
constexpr std::ptrdiff_t kEnoughPairs = 3;

bool isWholeBrain(const LabelMap& map) {
  const auto has = [&](std::int64_t label) {
    return std::any_of(map.segments.begin(), map.segments.end(),
                       [&](const Segment& segment) { return segment.label == label; });
  };
  return std::count_if(kBothSides.begin(), kBothSides.end(),
                       [&](const auto& pair) { return has(pair[0]) && has(pair[1]); }) >= kEnoughPairs;
}

} // namespace

void nameAsFreeSurfer(LabelMap& map) {
  const bool named =
      std::any_of(map.segments.begin(), map.segments.end(), [](const Segment& s) { return s.named; });
  if (named || !isWholeBrain(map))
    return;
  for (Segment& segment : map.segments) {
    const auto found = std::find_if(kFreeSurferLabels.begin(), kFreeSurferLabels.end(),
                                    [&](const KnownLabel& known) { return known.label == segment.label; });
    if (found == kFreeSurferLabels.end())
      continue;
    segment.name = found->name;
    segment.named = true;
    segment.color = Vec3(found->color[0], found->color[1], found->color[2]) / 255;
    segment.colored = true;
  }
  map.warnings.push_back("the names of its labels are those of FreeSurfer's colour table");
}

} // namespace viscera::medical_io
