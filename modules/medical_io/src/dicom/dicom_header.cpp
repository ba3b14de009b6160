#include "dicom/dicom_header.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "dicom/dicom_kinds.h"
#include "dicom/dicom_load.h"
#include "dicom/dicom_text.h"
#include "dicom/for_all.h"
#include "image_formats/raw_image.h"
#include "text_scanner.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmdata/dcxfer.h>

namespace viscera::medical_io {
namespace {

constexpr int kMostFrames = 100'000;
/// A picture that is all of one value takes few bytes, but not as few as a damaged header may claim.
constexpr std::uint64_t kMostPerByte = 2000, kLeastLimit = std::uint64_t{1} << 25U;
constexpr double kUnitLength = 1e-3; ///< Direction cosines are off by no more.
constexpr double kSecondsPerMinute = 60, kSecondsPerHour = 3600;

std::optional<double> numberAt(DcmItem& item, const DcmTagKey& key) {
  const std::vector<double> list = numbersAt(item, key);
  return list.empty() ? std::nullopt : std::optional(list.front());
}

/// 0 where there is none, or one that no header means.
int wholeAt(DcmItem& item, const DcmTagKey& key) {
  const double number = numberAt(item, key).value_or(0);
  return std::abs(number) <= std::numeric_limits<int>::max() ? static_cast<int>(number) : 0;
}

/// The seconds of a time "hhmmss.ffffff", or of a date with a time behind it.
std::optional<double> secondsOfTime(std::string_view text) {
  const std::size_t whole = std::min(text.find('.'), text.size());
  if (whole == 14)
    text.remove_prefix(8);
  else if (whole != 6)
    return std::nullopt;
  text = text.substr(0, text.find_first_of("+-&"));
  const auto hours = parseNumber(text.substr(0, 2)), minutes = parseNumber(text.substr(2, 2)),
             seconds = parseNumber(text.substr(4));
  if (!hours || !minutes || !seconds)
    return std::nullopt;
  return *hours * kSecondsPerHour + *minutes * kSecondsPerMinute + *seconds;
}

/// Where the values of one frame are: of an enhanced file in the frame's group or in the one that all share,
/// else in the data set itself.
class FrameItems {
public:
  FrameItems(DcmItem& dataset, DcmItem* shared, DcmItem* own) : items_{own, shared}, dataset_(dataset) {}

  /// The item that has `key`, within `sequence` of an enhanced file.
  DcmItem* with(const DcmTagKey& sequence, const DcmTagKey& key) const {
    for (DcmItem* group : items_) {
      DcmItem* item = nullptr;
      if (group != nullptr && group->findAndGetSequenceItem(sequence, item, 0).good() && item != nullptr &&
          item->tagExistsWithValue(key))
        return item;
    }
    return dataset_.tagExistsWithValue(key) ? &dataset_ : nullptr;
  }
  std::optional<double> number(const DcmTagKey& sequence, const DcmTagKey& key) const {
    DcmItem* item = with(sequence, key);
    return item != nullptr ? numberAt(*item, key) : std::nullopt;
  }
  std::vector<double> numbers(const DcmTagKey& sequence, const DcmTagKey& key) const {
    DcmItem* item = with(sequence, key);
    return item != nullptr ? numbersAt(*item, key) : std::vector<double>{};
  }
  std::string text(const DcmTagKey& sequence, const DcmTagKey& key) const {
    DcmItem* item = with(sequence, key);
    return item != nullptr ? codeAt(*item, key) : std::string();
  }

private:
  std::array<DcmItem*, 2> items_;
  DcmItem& dataset_;
};

/// "Doe^Jane^Mary^Dr" as "Doe, Jane Mary Dr": of a name's writings the alphabetic one (PS3.5, 6.2.1).
std::string readableName(std::string name) {
  name.resize(std::min(name.find('='), name.size()));
  std::string readable;
  std::size_t parts = 0;
  std::istringstream stream(name);
  for (std::string part; std::getline(stream, part, '^');) {
    while (!part.empty() && part.back() == ' ')
      part.pop_back();
    if (part.empty())
      continue;
    readable += (parts == 0 ? "" : parts == 1 ? ", " : " ") + part;
    ++parts;
  }
  return readable;
}

/// DCMTK renamed its question in 3.6.9.
bool isPacked(const DcmXfer& syntax) {
#if OFFIS_DCMTK_VERSION_NUMBER >= 369
  return syntax.usesEncapsulatedFormat();
#else
  return syntax.isEncapsulated();
#endif
}

class ElementReader {
public:
  ElementReader(const std::filesystem::path& file, DcmFileFormat& format) : file_{file, {}}, format_(format) {
    header_.file = file;
  }

