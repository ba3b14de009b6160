#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "image_formats/label_rounding.h"
#include "image_formats/numbered_values.h"
#include "image_formats/raw_image.h"

/// Converts the values of an image to consecutive numbers of labels.
namespace viscera::medical_io {

/// A layer and a value in it.
using LayerLabel = std::pair<int, std::int64_t>;

/// Voxels as numbers of their labels.
struct EncodedLabels {
  std::vector<LabelLayer> layers;
  std::vector<LayerLabel> labels; ///< Ascending; that of number n is `labels[n - 1]`.
  double farthest = 0;            ///< The largest distance of a value from its label.
};

/// One layer of an image as numbers of its values.
struct NumberedLayer {
  ValueNumbering values;
  VoxelNumbers voxels;
};

/// Numbers the values of all layers block by block, so that nothing else of them stays in memory.
class LabelEncoder {
public:
  /// `image` says how the layers lie; its values are not used.
  explicit LabelEncoder(const RawImage& image);

  /// Takes memory for all layers.
  void reserve();
  /// Takes the next values, in the order in which the file has them.
  void take(const char* bytes, std::size_t count, Scalar scalar, std::endian order);
  /// The labels of all values that were taken. Throws `DataError` naming `file` for values that are no labels
  /// and for too many different ones.
  EncodedLabels finish(const RawImage& image, const FileBytes& file);

private:
  bool accept(std::size_t layer, double stored);
  void takeLayer(std::size_t layer, const char* bytes, std::size_t count, Scalar scalar, std::endian order);

  LabelRounding rounding_;
  std::size_t voxels_ = 0; ///< Of one layer.
  bool layersFirst_ = false;
  std::size_t seen_ = 0; ///< Values of all layers.
  bool tooMany_ = false; ///< Different values: no more are taken.
  std::vector<NumberedLayer> layers_;
  std::vector<std::set<std::int64_t>> labels_; ///< Of each layer.
  std::optional<double> wrong_;                ///< The first value that is no label; no more are taken.
};

/// The labels of layers whose values are numbered. Throws as `LabelEncoder::finish`.
EncodedLabels encodedLabels(std::vector<NumberedLayer> layers, const RawImage& image, const FileBytes& file);

/// Numbers the values of an image that is in memory. Throws as `LabelEncoder::finish`, and `Cancelled`.
EncodedLabels encodeLabels(const RawImage& raw, const FileBytes& file, Progress& progress);

} // namespace viscera::medical_io
