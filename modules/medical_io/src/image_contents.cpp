#include <map>
#include <new>
#include <optional>
#include <utility>
#include <vector>

#include "dicom/dicom_mark.h"
#include "image_formats/label_encoding.h"
#include "image_formats/label_rounding.h"
#include "image_formats/sample_collector.h"
#include "opened_image.h"
#include "viscera/medical_io/image_file.h"

namespace viscera::medical_io {
namespace {

/// So few different values are labels even when no two neighbours are the same.
constexpr std::size_t kFewValues = 8;
constexpr double kMostlyEqual = 0.4; ///< Of pairs of neighbours of which one is not 0.

/// Whether values are probably labels: whole up to rounding, none below zero, and few or mostly equal to
/// their neighbours'.
class LabelLook {
public:
  explicit LabelLook(const RawImage& image) : rounding_(image) {}

  /// Looks at a value that is new; false when these are no labels.
  bool accept(double stored) {
    const auto near = rounding_.nearest(stored);
    if (!near)
      return false;
    bent_ = bent_ || near->distance > 0;
    labelled_ = labelled_ || near->label != 0;
    const std::size_t id = ids_.try_emplace(near->label, ids_.size()).first->second;
    samples_.push_back({id, near->label == 0});
    return ids_.size() <= std::size_t(kMostLabels);
  }

  /// `length` times the value with that number, behind what came before.
  void run(std::size_t number, std::size_t length) {
    const Sample& sample = samples_[number];
    if (last_ && !(sample.zero && last_->zero)) {
      ++pairs_;
      equal_ += sample.id == last_->id ? 1 : 0;
    }
    if (!sample.zero) {
      pairs_ += length - 1;
      equal_ += length - 1;
    }
    last_ = sample;
  }

  /// Tells whether the accepted values, taken together, are labels. Fractions that all round to 0 are small
  /// measurements.
  bool areLabels() const {
    if (bent_ && !labelled_)
      return false;
    return ids_.size() <= kFewValues + 1 || double(equal_) >= kMostlyEqual * double(pairs_);
  }

private:
  struct Sample {
    std::size_t id = 0;
    bool zero = false;
  };

  LabelRounding rounding_;
  std::map<std::int64_t, std::size_t> ids_; ///< By label.
  std::vector<Sample> samples_;             ///< By the numbers of values.
  std::optional<Sample> last_;
  std::size_t pairs_ = 0, equal_ = 0;
  bool bent_ = false, labelled_ = false;
};

/// What place, mark or name say without the voxels.
std::optional<ImageContents> statedContents(const std::filesystem::path& fileOrFolder) {
  std::error_code error;
  if (std::filesystem::is_directory(fileOrFolder, error))
    return hasDicomImages(fileOrFolder) ? ImageContents::values : ImageContents::labels;
  switch (dicomKind(fileOrFolder)) {
  case DicomKind::segmentation:
    return ImageContents::labels;
  case DicomKind::image:
  case DicomKind::surface:
  case DicomKind::other:
    return ImageContents::values;
  case DicomKind::none:
    break;
  }
  return extensionOf(fileOrFolder).starts_with(".seg.") ? std::optional(ImageContents::labels) : std::nullopt;
}

/// Reads the voxels once. As long as they may be labels they are kept as numbers of their values, which a
/// label map has as well; from the first value on that is none, all of them are samples.
class UndecidedImage {
public:
  explicit UndecidedImage(OpenedImage& image)
      : image_(image), look_(image.header.image), samples_(image.header.image.scalar) {}

  void read(Progress& progress) {
    visitPhase(
        image_, 0, progress,
        [&](std::size_t count) {
          voxels_ = count;
          layer_.voxels.reserve(count);
        },
        [&](const char* bytes, std::size_t count, Scalar scalar, std::endian order) {
          take(bytes, count, scalar, order);
        });
    if (undecided_ && !look_.areLabels())
      becomeSamples();
  }

