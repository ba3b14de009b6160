#include "image_formats/label_encoding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

constexpr std::size_t kEncodedBlock = std::size_t{1} << 20U; ///< Values between two looks at the progress.

/// Numbers the labels of one layer after another in the order in which they come.
class Encoder {
public:
  Encoder(const RawImage& raw, const FileBytes& file) : raw_(raw), file_(file), width_(sizeOf(raw.scalar)) {}

  /// The layers with numbers from 1, which `labels()` explains.
  std::vector<LabelMap::Layer> run(Progress& progress) {
    const std::size_t voxels =
        static_cast<std::size_t>(raw_.valueCount()) / static_cast<std::size_t>(raw_.layers);
    std::vector<LabelMap::Layer> layers;
    for (layer_ = 0; layer_ < raw_.layers; ++layer_) {
      LabelMap::Layer& layer = layers.emplace_back(voxels);
      const std::size_t number = static_cast<std::size_t>(layer_),
                        count = static_cast<std::size_t>(raw_.layers);
      const std::size_t step = width_ * (raw_.layersFirst ? count : 1);
      const char* data = raw_.values().data() + width_ * (raw_.layersFirst ? number : number * voxels);
      for (std::size_t begin = 0; begin < voxels; begin += kEncodedBlock) {
        progress.report(static_cast<double>(number * voxels + begin) / static_cast<double>(count * voxels),
                        "labels");
        progress.throwIfCancelled();
        for (std::size_t v = begin; v < std::min(voxels, begin + kEncodedBlock); ++v)
          layer[v] = numberOf(data + v * step);
      }
      lastNumber_.reset();
    }
    return layers;
  }

  /// Layer and label of every number but 0.
  const std::vector<LayerLabel>& labels() const { return labels_; }

private:
  /// Neighbours mostly have the same label, so the last one is remembered by its bytes.
  std::uint16_t numberOf(const char* data) {
    if (lastNumber_ && std::equal(data, data + width_, last_.begin()))
      return *lastNumber_;
    std::copy(data, data + width_, last_.begin());
    lastNumber_ = look(raw_.slope * loadDouble(data, raw_.scalar, raw_.order) + raw_.intercept);
    return *lastNumber_;
  }

  std::uint16_t look(double value) {
    constexpr double kLargest = 9007199254740992.0; // All whole numbers up to it are doubles.
    const std::string tryThis = "open the segmentation that was made from the image";
    if (!(value >= 0 && value <= kLargest) || value != std::floor(value))
      file_.fail(phrase("It holds an image, not labels: one of its values is %1", std::to_string(value)),
                 tryThis);
    if (value == 0)
      return 0;
    const auto [found, isNew] =
        numbers_.try_emplace({layer_, static_cast<std::int64_t>(value)}, labels_.size() + 1);
    if (isNew)
      labels_.emplace_back(found->first);
    if (labels_.size() > kMostLabels)
      file_.fail(phrase("It holds an image, not labels: it has more than %1 different values", kMostLabels),
                 tryThis);
    return static_cast<std::uint16_t>(found->second);
  }

  const RawImage& raw_;
  const FileBytes& file_;
  std::size_t width_;
  int layer_ = 0;
  std::map<LayerLabel, std::size_t> numbers_;
  std::vector<LayerLabel> labels_;
  std::array<char, sizeof(double)> last_ = {};
  std::optional<std::uint16_t> lastNumber_;
};

/// Numbers in the order of layers and labels, whichever voxel came first.
void sortLabels(std::vector<LabelMap::Layer>& layers, std::vector<LayerLabel>& labels) {
  const std::vector<LayerLabel> before = labels;
  std::sort(labels.begin(), labels.end());
  if (labels == before)
    return;
  std::vector<std::uint16_t> numbers(labels.size() + 1, 0);
  for (std::size_t i = 0; i < before.size(); ++i)
    numbers[i + 1] = static_cast<std::uint16_t>(std::lower_bound(labels.begin(), labels.end(), before[i]) -
                                                labels.begin() + 1);
  for (LabelMap::Layer& layer : layers)
    for (std::uint16_t& voxel : layer)
      voxel = numbers[voxel];
}

} // namespace

EncodedLabels encodeLabels(const RawImage& raw, const FileBytes& file, Progress& progress) {
  Encoder encoder(raw, file);
  EncodedLabels result;
  result.layers = encoder.run(progress);
  result.labels = encoder.labels();
  sortLabels(result.layers, result.labels);
  return result;
}

} // namespace viscera::medical_io
