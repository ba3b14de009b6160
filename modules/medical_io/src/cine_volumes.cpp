#include "cine_volumes.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>

#include "image_ring.h"
#include "opened_image.h"
#include "viscera/core/error.h"
#include "viscera/medical_io/scan.h"

namespace viscera::medical_io {
namespace {

/// Durations of a heart's cycle, s; others come from a unit that the file does not mean.
constexpr double kShortestCycle = 0.25, kLongestCycle = 5;

/// Layer k of a volume, NaN where nothing was measured.
CineImage layerOf(const Scan& scan, int k) {
  CineImage image(scan.size[1], scan.size[0]);
  for (int j = 0; j < scan.size[1]; ++j)
    for (int i = 0; i < scan.size[0]; ++i)
      image(j, i) = static_cast<float>(scan.value(i, j, k));
  return image;
}

/// Decodes all layers of a phase at a time, because a packed file is unpacked from its beginning.
class VolumeSource {
public:
  VolumeSource(std::filesystem::path file, const std::array<int, 3>& size, std::size_t keptBytes)
      : file_(std::move(file)), size_(size), ring_(std::max(keptBytes, bytesOfPhase())) {}

  ImageRing::Picture image(std::size_t layer, std::size_t phase) {
    return ring_.get({layer, phase}, [&] {
      Progress quiet;
      const Scan scan = readScan(file_, {{}, static_cast<int>(phase)}, quiet);
      if (scan.size != size_)
        throw DataError("It has changed since it was opened", file_.string(), "open it again");
      for (int k = 0; k < size_[2]; ++k)
        if (static_cast<std::size_t>(k) != layer)
          ring_.keep({static_cast<std::size_t>(k), phase}, layerOf(scan, k));
      return layerOf(scan, static_cast<int>(layer));
    });
  }

private:
  std::size_t bytesOfPhase() const {
    return std::size_t(size_[0]) * std::size_t(size_[1]) * std::size_t(size_[2]) * sizeof(float);
  }

  std::filesystem::path file_;
  std::array<int, 3> size_;
  ImageRing ring_;
};

CineGeometry geometryOf(const ScanSeries& series) {
  CineGeometry geometry;
  geometry.origin = series.indexToLps.translation();
  geometry.row = series.indexToLps.linear().col(0).normalized();
  geometry.column = series.indexToLps.linear().col(1).normalized();
  geometry.betweenColumns = series.spacing[0];
  geometry.betweenRows = series.spacing[1];
  geometry.thickness = std::abs(geometry.normal().dot(series.indexToLps.linear().col(2)));
  geometry.columns = series.size[0];
  geometry.rows = series.size[1];
  return geometry;
}

/// The fractions of phases, evenly spaced where the file states no times; and the cycle's duration, s.
std::pair<std::vector<double>, double> cycleOf(const OpenedImage& opened, std::size_t phases) {
  const RawImage& image = opened.header.image;
  std::vector<double> times = statedPhaseTimes(image);
  const bool ascending = times.size() == phases && std::adjacent_find(times.begin(), times.end(),
                                                                      std::greater_equal<>()) == times.end();
  const double count = static_cast<double>(phases);
  std::vector<double> fractions(phases);
  if (!ascending) {
    for (std::size_t phase = 0; phase < phases; ++phase)
      fractions[phase] = static_cast<double>(phase) / count;
    return {fractions, 0};
  }
  const double cycle = times.back() / (count - 1) * count;
  for (std::size_t phase = 0; phase < phases; ++phase)
    fractions[phase] = times[phase] / cycle;
  const bool stated = image.times && secondsAUnit(image.times->unit) > 0;
  const double seconds = 1e-3 * cycle;
  return {fractions, stated && seconds >= kShortestCycle && seconds <= kLongestCycle ? seconds : 0};
}

} // namespace

std::optional<CineStudy> cineOfVolumes(const std::filesystem::path& file, Progress& progress,
                                       const CineOptions& options) {
  const std::vector<ScanSeries> all = listScans(file, progress);
  if (all.size() != 1 || all.front().phases < 2)
    return std::nullopt;
  const ScanSeries& series = all.front();
  const auto phases = static_cast<std::size_t>(series.phases);
  const auto source = std::make_shared<VolumeSource>(file, series.size, options.keptBytes);
  CineStudy study;
  study.modality = series.modality;
  CineSlice slice;
  slice.description = series.description;
  slice.geometry = geometryOf(series);
  std::tie(slice.fractions, slice.interval) = cycleOf(openImage(file), phases);
  if (slice.interval <= 0)
    study.findings.push_back("It does not say how long the heart's cycle is; its phases are spread over one");
  for (int k = 0; k < series.size[2]; ++k) {
    slice.image = [source, layer = static_cast<std::size_t>(k)](std::size_t phase) {
      return source->image(layer, phase);
    };
    study.slices.push_back(slice);
    slice.geometry.origin += series.indexToLps.linear().col(2);
  }
  return study;
}

} // namespace viscera::medical_io
