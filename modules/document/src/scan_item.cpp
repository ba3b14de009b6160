#include "viscera/document/scan_item.h"

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <utility>
#include <vector>

#include "viscera/core/content_hash.h"
#include "viscera/core/error.h"
#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/medical_io/image_file.h"
#include "viscera/medical_io/label_map.h"

namespace viscera::document {
namespace {

constexpr std::size_t kHashedAtOnce = std::size_t{1} << 20U; ///< Bytes; the hash depends on it.

/// Segmentations say what they are.
bool isNamedAsLabels(const std::filesystem::path& file) {
  const std::string name = file.filename().string();
  return name.ends_with(".seg.nrrd") || name.ends_with(".seg.nhdr");
}

std::string_view sampleBytes(const medical_io::Scan& scan) {
  return std::visit(
      [](const auto& samples) {
        return std::string_view(reinterpret_cast<const char*>(samples.data()),
                                samples.size() * sizeof(samples[0]));
      },
      scan.samples);
}

ScanItem withHash(ScanItem item) {
  item.hash = scanHash(*item.scan);
  return item;
}

bool sameTime(const ScanItem& a, const ScanItem& b) {
  return a.time == b.time || (a.time && b.time && a.time->hash == b.time->hash);
}

/// The phase of the file that is asked for; the first that can be read where it is damaged.
std::size_t phaseNumbered(const medical_io::ScanOverTime& time, int number) {
  const auto found = std::find(time.numbers.begin(), time.numbers.end(), number);
  return found == time.numbers.end() ? 0 : static_cast<std::size_t>(found - time.numbers.begin());
}

/// A scan with all of its phases, named by what its series and its file are called.
ScanItem timedItem(const std::filesystem::path& file, medical_io::ScanOverTime time, int number) {
  const std::size_t phase = phaseNumbered(time, number);
  const std::shared_ptr<const medical_io::Scan> scan = time.volume(phase);
  medical_io::Scan named;
  named.modality = scan->modality;
  named.description = scan->description;
  ScanItem item = scanItem(std::move(named), file, {time.series, time.numbers[phase]});
  item.scan = scan;
  item.time = std::make_shared<const medical_io::ScanOverTime>(std::move(time));
  return withHash(std::move(item));
}

} // namespace

std::string scanHash(const medical_io::Scan& scan) {
  const std::string_view bytes = sampleBytes(scan);
  std::vector<std::uint64_t> parts((bytes.size() + kHashedAtOnce - 1) / kHashedAtOnce);
  parallelRanges(static_cast<Eigen::Index>(parts.size()), 1, {}, [&](Eigen::Index begin, Eigen::Index end) {
    for (auto part = static_cast<std::size_t>(begin); part < static_cast<std::size_t>(end); ++part)
      parts[part] = contentHash(bytes.substr(part * kHashedAtOnce, kHashedAtOnce));
  });
  std::uint64_t hash = scan.samples.index();
  const auto add = [&hash](const void* data, std::size_t size) {
    hash = contentHash({static_cast<const char*>(data), size}, hash);
  };
  add(parts.data(), parts.size() * sizeof(parts[0]));
  add(scan.size.data(), sizeof scan.size);
  const Eigen::Matrix4f grid = scan.indexToLps.matrix().cast<float>(); // Its last bits are another machine's.
  add(grid.data(), 16 * sizeof(float));
  add(&scan.slope, sizeof scan.slope);
  add(&scan.intercept, sizeof scan.intercept);
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

bool identical(const std::shared_ptr<const ScanItem>& a, const std::shared_ptr<const ScanItem>& b) {
  if (a == b || !a || !b)
    return a == b;
  const medical_io::Scan &x = *a->scan, &y = *b->scan;
  const bool samePlace = sameTime(*a, *b) && a->name == b->name && a->file == b->file &&
                         a->series == b->series && a->phase == b->phase;
  return samePlace &&
         (&x == &y || (x.size == y.size && x.indexToLps.matrix() == y.indexToLps.matrix() &&
                       x.slope == y.slope && x.intercept == y.intercept && x.samples == y.samples));
}

ScanItem scanItem(medical_io::Scan scan, const std::filesystem::path& file,
                  const medical_io::ScanOptions& options) {
  std::string name = scan.modality;
  if (!scan.description.empty())
    name += (name.empty() ? "" : ", ") + scan.description;
  else if (!file.empty())
    name +=
        (name.empty() ? "" : ", ") + (file.has_filename() ? file : file.parent_path()).filename().string();
  return {name.empty() ? "Scan" : name, std::make_shared<const medical_io::Scan>(std::move(scan)), file,
          options.series, options.phase};
}

ScanItem openScanFile(const std::filesystem::path& file, const medical_io::ScanOptions& options,
                      Progress& progress) {
  if (auto time = medical_io::readScanOverTime(file, options, progress))
    return timedItem(file, *std::move(time), options.phase);
  return withHash(scanItem(medical_io::readScan(file, options, progress), file, options));
}

std::optional<ScanItemOrLabels> openImage(const std::filesystem::path& file, Progress& progress) {
  if (isNamedAsLabels(file) || !medical_io::isScan(file))
    return std::nullopt;
  try {
    medical_io::ScanOrLabels read = medical_io::readScanOrLabels(file, {}, progress);
    if (auto* labels = std::get_if<medical_io::LabelMap>(&read))
      return std::move(*labels);
    if (std::get<medical_io::Scan>(read).phaseTimesMs.size() > 1)
      return openScanFile(file, {}, progress);
    return withHash(scanItem(std::get<medical_io::Scan>(std::move(read)), file));
  } catch (const DataError&) {
    if (!medical_io::isLabelMap(file))
      throw;
    return std::nullopt;
  }
}

std::shared_ptr<const medical_io::Scan> scanAt(const ScanItem& item, double fraction) {
  if (!item.time)
    return item.scan;
  const std::optional<std::size_t> phase = item.time->shownAt(fraction);
  if (!phase)
    return nullptr;
  if (item.time->numbers[*phase] == item.scan->phase)
    return item.scan;
  try {
    return item.time->volume(*phase);
  } catch (const DataError&) {
    return nullptr; // Its file has changed since: the slices say that nothing is known.
  }
}

bool hasImagesOverTime(const DocumentState& state) {
  return state.study || (state.scan && state.scan->time);
}

double fractionOf(const ScanItem& item) {
  return item.time ? item.time->fractions[phaseNumbered(*item.time, item.scan->phase)] : 0;
}

std::optional<int> phaseOfLabels(const std::filesystem::path& file, const ScanItem* scan,
                                 Progress& progress) {
  const std::size_t phases = scan != nullptr ? scan->scan->phaseTimesMs.size() : 0;
  std::error_code error;
  if (phases < 2 || !std::filesystem::is_regular_file(file, error) || !medical_io::isScan(file))
    return std::nullopt;
  const auto series = medical_io::listScans(file, progress);
  const bool asMany = series.size() == 1 && static_cast<std::size_t>(series.front().phases) == phases;
  return asMany ? std::optional(scan->phase) : std::nullopt;
}

Command openScan(ScanItem item) {
  const Text name = phrase("Open scan %1", item.name);
  auto shared = std::make_shared<const ScanItem>(std::move(item));
  return {name, [shared](DocumentState state, IdSource&) {
            state.scan = shared;
            state.study = nullptr;
            return state;
          }};
}

Command closeScan() {
  return {"Close scan", [](DocumentState state, IdSource&) {
            if (!state.scan)
              throw UsageError("There is no scan to close");
            state.scan = nullptr;
            return state;
          }};
}

} // namespace viscera::document
