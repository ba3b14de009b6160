#include "viscera/medical_io/scan_over_time.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include "dicom/dicom_mark.h"
#include "dicom/dicom_scan.h"
#include "timed_volumes.h"
#include "viscera/core/content_hash.h"
#include "viscera/core/error.h"
#include "volume_ring.h"

namespace viscera::medical_io {
namespace {

/// Phases that a sentence about damaged ones names one by one.
constexpr std::size_t kMostDamagedNamed = 4;
constexpr double kBytesOfGb = 1e9;

/// How far two parts of a cycle are apart, around its end as well.
double apartInCycle(double a, double b) {
  return std::abs(std::remainder(a - b, 1.0));
}

/// The volumes of one scan: where they come from, and those that are decoded.
class TimedScan {
public:
  TimedScan(TimedVolumes volumes, std::filesystem::path place, std::size_t keptBytes)
      : volumes_(std::move(volumes)), place_(std::move(place)),
        ring_(std::max(keptBytes, volumes_.bytesOfPhase())), kept_(keptBytes) {}

  const TimedVolumes& volumes() const { return volumes_; }
  bool inSixteen() const { return sixteen_; }
  std::size_t bytes() const { return volumes_.count() * volumes_.bytesOfPhase() / (sixteen_ ? 2 : 1); }
  bool fits() const { return bytes() <= kept_; }

  /// Why each phase cannot be read; empty where it can. Decodes what fits.
  std::vector<Text> readAll(Progress& progress) {
    if (bytes() > kept_ && volumes_.sampleBytes == 4 && bytes() / 2 <= kept_)
      sixteen_ = true;
    std::vector<Text> damaged(volumes_.count());
    if (volumes_.atRandom)
      readOneByOne(damaged, progress);
    else if (fits() || !volumes_.interleaved)
      readInOneGo(damaged, progress);
    findOthers(damaged);
    return damaged;
  }

  VolumeRing::Volume volume(std::size_t phase) {
    return ring_.get(phase, [&] {
      Progress quiet;
      Scan scan = decoded(phase, quiet);
      if (scan.size != volumes_.size)
        throw DataError("It has changed since it was opened", place_.string(), "open it again");
      return scan;
    });
  }

private:
  Scan decoded(std::size_t phase, Progress& progress) { return kept(volumes_.read(phase, progress)); }
  Scan kept(Scan&& scan) {
    return sixteen_ && !std::holds_alternative<std::vector<std::int16_t>>(scan.samples)
               ? inSixteenBits(std::move(scan))
               : std::move(scan);
  }
  void take(std::size_t phase, Scan&& scan) {
    sizes_[phase] = scan.size;
    ring_.keep(phase, kept(std::move(scan)));
  }

  /// Reads as many as fit, and the last one, which a file that is cut off lacks first.
  void readOneByOne(std::vector<Text>& damaged, Progress& progress) {
    const std::size_t count = volumes_.count();
    const std::size_t fit = fits() ? count : std::max<std::size_t>(1, kept_ / (bytes() / count));
    for (std::size_t i = 0; i < count; ++i) {
      progress.report(double(i) / double(count), volumes_.names[i]);
      progress.throwIfCancelled();
      if (i >= fit && i + 1 < count)
        continue;
      try {
        Progress quiet;
        take(i, volumes_.read(i, quiet));
      } catch (const Cancelled&) {
        throw;
      } catch (const Error& error) {
        damaged[i] = error.problem();
      }
    }
    if (fit < count && !damaged.back().empty())
      findCutOff(fit, damaged);
  }

  /// The first of the later phases that is not there any more, by halving.
  void findCutOff(std::size_t from, std::vector<Text>& damaged) {
    std::size_t there = from, gone = damaged.size() - 1;
    while (there < gone) {
      const std::size_t middle = (there + gone) / 2;
      try {
        Progress quiet;
        volumes_.read(middle, quiet);
        there = middle + 1;
      } catch (const DataError&) {
        gone = middle;
      }
    }
    for (std::size_t phase = gone; phase + 1 < damaged.size(); ++phase)
      damaged[phase] = damaged.back();
  }

  void readInOneGo(std::vector<Text>& damaged, Progress& progress) {
    std::vector<bool> there(volumes_.count());
    try {
      volumes_.readAll(progress, [&](std::size_t phase, Scan&& scan) {
        there[phase] = true;
        if (fits() || ring_.heldBytes() + bytes() / volumes_.count() <= kept_)
          take(phase, std::move(scan));
      });
    } catch (const DataError& error) {
      for (std::size_t phase = 0; phase < there.size(); ++phase)
        if (!there[phase])
          damaged[phase] = error.problem();
    }
  }

