#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/medical_io/scan.h"

namespace viscera::medical_io {

/// The volumes of one scan over a cycle: of a 4D NIfTI or MetaImage, a sequence of 3D Slicer (.seq.nrrd), or
/// a gated DICOM scan. All have one grid. Immutable; what it hands out is decoded when asked for, and a
/// bounded number of bytes of it is kept.
struct ScanOverTime {
  /// The part of the cycle that has gone by at each phase that can be read, in [0, 1), ascending.
  std::vector<double> fractions;
  std::vector<double> missing;  ///< The same of phases that are damaged; nothing is made up for them.
  std::vector<int> numbers;     ///< Of each phase in `fractions`, as `ScanOptions::phase`.
  double periodSeconds = 0;     ///< Duration of the cycle; 0: not stated, or none of a heart or a breath.
  std::array<int, 3> size = {}; ///< Of the grid, as of `Scan`.
  std::string series;           ///< As `ScanOptions::series`; empty for a file.
  std::string description;      ///< Of the series, or the name of the file.
  std::string modality;         ///< "CT"; empty: not stated.
  std::size_t bytes = 0;        ///< That all phases take when they are decoded.
  std::size_t keptBytes = 0;    ///< At most so many of them stay decoded.
  std::vector<Text> findings;   ///< Phases that are damaged, times that are not stated.
  std::string hash;             ///< Of the grid and the phases' times, not of the samples: 16 digits.
  /// A phase of `fractions`, kept or decoded now. Throws `DataError` when the file has changed since, or is
  /// damaged there. For any thread.
  std::function<std::shared_ptr<const Scan>(std::size_t phase)> volume;

  /// Phases that there should be.
  std::size_t phasesInCycle() const { return fractions.size() + missing.size(); }
  /// The phase that lies nearest, around the end of the cycle as well; none where the nearest one is damaged.
  /// O(phases).
  std::optional<std::size_t> shownAt(double fraction) const;
};

/// How a scan over time is read.
struct ScanTimeOptions {
  /// Decoded bytes that are kept, those used last; one phase at least.
  std::size_t keptBytes = std::size_t{2} << 30U;
};

/// Reads the volumes over time at a place: none for one volume. Every phase is read once, as long as they fit
/// into the bytes that are kept, so that damaged ones are found; a file that is packed or keeps its phases
/// beside each other is read in one go. Where they do not fit, samples of 32 bits are kept as 16 bits, at a
/// 65,000th of a phase's range, and where they still do not, this is said.
///
/// DICOM volumes are phases by temporal position (0020,0100), part of the cycle (0020,9241), trigger time
/// (0018,1060) or time of acquisition; also when each is a series of its own in one study, of one place, told
/// by part of the cycle, by "30%" in its description, or in CT by trigger time. Throws as `readScan`.
/// O(voxels of all phases).
std::optional<ScanOverTime> readScanOverTime(const std::filesystem::path& fileOrFolder,
                                             const ScanOptions& options, Progress& progress,
                                             const ScanTimeOptions& time = {});

} // namespace viscera::medical_io