  DicomHeader run() {
    DcmDataset& dataset = *format_.getDataset();
    readOrigin(dataset);
    if (readPixelFormat(dataset)) {
      readFrames(dataset);
      requirePixels(dataset);
    }
    return std::move(header_);
  }

  DicomHeader runWithoutPixels() {
    try {
      DcmDataset& dataset = *format_.getDataset();
      readOrigin(dataset);
      readFrame(FrameItems(dataset, nullptr, nullptr), 0);
    } catch (const DataError&) {
      header_.frames.clear();
    }
    return std::move(header_);
  }

private:
  /// Reads whose image it is, of which study and series.
  void readOrigin(DcmDataset& dataset) {
    header_.classUid = codeAt(dataset, DCM_SOPClassUID);
    header_.instanceUid = codeAt(dataset, DCM_SOPInstanceUID);
    header_.seriesUid = codeAt(dataset, DCM_SeriesInstanceUID);
    header_.frameOfReference = codeAt(dataset, DCM_FrameOfReferenceUID);
    header_.modality = codeAt(dataset, DCM_Modality);
    header_.description = textAt(dataset, dataset, DCM_SeriesDescription);
    header_.patientName = readableName(textAt(dataset, dataset, DCM_PatientName));
    header_.patientId = textAt(dataset, dataset, DCM_PatientID);
    header_.heightM = numberAt(dataset, DCM_PatientSize);
    header_.weightKg = numberAt(dataset, DCM_PatientWeight);
    header_.studyUid = codeAt(dataset, DCM_StudyInstanceUID);
    header_.studyDate = codeAt(dataset, DCM_StudyDate);
    header_.seriesDate = codeAt(dataset, DCM_SeriesDate);
    header_.seriesNumber = wholeAt(dataset, DCM_SeriesNumber);
    header_.cardiacImages = wholeAt(dataset, DCM_CardiacNumberOfImages);
    header_.rescaleType = codeAt(dataset, DCM_RescaleType);
    isSegmentation_ = isSegmentationClass(header_.classUid);
    header_.temporalResolutionMs = numberAt(dataset, DCM_TemporalResolution);
    const DcmXfer syntax(dataset.getOriginalXfer());
    header_.transferSyntax = syntax.getXferName();
    header_.packed = isPacked(syntax);
  }

  /// False for what is no slice of a scan.
  bool readPixelFormat(DcmItem& dataset) {
    if (!dataset.tagExists(DCM_PixelData)) {
      header_.notAScan = dataset.tagExists(DCM_FloatPixelData) || dataset.tagExists(DCM_DoubleFloatPixelData)
                             ? "has pixels that are fractions (Float Pixel Data), which Viscera does not "
                               "read; export it as whole numbers, or as NIfTI"
                             : "has no pixels";
      return false;
    }
    // Siemens puts the slices of one instant side by side into one large image.
    if (codeAt(dataset, DCM_ImageType).find("MOSAIC") != std::string::npos) {
      header_.notAScan =
          "is a mosaic of many slices in one image, as Siemens writes them, which Viscera does "
          "not take apart; convert it to NIfTI (dcm2niix does)";
      return false;
    }
    const auto number = [&](const DcmTagKey& key, int otherwise) {
      return static_cast<int>(numberAt(dataset, key).value_or(otherwise));
    };
    header_.columns = axisSize(file_, number(DCM_Columns, 0), "a row");
    header_.rows = axisSize(file_, number(DCM_Rows, 0), "a column");
    const std::string colours = codeAt(dataset, DCM_PhotometricInterpretation);
    const bool plain = colours.empty() || colours.starts_with("MONOCHROME") ||
                       (isSegmentation_ && colours.starts_with("PALETTE")); // Labels with their colours.
    if (number(DCM_SamplesPerPixel, 1) != 1 || !plain) {
      header_.notAScan = withKind("is a colour image");
      return false;
    }
    DicomPixelFormat& format = header_.format;
    format.allocated = number(DCM_BitsAllocated, 16);
    format.stored = number(DCM_BitsStored, format.allocated);
    format.high = number(DCM_HighBit, format.stored - 1);
    format.isSigned = number(DCM_PixelRepresentation, 0) == 1;
    const bool bits = format.allocated == 1 && isSegmentation_;
    if ((!bits && format.allocated != 8 && format.allocated != 16 && format.allocated != 32) ||
        format.stored < 1 || format.high >= format.allocated || format.high + 1 < format.stored)
      file_.fail(phrase("its pixels of %1 bits in %2, up to bit %3, are not supported", format.stored,
                        format.allocated, format.high),
                 "export it as pixels of 16 bits");
    readPadding(dataset);
    const auto level = numberAt(dataset, DCM_WindowCenter), width = numberAt(dataset, DCM_WindowWidth);
    if (level && width && *width > 0)
      header_.window = ValueWindow{*level, *width};
    return true;
  }

