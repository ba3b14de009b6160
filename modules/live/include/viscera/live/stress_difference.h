#pragma once

#include <filesystem>
#include <optional>

#include "viscera/live/stress_frame.h"

/// The difference of the stress in two poses of one organ, point by point.
namespace viscera::live {

/// What each quantity of one pose exceeds that of another one by, at every point of the mesh, in its unit;
/// not a number where the tissue is folded in one of them.
struct StressDifference {
  Values stressDegrees; ///< Degrees.
  Values volumeRatio;
  Values stretchMax;
  Values stretchMin;
  Values vonMisesKpa = {}; ///< Of a stated material; empty without one.
  Values energyKpa = {};
  elasticity::StatedMaterial material = {};
};

/// The difference of `a` less `b` (see `differenceOf`). None unless both are of the same points. O(n).
std::optional<StressDifference> stressDifference(const StressFrame& a, const StressFrame& b,
                                                 const elasticity::StatedMaterial& material = {});

/// Writes a difference as a map: VTK's unstructured grid (.vtu) in the pose of `a`, whose mesh and points are
/// written, with the arrays `stress_degrees_difference`, `volume_ratio_difference`, `stretch_max_difference`,
/// `stretch_min_difference` and `Witness`, with a material also `von_mises_kpa_difference, <material>` and
/// `strain_energy_kpa_difference, <material>`; else as a table with these columns behind the place of each
/// witness at rest and in that pose, empty where one pose folds the tissue. Atomic. Throws
/// `CannotCreateError`.
void writeStressDifference(const std::filesystem::path& file, const StressFrame& a,
                           const StressDifference& difference);

} // namespace viscera::live
