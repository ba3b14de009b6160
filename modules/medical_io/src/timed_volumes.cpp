#include "timed_volumes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <new>
#include <utility>

#include "file_signature.h"
#include "image_formats/sample_collector.h"
#include "opened_image.h"
#include "viscera/core/error.h"

namespace viscera::medical_io {
namespace {

/// Durations of a heart's beat or a breath, s.
constexpr double kShortestCycle = 0.25, kLongestCycle = 10;
/// The duration of a beat in a file without a unit of time, s: steps of 1, which say nothing, make longer
/// ones.
constexpr double kLongestBeat = 1.6;

/// Bytes of a sample as `SampleCollector` keeps it.
std::size_t keptWidth(Scalar scalar) {
  return std::min<std::size_t>(sizeOf(scalar), 4);
}

/// Where the phases of a file can be read one by one: neither packed, nor in words, nor beside each other.
bool isAtRandom(const OpenedImage& opened) {
  return opened.header.stored.packing == Packing::none && !opened.header.stored.text &&
         !opened.begin.unpacked && !opened.header.image.layersFirst;
}

[[noreturn]] void failAsTooLarge(const FileBytes& begin) {
  begin.fail("it does not fit into memory", "crop the image to the organs");
}

Scan readPhase(const std::filesystem::path& file, std::size_t phase, Progress& progress) {
  OpenedImage image = openImage(file);
  RawImage& raw = image.header.image;
  const int number = static_cast<int>(phase);
  if (number >= raw.layers)
    throw DataError("It has changed since it was opened", file.string(), "open it again");
  SampleCollector collector(raw.scalar);
  try {
    visitPhase(
        image, number, progress, [&](std::size_t count) { collector.reserve(count); },
        [&](const char* bytes, std::size_t count, Scalar scalar, std::endian order) {
          collector.take(bytes, count, scalar, order);
        });
  } catch (const std::bad_alloc&) {
    failAsTooLarge(image.begin);
  }
  return scanOf(std::move(image), number, collector);
}

/// Divides all values of a file among the scans of its phases.
class Dividing {
public:
  Dividing(const std::filesystem::path& file, const TakeVolume& take)
      : file_(file), opened_(openImage(file)), take_(take),
        phases_(static_cast<std::size_t>(opened_.header.image.layers)),
        voxels_(static_cast<std::size_t>(opened_.header.image.valueCount()) / phases_) {
    const std::size_t open = interleaved() ? phases_ : 1;
    for (std::size_t i = 0; i < open; ++i)
      collectors_.emplace_back(opened_.header.image.scalar);
  }

  void run(Progress& progress) {
    RawImage& raw = opened_.header.image;
    try {
      visitValues(
          opened_.begin, opened_.header.stored, raw, {0, raw.valueCount()}, progress,
          [&](std::uint64_t) {
            for (SampleCollector& one : collectors_)
              one.reserve(voxels_);
          },
          [&](const char* bytes, std::size_t count) {
            interleaved() ? takeMixed(bytes, count) : takeInOrder(bytes, count);
          });
    } catch (const std::bad_alloc&) {
      failAsTooLarge(opened_.begin);
    }
    for (std::size_t phase = 0; interleaved() && phase < phases_; ++phase)
      finish(phase, collectors_[phase]);
  }

private:
  bool interleaved() const { return opened_.header.image.layersFirst; }

  void finish(std::size_t phase, SampleCollector& collector) {
    OpenedImage header{FileBytes{file_, {}}, opened_.header};
    take_(phase, scanOf(std::move(header), static_cast<int>(phase), collector));
  }

  /// One value of each phase after the other.
  void takeMixed(const char* bytes, std::size_t count) {
    const RawImage& raw = opened_.header.image;
    const std::size_t width = sizeOf(raw.scalar);
    std::vector<std::uint64_t> own(count / phases_ + 2); // Aligned as the block is.
    for (std::size_t phase = 0; phase < phases_; ++phase) {
      std::size_t found = 0;
      for (std::size_t at = (phase + phases_ - seen_ % phases_) % phases_; at < count; at += phases_)
        std::copy_n(bytes + at * width, width, reinterpret_cast<char*>(own.data()) + width * found++);
      collectors_[phase].take(reinterpret_cast<const char*>(own.data()), found, raw.scalar, raw.order);
    }
    seen_ += count;
  }

