#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "viscera/core/progress.h"
#include "viscera/medical_io/label_map.h"

/// Reads label maps over time, as a series of phases.
namespace viscera::medical_io {

/// The times of the phases of a series, as far as its files state them.
struct SeriesTimes {
  std::vector<double> seconds; ///< One for each phase, from 0 on; empty: not stated.
  /// Duration of one cycle: as many steps as there are phases; none: not stated.
  std::optional<double> periodSeconds;
  Text doubt; ///< An assumption that was made, as a sentence; empty for none.
};

/// The number of label maps that an image file has over time: 1 for a single one, and for every other file,
/// DICOM too. Reads the header. Throws as `readLabelMap`.
std::size_t volumesIn(const std::filesystem::path& file);

/// Reads a file with several label maps, one for each phase (a 4D NIfTI or MetaImage with time last; 3D
/// Slicer's .seq.nrrd, whose list axis comes first or last; FreeSurfer's frames; DICOM-SEG with several
/// temporal positions), and hands them to `visit` in order. Names and colours as in `readLabelMap`; a phase
/// may be empty. Returns the times that the file states: of NIfTI the step and unit of the fourth axis, of
/// NRRD `axis N index values` and its unit, of DICOM-SEG the offset of each temporal position, else the
/// trigger delay. Throws as `readLabelMap`.
SeriesTimes readLabelSeries(const std::filesystem::path& file, Progress& progress,
                            const std::function<void(std::size_t phase, LabelMap&& map)>& visit);

/// The time within the heart's cycle at which the image of a DICOM file was acquired.
struct DicomPhase {
  std::optional<double> triggerMs;         ///< After the R wave (0018,1060), else (0020,9153).
  std::optional<double> nominalIntervalMs; ///< From one R wave to the next (0018,1062).
  std::optional<double> percent;           ///< Of the cycle (0020,9241).
};

/// Reads it from a DICOM file and the sequences in it. Empty for any other file. Does not throw.
DicomPhase dicomPhase(const std::filesystem::path& file);

/// The times of phases from the times of their DICOM files; empty unless all files have one.
SeriesTimes timesOf(const std::vector<DicomPhase>& phases);

} // namespace viscera::medical_io
