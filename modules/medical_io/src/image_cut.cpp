#include "viscera/medical_io/image_cut.h"

#include <array>
#include <cstdint>

#include "viscera/anatomy/part.h"

namespace viscera::medical_io {
namespace {

/// An organ that ends there has half the voxels or less in its last slices, as the cap of a ball has; an
/// organ that goes on has nearly the same number.
constexpr double kGoesOn = 0.6;

/// The voxels of a segment in one slice across an axis.
std::int64_t voxelsIn(const LabelMap& map, std::size_t index, std::size_t axis, int slice) {
  const Segment& segment = map.segments[index];
  const LabelLayer& layer = map.layers[static_cast<std::size_t>(segment.layer)];
  std::array<int, 3> low = segment.low, high = segment.high;
  low[axis] = high[axis] = slice;
  std::int64_t count = 0;
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i)
        count += layer[map.indexOf(i, j, k)] == index + 1 ? 1 : 0;
  return count;
}

/// What the patient has at that end of an axis of the image.
std::string edgeName(const LabelMap& map, std::size_t axis, bool atEnd) {
  static constexpr std::array<std::array<const char*, 2>, 3> kNames = {
      {{"right", "left"}, {"front", "back"}, {"lower", "upper"}}};
  const Vec3 along = map.indexToLps.linear().col(static_cast<Eigen::Index>(axis));
  Eigen::Index nearest = 0;
  along.cwiseAbs().maxCoeff(&nearest);
  const bool ahead = (along[nearest] > 0) == atEnd;
  return kNames[static_cast<std::size_t>(nearest)][ahead ? 1 : 0];
}

} // namespace

Text ImageCut::text() const {
  std::vector<Text> names;
  for (const std::string& edge : edges)
    names.push_back(named(edge));
  const Text list = listOf(std::move(names));
  return sure ? phrase("is cut by {the %2 edge|%n edges (%2)} of the image: its volume is too small",
                       edges.size(), list)
              : phrase("reaches {the %2 edge|%n edges (%2)} of the image, which may cut it off", edges.size(),
                       list);
}

std::optional<ImageCut> imageCut(const LabelMap& map, std::size_t index) {
  const Segment& segment = map.segments.at(index);
  const auto part = anatomy::partNamed(segment.name);
  if (part && anatomy::isSeldomWhole(*part))
    return std::nullopt;
  ImageCut sure, touched;
  sure.sure = true;
  bool through = false; // From one edge to the opposite one.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (map.size[axis] < 2)
      continue;
    through = through || (segment.low[axis] == 0 && segment.high[axis] == map.size[axis] - 1);
    for (const bool atEnd : {false, true}) {
      const int edge = atEnd ? map.size[axis] - 1 : 0;
      if ((atEnd ? segment.high : segment.low)[axis] != edge)
        continue;
      const std::int64_t last = voxelsIn(map, index, axis, edge);
      const std::int64_t before = voxelsIn(map, index, axis, edge + (atEnd ? -1 : 1));
      touched.edges.push_back(edgeName(map, axis, atEnd));
      if (static_cast<double>(last) >= kGoesOn * static_cast<double>(before))
        sure.edges.push_back(touched.edges.back());
    }
  }
  if (touched.edges.empty() || (!part && through))
    return std::nullopt;
  return sure.edges.empty() ? touched : sure;
}

} // namespace viscera::medical_io