  /// So that no memory is taken for pixels that cannot be there.
  void requirePixels(DcmItem& dataset) const {
    const std::uint64_t all =
        saturatedProduct(std::uint64_t(header_.rows) * std::uint64_t(header_.columns), header_.frames.size());
    const std::uint64_t promised = header_.format.allocated == 1
                                       ? all / 8 + (all % 8 != 0 ? 1 : 0)
                                       : saturatedProduct(all, std::uint64_t(header_.format.allocated / 8));
    if (header_.packed) {
      std::error_code error;
      const std::uint64_t there = std::filesystem::file_size(file_.file, error);
      if (promised > std::max(kLeastLimit, saturatedProduct(there, kMostPerByte)))
        file_.fail(diagnostic("its header is damaged: it promises %1 bytes of pixels in a file of %2 bytes",
                              promised, there));
      return;
    }
    DcmElement* pixels = nullptr;
    if (dataset.findAndGetElement(DCM_PixelData, pixels).good() && pixels != nullptr &&
        pixels->getLengthField() == DCM_UndefinedLength)
      file_.fail("its pixels are packed in a way that is not supported", "save it without compression");
    if (pixels == nullptr || pixels->getLengthField() < promised)
      file_.fail(diagnostic("the file is cut off: its header promises %1 bytes of pixels, %2 are there",
                            promised, pixels == nullptr ? 0 : pixels->getLengthField()));
  }

  /// The values are stored as pixels are; some writers forget a sign.
  void readPadding(DcmItem& dataset) {
    const auto first = numberAt(dataset, DCM_PixelPaddingValue);
    if (!first)
      return;
    const auto asPixel = [&](double value) {
      const std::int64_t whole = std::int64_t{1} << std::min(header_.format.allocated, 32);
      auto number = static_cast<std::int64_t>(std::clamp(value, -9e9, 9e9));
      if (header_.format.isSigned && number >= whole / 2)
        number -= whole;
      return !header_.format.isSigned && number < 0 ? number + whole : number;
    };
    const std::int64_t a = asPixel(*first);
    const std::int64_t b = asPixel(numberAt(dataset, DCM_PixelPaddingRangeLimit).value_or(*first));
    header_.format.padding = {std::min(a, b), std::max(a, b)};
  }

  void readFrames(DcmItem& dataset) {
    const int count = static_cast<int>(numberAt(dataset, DCM_NumberOfFrames).value_or(1));
    if (count < 1 || count > kMostFrames)
      file_.fail(diagnostic("its header is damaged: it has %1 frames", count));
    DcmItem* shared = nullptr;
    dataset.findAndGetSequenceItem(DCM_SharedFunctionalGroupsSequence, shared, 0);
    DcmSequenceOfItems* groups = nullptr;
    dataset.findAndGetSequence(DCM_PerFrameFunctionalGroupsSequence, groups);
    if (groups != nullptr && groups->card() != static_cast<unsigned long>(count))
      file_.fail(diagnostic("its header is damaged: it describes %1 of %2 frames", groups->card(), count));
    const std::string& uid = header_.instanceUid;
    DcmObject* own = nullptr;
    for (int frame = 0; frame < count; ++frame) {
      own = groups != nullptr ? groups->nextInContainer(own) : nullptr;
      readFrame(FrameItems(dataset, shared, dynamic_cast<DcmItem*>(own)), frame);
      if (!header_.notAScan.empty()) {
        header_.frames.clear();
        return;
      }
      header_.frames.back().uid = uid.empty() ? uid : uid + ' ' + std::to_string(frame);
    }
    if (count > 1 && groups == nullptr)
      placePlainFrames(dataset);
  }

  /// What keeps an object from being a slice, with the kind of object that it is.
  Text withKind(const char* problem) const {
    const std::string kind = nameOfDicomClass(header_.classUid);
    return kind.empty() ? Text(problem) : phrase("%1 (%2)", Text(problem), kind);
  }

