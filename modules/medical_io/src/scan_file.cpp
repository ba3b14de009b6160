#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <type_traits>

#include "dicom/dicom_mark.h"
#include "dicom/dicom_scan.h"
#include "file_bytes.h"
#include "file_signature.h"
#include "image_formats/data_file.h"
#include "viscera/core/error.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/scan.h"

namespace viscera::medical_io {
namespace {

/// Headers in words may name hundreds of segments.
constexpr std::size_t kMostScanHeaderBytes = std::size_t{1} << 22U;

using HeaderReader = ImageHeader (*)(FileBytes&);

/// The reader by what the file begins with, and by its ending where that says nothing.
HeaderReader headerReaderOf(const FileBytes& begin) {
  const std::string extension = extensionOf(begin.file);
  const bool namedNifti =
      extension.starts_with(".nii") || extension.starts_with(".hdr") || extension.starts_with(".img");
  const Signature found = signatureOf(begin);
  switch (found) {
  case Signature::nifti:
    return niftiSeriesHeader;
  case Signature::nrrd:
    return nrrdHeader;
  case Signature::metaImage:
    return metaImageHeader;
  case Signature::gzip:
  case Signature::unknown:
    if (namedNifti)
      return niftiSeriesHeader;
    if (extension.ends_with("nrrd") || extension.ends_with("nhdr"))
      return nrrdHeader;
    if (extension == ".mha" || extension == ".mhd")
      return metaImageHeader;
    break;
  default:
    break;
  }
  begin.fail(looksLike("It is not a scan in a known format", found),
             "open a NIfTI, NRRD or MetaImage file, or a DICOM series");
}

/// Values behind each other as one vector of a scan's samples.
template <class Sample>
class Collector {
public:
  explicit Collector(std::uint64_t count) : count_(count) {}

  void prepare() { samples_.reserve(static_cast<std::size_t>(count_)); }
  /// False when a value does not fit.
  bool take(const char* bytes, std::size_t count, Scalar scalar, std::endian order) {
    if (isStoredAsSample(scalar) && order == std::endian::native) {
      const auto* first = reinterpret_cast<const Sample*>(bytes); // Blocks are aligned.
      samples_.insert(samples_.end(), first, first + count);
      return true;
    }
    const std::size_t width = sizeOf(scalar);
    for (std::size_t i = 0; i < count; ++i) {
      const double value = loadDouble(bytes + i * width, scalar, order);
      if constexpr (std::is_integral_v<Sample>)
        if (!(value >= double(std::numeric_limits<Sample>::min()) &&
              value <= double(std::numeric_limits<Sample>::max())) ||
            value != std::floor(value))
          return false;
      samples_.push_back(static_cast<Sample>(value));
    }
    return true;
  }
  std::vector<Sample> samples() { return std::move(samples_); }

private:
  static bool isStoredAsSample(Scalar scalar) {
    switch (scalar) {
    case Scalar::int8:
      return std::is_same_v<Sample, std::int8_t>;
    case Scalar::uint8:
      return std::is_same_v<Sample, std::uint8_t>;
    case Scalar::int16:
      return std::is_same_v<Sample, std::int16_t>;
    case Scalar::uint16:
      return std::is_same_v<Sample, std::uint16_t>;
    case Scalar::int32:
      return std::is_same_v<Sample, std::int32_t>;
    case Scalar::uint32:
      return std::is_same_v<Sample, std::uint32_t>;
    case Scalar::float32:
      return std::is_same_v<Sample, float>;
    default:
      return false;
    }
  }

