#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "viscera/live/cine_motion.h"
#include "viscera/live/motion_series.h"
#include "viscera/medical_io/label_series.h"

/// Sorts files into the phases of a series.
namespace viscera::live {

/// The kind and the files of a request's inputs.
struct SeriesFiles {
  enum class Kind { surfaces, labelMaps, volumes };
  Kind kind = Kind::surfaces;
  /// Surfaces: by name, one file a phase. Label maps: one entry "". Volumes: one entry "" with one file.
  std::map<std::string, std::vector<std::filesystem::path>> files;
  std::size_t phases = 0; ///< 0 for volumes.
};

/// Whether the inputs are one folder with a mask for each part of one heart (TotalSegmentator): one image,
/// and no phases.
bool isHeartFolder(const std::vector<std::filesystem::path>& inputs);

/// Sorts the inputs into phases. Throws `NoInputError`, `DataError` for kinds that are mixed and for surfaces
/// that miss a phase, `UsageError` for no inputs.
SeriesFiles seriesFiles(const SeriesRequest& request);

/// The files of labelled phases, in their order. Surfaces are told by their files' names; one a phase has the
/// name that `surfaces` gives it, or what the names begin with alike. Throws as `seriesFiles`.
SeriesFiles labelledFiles(const std::vector<PhaseLabels>& phases,
                          const std::vector<LabelledSurface>& surfaces);

/// The times of phases from their DICOM files; empty for files of another kind.
medical_io::SeriesTimes dicomTimes(const std::vector<std::filesystem::path>& files);

} // namespace viscera::live