  void readFrame(const FrameItems& items, int number) {
    DicomFrame frame;
    frame.frame = number;
    const auto position = items.numbers(DCM_PlanePositionSequence, DCM_ImagePositionPatient);
    const auto directions = items.numbers(DCM_PlaneOrientationSequence, DCM_ImageOrientationPatient);
    const auto spacing = pixelSpacing(items);
    if (position.size() != 3 || directions.size() != 6) {
      header_.notAScan = withKind("does not say where in the patient it lies");
      return;
    }
    if (spacing.size() != 2 || !(spacing[0] > 0 && spacing[1] > 0)) {
      header_.notAScan = "does not say how large its pixels are";
      return;
    }
    frame.position = {position[0], position[1], position[2]};
    const Vec3 row(directions[0], directions[1], directions[2]);
    const Vec3 column(directions[3], directions[4], directions[5]);
    if (std::abs(row.norm() - 1) > kUnitLength || std::abs(column.norm() - 1) > kUnitLength ||
        std::abs(row.dot(column)) > kUnitLength)
      file_.fail(diagnostic("its header is damaged: the directions of its rows and columns are not square"));
    frame.row = row.normalized();
    frame.column = column.normalized();
    frame.betweenRows = spacing[0];
    frame.betweenColumns = spacing[1];
    const auto betweenSlices = items.number(DCM_PixelMeasuresSequence, DCM_SpacingBetweenSlices);
    frame.betweenSlices = betweenSlices.value_or(0);
    frame.thickness = betweenSlices ? *betweenSlices
                                    : items.number(DCM_PixelMeasuresSequence, DCM_SliceThickness).value_or(0);
    frame.sliceThickness =
        items.number(DCM_PixelMeasuresSequence, DCM_SliceThickness).value_or(frame.sliceThickness);
    frame.slope = items.number(DCM_PixelValueTransformationSequence, DCM_RescaleSlope).value_or(1);
    frame.intercept = items.number(DCM_PixelValueTransformationSequence, DCM_RescaleIntercept).value_or(0);
    if (frame.slope == 0)
      file_.fail(diagnostic("its header is damaged: its rescale slope is 0"));
    if (!header_.window)
      readFrameWindow(items);
    frame.temporalPosition = items.number(DCM_FrameContentSequence, DCM_TemporalPositionIndex);
    if (isSegmentation_) {
      frame.segment = static_cast<int>(
          items.number(DCM_SegmentIdentificationSequence, DCM_ReferencedSegmentNumber).value_or(0));
      readPhaseTime(items, frame);
    } else
      readTimes(items, frame);
    header_.frames.push_back(std::move(frame));
  }

  /// Between rows and between columns; of a file that has lost it, from what else tells it.
  std::vector<double> pixelSpacing(const FrameItems& items) {
    auto spacing = items.numbers(DCM_PixelMeasuresSequence, DCM_PixelSpacing);
    if (spacing.size() == 2)
      return spacing;
    spacing = items.numbers(DCM_PixelMeasuresSequence, DCM_ImagerPixelSpacing);
    if (spacing.size() != 2)
      if (const auto diameter = items.number(DCM_CTReconstructionSequence, DCM_ReconstructionDiameter))
        spacing.assign(2, *diameter / std::max(header_.columns, header_.rows));
    if (spacing.size() == 2)
      header_.assumed = phrase("It does not say how large its pixels are; %1 mm were taken from its "
                               "field of view, so check a length that you know",
                               inDigits(spacing[1], 3));
    return spacing;
  }

  void readFrameWindow(const FrameItems& items) {
    const auto level = items.number(DCM_FrameVOILUTSequence, DCM_WindowCenter),
               width = items.number(DCM_FrameVOILUTSequence, DCM_WindowWidth);
    if (level && width && *width > 0)
      header_.window = ValueWindow{*level, *width};
  }

  /// A segmentation counts the time from its first phase, or from the R wave.
  static void readPhaseTime(const FrameItems& items, DicomFrame& frame) {
    frame.triggerMs = items.number(DCM_TemporalPositionSequence, DCM_TemporalPositionTimeOffset);
    if (frame.triggerMs)
      *frame.triggerMs *= 1000; // It is in seconds.
    else
      frame.triggerMs = items.number(DCM_CardiacSynchronizationSequence, DCM_NominalCardiacTriggerDelayTime);
    if (frame.triggerMs && !std::isfinite(*frame.triggerMs))
      frame.triggerMs.reset();
    frame.intervalMs = items.number(DCM_CardiacSynchronizationSequence, DCM_RRIntervalTimeNominal);
    if (!frame.temporalPosition)
      frame.temporalPosition = frame.triggerMs;
  }