  bool areLabels() const { return undecided_; }
  NumberedLayer& layer() { return layer_; }
  SampleCollector& samples() { return samples_; }

private:
  void take(const char* bytes, std::size_t count, Scalar scalar, std::endian order) {
    scalar_ = scalar;
    order_ = order;
    std::size_t taken = 0;
    if (undecided_) {
      taken = layer_.values.take(
          bytes, count, scalar, order, [&](double value) { return look_.accept(value); },
          [&](std::size_t number, std::size_t length) {
            look_.run(number, length);
            layer_.voxels.append(number, length);
          });
      if (taken == count)
        return;
      becomeSamples();
    }
    samples_.take(bytes + taken * sizeOf(scalar), count - taken, scalar, order);
  }

  void becomeSamples() {
    undecided_ = false;
    samples_.reserve(voxels_);
    layer_.voxels.release(layer_.values.stored(), sizeOf(scalar_), [&](const char* bytes, std::size_t count) {
      samples_.take(bytes, count, scalar_, order_);
    });
  }

  OpenedImage& image_;
  LabelLook look_;
  NumberedLayer layer_;
  SampleCollector samples_;
  std::size_t voxels_ = 0; ///< For which memory is taken.
  Scalar scalar_ = Scalar::uint8;
  std::endian order_ = std::endian::native;
  bool undecided_ = true;
};

/// An image that names its segments is a label map.
bool namesLabels(const OpenedImage& image) {
  return !image.header.image.stated.empty();
}

ScanOrLabels readUndecided(const std::filesystem::path& file, std::optional<int> labelPhase,
                           Progress& progress) {
  OpenedImage image = openImage(file);
  if (namesLabels(image))
    return readLabelMap(file, progress, labelPhase);
  try {
    UndecidedImage undecided(image);
    undecided.read(progress);
    if (!undecided.areLabels()) {
      progress.report(1);
      return scanOf(std::move(image), 0, undecided.samples());
    }
    if (image.header.image.layers == 1)
      return labelMapOf(std::move(image), std::move(undecided.layer()), progress);
  } catch (const std::bad_alloc&) {
    image.begin.fail("it does not fit into memory", "crop the image to the organs");
  }
  return readLabelMap(file, progress, labelPhase); // All layers of it.
}

} // namespace

ImageContents imageContents(const std::filesystem::path& fileOrFolder, Progress& progress) {
  if (const auto stated = statedContents(fileOrFolder))
    return *stated;
  OpenedImage image = openImage(fileOrFolder);
  if (namesLabels(image))
    return ImageContents::labels;
  LabelLook look(image.header.image);
  ValueNumbering numbers;
  bool mayBeLabels = true;
  const auto take = [&](const char* bytes, std::size_t count, Scalar scalar, std::endian order) {
    mayBeLabels = mayBeLabels &&
                  numbers.take(
                      bytes, count, scalar, order, [&](double value) { return look.accept(value); },
                      [&](std::size_t number, std::size_t length) { look.run(number, length); }) == count;
  };
  visitPhase(
      image, 0, progress, [](std::size_t) {}, take);
  return mayBeLabels && look.areLabels() ? ImageContents::labels : ImageContents::values;
}

ScanOrLabels readScanOrLabels(const std::filesystem::path& fileOrFolder, const ScanOptions& options,
                              Progress& progress, std::optional<int> labelPhase) {
  auto contents = statedContents(fileOrFolder);
  if (!contents && (options.phase != 0 || !options.series.empty())) // The first phase decides.
    contents = imageContents(fileOrFolder, progress);
  if (!contents)
    return readUndecided(fileOrFolder, labelPhase, progress);
  if (contents == ImageContents::labels)
    return readLabelMap(fileOrFolder, progress, labelPhase);
  return readScan(fileOrFolder, options, progress);
}

} // namespace viscera::medical_io
