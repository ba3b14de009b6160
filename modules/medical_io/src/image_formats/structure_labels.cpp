#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "dicom/structure_grid.h"
#include "dicom/structure_set.h"
#include "image_formats/raw_image.h"
#include "label_segments.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

/// The regions' own numbers as labels where these are different ones that a voxel can hold, else 1, 2, ...
std::vector<std::uint16_t> labelsOf(const StructureSet& set) {
  std::set<int> numbers;
  for (const DrawnRegion& region : set.regions)
    if (region.number >= 1 && region.number <= UINT16_MAX)
      numbers.insert(region.number);
  const bool own = numbers.size() == set.regions.size();
  std::vector<std::uint16_t> labels;
  for (const DrawnRegion& region : set.regions)
    labels.push_back(static_cast<std::uint16_t>(own ? std::size_t(region.number) : labels.size() + 1));
  return labels;
}

LabelLayer maskOf(const FilledRegion& filled, std::size_t voxels, std::size_t slice) {
  LabelLayer mask(voxels);
  const std::size_t from = std::size_t(filled.first) * slice;
  for (std::size_t v = 0; v < filled.voxels.size(); ++v)
    if (filled.voxels[v] != 0)
      mask.set(from + v, 1);
  return mask;
}

/// What was left out, and what stands between contours.
std::vector<Text> remarksOn(const StructureSet& set, const StructureGrid& grid) {
  std::vector<Text> remarks;
  if (set.notClosed > 0)
    remarks.push_back(
        phrase("%n {point or open contour was|points and open contours were} left out", set.notClosed));
  if (set.damaged > 0)
    remarks.push_back(
        phrase("%n {contour was|contours were} left out, whose numbers cannot be read", set.damaged));
  if (grid.aslant > 0)
    remarks.push_back(phrase("%n {contour was left out, which lies|contours were left out, which lie} in "
                             "another direction than most",
                             grid.aslant));
  if (set.elsewhere > 0)
    remarks.push_back(phrase("%n {region was left out, which is|regions were left out, which are} in another "
                             "coordinate system (frame of reference)",
                             set.elsewhere));
  if (grid.single)
    remarks.push_back(phrase("all contours lie in one plane, whose thickness is not stated; %1 mm were taken",
                             inDigits(grid.indexToLps.linear().col(2).norm(), 3)));
  return remarks;
}

void remarkOn(const FilledRegion& filled, const std::string& name, std::vector<Text>& remarks) {
  if (filled.interpolated > 0)
    remarks.push_back(
        phrase("%n {slice|slices} of %2 without a contour got the shape between their neighbours",
               filled.interpolated, name));
  if (filled.gap > 0)
    remarks.push_back(
        phrase("%1 has no contour over %2 mm; that gap stays open", name, inFixed(filled.gap, 1)));
}

} // namespace

RawImage readStructureLabels(const FileBytes& file) {
  const StructureSet set = readStructureSet(file);
  const StructureGrid grid = structureGrid(set, file);
  RawImage raw;
  raw.size = grid.size;
  raw.indexToLps = grid.indexToLps;
  raw.space = "LPS";
  raw.warnings = remarksOn(set, grid);
  const std::vector<std::uint16_t> labels = labelsOf(set);
  const std::size_t slice = std::size_t(grid.size[0]) * std::size_t(grid.size[1]);
  std::vector<LabelLayer> layers;
  for (std::size_t r = 0; r < set.regions.size(); ++r) {
    StatedSegment segment{labels[r], 0, set.regions[r].name, set.regions[r].color};
    if (const FilledRegion filled = fillRegion(grid, r); filled.slices > 0) {
      const LabelLayer mask = maskOf(filled, slice * std::size_t(grid.size[2]), slice);
      segment.layer = addToFreeLayer(layers, mask, labels[r]);
      remarkOn(filled, segment.name, raw.warnings);
    }
    raw.stated.push_back(std::move(segment));
  }
  storeLayers(layers, raw);
  return raw;
}

} // namespace viscera::medical_io