  static void readTimes(const FrameItems& items, DicomFrame& frame) {
    if (!frame.temporalPosition)
      frame.temporalPosition = items.number(DCM_FrameContentSequence, DCM_TemporalPositionIdentifier);
    frame.triggerMs = items.number(DCM_CardiacSynchronizationSequence, DCM_NominalCardiacTriggerDelayTime);
    if (!frame.triggerMs)
      frame.triggerMs = items.number(DCM_CardiacSynchronizationSequence, DCM_TriggerTime);
    frame.intervalMs = items.number(DCM_CardiacSynchronizationSequence, DCM_RRIntervalTimeNominal);
    if (!frame.intervalMs)
      frame.intervalMs = items.number(DCM_CardiacSynchronizationSequence, DCM_NominalInterval);
    frame.percent = items.number(DCM_CardiacSynchronizationSequence, DCM_NominalPercentageOfCardiacPhase);
    frame.acquisitionSeconds =
        secondsOfTime(items.text(DCM_FrameContentSequence, DCM_FrameAcquisitionDateTime));
    if (!frame.acquisitionSeconds)
      frame.acquisitionSeconds = secondsOfTime(items.text(DCM_FrameContentSequence, DCM_AcquisitionDateTime));
    if (!frame.acquisitionSeconds)
      frame.acquisitionSeconds = secondsOfTime(items.text(DCM_FrameContentSequence, DCM_AcquisitionTime));
    frame.instance = static_cast<std::int64_t>(
        items.number(DCM_FrameContentSequence, DCM_InstanceNumber).value_or(0) + frame.frame);
    frame.echo = items.text(DCM_MREchoSequence, DCM_EchoNumbers);
    const std::string time = items.text(DCM_MREchoSequence, DCM_EffectiveEchoTime);
    frame.echo += ' ' + (time.empty() ? items.text(DCM_MREchoSequence, DCM_EchoTime) : time);
  }

  /// Frames of old kinds (dose, nuclear medicine) lie above the first one.
  void placePlainFrames(DcmItem& dataset) {
    std::vector<double> offsets = numbersAt(dataset, DCM_GridFrameOffsetVector);
    const auto spacing = numberAt(dataset, DCM_SpacingBetweenSlices);
    if (offsets.empty() && spacing)
      for (std::size_t f = 0; f < header_.frames.size(); ++f)
        offsets.push_back(*spacing * double(f));
    if (offsets.size() != header_.frames.size()) {
      header_.notAScan = "does not say where its frames lie";
      header_.frames.clear();
      return;
    }
    for (std::size_t f = 0; f < offsets.size(); ++f)
      header_.frames[f].position += (offsets[f] - offsets[0]) * header_.frames[f].normal();
  }

  FileBytes file_;
  DcmFileFormat& format_;
  DicomHeader header_;
  bool isSegmentation_ = false;
};

} // namespace

DicomHeader dicomHeaderOf(const std::filesystem::path& file, DcmFileFormat& format) {
  return ElementReader(file, format).run();
}

DicomHeader readDicomHeader(const std::filesystem::path& file) {
  DcmFileFormat format;
  loadDicom(format, FileBytes{file, {}});
  return dicomHeaderOf(file, format);
}

DicomHeader remainsOfDicomHeader(const std::filesystem::path& file) {
  DcmFileFormat format;
  try {
    loadDicomBeforePixels(format, FileBytes{file, {}});
  } catch (const Error&) {
    DicomHeader none;
    none.file = file;
    return none;
  }
  return ElementReader(file, format).runWithoutPixels();
}

FolderHeaders readDicomHeaders(std::vector<std::filesystem::path> files, Progress& progress, double until) {
  FolderHeaders folder;
  folder.files = std::move(files);
  folder.headers.resize(folder.files.size());
  folder.errors.resize(folder.files.size());
  forAll(folder.files.size(), progress, 0, until, "headers", [&](std::size_t i) {
    try {
      folder.headers[i] = readDicomHeader(folder.files[i]);
    } catch (const DataError& error) {
      folder.headers[i].file = folder.files[i];
      folder.errors[i] = error;
    }
  });
  return folder;
}

} // namespace viscera::medical_io
