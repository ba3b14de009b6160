#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/medical_io/scan.h"

namespace viscera::medical_io {

using TakeVolume = std::function<void(std::size_t phase, Scan&& scan)>;

/// The volumes of a scan over time as their headers promise them, before any is read. The vectors have one
/// item for each phase.
struct TimedVolumes {
  std::vector<double> fractions; ///< Of the cycle, ascending, in [0, 1).
  std::vector<int> numbers;      ///< As `ScanOptions::phase`.
  std::vector<Text> names;       ///< "phase 3", "phase 30 %".
  double periodSeconds = 0;      ///< 0: not known.
  std::array<int, 3> size = {};
  std::size_t sampleBytes = 2; ///< Of a voxel, decoded.
  std::string series, description, modality;
  std::vector<Text> findings;
  bool atRandom = true;     ///< A phase can be read without those before it.
  bool interleaved = false; ///< Samples of all phases lie beside each other.
  std::function<Scan(std::size_t phase, Progress& progress)> read;
  /// All in one go, where they are not at random; throws `DataError` at what is damaged.
  std::function<void(Progress& progress, const TakeVolume& take)> readAll;

  std::size_t count() const { return fractions.size(); }
  std::size_t bytesOfPhase() const {
    return std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]) * sampleBytes;
  }
};

/// The cycle that times in ascending order span, as many steps as there are times: in their unit.
double cycleOfTimes(const std::vector<double>& times);

/// Whether a cycle of so many seconds is one of a heart or of breath; others come from a unit that the file
/// does not mean, or from something else than a cycle.
bool isCycle(double seconds);

/// The volumes of a file other than DICOM; none of one volume, and of layers that are no phases. Throws as
/// `readScan`.
std::optional<TimedVolumes> imageVolumes(const std::filesystem::path& file);

} // namespace viscera::medical_io
