#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/geometry/triangle_mesh.h"
#include "viscera/tracking/mask.h"
#include "viscera/tracking/phase_times.h"
#include "viscera/tracking/rims.h"
#include "viscera/tracking/surface_series.h"

/// Reads a patient's organ over time from a series of files.
namespace viscera::live {

/// The labels whose union makes one surface: the epicardium of a heart is muscle and both cavities together.
struct LabelledSurface {
  std::string name;                ///< "LV"
  std::vector<std::string> labels; ///< Names or values; all of a map when empty.
};

/// The files of a series, and the surfaces to make from them.
struct SeriesRequest {
  /// Surfaces or label maps, one for each phase; or one folder of them; or one file with several phases.
  /// Several surfaces of a phase are distinguished by their files' names without the last number.
  std::vector<std::filesystem::path> inputs;
  /// Surfaces of label maps; empty: their only label, or those of a heart. Or the files of surfaces to use,
  /// without labels; empty: all.
  std::vector<LabelledSurface> surfaces;
  std::optional<double> periodSeconds; ///< Duration of one cycle; overrides the files.
  std::vector<double> seconds;         ///< One for each phase; overrides the files.
  std::vector<std::size_t> leftOut;    ///< Phases, counted from 0, that are not used.
  bool loop = true;                    ///< Whether the last phase leads back to the first.
};

/// The surfaces of one organ in all phases of a series. Volumes and grids are checked.
struct MotionSeries {
  std::vector<std::string> names; ///< Of the surfaces, the outer one first.
  std::size_t outer = 0;          ///< Index of the surface that contains the others.
  tracking::PhaseTimes times;
  /// Series with the same triangles in all phases, one for each surface; else empty.
  std::vector<tracking::SurfaceSeries> corresponding;
  /// Surfaces without correspondence, `[phase][surface]`; else empty.
  std::vector<std::vector<std::shared_ptr<const geometry::TriangleMesh>>> meshes;
  /// The rims of the openings of `meshes` that every phase has, each filled by a cap:
  /// `[phase][surface][rim]`, the same opening at the same place of each list. Empty where there are no
  /// `meshes`.
  std::vector<std::vector<std::vector<tracking::Rim>>> rims;
  /// Voxels of label maps, `[phase][surface]`; else empty.
  std::vector<std::vector<tracking::Mask>> masks;
  std::vector<std::vector<double>> volumesMl; ///< Measured, `[phase][surface]`.
  /// The files of each surface in the order of phases, those of phases that were left out among them; one
  /// file of several phases is alone in its list.
  std::vector<std::vector<std::filesystem::path>> files;
  std::vector<Text> warnings; ///< Repairs and assumptions, a sentence each.

  std::size_t phases() const { return times.count(); }
  /// Distance of the slices of label maps, mm; 0 for surfaces.
  double sliceMm() const;
};

/// Reads a series: a list of surfaces of any format or of label maps, a folder of them (natural order of the
/// last number in a name), a 4D NIfTI, a .seq.nrrd of 3D Slicer. Times are the request's, else the files';
/// phases without times are spread evenly over the period. A last phase that equals the first (0.1 mm, and a
/// fifth of the step before) is dropped, with a warning.
///
/// Throws `NoInputError` and `DataError` of the files, and `DataError`, whose text names a remedy, for: fewer
/// than four phases; a surface or label missing in a phase; grids that differ or are sheared; a label that
/// touches the image's edge in some phases only; times that do not ascend; a cavity that is not inside the
/// outer surface; a volume that jumps by more than half of the largest between neighbours; axes that differ
/// between files; a series that does not lead back to its first phase. `UsageError` if the period, or the
/// labels of surfaces, are not given. `Cancelled`.
MotionSeries readMotionSeries(const SeriesRequest& request, Progress& progress);

/// Reads one image of an organ, or one set of surfaces, as a series of one phase, the outer surface first:
/// for computations that need no time. Throws what `readMotionSeries` throws of files, labels and cavities.
MotionSeries readOnePhase(const SeriesRequest& request, Progress& progress);

/// The name without its last number, and that number: ("LV", 3) for "LV_003.obj", ("scan", none) for
/// "scan.nii.gz".
std::pair<std::string, std::optional<std::uint64_t>> seriesName(const std::filesystem::path& file);

} // namespace viscera::live
