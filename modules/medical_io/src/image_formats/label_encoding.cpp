#include "image_formats/label_encoding.h"

#include <algorithm>
#include <map>
#include <string>

#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

constexpr std::size_t kEncodedBlock = std::size_t{1} << 20U; ///< Values between two looks at the progress.
constexpr const char* kTryLabels = "open the segmentation that was made from it";

[[noreturn]] void failAsTooMany(const FileBytes& file) {
  file.fail(phrase("It holds an image, not labels: it has more than %1 different values", kMostLabels),
            kTryLabels);
}

[[noreturn]] void failAsNoLabel(double value, const FileBytes& file) {
  file.fail(phrase("It holds an image, not labels: one of its values is %1", std::to_string(value)),
            kTryLabels);
}

} // namespace

LabelEncoder::LabelEncoder(const RawImage& image)
    : rounding_(image),
      voxels_(static_cast<std::size_t>(image.valueCount()) / static_cast<std::size_t>(image.layers)),
      layersFirst_(image.layersFirst && image.layers > 1), layers_(static_cast<std::size_t>(image.layers)),
      labels_(layers_.size()) {}

void LabelEncoder::reserve() {
  for (NumberedLayer& layer : layers_)
    layer.voxels.reserve(voxels_);
}

bool LabelEncoder::accept(std::size_t layer, double stored) {
  const auto near = rounding_.nearest(stored);
  if (!near) {
    wrong_ = wrong_.value_or(rounding_.valueOf(stored));
    return false;
  }
  labels_[layer].insert(near->label);
  return labels_[layer].size() <= kMostLabels + 1U;
}

void LabelEncoder::takeLayer(std::size_t layer, const char* bytes, std::size_t count, Scalar scalar,
                             std::endian order) {
  NumberedLayer& own = layers_[layer];
  const auto append = [&own](std::size_t number, std::size_t length) { own.voxels.append(number, length); };
  const auto mayTake = [&](double stored) { return accept(layer, stored); };
  tooMany_ = tooMany_ || own.values.take(bytes, count, scalar, order, mayTake, append) < count;
}

void LabelEncoder::take(const char* bytes, std::size_t count, Scalar scalar, std::endian order) {
  const std::size_t width = sizeOf(scalar), layers = layers_.size();
  if (layersFirst_) {
    std::vector<char> own((count / layers + 1) * width);
    for (std::size_t layer = 0; layer < layers; ++layer) {
      std::size_t found = 0;
      for (std::size_t v = (layer + layers - seen_ % layers) % layers; v < count; v += layers)
        std::copy_n(bytes + v * width, width, own.data() + width * found++);
      takeLayer(layer, own.data(), found, scalar, order);
    }
  } else {
    for (std::size_t begin = 0; begin < count;) {
      const std::size_t at = seen_ + begin, part = std::min(count - begin, voxels_ - at % voxels_);
      takeLayer(at / voxels_, bytes + begin * width, part, scalar, order);
      begin += part;
    }
  }
  seen_ += count;
}

EncodedLabels LabelEncoder::finish(const RawImage& image, const FileBytes& file) {
  if (wrong_)
    failAsNoLabel(*wrong_, file);
  EncodedLabels result = encodedLabels(std::move(layers_), image, file);
  if (tooMany_)
    failAsTooMany(file);
  return result;
}

EncodedLabels encodedLabels(std::vector<NumberedLayer> layers, const RawImage& image, const FileBytes& file) {
  std::map<LayerLabel, std::uint16_t>
      numbers; // In the order of layers and labels, whichever voxel came first.
  std::vector<std::vector<std::int64_t>> labels(layers.size());
  const LabelRounding rounding(image);
  double farthest = 0, farValue = 0;
  for (std::size_t layer = 0; layer < layers.size(); ++layer)
    for (const double stored : layers[layer].values.values()) {
      const auto near = rounding.nearest(stored);
      if (!near)
        failAsNoLabel(rounding.valueOf(stored), file);
      if (near->distance > farthest)
        farValue = rounding.valueOf(stored);
      farthest = std::max(farthest, near->distance);
      labels[layer].push_back(near->label);
      if (labels[layer].back() != 0)
        numbers.try_emplace({static_cast<int>(layer), labels[layer].back()});
      if (numbers.size() > kMostLabels)
        failAsTooMany(file);
    }
  if (numbers.empty() && farthest > 0) // Small measurements.
    failAsNoLabel(farValue, file);
  EncodedLabels result;
  result.farthest = farthest;
  for (auto& [label, number] : numbers) {
    result.labels.push_back(label);
    number = static_cast<std::uint16_t>(result.labels.size());
  }
  for (std::size_t layer = 0; layer < layers.size(); ++layer) {
    std::vector<std::uint16_t> table;
    for (const std::int64_t label : labels[layer])
      table.push_back(label == 0 ? std::uint16_t{0} : numbers.at({static_cast<int>(layer), label}));
    result.layers.push_back(layers[layer].voxels.mapped(table));
  }
  return result;
}

EncodedLabels encodeLabels(const RawImage& raw, const FileBytes& file, Progress& progress) {
  LabelEncoder encoder(raw);
  encoder.reserve();
  const std::size_t width = sizeOf(raw.scalar), count = static_cast<std::size_t>(raw.valueCount());
  for (std::size_t begin = 0; begin < count; begin += kEncodedBlock) {
    progress.report(static_cast<double>(begin) / static_cast<double>(count), "labels");
    progress.throwIfCancelled();
    encoder.take(raw.values().data() + begin * width, std::min(kEncodedBlock, count - begin), raw.scalar,
                 raw.order);
  }
  return encoder.finish(raw, file);
}

} // namespace viscera::medical_io
