#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "image_formats/raw_image.h"

/// Converts the values of an image to consecutive numbers of labels.
namespace viscera::medical_io {

/// A layer and a value in it.
using LayerLabel = std::pair<int, std::int64_t>;

/// Voxels as numbers of their labels.
struct EncodedLabels {
  std::vector<LabelMap::Layer> layers;
  std::vector<LayerLabel> labels; ///< Ascending; that of number n is `labels[n - 1]`.
};

/// Numbers the values of all layers. Throws `DataError` for values that are no labels and for too many
/// different ones, `Cancelled`. O(values).
EncodedLabels encodeLabels(const RawImage& raw, const FileBytes& file, Progress& progress);

} // namespace viscera::medical_io
