#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "viscera/core/parallel.h"
#include "viscera/core/phrase.h"
#include "viscera/core/progress.h"
#include "viscera/deformation/witness_mesh.h"
#include "viscera/geometry/triangle_mesh.h"

namespace viscera::live {

/// The options for filling an organ with witness points: their number, and limits of time and memory.
struct WitnessOptions {
  static constexpr int kFewest = 200;
  static constexpr int kMost = 200'000;

  int wanted = 20'000;            ///< Witness points, kFewest to kMost; met to `kWitnessCountTolerance`.
  double radiusEdgeRatio = 1.414; ///< Quality: the largest circumradius by shortest edge, 1.1 to 10.
  double timeLimitSeconds = 60;   ///< For one run of TetGen, which is aborted after that.
  std::uint64_t memoryLimitBytes = std::uint64_t{2} << 30; ///< Of TetGen's process.
  std::filesystem::path worker; ///< The program that runs TetGen; empty: the one installed with this library.
  Threads threads;
};

/// The method by which witness points were made, best first.
enum class WitnessOrigin {
  surface,         ///< TetGen filled the surface as it is, or thinned out where it is finer than needed.
  repairedSurface, ///< TetGen filled a closed surface made from the organ's, which it had refused.
  grid,            ///< A regular grid inside the surface: TetGen has failed.
};

/// The witness points of an organ, with their origin and remarks.
struct WitnessSample {
  std::shared_ptr<const deformation::WitnessMesh> mesh; ///< Never null.
  WitnessOrigin origin = WitnessOrigin::surface;
  std::vector<Text> remarks; ///< What the user should know, a sentence each; empty when all went well.
};

/// The relative tolerance of the number of witnesses, unless a remark gives another deviation.
inline constexpr double kWitnessCountTolerance = 0.15;

/// Fills the inside of `surface` (mm, LPS) with witness points. TetGen does it in a process of its own, which
/// may fail in any way without harm; a surface that it refuses (open, self-intersecting) is repaired through
/// a signed distance grid and filled again, and if that fails too, the points are those of a regular grid.
///
/// Throws `UsageError` for options out of range, `DataError` for a surface that encloses nothing (no
/// triangles, flat, coordinates that are not finite), `Cancelled`. Seconds; for a worker thread. The same
/// surface and options give the same points, whatever the number of threads.
WitnessSample sampleWitnesses(const geometry::TriangleMesh& surface, const WitnessOptions& options,
                              Progress& progress);

/// The same without the points inside `cavities` (closed surfaces in the organ): what they hold is no tissue.
/// A remark says how many points are left when that is fewer than `options` ask for. Throws `DataError` when
/// nothing is left.
WitnessSample withoutCavities(WitnessSample sample,
                              const std::vector<std::shared_ptr<const geometry::TriangleMesh>>& cavities,
                              const WitnessOptions& options);

} // namespace viscera::live