  /// A block may end one phase and begin the next; what follows another phase is copied to an aligned place.
  void takeInOrder(const char* bytes, std::size_t count) {
    const RawImage& raw = opened_.header.image;
    const std::size_t width = sizeOf(raw.scalar);
    while (count > 0) {
      const std::size_t phase = seen_ / voxels_, left = (phase + 1) * voxels_ - seen_;
      const std::size_t now = std::min(left, count);
      std::vector<std::uint64_t> aligned;
      const char* from = bytes;
      if (reinterpret_cast<std::uintptr_t>(bytes) % sizeof(std::uint64_t) != 0) {
        aligned.resize(now * width / sizeof(std::uint64_t) + 1);
        std::copy_n(bytes, now * width, reinterpret_cast<char*>(aligned.data()));
        from = reinterpret_cast<const char*>(aligned.data());
      }
      collectors_[0].take(from, now, raw.scalar, raw.order);
      seen_ += now;
      bytes += now * width;
      count -= now;
      if (now < left)
        continue;
      finish(phase, collectors_[0]);
      collectors_[0] = SampleCollector(raw.scalar);
      collectors_[0].reserve(voxels_);
    }
  }

  std::filesystem::path file_;
  OpenedImage opened_;
  const TakeVolume& take_;
  std::size_t phases_, voxels_;
  std::size_t seen_ = 0; ///< Values.
  std::vector<SampleCollector> collectors_;
};

/// The cycle in seconds; without a unit as the one that makes it a heart's beat, which is said. `cycle` is as
/// `statedPhaseTimes` has it: in ms, or as it stands without a unit.
std::optional<double> secondsOf(const RawTimes& times, double cycle, TimedVolumes& volumes) {
  if (secondsAUnit(times.unit) > 0)
    return 1e-3 * cycle;
  if (!times.unit.empty())
    return std::nullopt;
  if (isCycle(1e-3 * cycle)) {
    volumes.findings.push_back("It does not say the unit of its times; they are taken as milliseconds");
    return 1e-3 * cycle;
  }
  if (cycle < kShortestCycle || cycle > kLongestBeat)
    return std::nullopt;
  volumes.findings.push_back("It does not say the unit of its times; they are taken as seconds");
  return cycle;
}

/// The phases' part of the cycle, evenly spaced where the file states no times in ascending order.
void setTimes(TimedVolumes& volumes, const RawImage& image, std::size_t count) {
  const std::vector<double> times = statedPhaseTimes(image);
  const bool ascending = times.size() == count && std::adjacent_find(times.begin(), times.end(),
                                                                     std::greater_equal<>()) == times.end();
  const double cycle = ascending ? cycleOfTimes(times) : double(count);
  for (std::size_t phase = 0; phase < count; ++phase)
    volumes.fractions.push_back((ascending ? times[phase] : double(phase)) / cycle);
  if (const std::optional<double> seconds =
          ascending ? secondsOf(*image.times, cycle, volumes) : std::nullopt;
      seconds && isCycle(*seconds))
    volumes.periodSeconds = *seconds;
  else
    volumes.findings.push_back(
        "It does not say how long the heart's cycle is; its phases are spread over one");
}

} // namespace

double cycleOfTimes(const std::vector<double>& times) {
  const double count = static_cast<double>(times.size());
  return (times.back() - times.front()) / (count - 1) * count;
}

bool isCycle(double seconds) {
  return seconds >= kShortestCycle && seconds <= kLongestCycle;
}

std::optional<TimedVolumes> imageVolumes(const std::filesystem::path& file) {
  const OpenedImage opened = openImage(file);
  const RawImage& image = opened.header.image;
  if (!image.overTime || image.layers < 2)
    return std::nullopt;
  TimedVolumes volumes;
  const auto count = static_cast<std::size_t>(image.layers);
  setTimes(volumes, image, count);
  for (std::size_t phase = 0; phase < count; ++phase) {
    volumes.numbers.push_back(static_cast<int>(phase));
    volumes.names.push_back(phrase("phase %1", phase));
  }
  volumes.size = image.size;
  volumes.sampleBytes = keptWidth(image.scalar);
  volumes.description = stemOf(file);
  volumes.atRandom = isAtRandom(opened);
  volumes.interleaved = image.layersFirst;
  volumes.read = [file](std::size_t phase, Progress& progress) { return readPhase(file, phase, progress); };
  volumes.readAll = [file](Progress& progress, const TakeVolume& take) {
    Dividing(file, take).run(progress);
  };
  return volumes;
}

} // namespace viscera::medical_io