  /// Volumes of another grid than that of most, and those that their headers say cannot be read.
  void findOthers(std::vector<Text>& damaged) {
    std::map<std::array<int, 3>, std::size_t> counts;
    for (const auto& [phase, size] : sizes_)
      ++counts[size];
    if (!counts.empty())
      volumes_.size = std::max_element(counts.begin(), counts.end(), [](const auto& a, const auto& b) {
                        return a.second < b.second;
                      })->first;
    for (const auto& [phase, size] : sizes_)
      if (size != volumes_.size) {
        damaged[phase] = phrase("it has %1 x %2 x %3 voxels, others %4 x %5 x %6", size[0], size[1], size[2],
                                volumes_.size[0], volumes_.size[1], volumes_.size[2]);
        ring_.drop(phase);
      }
  }

  TimedVolumes volumes_;
  std::filesystem::path place_;
  VolumeRing ring_;
  std::size_t kept_;
  bool sixteen_ = false;
  std::map<std::size_t, std::array<int, 3>> sizes_; ///< Of the phases that were decoded.
};

/// Names the damaged phases, and says why.
void reportDamaged(const TimedVolumes& volumes, const std::vector<Text>& damaged,
                   std::vector<Text>& findings) {
  std::size_t said = 0, more = 0;
  for (std::size_t phase = 0; phase < damaged.size(); ++phase) {
    if (damaged[phase].empty())
      continue;
    if (said++ < kMostDamagedNamed)
      findings.push_back(phrase("The %1 is damaged and left out: %2", volumes.names[phase], damaged[phase]));
    else
      ++more;
  }
  if (more > 0)
    findings.push_back(phrase("%n more {phase is|phases are} damaged and left out", more));
}

void reportMemory(const TimedScan& scan, std::size_t keptBytes, std::vector<Text>& findings) {
  if (scan.inSixteen())
    findings.push_back("Its phases are kept as 16 bits a voxel, to a 65,000th of their range");
  if (scan.fits())
    return;
  findings.push_back(
      phrase("Its phases need %1 GB, of which %2 GB are kept at a time; the others are read again "
             "when they are shown",
             inDigits(double(scan.bytes()) / kBytesOfGb), inDigits(double(keptBytes) / kBytesOfGb)));
  if (!scan.volumes().atRandom)
    findings.push_back("It is packed, or keeps its phases beside each other, so that each of them is read as "
                       "slowly as all; save it unpacked to move through it");
}

std::string hashOf(const TimedVolumes& volumes, const std::vector<double>& missing) {
  std::uint64_t hash = 0;
  const auto add = [&hash](const char* format, double number) {
    char digits[32];
    std::snprintf(digits, sizeof digits, format, number + 0.0);
    hash = contentHash(std::string(digits) + '\n', hash);
  };
  for (const int length : volumes.size)
    add("%.0f", length);
  for (const double fraction : volumes.fractions)
    add("%.4f", fraction);
  for (const double fraction : missing)
    add("missing %.4f", fraction);
  add("%.4f", volumes.periodSeconds);
  char digits[17];
  std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

} // namespace

std::optional<std::size_t> ScanOverTime::shownAt(double fraction) const {
  std::optional<std::size_t> nearest;
  double least = 1;
  for (std::size_t phase = 0; phase < fractions.size(); ++phase)
    if (const double off = apartInCycle(fractions[phase], fraction); off < least) {
      least = off;
      nearest = phase;
    }
  const bool lost = std::any_of(missing.begin(), missing.end(),
                                [&](double one) { return apartInCycle(one, fraction) < least; });
  return lost ? std::nullopt : nearest;
}

std::optional<ScanOverTime> readScanOverTime(const std::filesystem::path& fileOrFolder,
                                             const ScanOptions& options, Progress& progress,
                                             const ScanTimeOptions& time) {
  std::optional<TimedVolumes> found = isDicomPlace(fileOrFolder)
                                          ? dicomVolumes(fileOrFolder, options.series, progress)
                                          : imageVolumes(fileOrFolder);
  if (!found)
    return std::nullopt;
  const auto scan = std::make_shared<TimedScan>(*std::move(found), fileOrFolder, time.keptBytes);
  const std::vector<Text> damaged = scan->readAll(progress);
  const TimedVolumes& volumes = scan->volumes();
  ScanOverTime over;
  std::vector<std::size_t> there;
  for (std::size_t phase = 0; phase < volumes.count(); ++phase) {
    if (!damaged[phase].empty()) {
      over.missing.push_back(volumes.fractions[phase]);
      continue;
    }
    there.push_back(phase);
    over.fractions.push_back(volumes.fractions[phase]);
    over.numbers.push_back(volumes.numbers[phase]);
  }
  if (there.empty())
    throw DataError(damaged.front(), fileOrFolder.string(), "export or copy it again");
  over.periodSeconds = volumes.periodSeconds;
  over.size = volumes.size;
  over.series = volumes.series;
  over.description = volumes.description;
  over.modality = volumes.modality;
  over.bytes = scan->bytes();
  over.keptBytes = time.keptBytes;
  over.findings = volumes.findings;
  reportDamaged(volumes, damaged, over.findings);
  reportMemory(*scan, time.keptBytes, over.findings);
  over.hash = hashOf(volumes, over.missing);
  over.volume = [scan, there](std::size_t phase) { return scan->volume(there.at(phase)); };
  progress.report(1);
  return over;
}

} // namespace viscera::medical_io
