#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "viscera/deformation/witness_gradients.h"
#include "viscera/deformation/witness_mesh.h"
#include "viscera/live/stress_frame.h"
#include "viscera/live/stress_quantity.h"

/// Writes stress maps as files for other programs; `viscera stress` and the window write the same bytes. All
/// are atomic and throw `CannotCreateError`. `posed` are the mesh's points in the pose (`n x 3` mm, LPS),
/// `map` is at the same points.
namespace viscera::live {

/// Writes all quantities at every point of the mesh as VTK's unstructured grid (.vtu):
/// `RotationalStress_deg`, `VolumeRatio`, `StretchMax`, `StretchMin`, `Folded`, `Witness`, `Displacement_mm`.
/// A stated material adds `VonMises_kPa, <material>` and `StrainEnergy_kPa, <material>`. O(points).
void writeStressSolid(const std::filesystem::path& file, const deformation::WitnessMesh& mesh,
                      const Points& posed, const deformation::StressMap& map,
                      const elasticity::StatedMaterial& material = {});

/// Writes a table of comma-separated values, one row for each witness: its place at rest and in the pose, and
/// what is measured there, with nine digits; with a stated material also `von_mises_kpa`, `strain_energy_kpa`
/// and `material`. O(witnesses).
void writeStressTable(const std::filesystem::path& file, const deformation::WitnessMesh& mesh,
                      const Points& posed, const deformation::StressMap& map,
                      const elasticity::StatedMaterial& material = {});

/// Bars of a histogram that is written.
inline constexpr int kHistogramBars = 100;

/// A histogram of the points of a stress map, with bars of the same width over a range.
struct StressHistogram {
  std::vector<double> edges; ///< One more than bars, ascending, in the quantity's unit.
  std::vector<int> points;   ///< In each bar; what is equal to the last edge is in the last bar.
  int missing = 0;           ///< Folded: they have no value.
};

/// Makes the histogram of the first `count` values from the smallest to the largest, in `bars` bars (at least
/// 1). Without bars when there is no number among them. O(count).
StressHistogram histogramOf(const Values& values, Eigen::Index count, int bars);

/// Comma-separated values: a row a bar with `from_<unit>`, `to_<unit>` (without unit `from`, `to`), `points`
/// and `percent` of those that have a value; of a material's quantity also `material`. A last row "folded"
/// where there are such points.
void writeStressHistogram(const std::filesystem::path& file, const StressHistogram& histogram,
                          const StressMeasure& measure);

/// Comma-separated values, a row for each instant: `time_s`, `min_deg`, `mean_deg`, `p95_deg`, `max_deg`,
/// `folded`.
void writeStressCurve(const std::filesystem::path& file, const std::vector<StressSample>& samples);

} // namespace viscera::live