  std::uint64_t count_;
  std::vector<Sample> samples_;
};

/// Which of a file's volumes is wanted.
struct Wanted {
  const FileBytes& file;
  const ImageHeader& header;
  int phase = 0;
};

/// The samples of one volume; nothing when one of them does not fit into the type.
template <class Sample>
std::optional<Scan::Samples> samplesAs(const Wanted& wanted, Progress& progress) {
  RawImage raw = wanted.header.image;
  const auto layers = static_cast<std::uint64_t>(raw.layers),
             phase = static_cast<std::uint64_t>(wanted.phase);
  const std::uint64_t voxels = raw.valueCount() / layers;
  const bool mixed = raw.layersFirst && layers > 1;
  const ValueRange range = mixed ? ValueRange{0, raw.valueCount()} : ValueRange{phase * voxels, voxels};
  Collector<Sample> collector(voxels);
  bool fits = true;
  std::uint64_t next = phase; // Of values that lie beside those of other phases.
  std::uint64_t seen = 0;
  visitValues(
      wanted.file, wanted.header.stored, raw, range, progress, [&](std::uint64_t) { collector.prepare(); },
      [&](const char* bytes, std::size_t count) {
        if (!mixed) {
          fits = fits && collector.take(bytes, count, raw.scalar, raw.order);
          return;
        }
        const std::size_t width = sizeOf(raw.scalar);
        std::vector<std::uint64_t> own(count / layers + 2); // Aligned as the block is.
        std::size_t found = 0;
        for (; next < seen + count; next += layers)
          std::copy_n(bytes + (next - seen) * width, width,
                      reinterpret_cast<char*>(own.data()) + width * found++);
        seen += count;
        fits =
            fits && collector.take(reinterpret_cast<const char*>(own.data()), found, raw.scalar, raw.order);
      });
  return fits ? std::optional<Scan::Samples>(collector.samples()) : std::nullopt;
}

Scan::Samples samplesOf(const Wanted& wanted, std::vector<ScanFinding>& findings, Progress& progress) {
  const auto as = [&]<class Sample>(Sample) { return *samplesAs<Sample>(wanted, progress); };
  const auto whole = [&]<class Sample>(Sample) -> Scan::Samples {
    // Numbers in words may be no whole ones, whatever the header says, and 64 bits may not fit into 32.
    if (auto samples = samplesAs<Sample>(wanted, progress))
      return std::move(*samples);
    findings.push_back({ScanFinding::Kind::other, "Some of its values need more than 32 bits as a whole "
                                                  "number; they are kept as fractions of seven digits"});
    return as(float());
  };
  switch (wanted.header.image.scalar) {
  case Scalar::int8:
    return whole(std::int8_t());
  case Scalar::uint8:
    return whole(std::uint8_t());
  case Scalar::int16:
    return whole(std::int16_t());
  case Scalar::uint16:
    return whole(std::uint16_t());
  case Scalar::uint32:
    return whole(std::uint32_t());
  case Scalar::int32:
  case Scalar::int64:
  case Scalar::uint64:
    return whole(std::int32_t());
  default:
    return as(float());
  }
}

/// Milliseconds of the phases of a file with several of them; their numbers where the file states no times.
std::vector<double> phaseTimes(const RawImage& image, std::vector<ScanFinding>& findings) {
  const auto count = static_cast<std::size_t>(image.layers);
  std::vector<double> times;
  if (count < 2)
    return times;
  const RawTimes stated = image.times.value_or(RawTimes{});
  const double unit = stated.unit == "s" ? 1000 : stated.unit == "us" ? 1e-3 : 1;
  const bool listed = stated.values.size() == count;
  for (std::size_t i = 0; i < count; ++i)
    times.push_back(listed ? unit * (stated.values[i] - stated.values[0]) : unit * stated.step * double(i));
  if (!std::all_of(times.begin(), times.end(), [](double t) { return std::isfinite(t); }) ||
      !(times.back() > 0)) {
    for (std::size_t i = 0; i < count; ++i)
      times[i] = double(i);
    findings.push_back(
        {ScanFinding::Kind::other,
         phrase("It does not say the times of its %n {phase|phases}; they are numbered", count)});
  }
  return times;
}

/// A NRRD file may keep colours where others keep phases.
void requirePlainVoxels(const FileBytes& file, const RawImage& image) {
  const std::string& kind = image.listKind;
  if (image.layers > 1 && (kind.find("color") != kind.npos || kind.find("vector") != kind.npos ||
                           kind.find("matrix") != kind.npos || kind == "complex"))
    file.fail(phrase("It has several values per voxel (%1)", kind), "save it with one value per voxel");
}

struct ImageFile {
  FileBytes begin;
  ImageHeader header;
};

ImageFile openImage(const std::filesystem::path& path) {
  ImageFile file{readBeginOfFile(path, kMostScanHeaderBytes), {}};
  const HeaderReader read = headerReaderOf(file.begin);
  file.header = read(file.begin);
  file.begin.bytes = {};
  requirePlainVoxels(file.begin, file.header.image);
  requireUsableGrid(file.header.image, file.begin);
  return file;
}

Scan readImageScan(const std::filesystem::path& path, const ScanOptions& options, Progress& progress) {
  const ImageFile file = openImage(path);
  const RawImage& image = file.header.image;
  if (!options.series.empty())
    throw UsageError(phrase("It has no series %1; it is one scan", options.series), path.string());
  if (options.phase < 0 || options.phase >= image.layers)
    throw UsageError(phrase("It has no phase %1; it has %2", options.phase, image.layers), path.string(),
                     "the first one is 0");
  Scan scan;
  scan.size = image.size;
  scan.indexToLps = image.indexToLps;
  scan.slope = image.slope;
  scan.intercept = image.intercept;
  scan.space = image.space;
  for (const std::string& warning : image.warnings)
    scan.findings.push_back({ScanFinding::Kind::other, warning});
  scan.phaseTimesMs = phaseTimes(image, scan.findings);
  scan.phase = options.phase;
  try {
    scan.samples = samplesOf({file.begin, file.header, options.phase}, scan.findings, progress);
  } catch (const std::bad_alloc&) {
    file.begin.fail("does not fit into memory", "crop the scan to the organs");
  }
  progress.report(1);
  return scan;
}

ScanSeries describeImage(const std::filesystem::path& path) {
  const ImageFile file = openImage(path);
  const RawImage& image = file.header.image;
  ScanSeries series;
  series.description = stemOf(path);
  series.size = image.size;
  series.spacing = image.indexToLps.linear().colwise().norm();
  series.indexToLps = image.indexToLps;
  series.phases = image.layers;
  series.files = {path};
  return series;
}

bool endsLikeAnImage(const std::filesystem::path& file) {
  static constexpr std::array<std::string_view, 10> kEndings = {
      ".nii", ".nii.gz", ".hdr", ".hdr.gz", ".img", ".img.gz", ".nrrd", ".nhdr", ".mha", ".mhd"};
  return std::find(kEndings.begin(), kEndings.end(), extensionOf(file)) != kEndings.end();
}

} // namespace

std::vector<ScanSeries> listScans(const std::filesystem::path& fileOrFolder, Progress& progress) {
  if (isDicomPlace(fileOrFolder))
    return listDicomScans(fileOrFolder, progress);
  return {describeImage(fileOrFolder)};
}

Scan readScan(const std::filesystem::path& fileOrFolder, const ScanOptions& options, Progress& progress) {
  if (isDicomPlace(fileOrFolder))
    return readDicomScan(fileOrFolder, options, progress);
  return readImageScan(fileOrFolder, options, progress);
}

bool isScan(const std::filesystem::path& fileOrFolder) {
  std::error_code error;
  if (std::filesystem::is_directory(fileOrFolder, error))
    return hasDicomImages(fileOrFolder);
  return endsLikeAnImage(fileOrFolder) || dicomKind(fileOrFolder) == DicomKind::image;
}

} // namespace viscera::medical_io
