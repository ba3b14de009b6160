#include "opened_image.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "file_signature.h"
#include "image_formats/sample_collector.h"
#include "scalar.h"
#include "unread_images.h"
#include "viscera/core/phrase.h"

namespace viscera::medical_io {
namespace {

using HeaderReader = ImageHeader (*)(FileBytes&);

/// The reader by what the file begins with, and by its ending where that says nothing.
HeaderReader headerReaderOf(const FileBytes& begin) {
  static constexpr std::array<std::pair<Signature, HeaderReader>, 5> kReaders = {
      {{Signature::nifti, niftiHeader},
       {Signature::nrrd, nrrdHeader},
       {Signature::metaImage, metaImageHeader},
       {Signature::mgh, mghHeader},
       {Signature::gipl, giplHeader}}};
  Signature found = signatureUnpacked(begin);
  if (found == Signature::unknown && unreadImage(begin))
    refuse(begin, FileKind::scan);
  if (found == Signature::gzip || found == Signature::unknown)
    found = signatureOfEnding(begin.file);
  if (const auto reader = lookUp(kReaders, found))
    return *reader;
  refuse(begin, FileKind::scan);
}

/// Milliseconds of the phases of a file with several of them; their numbers where the file states no times.
std::vector<double> phaseTimes(const RawImage& image, std::vector<ScanFinding>& findings) {
  const auto count = static_cast<std::size_t>(image.layers);
  std::vector<double> times = statedPhaseTimes(image);
  if (count > 1 && times.empty()) {
    for (std::size_t i = 0; i < count; ++i)
      times.push_back(double(i));
    findings.push_back(
        {ScanFinding::Kind::other,
         phrase("It does not say the times of its %n {phase|phases}; they are numbered", count)});
  }
  return times;
}

/// A NRRD file may keep colours where others keep phases; one that names segments keeps layers of them there.
void requirePlainVoxels(const FileBytes& file, const RawImage& image) {
  const std::string& kind = image.listKind;
  if (image.layers > 1 && image.stated.empty() &&
      (kind.find("color") != kind.npos || kind.find("vector") != kind.npos ||
       kind.find("matrix") != kind.npos || kind == "complex"))
    file.fail(phrase("It has several values per voxel (%1)", kind), "save it with one value per voxel");
}

} // namespace

std::vector<double> statedPhaseTimes(const RawImage& image) {
  const auto count = static_cast<std::size_t>(image.layers);
  std::vector<double> times;
  if (count < 2 || !image.times)
    return times;
  const RawTimes& stated = *image.times;
  const double seconds = secondsAUnit(stated.unit), unit = seconds > 0 ? 1000 * seconds : 1;
  const bool listed = stated.values.size() == count;
  for (std::size_t i = 0; i < count; ++i)
    times.push_back(listed ? unit * (stated.values[i] - stated.values[0]) : unit * stated.step * double(i));
  const bool usable = std::all_of(times.begin(), times.end(), [](double t) { return std::isfinite(t); });
  return usable && times.back() > 0 ? times : std::vector<double>();
}

OpenedImage openImage(const std::filesystem::path& path) {
  OpenedImage image{readBeginOfFile(path, kMostHeaderBytes), {}};
  const HeaderReader read = headerReaderOf(image.begin);
  image.header = read(image.begin);
  requirePlainVoxels(image.begin, image.header.image);
  requireUsableGrid(image.header.image, image.begin);
  return image;
}

void visitPhase(OpenedImage& image, int phase, Progress& progress,
                const std::function<void(std::size_t)>& prepare, const TakeValues& take) {
  RawImage& raw = image.header.image;
  const auto layers = static_cast<std::uint64_t>(raw.layers), first = static_cast<std::uint64_t>(phase);
  const std::uint64_t voxels = raw.valueCount() / layers;
  const bool mixed = raw.layersFirst && layers > 1;
  // A file that is cut off still has its first phases.
  const bool fromBegin =
      !mixed && !image.header.stored.atEnd && image.header.stored.parts.empty() && raw.overTime;
  const int all = raw.layers;
  const ValueRange range = mixed ? ValueRange{0, raw.valueCount()} : ValueRange{first * voxels, voxels};
  std::uint64_t next = first; // Of values that lie beside those of other phases.
  std::uint64_t seen = 0;
  if (fromBegin)
    raw.layers = phase + 1;
  visitValues(
      image.begin, image.header.stored, raw, range, progress,
      [&](std::uint64_t) { prepare(static_cast<std::size_t>(voxels)); },
      [&](const char* bytes, std::size_t count) {
        if (!mixed)
          return take(bytes, count, raw.scalar, raw.order);
        const std::size_t width = sizeOf(raw.scalar);
        std::vector<std::uint64_t> own(count / layers + 2); // Aligned as the block is.
        std::size_t found = 0;
        for (; next < seen + count; next += layers)
          std::copy_n(bytes + (next - seen) * width, width,
                      reinterpret_cast<char*>(own.data()) + width * found++);
        seen += count;
        take(reinterpret_cast<const char*>(own.data()), found, raw.scalar, raw.order);
      });
  raw.layers = all;
}

Scan scanOf(OpenedImage&& opened, int phase, SampleCollector& collector) {
  RawImage& image = opened.header.image;
  Scan scan;
  scan.size = image.size;
  scan.indexToLps = image.indexToLps;
  scan.slope = image.slope;
  scan.intercept = image.intercept;
  scan.space = image.space;
  for (const Text& warning : image.warnings)
    scan.findings.push_back({ScanFinding::Kind::other, warning});
  scan.phaseTimesMs = phaseTimes(image, scan.findings);
  scan.phase = phase;
  scan.samples = collector.samples();
  if (collector.rounded())
    scan.findings.push_back({ScanFinding::Kind::other, "Some of its values need more than 32 bits as a whole "
                                                       "number; they are kept as fractions of seven digits"});
  return scan;
}

} // namespace viscera::medical_io
