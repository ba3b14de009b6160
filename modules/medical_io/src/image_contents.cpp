#include <cmath>
#include <type_traits>
#include <unordered_set>

#include "dicom/dicom_mark.h"
#include "file_bytes.h"
#include "viscera/medical_io/image_file.h"

namespace viscera::medical_io {
namespace {

/// So few different values are labels even when no two neighbours are the same.
constexpr std::size_t kFewValues = 8;
constexpr double kMostlyEqual = 0.4; ///< Of pairs of neighbours of which one is not 0.

template <class Sample>
bool areLabels(const std::vector<Sample>& samples, double slope, double intercept) {
  constexpr double kLargest = 9e15;
  std::unordered_set<Sample> values;
  std::size_t pairs = 0, equal = 0;
  Sample last = 0;
  bool started = false;
  for (const Sample sample : samples) {
    const bool same = started && sample == last;
    if (!same) {
      const double value = slope * double(sample) + intercept;
      if (!(value >= 0 && value < kLargest) || value != std::floor(value))
        return false;
      values.insert(sample);
      if (values.size() > std::size_t(kMostLabels))
        return false;
    }
    if (started && (sample != 0 || last != 0)) {
      ++pairs;
      equal += same ? 1U : 0U;
    }
    last = sample;
    started = true;
  }
  return values.size() <= kFewValues + 1 || double(equal) >= kMostlyEqual * double(pairs);
}

} // namespace

bool looksLikeLabels(const Scan& scan) {
  return scan.modality.empty() &&
         std::visit([&](const auto& samples) { return areLabels(samples, scan.slope, scan.intercept); },
                    scan.samples);
}

ImageContents imageContents(const std::filesystem::path& fileOrFolder, Progress& progress) {
  std::error_code error;
  if (std::filesystem::is_directory(fileOrFolder, error))
    return hasDicomImages(fileOrFolder) ? ImageContents::values : ImageContents::labels;
  switch (dicomKind(fileOrFolder)) {
  case DicomKind::segmentation:
    return ImageContents::labels;
  case DicomKind::image:
  case DicomKind::other:
    return ImageContents::values;
  case DicomKind::none:
    break;
  }
  if (extensionOf(fileOrFolder).starts_with(".seg."))
    return ImageContents::labels;
  const Scan scan = readScan(fileOrFolder, {}, progress);
  return looksLikeLabels(scan) ? ImageContents::labels : ImageContents::values;
}

} // namespace viscera::medical_io
