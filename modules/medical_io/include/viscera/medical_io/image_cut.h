#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/medical_io/label_map.h"

namespace viscera::medical_io {

/// An organ of a label map that the edge of the image cuts off, so that its volume is too small.
struct ImageCut {
  /// The edges: "right", "left", "front", "back", "lower", "upper", by the patient's axes that the image's
  /// lie nearest to.
  std::vector<std::string> edges;
  /// Whether it ends flat at one of them. Else it touches them with less and less of it, as the end of an
  /// organ in an image that was cropped around it does.
  bool sure = false;

  /// The text has no capital, full stop or subject: "is cut by the lower edge of the image: its volume is too
  /// small".
  Text text() const;
};

/// Looks for the edges of the image that a segment reaches. None for a segment that reaches none; for those
/// of which every image holds a part only, as their names say (`anatomy::isSeldomWhole`: vessels, bones,
/// skin); and for one whose name is not known and that goes from one edge to the opposite one, as a body or a
/// background does. An axis of a single voxel has no edges. O(voxels of the segment's faces).
std::optional<ImageCut> imageCut(const LabelMap& map, std::size_t segment);

} // namespace viscera::medical_io
